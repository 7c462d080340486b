// Cosine and sine of an angle given in turns.
#include "core/turn.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace photic {
namespace {

// Seen red: with the rose's points counted from 1; with the last term of the cosine left out.
TEST(CosSinOfTurns, AreThoseOfTheMathematicsLibrary) {
  for (int i = 0; i <= 8000; ++i) {
    const double u = i / 8000.0;
    const auto [cosine, sine] = cos_sin_of_turns(u);
    const long double angle = 2 * std::numbers::pi_v<long double> * u;
    ASSERT_NEAR(cosine, static_cast<double>(std::cos(angle)), 8e-16) << u;
    ASSERT_NEAR(sine, static_cast<double>(std::sin(angle)), 8e-16) << u;
  }
}

TEST(CosSinOfTurns, LieOnTheUnitCircleInFloatToo) {
  test::Random random(6);
  for (int i = 0; i < 100000; ++i) {
    const double u = random.uniform();
    const auto d = cos_sin_of_turns(u);
    ASSERT_NEAR(d.cosine * d.cosine + d.sine * d.sine, 1, 1e-15);
    const auto f = cos_sin_of_turns(static_cast<float>(u));
    ASSERT_NEAR(f.cosine, d.cosine, 6e-7);
    ASSERT_NEAR(f.sine, d.sine, 6e-7);
  }
}

}  // namespace
}  // namespace photic
