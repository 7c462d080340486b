// The operations of packs against those of scalars, bit for bit. Compiled for each instruction set.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "core/elementary.hpp"
#include "core/pack.hpp"
#include "core/sobol.hpp"
#include "core/turn.hpp"
#include "core/twin_table.hpp"
#include "support/random.hpp"

namespace photic {
namespace {

constexpr int groups = 2000;
constexpr int lanes = native::float_lanes;
constexpr auto width = static_cast<std::size_t>(lanes);
using Real = Pack<float, lanes>;
using Integer = Index<Real>;
using Flags = Mask<Real>;

template <class E>
using Lanes = std::array<E, width>;

template <class E, class Make>
Lanes<E> make_lanes(Make make) {
  Lanes<E> out;
  for (E& lane : out) lane = static_cast<E>(make());
  return out;
}
Real pack(const Lanes<float>& values) { return Real::load(values.data()); }
Integer pack(const Lanes<std::int32_t>& values) { return Integer::load(values.data()); }

void expect_bits(const Real& packed, std::size_t i, float scalar, const char* what) {
  ASSERT_EQ(std::bit_cast<std::uint32_t>(packed[i]), std::bit_cast<std::uint32_t>(scalar))
      << what << ", lane " << i << ": " << packed[i] << " and " << scalar;
}

/// Numbers of all sizes, and some that meet.
Lanes<float> numbers(test::Random& random) {
  return make_lanes<float>([&] {
    if (random.chance(0.2)) return static_cast<double>(random.below(3) - 1);
    return random.scale(1e-6, 1e6) * (random.chance(0.5) ? 1 : -1);
  });
}

void check_arithmetic(test::Random& random) {
  const auto x = numbers(random), y = numbers(random);
  const Real a = pack(x), b = pack(y);
  const Flags less = a < b, less_equal = a <= b, equal = a == b;
  for (std::size_t i = 0; i < width; ++i) {
    expect_bits(a + b, i, x[i] + y[i], "sum");
    expect_bits(a - b, i, x[i] - y[i], "difference");
    expect_bits(a * b, i, x[i] * y[i], "product");
    expect_bits(a / b, i, x[i] / y[i], "quotient");
    expect_bits(-a, i, -x[i], "negative");
    expect_bits(abs(a), i, std::abs(x[i]), "absolute value");
    expect_bits(copysign(a, b), i, std::copysign(x[i], y[i]), "sign");
    expect_bits(sqrt(abs(a)), i, std::sqrt(std::abs(x[i])), "square root");
    ASSERT_EQ(less[i], x[i] < y[i]);
    ASSERT_EQ((a > b)[i], x[i] > y[i]);
    ASSERT_EQ(less_equal[i], x[i] <= y[i]);
    ASSERT_EQ((a >= b)[i], x[i] >= y[i]);
    ASSERT_EQ(equal[i], x[i] == y[i]);
    expect_bits(select(less, a, b), i, x[i] < y[i] ? x[i] : y[i], "blend");
    expect_bits(Real(0.1), i, 0.1F, "same");
  }
}

void check_masks(test::Random& random) {
  const auto x = make_lanes<std::int32_t>([&] { return random.below(3); });
  const auto y = make_lanes<std::int32_t>([&] { return random.below(3); });
  const Flags a = pack(x) == Integer(0), b = pack(y) < Integer(2);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < width; ++i) {
    const bool p = x[i] == 0, q = y[i] < 2;
    bits |= p ? 1U << i : 0U;
    ASSERT_EQ((a & b)[i], p && q);
    ASSERT_EQ((a | b)[i], p || q);
    ASSERT_EQ((!a)[i], !p);
    ASSERT_EQ(select(a, b, !b)[i], p ? q : !q);
    ASSERT_EQ(select(a, pack(x), pack(y))[i], p ? x[i] : y[i]);
  }
  ASSERT_EQ(lane_bits(a), bits);
  ASSERT_EQ(lane_bits(Flags::of_bits(bits)), bits);
  ASSERT_EQ(count(a), std::popcount(bits));
  ASSERT_EQ(any(a), bits != 0);
  ASSERT_EQ(all(a), std::popcount(bits) == lanes);
  ASSERT_TRUE(all(Flags(true)) && !any(Flags(false)));
  std::vector<std::size_t> visited;
  for_each_lane(a, [&](int lane) { visited.push_back(static_cast<std::size_t>(lane)); });
  ASSERT_EQ(visited.size(), count(a));
}

/// Lanes that go to memory and come from it under a mask, and from one lane to another.
void check_moves(test::Random& random) {
  const auto x = numbers(random), y = numbers(random);
  const std::uint32_t bits =
      static_cast<std::uint32_t>(random.below(1 << width)) & ((1U << width) - 1);
  const Flags mask = mask_of_bits<Real>(bits);
  const auto place = make_lanes<std::int32_t>([n = 3 * lanes]() mutable { return n -= 2; });
  const auto lane = make_lanes<std::int32_t>([&] { return random.below(lanes); });
  std::array<float, 2 * width> together{};
  compress(mask, pack(x), together.data());
  Real expanded = pack(y);
  expand(mask, x.data(), expanded);
  std::array<float, 4 * width> scattered{};
  scatter(mask, pack(place), pack(x), scattered.data());
  std::array<Real, width> square;
  for (std::size_t i = 0; i < width; ++i) square[i] = pack(x) + Real(i);
  transpose(square);
  std::size_t found = 0;
  for (std::size_t i = 0; i < width; ++i) {
    const bool is = (bits >> i & 1U) != 0;
    if (is) expect_bits(pack(x), i, together[found], "compressed");
    expect_bits(expanded, i, is ? x[found] : y[i], "expanded");
    ASSERT_EQ(scattered[static_cast<std::size_t>(place[i])], is ? x[i] : 0);
    ASSERT_EQ(scattered[static_cast<std::size_t>(place[i]) + 1], 0);
    expect_bits(permute(pack(x), pack(lane)), i, x[static_cast<std::size_t>(lane[i])], "permuted");
    for (std::size_t k = 0; k < width; ++k)
      expect_bits(square[k], i, x[k] + static_cast<float>(i), "transposed");
    ASSERT_EQ(lane_numbers<Real>()[i], static_cast<std::int32_t>(i));
    found += is ? 1 : 0;
  }
}

/// Random numbers made of words.
void check_words(test::Random& random) {
  std::array<std::uint32_t, 64> table{};
  for (auto& word : table) word = static_cast<std::uint32_t>(random.uniform() * 4294967296.0);
  const auto at = make_lanes<std::int32_t>([&] { return random.below(64); });
  const auto words = gather_word<Real>(table.data(), pack(at));
  const Word<Real> key(table[0]);
  for (std::size_t i = 0; i < width; ++i) {
    const std::uint32_t word = table[static_cast<std::size_t>(at[i])];
    ASSERT_EQ(words[i], word);
    ASSERT_EQ(scrambled(words, key)[i], scrambled(word, table[0]));
    expect_bits(uniform_from_word<Real>(words), i, uniform_from_word<float>(word), "uniform");
  }
}

void check_integers(test::Random& random) {
  const auto number = [&] { return random.below(2000) - 1000; };
  const auto x = make_lanes<std::int32_t>(number), y = make_lanes<std::int32_t>(number);
  const auto z = make_lanes<float>([&] { return random.scale(1e-3, 1e6); });
  const Integer a = pack(x), b = pack(y);
  for (std::size_t i = 0; i < width; ++i) {
    ASSERT_EQ((a + b)[i], x[i] + y[i]);
    ASSERT_EQ((a - b)[i], x[i] - y[i]);
    ASSERT_EQ((a * b)[i], x[i] * y[i]);
    ASSERT_EQ((a >> 3)[i], x[i] >> 3);
    ASSERT_EQ((a & b)[i], x[i] & y[i]);
    ASSERT_EQ((a < b)[i], x[i] < y[i]);
    ASSERT_EQ(to_real<Real>(a)[i], static_cast<float>(x[i]));
    ASSERT_EQ(floor_index(pack(z))[i], floor_index(z[i]));
    ASSERT_EQ(to_double(pack(z))[i], static_cast<double>(z[i]));
  }
}

/// Tables of all lengths: those that fit into registers and those that do not.
void check_gathers(test::Random& random) {
  const auto length = static_cast<std::size_t>(1 + random.below(100));
  std::vector<double> reals;
  std::vector<std::int32_t> integers;
  for (std::size_t k = 0; k < length; ++k) {
    reals.push_back(random.uniform());
    integers.push_back(random.below(1000));
  }
  const TwinTable table(reals);
  const IndexTableOwner numbers(integers);
  const auto x = make_lanes<std::int32_t>([&] { return random.below(static_cast<int>(length)); });
  const Integer i = pack(x);
  const ShortTable view = table.view();
  for (std::size_t k = 0; k < width; ++k) {
    const auto exact = static_cast<float>(reals[static_cast<std::size_t>(x[k])]);
    expect_bits(gather<Real>(view, i), k, exact, "short table");
    expect_bits(gather<Real>(static_cast<const Table&>(view), i), k, exact, "table");
    ASSERT_EQ(gather_index<Real>(numbers.view(), i)[k], integers[static_cast<std::size_t>(x[k])]);
    ASSERT_EQ(gather_index<Real>(numbers.view().data, i)[k],
              integers[static_cast<std::size_t>(x[k])]);
    const Integer cell = i & Integer(cells<Real> - 1);
    expect_bits(gather<Real>(octave_tables.power, cell), k,
                gather<float>(octave_tables.power, x[k] & (cells<float> - 1)), "table of cells");
  }
}

/// Numbers that stand one behind the other in each lane's place of a table.
void check_rows(test::Random& random) {
  std::vector<double> reals;
  for (int k = 0; k < 50; ++k) reals.push_back(random.uniform());
  const TwinTable table(reals);
  const auto x = make_lanes<std::int32_t>([&] { return random.below(50 - 3); });
  const auto four = gather_row<4, Real>(table.table(), pack(x));
  const auto two = gather_row<2, Real>(table.table(), pack(x));
  for (std::size_t i = 0; i < width; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      const auto at = static_cast<std::size_t>(x[i]) + k;
      expect_bits(four[k], i, static_cast<float>(reals[at]), "row of four");
      if (k < 2) expect_bits(two[k], i, static_cast<float>(reals[at]), "row of two");
    }
  }
}

