// Other airs above the sea as environments, and derivatives by them, against runs of their own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "support/own_runs.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

std::string iop(double a, double b) {
  return fmt::format(
      "iop = [ {{ wavelength_nm = 532.0, a_per_m = {0}, b_per_m = {1} }}, "
      "{{ wavelength_nm = 649.0, a_per_m = {0}, b_per_m = {2} }} ]\n",
      a, b, 0.5 * b);
}
/// A ship's lidar, 10 degrees off nadir, in dense air of two layers over water with Raman light.
std::string ship(const std::string& surface) {
  return "[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.0, 12.0]\n"
         "direction = [0.17, 0.0, -1.0]\ndiameter_m = 0.04\nhalf_divergence_mrad = 10.0\n"
         "[[telescope]]\nposition_m = [0.3, 0.0, 12.0]\ndirection = [0.17, 0.0, -1.0]\n"
         "diameter_m = 0.4\nfocal_length_m = 1.0\nhalf_field_of_view_mrad = 60.0\n"
         "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 4.0\n" +
         iop(0.004, 0.02) +
         "phase_function = { model = \"henyey-greenstein\", g = 0.6 }\n"
         "[[atmosphere.layer]]\nbottom_height_m = 4.0\ntop_height_m = 20.0\n" +
         iop(0.0, 0.01) + "[sea]\nsurface = { " + surface + " }\n[[sea.layer]]\n" + iop(0.06, 0.2) +
         "phase_function = { model = \"henyey-greenstein\", g = 0.7 }\n" + channel("elastic") +
         channel("raman") + "[gates]\ndepth_min_m = -8.0\ndepth_max_m = 8.0\ndepth_step_m = 4.0\n";
}
const std::string frees = "free_telescope_meetings = 0.1\nfree_laser_meetings = 0.1";

