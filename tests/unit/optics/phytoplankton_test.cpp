#include "optics/phytoplankton.hpp"

#include "optics/cdom.hpp"
#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

Phytoplankton bricaud(double c, double nm) { return phytoplankton(library(), "bricaud", c, nm); }
Phytoplankton paper(double c, double nm) {
  return phytoplankton(library(), "prieur-sathyendranath", c, nm);
}

// Values of the tables' rows. Seen red: with A C^B for the absorption that excites (its exponent is
// 1 - B).
TEST(Phytoplankton, OfBricaudIsTheTablesRows) {
  const Phytoplankton at_440 = bricaud(0.1, 440);
  EXPECT_NEAR(at_440.a_per_m, 0.0520 * std::pow(0.1, 0.6350), 1e-15);
  EXPECT_NEAR(at_440.a_exciting_per_m, 0.0403 * std::pow(0.1, 1 - 0.332), 1e-15);
  // Particles absorb 1.39 times what phytoplankton alone does at 440 nm and 0.1 mg/m^3.
  EXPECT_NEAR(at_440.a_per_m / at_440.a_exciting_per_m, 1.39, 5e-3);
  EXPECT_NEAR(bricaud(1, 550).b_per_m, 0.30, 1e-15);
  EXPECT_NEAR(bricaud(0.1, 532).b_per_m, 0.30 * 550 / 532 * std::pow(0.1, 0.62), 1e-15);
}

TEST(Phytoplankton, OfThePaperIsItsFormula) {
  const Phytoplankton p = paper(0.5, 500);
  EXPECT_NEAR(p.a_per_m, 0.06 * std::pow(0.5, 0.602) * 0.668, 1e-15);
  EXPECT_EQ(p.a_exciting_per_m, p.a_per_m);
  EXPECT_NEAR(p.b_per_m, 0.33 * 1.1 * std::pow(0.5, 0.620), 1e-15);
}

TEST(Phytoplankton, SetsDiffer) {
  EXPECT_GT(paper(0.1, 532).a_per_m, 1.2 * bricaud(0.1, 532).a_per_m);
  EXPECT_NEAR(paper(0.1, 532).b_per_m / bricaud(0.1, 532).b_per_m, 1.1, 1e-12);
  EXPECT_NE(paper(0.1, 532).source, bricaud(0.1, 532).source);
}

// Seen red: with the shape beyond the table's end left out.
TEST(Phytoplankton, GoesOnInTheUltravioletWithTheShapeOfParticles) {
  const double shape = bricaud(0.3, 337).a_per_m / bricaud(0.3, 400).a_per_m;
  EXPECT_GT(shape, 1.2);
  EXPECT_NEAR(bricaud(0.3, 337).a_exciting_per_m, shape * bricaud(0.3, 400).a_exciting_per_m,
              1e-15);
  EXPECT_NEAR(paper(0.3, 337).a_per_m, shape * paper(0.3, 400).a_per_m, 1e-15);
}

// Seen red: with the limit to a left out.
TEST(Phytoplankton, IsContinuousAndNeverExcitesMoreThanItAbsorbs) {
  for (const double c : {0.01, 0.1, 1.0, 10.0, 100.0}) {
    for (const auto& model : {bricaud, paper}) {
      for (double nm = 300; nm <= 800; nm += 0.5) {
        const Phytoplankton p = model(c, nm);
        ASSERT_LE(p.a_exciting_per_m, p.a_per_m) << c << " " << nm;
        ASSERT_GE(p.a_exciting_per_m, 0) << c << " " << nm;
        ASSERT_GT(p.b_per_m, 0);
      }
      for (const double edge : {400.0, 700.0, 720.0}) {
        const Phytoplankton below = model(c, edge - 1e-6), above = model(c, edge + 1e-6);
        EXPECT_NEAR(below.a_exciting_per_m, above.a_exciting_per_m, 1e-6 * c + 1e-8);
        EXPECT_NEAR(below.a_per_m, above.a_per_m, 1e-6 * c + 1e-8);
      }
    }
  }
  EXPECT_EQ(paper(1, 720).a_per_m, 0);
}

TEST(Phytoplankton, WithoutChlorophyllIsExactlyNothingAtAnyWavelength) {
  for (const auto& model : {bricaud, paper}) {
    for (const double nm : {250.0, 532.0, 950.0}) {
      const Phytoplankton none = model(0, nm);
      EXPECT_EQ(none.a_per_m, 0);
      EXPECT_EQ(none.a_exciting_per_m, 0);
      EXPECT_EQ(none.b_per_m, 0);
    }
  }
}

TEST(Phytoplankton, NamesItsRangeAndModels) {
  expect_contains(message<InputError>([] { bricaud(0.1, 266); }),
                  "no phytoplankton absorption data at 266 nm: Bricaud et al. 1998");
  expect_contains(message<InputError>([] { paper(0.1, 801); }), "cover 300-800 nm");
  expect_contains(message<InputError>([] { phytoplankton(library(), "mie", 0.1, 532); }),
                  "no phytoplankton model \"mie\" (there are: bricaud, prieur-sathyendranath)");
}

// Seen red: with the sign of the slope turned.
TEST(Cdom, FallsExponentiallyFrom440Nm) {
  EXPECT_EQ(cdom_absorption_per_m(0.07, 0.017, 440), 0.07);
  EXPECT_NEAR(cdom_absorption_per_m(0.07, 0.017, 540), 0.07 * std::exp(-1.7), 1e-15);
  EXPECT_NEAR(cdom_absorption_per_m(0.07, 0.017, 355), 0.297, 5e-4);
}

}  // namespace
}  // namespace photic::optics
