// A film of oil under air that scatters: light of the film goes up and down, and comes back to it
// from both sides.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "run/run.hpp"
#include "support/films.hpp"
#include "support/runs.hpp"
#include "support/same_light.hpp"
#include "support/scenes.hpp"

namespace photic::test {
namespace {

/// A lidar whose lens lies in clear air, as near scattering makes tails of single scores heavy.
std::string lidar_above(double lens_m, double view_mrad) {
  return fmt::format(
      "[source]\nwavelength_nm = 355.0\nposition_m = [0.0, 0.0, 4.0]\ndirection = [0.2, 0.0, "
      "-1.0]\n"
      "diameter_m = 0.05\nhalf_divergence_mrad = 40.0\n[[telescope]]\n"
      "position_m = [0.3, 0.1, 4.0]\ndirection = [0.1, 0.0, -1.0]\ndiameter_m = {}\n"
      "focal_length_m = 4.0\nhalf_field_of_view_mrad = {}\n",
      lens_m, view_mrad);
}
const std::string air_and_water =
    "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 2.0\n" +
    scattering(0.02, 0.3, 0.2) + "[[sea.layer]]\nbottom_depth_m = 2.0\n" +
    scattering(0.05, 0.5, 0.3) + "[bottom]\nalbedo = 0.4\n";
const std::string times = "[gates]\nstart_ns = 10.0\nstop_ns = 74.0\nstep_ns = 8.0\n";

scene::Scene scene_of(const std::string& instrument, const std::string& surface,
                      const std::string& settings) {
  return read(instrument + channel("oil") + channel("raman") + channel("elastic") +
              film(3, "yield = 0.45\n") + "[sea]\nsurface = { " + surface + " }\n" + air_and_water +
              times + settings);
}

// Seen red: with rays that begin above the air on a plane across the axis, where some of a tilted
// lens's are within it already (2 % of a gate).
TEST(FilmUnderAir, BothEstimatorsFindItsLight) {
  for (const auto& surface : {flat, waves}) {
    const auto run_by = [&](double photons, const std::string& estimator) {
      return run_in_lanes(
          scene_of(lidar_above(1, 120), surface, simulation(photons, 11, "", estimator)));
    };
    const auto forward = run_by(6e5, "forward");
    const auto both = run_by(6e4, "bidirectional");
    expect_same_light(forward, both, "both estimators, " + surface, 0.05, 25);
    EXPECT_NEAR(forward.ledger.sum(), 1, 5 * forward.ledger_standard_error + 1e-6);
  }
}

// The film is met face by face there, flat or on facets (film_by_chance.hpp, facet_by_chance.hpp).
// Seen red: with the film's light not passed on into the other medium; with what the laser's light
// excites straight counted in the air as well; with the film's index against air in the air's
// world.
TEST(FilmUnderAir, IsThatWhichPhotonsMeetByChance) {
  for (const auto& surface : {flat, waves}) {
    const auto run_by = [&](double photons, const std::string& more, const std::string& estimator) {
      return run_in_lanes(
          scene_of(lidar_above(3, 600), surface, simulation(photons, 12, more, estimator)));
    };
    const auto analog = run_by(4e6, "", "analog");
    const auto forward = run_by(4e5, "directed_fraction = 0.0", "forward");
    expect_same_light(analog, forward, "by chance, " + surface, 0.06, 18);
  }
}

}  // namespace
}  // namespace photic::test
