// Philox and the numbers made of it.
#include "core/random.hpp"

#include <Random123/philox.h>
#include <gtest/gtest.h>

#include <limits>

#include "support/chi_squared.hpp"
#include "support/lanes4.hpp"
#include "support/random.hpp"

namespace photic {
namespace {

using Words = std::array<std::uint32_t, 4>;

// The known answers that Random123 ships (kat_vectors, philox4x32 10). Seen red: with the two
// halves of the seed swapped; with event and block swapped; with nine rounds; with products that
// stay where they were.
TEST(Philox, GivesTheKnownAnswers) {
  EXPECT_EQ(philox_words(0, 0, 0, 0), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  constexpr std::uint32_t ones = 0xffffffff;
  EXPECT_EQ(philox_words(~std::uint64_t{0}, ~std::uint64_t{0}, ones, ones),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  // The digits of pi; the first word of counter and key is the low one.
  EXPECT_EQ(philox_words(0x299f31d0a4093822, 0x85a308d3243f6a88, 0x13198a2e, 0x03707344),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Philox, IsThatOfRandom123) {
  test::Random random(9);
  const auto word = [&] { return static_cast<std::uint32_t>(random.uniform() * 4294967296.0); };
  for (int i = 0; i < 100000; ++i) {
    const r123::Philox4x32::ctr_type counter = {{word(), word(), word(), word()}};
    const r123::Philox4x32::key_type key = {{word(), word()}};
    const auto theirs = r123::Philox4x32{}(counter, key);
    const auto wide = [](std::uint32_t low, std::uint32_t high) {
      return low | std::uint64_t{high} << 32;
    };
    ASSERT_EQ(
        philox_words(wide(key[0], key[1]), wide(counter[0], counter[1]), counter[2], counter[3]),
        (Words{theirs[0], theirs[1], theirs[2], theirs[3]}));
  }
}

template <class T>
class UniformOf : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(UniformOf, Reals);

// Seen red: without the half that puts a number in the middle of its cell; with all 32 bits in a
// float.
TYPED_TEST(UniformOf, LiesStrictlyBetween0And1) {
  using T = TypeParam;
  for (const std::uint32_t word :
       {0U, 1U, 0x1ffU, 0x7fffffffU, 0x80000000U, 0xfffffe00U, 0xffffffffU}) {
    EXPECT_GT(uniform_from<T>(word), T(0)) << word;
    EXPECT_LT(uniform_from<T>(word), T(1)) << word;
  }
  EXPECT_EQ(uniform_from<T>(0) + uniform_from<T>(0xffffffffU), T(1));  // as near to 0 as to 1
  EXPECT_NEAR(uniform_from<T>(0x40000000U), T(0.25), T(1e-7));
}

// 100 cells for each of the four numbers, 1 % for all eight tests (Bonferroni).
TYPED_TEST(UniformOf, IsUniform) {
  using T = TypeParam;
  constexpr int photons = 100000;
  std::array<std::vector<double>, 4> count;
  count.fill(std::vector<double>(100, 0.0));
  for (std::uint64_t photon = 0; photon < photons; ++photon) {
    const auto u = uniforms(RandomPlace<T>{7, photon, 3}, 1);
    for (std::size_t k = 0; k < 4; ++k) count[k][static_cast<std::size_t>(u[k] * T(100))] += 1;
  }
  for (const auto& c : count) test::expect_uniform(c, photons, 0.01 / 8);
}

// Whatever was chosen, what is left of even numbers is even: 1 % for both. Seen red: without the
// share taken off where it was not chosen.
TEST(LeftOfChoice, IsUniform) {
  constexpr int numbers = 100000;
  constexpr double share = 0.3;
  std::array<std::vector<double>, 2> count;
  count.fill(std::vector<double>(50, 0.0));
  std::array<double, 2> total{};
  for (std::uint64_t i = 0; i < numbers; ++i) {
    const double u = uniforms(RandomPlace<double>{9, i, 1}, 0)[0];
    const std::size_t chosen = u < share ? 1 : 0;
    const double left = left_of_choice(u, share);
    ASSERT_TRUE(left >= 0 && left < 1);
    count[chosen][static_cast<std::size_t>(left * 50)] += 1;
    total[chosen] += 1;
  }
  for (std::size_t i = 0; i < 2; ++i) test::expect_uniform(count[i], total[i], 0.01 / 2);
  EXPECT_EQ(left_of_choice(0.25, 0.0), 0.25);
}

TEST(Uniforms, DifferByPhotonEventBlockAndSeed) {
  const auto here = uniforms(RandomPlace<double>{1, 2, 3}, 0);
  EXPECT_EQ(here, uniforms(RandomPlace<double>{1, 2, 3}, 0));
  EXPECT_NE(here, uniforms(RandomPlace<double>{1, 2, 3}, 1));
  EXPECT_NE(here, uniforms(RandomPlace<double>{1, 2, 4}, 0));
  EXPECT_NE(here, uniforms(RandomPlace<double>{1, 3, 3}, 0));
  EXPECT_NE(here, uniforms(RandomPlace<double>{2, 2, 3}, 0));
  // Photons and seeds beyond 32 bits are others.
  EXPECT_NE(here, uniforms(RandomPlace<double>{1, 2 + (std::uint64_t{1} << 32), 3}, 0));
  EXPECT_NE(here, uniforms(RandomPlace<double>{1 + (std::uint64_t{1} << 32), 2, 3}, 0));
}

// Seen red: with the words of a block in another order; with a double's words one too large.
TEST(Uniforms, AreTheSameInEveryLane) {
  RandomPlace<test::Lanes4> place{11, {}, {}};
  constexpr std::array<std::uint64_t, test::lanes> photon{5, 6, std::uint64_t{1} << 40, 5};
  constexpr std::array<std::int32_t, test::lanes> event{0, 1, 2, 3};
  place.photon = decltype(place.photon)::load(photon.data());
  place.event = decltype(place.event)::load(event.data());
  const auto packed = uniforms(place, 2);
  for (std::size_t i = 0; i < test::lanes; ++i) {
    const auto one = uniforms(RandomPlace<double>{11, place.photon[i], place.event[i]}, 2);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(packed[k][i], one[k]);
  }
}

}  // namespace
}  // namespace photic