/// Pairs from registers and from memory.
void check_pairs(test::Random& random, std::int32_t length) {
  std::vector<double> first, second;
  for (std::int32_t k = 0; k < length; ++k) {
    first.push_back(random.uniform());
    second.push_back(random.uniform());
  }
  const TwinPairs pairs(first, second);
  const auto x = make_lanes<std::int32_t>([&] { return random.below(length); });
  const auto [a, b] = gather_pair<Real>(pairs.view(), pack(x));
  for (std::size_t k = 0; k < width; ++k) {
    const auto at = static_cast<std::size_t>(x[k]);
    expect_bits(a, k, static_cast<float>(first[at]), "first of a pair");
    expect_bits(b, k, static_cast<float>(second[at]), "second of a pair");
    const auto [one, other] = gather_pair<double>(pairs.view(), x[k]);
    ASSERT_EQ(one, first[at]);
    ASSERT_EQ(other, second[at]);
  }
}

void check_functions(test::Random& random) {
  const auto u = make_lanes<float>([&] { return random.uniform(); });
  const auto y = make_lanes<float>([&] { return random.scale(1e-6, 100); });
  const auto at = octave_cell(pack(y), 7);
  const auto turned = cos_sin_of_turns(pack(u));
  for (std::size_t i = 0; i < width; ++i) {
    const auto one = octave_cell(y[i], 7);
    ASSERT_EQ(at.cell[i], one.cell);
    expect_bits(at.fraction, i, one.fraction, "fraction");
    expect_bits(octave_edge<Real>(at.cell, 7), i, octave_edge<float>(one.cell, 7), "edge");
    expect_bits(exp_minus(pack(y)), i, exp_minus(y[i]), "exp");
    expect_bits(minus_log(pack(u)), i, minus_log(u[i]), "log");
    expect_bits(turned.cosine, i, cos_sin_of_turns(u[i]).cosine, "cosine");
    expect_bits(turned.sine, i, cos_sin_of_turns(u[i]).sine, "sine");
  }
}