struct Other {
  const char* name;
  std::string set;
};
const std::string flat = "model = \"flat\"";
const std::string waves = "model = \"cox-munk\", wind_speed_m_s = 6.0";
std::vector<Other> others_under(const std::string& surface) {
  std::vector<Other> all{{"thinner", R"("atmosphere.layer.0.iop.0.b_per_m" = 0.01)"},
                         {"darker, of all light", R"("atmosphere.layer.0.iop.0.a_per_m" = 0.02
                                "atmosphere.layer.0.iop.1.a_per_m" = 0.03)"},
                         {"sharper", R"("atmosphere.layer.0.phase_function.g" = 0.75)"},
                         {"denser high up", R"("atmosphere.layer.1.iop.0.b_per_m" = 0.014)"},
                         {"and darker water", R"("atmosphere.layer.1.iop.0.b_per_m" = 0.007
                            "sea.layer.0.iop.0.a_per_m" = 0.08)"}};
  if (surface == waves)
    all.push_back({"and calmer waves", R"("atmosphere.layer.0.iop.0.b_per_m" = 0.016
                                          "sea.surface.wind_speed_m_s" = 4.0)"});
  return all;
}

void expect_airs_are_their_own_runs(const std::string& surface, const std::string& estimator,
                                    double photons, std::size_t least) {
  const auto others = others_under(surface);
  const auto scene = [&](double of, std::uint64_t seed) {
    std::string text = ship(surface);
    for (const Other& o : others)
      text += fmt::format("[[environment]]\nname = \"{}\"\n[environment.set]\n{}\n", o.name, o.set);
    return read(text + simulation(of, seed, frees, estimator));
  };
  const auto all = run_in_lanes(scene(2 * photons, 31));
  ZFamily family(0.01);
  for (std::size_t e = 0; e < others.size(); ++e) {
    const auto own = scene(photons, 32 + e);
    compare_environment(all, e, run_in_lanes(scene::scene_in(own, own.environment[e])), family,
                        others[e].name);
  }
  std::printf("%s, %s: %zu cells, rms z %.2f\n", estimator.c_str(), surface.c_str(), family.size(),
              family.rms());
  EXPECT_GE(family.size(), least);
  family.judge();
}

// Light of the air, of the water, and of both, elastic and Raman. Seen red, each for itself:
// without the air between the sea and the laser, or the telescopes, reached straight, from waves'
// facets or by light that stands at them; with histories that forget their ratios at the surface,
// or take another's; with the scene's waves above environments; with all parts of the scattering
// alike.
TEST(OtherAirs, AreThoseOfTheirOwnRuns) {
  expect_airs_are_their_own_runs(flat, "forward", 2.5e5, 24);
  expect_airs_are_their_own_runs(waves, "forward", 2.5e5, 20);
}
// Seen red: without the air between the sea and where walks begin, or where they end.
TEST(OtherAirs, AreThoseOfTheirOwnRunsByWalks) {
  expect_airs_are_their_own_runs(flat, "bidirectional", 8e4, 20);
  expect_airs_are_their_own_runs(waves, "bidirectional", 6e4, 16);
}

/// A lidar that looks straight down from a height through air that absorbs so much.
scene::Scene smoke(double height_m, double a, double photons, std::uint64_t seed,
                   const std::string& estimator) {
  const std::string instruments = fmt::format(
      "[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.0, {0}]\n"
      "direction = [0.0, 0.0, -1.0]\ndiameter_m = 0.04\nhalf_divergence_mrad = 5.0\n"
      "[[telescope]]\nposition_m = [0.0, 0.0, {0}]\ndirection = [0.0, 0.0, -1.0]\n"
      "diameter_m = 0.4\nfocal_length_m = 2.0\nfocus_m = {0}\nhalf_field_of_view_mrad = 20.0\n",
      height_m);
  return read(instruments + "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 40.0\n" +
              iop(a, 0.01) + "phase_function = { model = \"henyey-greenstein\", g = 0.6 }\n" +
              "[[sea.layer]]\n" + iop(0.05, 0.1) +
              "phase_function = { model = \"henyey-greenstein\", g = 0.8 }\n" + channel("elastic") +
              fmt::format("[gates]\ndepth_min_m = {}\ndepth_max_m = 12.0\ndepth_step_m = 4.0\n",
                          -height_m + 4) +
              "[[environment]]\nset = { \"atmosphere.layer.0.iop.0.a_per_m\" = 0.001, "
              "\"atmosphere.layer.0.iop.1.a_per_m\" = 0.001 }\n" +
              simulation(photons, seed, no_free_walks, estimator));
}

// From 30 m the scene's own light is weakened by 1e-12 on its way to the sea, and the clear air's
// by 0.7: few walks come so far, and most of their gates are flagged. False alarms: one in a
// hundred for each run. Seen red: with free paths of absorbing air drawn for its scattering alone
// (walks: the air before the sea 1 % low, by 7 standard errors); with histories that play roulette
// by their weight in the scene's air (from 30 m 2 to 3 % low, by 6).
TEST(OtherAirs, MayBeFarClearerThanAbsorbingAir) {
  for (const auto& [estimator, height_m, photons, least] : {std::tuple("forward", 12.0, 4e5, 4U),
                                                            {"forward", 30.0, 4e5, 8U},
                                                            {"bidirectional", 12.0, 4e4, 3U},
                                                            {"bidirectional", 30.0, 4e4, 0U}}) {
    const auto all = run_in_lanes(smoke(height_m, 0.9, photons, 41, estimator));
    const auto own = run_in_lanes(smoke(height_m, 0.001, 1e5, 42, "bidirectional"));
    ZFamily family(0.01);
    compare_environment(all, 0, own, family, fmt::format("{}, {:g} m", estimator, height_m));
    std::printf("%s, %g m: %zu of %zu cells, rms z %.2f\n", estimator, height_m, family.size(),
                all.echo.mean.size(), family.rms());
    EXPECT_GE(family.size(), least);
    if (family.size() > 0) family.judge();
  }
}

// A derivative is that of air, or water, of a little more and less scattering.
TEST(OtherAirs, HaveDerivativesByTheAir) {
  const std::string path = "atmosphere.layer.0.iop.0.b_per_m";
  for (const std::string& surface : {flat, waves})
    for (const auto& [estimator, photons] : {std::pair("forward", 4e4), {"bidirectional", 8e3}}) {
      const std::string water = "sea.layer.0.iop.0.b_per_m";
      const auto r = run::run(
          read(
              fmt::format("sensitivity = [\"{}\", \"{}\"]\n", path, water) + ship(surface) +
              fmt::format("[[environment]]\nset = {{ \"{0}\" = 0.02001 }}\n[[environment]]\nset = "
                          "{{ \"{0}\" = 0.01999 }}\n[[environment]]\nset = {{ \"{1}\" = 0.2001 }}\n"
                          "[[environment]]\nset = {{ \"{1}\" = 0.1999 }}\n",
                          path, water) +
              simulation(photons, 11, frees, estimator)),
          *test::tables(), {});  // in double
      expect_derivative_by_steps(r, 0, 0, 0.00001, fmt::format("{}, {}, air", estimator, surface));
      expect_derivative_by_steps(r, 1, 2, 0.0001, fmt::format("{}, {}, water", estimator, surface));
    }
}

}  // namespace
}  // namespace photic::test
