// What the steps of sensitivities make of the water: central differences of its optics against
// derivatives in closed form.
#include <cmath>
#include <string>

#include "medium/layer_optics.hpp"
#include "unit/medium/scenes.hpp"
#include "unit/scene/base_scene.hpp"

namespace photic::medium {
namespace {

/// The error of the central difference of a power x^e over a step of 1e-3 x: |(e-1)(e-2)| / 6 *
/// 1e-6.
constexpr double error_of_difference = 4e-7;

struct Derivatives {
  double a, b;  ///< per unit of the parameter
};

/// Of the first layer, at 500 nm, where the exponent of absorption is far from 1.
constexpr double wavelength_nm = 500;

Derivatives derivatives_in(const scene::Scene& scene) {
  const scene::Sensitivity& s = scene.sensitivity.at(0);
  const auto optics_in = [&](const scene::Environment& environment) {
    const scene::Scene there = scene::scene_in(scene, environment);
    return LayerOptics(there, library())(there.sea.layer[0], wavelength_nm);
  };
  const WaterOptics below = optics_in(s.below);
  const WaterOptics above = optics_in(s.above);
  return {(above.a_per_m - below.a_per_m) / (2 * s.step),
          (above.b_per_m - below.b_per_m) / (2 * s.step)};
}

// Seen red, each for itself: with one-sided steps; with steps of a hundredth.
TEST(Sensitivities, ToChlorophyllAreTheDerivativesOfItsPowerLaws) {
  const double exponent = library().particles_e.at(wavelength_nm, "");
  const double factor = library().particles_a.at(wavelength_nm, "");
  for (const double c : {0.02, 0.1, 1.0, 10.0}) {
    const Derivatives slopes = derivatives_in(
        scene::read_text("sensitivity = ['sea.layer.0.chlorophyll_mg_m3']\n" + scene::edited({}),
                         {"sea.layer.0.chlorophyll_mg_m3=" + std::to_string(c)}));
    const double a = exponent * factor * std::pow(c, exponent - 1);
    const double b = 0.62 * 0.30 * (550.0 / wavelength_nm) * std::pow(c, 0.62 - 1);
    EXPECT_NEAR(slopes.a / a, 1, error_of_difference) << c;
    EXPECT_NEAR(slopes.b / b, 1, error_of_difference) << c;
  }
}

TEST(Sensitivities, ToMineralsAreExact) {
  const Derivatives slopes = derivatives_in(
      scene::read_text("sensitivity = ['sea.layer.0.minerals_g_m3']\n" + scene::edited({}),
                       {"sea.layer.0.minerals_g_m3=0.5"}));
  EXPECT_NEAR(slopes.a / (0.041 * std::exp(-0.0123 * (wavelength_nm - 443))), 1, 1e-11);
  EXPECT_NEAR(slopes.b / (0.5 * std::sqrt(555 / wavelength_nm)), 1, 1e-11);
}

// Of one of the constants of [optics].
TEST(Sensitivities, ToTheSlopeOfMineralsAreTheDerivativeOfItsPower) {
  const Derivatives slopes = derivatives_in(
      scene::read_text("sensitivity = ['optics.minerals_b_exponent']\n" + scene::edited({}),
                       {"sea.layer.0.minerals_g_m3=0.5"}));
  EXPECT_NEAR(slopes.b / (0.25 * std::log(555 / wavelength_nm) * std::sqrt(555 / wavelength_nm)), 1,
              error_of_difference);
  EXPECT_EQ(slopes.a, 0);
}

// What absorption is linear in has no such error.
TEST(Sensitivities, ToDissolvedMatterAreExact) {
  const scene::Scene scene =
      scene::read_text("sensitivity = ['sea.layer.0.cdom_a440_per_m']\n" + scene::edited({}),
                       {"sea.layer.0.cdom_a440_per_m=0.05"});
  const Derivatives slopes = derivatives_in(scene);
  EXPECT_NEAR(slopes.a / std::exp(-0.017 * (wavelength_nm - 440)), 1, 1e-11);
  EXPECT_EQ(slopes.b, 0);
}

}  // namespace
}  // namespace photic::medium