void check_random_numbers(test::Random& random) {
  RandomPlace<Real> place{static_cast<std::uint64_t>(random.uniform() * 1e18), {}, {}};
  const auto photon = make_lanes<std::uint64_t>([&] { return random.scale(1, 1e18); });
  const auto event = make_lanes<std::int32_t>([&] { return 1 + random.below(1000000); });
  place.photon = Counter<Real>::load(photon.data());
  place.event = pack(event);
  const auto packed = uniforms(place, 3);
  RandomPlace<Real> before = place;
  before.event = place.event - Integer(1);
  const auto twins = uniforms(place, before, 3);
  for (std::size_t i = 0; i < width; ++i) {
    const auto one = uniforms(RandomPlace<float>{place.key, photon[i], event[i]}, 3);
    const auto other = uniforms(RandomPlace<float>{place.key, photon[i], event[i] - 1}, 3);
    for (std::size_t k = 0; k < 4; ++k) {
      expect_bits(packed[k], i, one[k], "uniform");
      expect_bits(twins[0][k], i, one[k], "uniform of the first of two");
      expect_bits(twins[1][k], i, other[k], "uniform of the second of two");
    }
  }
}

}  // namespace

namespace PHOTIC_ISA {
void check_packs();
void check_packs() {
  test::Random random(1);
  for (int g = 0; g < groups && !testing::Test::HasFatalFailure(); ++g) {
    check_arithmetic(random);
    check_masks(random);
    check_moves(random);
    check_words(random);
    check_integers(random);
    check_gathers(random);
    check_rows(random);
    check_pairs(random, 1 + random.below(100));
    check_functions(random);
    check_random_numbers(random);
  }
}
}  // namespace PHOTIC_ISA

}  // namespace photic
