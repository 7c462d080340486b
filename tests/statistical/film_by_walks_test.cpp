// A film of oil in the bidirectional estimator, against the forward one.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "support/films.hpp"
#include "support/runs.hpp"
#include "support/same_light.hpp"
#include "support/scenes.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

/// A lidar's text without the telescopes below the surface.
std::string above_water(const std::string& lidar) {
  return lidar.substr(0, lidar.find("[[telescope]]\nname = \"below\""));
}

// Both estimators have the same light of the water, by gates and by orders: down and up through the
// film, and sent back by it, of all from below that cannot leave the water, too.
// Seen red: with what the film absorbs of light that facets send back left to walks from
// telescopes.
TEST(OilFilm, IsCrossedAlikeByBothEstimators) {
  for (const auto& [surface, sets] : {std::pair{flat, 5e4}, {waves, 8e4}}) {
    const std::string scene =
        instrument(12, 10, 355) + of_water + film(25) + "[sea]\nsurface = { " + surface + " }\n" +
        "[[sea.layer]]\nbottom_depth_m = 6.0\niop = [{ wavelength_nm = 355.0, a_per_m = 0.02, "
        "b_per_m = 0.6 }, { wavelength_nm = 800.0, a_per_m = 0.02, b_per_m = 0.6 }]\n"
        "phase_function = { model = \"henyey-greenstein\", g = 0.3 }\n[bottom]\nalbedo = 0.5\n"
        "[gates]\ndepth_max_m = 20.0\ndepth_step_m = 4.0\n";
    const auto forward = run_in_lanes(read(scene + simulation(10 * sets, 31)));
    const auto walks = run_in_lanes(read(scene + simulation(sets, 32, "", "bidirectional")));
    ZFamily family(0.01);
    const auto& f = forward.grid("echo_by_order");
    const auto& b = walks.grid("echo_by_order");
    for (std::size_t i = 0; i < f.mean.size(); ++i) {
      if (!(f.standard_error[i] < 0.03 * f.mean[i] && b.standard_error[i] < 0.03 * b.mean[i]))
        continue;
      family.add(b.mean[i], f.mean[i], std::hypot(f.standard_error[i], b.standard_error[i]),
                 fmt::format("{} cell {}", surface, i));
    }
    std::printf("%s: %zu cells, rms z %.2f\n", surface.c_str(), family.size(), family.rms());
    EXPECT_GE(family.size(), 10U);
    EXPECT_LT(family.rms(), 1.3);
    family.judge();
  }
}

// The film takes as much of the laser's light by the accounts of walks, on the way in and of light
// from below.
// Seen red: with what the film absorbs on the way in left to what escapes, flat and on waves; on
// waves with that of light from below.
TEST(OilFilm, TakesAlikeByTheAccountsOfBothEstimators) {
  for (const auto& surface : {flat, waves}) {
    const std::string scene =
        instrument(12, 10, 355) + channel("elastic") + film(2) + "[sea]\nsurface = { " + surface +
        " }\n[[sea.layer]]\nbottom_depth_m = 6.0\niop = [{ wavelength_nm = 355.0, " +
        "a_per_m = 0.2, b_per_m = 0.6 }]\n" +
        "phase_function = { model = \"henyey-greenstein\", g = 0.3 }\n[bottom]\nalbedo = 0.5\n"
        "[gates]\ndepth_max_m = 20.0\ndepth_step_m = 20.0\n";
    const auto forward =
        run_in_lanes(read(scene + simulation(1.6e5, 33, "directed_fraction = 0.0"))).ledger;
    const auto walks =
        run_in_lanes(read(scene + simulation(4e4, 34, no_free_walks, "bidirectional")));
    std::printf("%s: oil %.4f and %.4f, escaped %.4f and %.4f\n", surface.c_str(), walks.ledger.oil,
                forward.oil, walks.ledger.escaped, forward.escaped);
    EXPECT_NEAR(walks.ledger.oil, forward.oil, 0.02 * forward.oil) << surface;
    EXPECT_NEAR(walks.ledger.escaped, forward.escaped, 0.02 * forward.escaped) << surface;
    EXPECT_NEAR(walks.ledger.sum(), 1, 5 * walks.ledger_standard_error + 1e-6) << surface;
  }
}

