#include "optics/sampled_spheres.hpp"

#include "optics/phase_between_angles.hpp"
#include "optics/phase_functions.hpp"
#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

constexpr double micron = 1e-6;

/// Soot, mineral dust, droplets that do not absorb, and grey ones that have a rainbow.
const Spheres soot{0.55 * micron, 1.75, 0.44,
                   LogNormal{0.0118 * micron, 2, 0.005 * micron, 1 * micron}};
const Spheres dust{0.55 * micron, 1.53, 0.0055,
                   LogNormal{0.39 * micron, 2, 0.005 * micron, 10 * micron}};
const Spheres droplets{1.064 * micron, 1.34, 1e-7,
                       LogNormal{0.5 * micron, 2, 0.01 * micron, 10 * micron}};
const Spheres rain{1.064 * micron, 1.33, 2e-3, LogNormal{5 * micron, 1.4, 1 * micron, 20 * micron}};

// Against the adaptive integral over sizes and the exact polynomial of the angle. Seen red: with
// steps of 4 in the size parameter; with 50 % in radius; with the width of small steps for all;
// with angles tens of degrees apart behind 90 degrees.
TEST(SampledSpheres, AreTheIntegralOverSizes) {
  for (const Spheres& spheres : {soot, dust, droplets, rain}) {
    const bool absorb = spheres.absorption_index > 1e-3;
    const SampledSpheres sampled = sampled_spheres(spheres);
    const SpheresOptics exact = optics_of_spheres(spheres);
    EXPECT_NEAR(sampled.extinction_m2 / exact.extinction_m2, 1, 1e-3);
    EXPECT_NEAR(sampled.scattering_m2 / exact.scattering_m2, 1, 1e-3);
    EXPECT_NEAR(sampled.absorption_m2, exact.absorption_m2, 1e-3 * exact.extinction_m2);
    EXPECT_NEAR(sampled.mean_cosine, exact.mean_cosine, 1e-3);
    EXPECT_NEAR(sampled.integral, 1, 1e-4);
    for (double degrees = 0; degrees <= 180; degrees += degrees < 1 ? 0.05 : 0.37) {
      const double tolerance = absorb ? 1.5e-2 : degrees < 90 ? 2e-2 : 6e-2;
      EXPECT_NEAR(sampled.phase.p(x_of(degrees)) / exact.phase.at(x_of(degrees)), 1, tolerance)
          << degrees;
    }
  }
}

TEST(SampledSpheres, HaveTheSameSectionsWithoutTheirPhaseFunctionAndEachTime) {
  const SampledSpheres whole = sampled_spheres(dust), again = sampled_spheres(dust);
  const SampledSpheresCache cache;
  EXPECT_EQ(cache.sections(dust)->extinction_m2, whole.extinction_m2);
  EXPECT_EQ(cache.sections(dust)->absorption_m2, whole.absorption_m2);
  EXPECT_EQ(cache(dust), cache(dust));
  EXPECT_NE(cache(dust), cache(soot));
  for (const double degrees : {0.0, 33.0, 180.0})
    EXPECT_EQ(whole.phase.p(x_of(degrees)), again.phase.p(x_of(degrees)));
}

// A formula with a forward peak, between its angles. Seen red: with straight lines between them.
TEST(PhaseBetweenAngles, IsTheFunctionBetweenThem) {
  const PhaseShape exact = henyey_greenstein(0.9);
  const PhaseAngles angles;
  std::vector<double> values;
  for (const double degrees : angles.degrees()) values.push_back(exact.p(x_of(degrees)));
  const PhaseBetweenAngles phase = phase_between_angles(values);
  EXPECT_NEAR(phase.integral, 1, 1e-5);
  EXPECT_NEAR(phase.shape.core_mass / exact.core_mass, 1, 1e-3);
  for (double degrees = 0; degrees <= 180; degrees += 0.1)
    EXPECT_NEAR(phase.shape.p(x_of(degrees)) / exact.p(x_of(degrees)), 1, 3e-4) << degrees;
}

// A glory of half a degree, also in a mixture. Seen red: with octaves of x alone in the table,
// which have too much light go back.
TEST(PhaseBetweenAngles, KeepsAGloryInATable) {
  const PhaseAngles angles;
  std::vector<double> values;
  for (const double degrees : angles.degrees())
    values.push_back((1 + 3 * std::exp(-std::pow((180 - degrees) / 0.5, 2))) / (4 * pi));
  const PhaseShape shape = phase_between_angles(values).shape;
  EXPECT_NEAR(table_integral(shape), 1, 1e-5);
  EXPECT_NEAR(shape.p(2) / (4 / (4 * pi)), 1, 1e-3);
  const PhaseTable table(mixture({{0.5, shape}, {0.5, isotropic()}}));
  for (const double degrees : {150.0, 179.0, 179.4, 179.7, 180.0}) {
    const double x = x_of(degrees), expected = (shape.p(x) + 1 / (4 * pi)) / 2;
    EXPECT_NEAR(table.view().value<double>(x) / expected, 1, 3e-2) << degrees;
  }
  EXPECT_NEAR(table.backscatter_fraction(), 0.5, 1e-4);
}

}  // namespace
}  // namespace photic::optics
