// Instruments in the water under air that scatters: a laser, a telescope or both, that the light of
// the air leaves or comes to by way of the surface.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "run/run.hpp"
#include "support/films.hpp"
#include "support/own_runs.hpp"
#include "support/runs.hpp"
#include "support/same_light.hpp"
#include "support/scenes.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

/// The water is clear where lenses are, as near scattering makes tails of single scores heavy.
const std::string air_and_water =
    "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 3.0\n" +
    scattering(0.02, 0.2, 0.2) + "[[sea.layer]]\nbottom_depth_m = 2.0\n" +
    scattering(0.05, 0.0, 0.3) + "[[sea.layer]]\nbottom_depth_m = 3.5\n" +
    scattering(0.05, 0.6, 0.3);

/// A lens so wide and tilted that its points are at depths that differ, and that analog photons
/// find it.
std::string lens_at(double z) {
  return fmt::format(
      "[[telescope]]\nposition_m = [0.3, 0.1, {}]\ndirection = [0.2, 0.1, {}]\ndiameter_m = 2.0\n"
      "focal_length_m = 4.0\nhalf_field_of_view_mrad = 600.0\n",
      z, z > 0 ? -1.0 : 1.0);
}
std::string laser_at(double z) {
  return fmt::format(
      "[source]\nwavelength_nm = 355.0\nposition_m = [0.0, 0.0, {}]\ndirection = [0.1, 0.0, {}]\n"
      "diameter_m = 0.05\nhalf_divergence_mrad = 40.0\n",
      z, z > 0 ? -1.0 : 1.0);
}

struct Place {
  const char* name;
  double laser, lens;
  std::string bottom = "[bottom]\nalbedo = 0.3\n";
};
const Place places[] = {{"the laser in the water", -0.5, 4},
                        {"the telescope in the water", 4, -1.5},
                        {"both in the water, over a black bed", -0.4, -1.5, ""}};

scene::Scene scene_of(const Place& place, const std::string& surface, double photons,
                      const std::string& estimator, const std::string& environment = "",
                      std::uint64_t seed = 21) {
  return read(laser_at(place.laser) + lens_at(place.lens) + channel("raman") + channel("elastic") +
              "[sea]\nsurface = { " + surface + " }\n" + air_and_water + place.bottom +
              "[gates]\nstart_ns = 0.0\nstop_ns = 60.0\nstep_ns = 10.0\n" + environment +
              simulation(photons, seed, "", estimator));
}
tally::Result run_of(const Place& place, const std::string& surface, double photons,
                     const std::string& estimator) {
  return run_in_lanes(scene_of(place, surface, photons, estimator));
}

/// Chance alone decides there by which way light comes, and what has touched it. Seen red: without
/// the delay of the water before a lens; with the depth of its centre for all of its points; with
/// light of a laser in the water that does not pass the surface unscattered; without a bed, with
/// light of the air counted as the water's where analog photons come to a lens.
TEST(InstrumentsUnderAir, SeeTheLightThatPhotonsMeetByChance) {
  for (const Place& place : places)
    for (const auto& surface : {flat, waves}) {
      const auto analog = run_of(place, surface, 1e7, "analog");
      const auto forward = run_of(place, surface, 4e5, "forward");
      expect_same_light(analog, forward, fmt::format("{}, {}", place.name, surface), 0.06, 10);
      EXPECT_NEAR(forward.ledger.sum(), 1, 5 * forward.ledger_standard_error + 1e-6);
      EXPECT_NEAR(analog.ledger.sum(), 1, 5 * analog.ledger_standard_error + 1e-6);
    }
}

/// Walks stay in the water; what the air scatters is left to histories beside them.
TEST(InstrumentsUnderAir, BothEstimatorsFindTheirLight) {
  for (const Place& place : places)
    for (const auto& surface : {flat, waves}) {
      const auto forward = run_of(place, surface, 4e5, "forward");
      const auto both = run_of(place, surface, 4e4, "bidirectional");
      expect_same_light(forward, both, fmt::format("both estimators, {}, {}", place.name, surface),
                        0.08, 12);
    }
}

/// Darker water weakens light of the air once more, on its way to a lens there or from a laser.
/// Seen red: without the excess depth of the water before a lens.
TEST(InstrumentsUnderAir, HaveTheEnvironmentsOfTheirOwnRuns) {
  const std::string darker =
      "[[environment]]\nset = { \"sea.layer.0.iop.0.a_per_m\" = 0.12, "
      "\"atmosphere.layer.0.iop.0.a_per_m\" = 0.05 }\n";
  for (const Place& place : places)
    for (const auto& surface : {flat, waves}) {
      const auto all = run_in_lanes(scene_of(place, surface, 2e5, "forward", darker));
      const auto own = scene_of(place, surface, 2e5, "forward", darker, 22);
      ZFamily family(0.01);
      const std::string name = fmt::format("{}, {}", place.name, surface);
      compare_environment(all, 0, run_in_lanes(scene::scene_in(own, own.environment[0])), family,
                          name);
      std::printf("%s: %zu cells, rms z %.2f\n", name.c_str(), family.size(), family.rms());
      EXPECT_GE(family.size(), 3U);
      family.judge();
    }
}

}  // namespace
}  // namespace photic::test