struct BothEstimators {
  const char* name;
  std::string scene;
  double photons, sets;
  std::size_t least;  ///< cells that are to be compared
  std::string settings = "";
};
/// Gate by gate, process by process and order by order.
void expect_both_estimators_agree(const BothEstimators& c) {
  const auto run = [&](double photons, std::uint64_t seed, const std::string& estimator) {
    return run_in_lanes(
        read(c.scene + simulation(photons, seed, c.settings + no_free_walks, estimator)));
  };
  const auto forward = run(c.photons, 41, "forward"), walks = run(c.sets, 42, "bidirectional");
  expect_same_light(forward, walks, c.name, 0.05, c.least);
  // The accounts are the walks', for which light that the film emits is absorbed.
  EXPECT_NEAR(walks.ledger.sum(), 1, 5 * walks.ledger_standard_error + 1e-6) << c.name;
}
const std::string slick = "[sea]\nsurface = { model = \"cox-munk\", wind_speed_m_s = 5.0 }\n";

// In runs of walks the film's light comes beside these: straight, of light that comes back from
// below, and by way of the water. Few walks are drawn where no other light is asked for.
// Seen red: without the light that telescopes see straight; without that which is sent down.
TEST(OilFilm, ShinesBesideWalks) {
  const std::string undirected = "directed_fraction = 0.0\n";
  const std::string grey =
      "iop = [{ wavelength_nm = 355.0, a_per_m = 0.05, b_per_m = 0.5 }, "
      "{ wavelength_nm = 800.0, a_per_m = 0.05, b_per_m = 0.5 }]\n"
      "phase_function = { model = \"henyey-greenstein\", g = 0.3 }\n";
  const std::string bright = channel("oil") + film(2, "yield = 0.45\n");
  const std::string gates = "[gates]\nstart_ns = 5.0\nstop_ns = 101.0\nstep_ns = 24.0\n";
  expect_both_estimators_agree(
      {"a slick", above_water(wide_lenses()) + bright + slick + "[[sea.layer]]\n" + grey + gates,
       8e5, 8e5, 8, undirected});
  expect_both_estimators_agree(
      {"three layers over a bed",
       wide_lenses() + bright + "[[sea.layer]]\nbottom_depth_m = 1.0\n" + grey +
           "[[sea.layer]]\nbottom_depth_m = 2.0\nchlorophyll_mg_m3 = 2.0\n" +
           "[[sea.layer]]\nbottom_depth_m = 5.0\n" + grey + "[bottom]\nalbedo = 0.4\n" + gates,
       8e5, 8e5, 8, undirected});
}

// With all other light: filters see it together, and none of it is counted twice.
// Seen red: with elastic light scored beside the walks, too; with the surface's own echo, and the
// film's first light, scored twice; with the weights of both in the accounts.
TEST(OilFilm, ShinesWithAllOtherLightBesideWalks) {
  const std::string gates = "[gates]\ndepth_min_m = -1.0\ndepth_max_m = 8.0\ndepth_step_m = 3.0\n";
  expect_both_estimators_agree(
      {"filters",
       instrument(12, 15, 355) +
           "[[channel]]\nname = \"raman line\"\ncentre_nm = 404.0\nfwhm_nm = 12.0\n"
           "[[channel]]\nname = \"blue\"\ncentre_nm = 450.0\nfwhm_nm = 40.0\n" +
           film(5, "yield = 0.01\n") +
           "[[sea.layer]]\nchlorophyll_mg_m3 = 0.1\ncdom_a440_per_m = 0.05\n" + gates,
       5e5, 6e4, 15});
  expect_both_estimators_agree(
      {"a slick",
       instrument(12, 15, 355) + channel("oil") + of_water + film(10) + slick + clear_water + gates,
       1e6, 1e5, 20});
}

}  // namespace
}  // namespace photic::test
