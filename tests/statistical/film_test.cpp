// A film of oil on the sea: its light by closed forms, and by photons that chance alone leads
// through it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/constants.hpp"
#include "optics/data_folder.hpp"
#include "optics/film.hpp"
#include "optics/fresnel.hpp"
#include "optics/library.hpp"
#include "optics/oil.hpp"
#include "optics/refractive_index.hpp"
#include "optics/sea_slopes.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

std::string film(double thickness_um, const std::string& more = "") {
  return fmt::format(
      "[oil]\nclass = \"weakly-absorbing-crude\"\nthickness_um = {}\n"
      "lifetime_ns = 0.0\n{}",
      thickness_um, more);
}
/// A thin beam and a lens of 0.4 m beside each other, looking off nadir.
std::string instrument(double height, double off_nadir_deg, double laser_nm) {
  const double t = off_nadir_deg * radian_per_degree;
  const std::string place =
      fmt::format("position_m = [0.0, 0.0, {}]\ndirection = [{:.15g}, 0.0, {:.15g}]\n", height,
                  std::sin(t), -std::cos(t));
  return fmt::format(
      "[source]\nwavelength_nm = {1}\n{0}diameter_m = 1e-6\nhalf_divergence_mrad = 0.1\n"
      "[[telescope]]\n{0}diameter_m = 0.4\nfocal_length_m = 1.0\nhalf_field_of_view_mrad = 50.0\n",
      place, laser_nm);
}
const std::string two_gates =
    "[gates]\ndepth_min_m = -1.0\ndepth_max_m = 3.0\ndepth_step_m = 2.0\n";
const std::string clear_water = "[[sea.layer]]\nchlorophyll_mg_m3 = 0.1\n";

/// Photons of the first order in a channel's first gate, and their error.
struct Echo {
  double mean = 0, error = 0;
};
Echo first_order(const tally::Result& r, std::size_t channel) {
  const std::size_t i = (channel * static_cast<std::size_t>(r.orders) + 1) * r.gates();
  return {r.echo_by_order.mean[i], r.echo_by_order.standard_error[i]};
}

/// Of a narrow filter: the laser's light comes down to a flat film of crude oil and light of the
/// film comes straight back.
double expected(double height, double off_nadir_deg, double laser_nm, double centre_nm,
                double fwhm_nm, double thickness_um) {
  const optics::Library library(optics::find_data_folder());
  const auto oil = optics::oil(library, "weakly-absorbing-crude");
  const auto on_water = [&](double nm) {
    return optics::FilmOnWater<double>{
        {oil.refractive_index(nm), oil.absorption_per_m(nm) * thickness_um * 1e-6},
        optics::refractive_index(nm, 35, 20)};
  };
  const double cosine = std::cos(off_nadir_deg * radian_per_degree);
  const double photons = optics::emission_above(oil, laser_nm)
                             .photons(centre_nm - fwhm_nm / 2, centre_nm + fwhm_nm / 2);
  const double distance = height / cosine;
  return photons *
         optics::film_emission(on_water(laser_nm), true, cosine, on_water(centre_nm), true,
                               cosine) *
         pi * 0.04 / (distance * distance);
}

TEST(OilFilm, ShinesFlatAsTheClosedFormHasIt) {
  ZFamily family(0.01);
  for (const double deg : {0.0, 20.0, 50.0})
    for (const double um : {0.1, 10.0}) {
      const auto r = run_in_lanes(
          read(instrument(12, deg, 355) + "[[channel]]\nname = \"c\"\ncentre_nm = 455.0\n" +
               "fwhm_nm = 2.0\n" + film(um) + clear_water + two_gates + simulation(2e5, 3)));
      const Echo echo = first_order(r, 0);
      // The lens is not a point: 1e-4 of it at 12 m; the line stands for 2 nm of the spectrum.
      const double value = expected(12, deg, 355, 455, 2, um);
      family.add(echo.mean, value, std::hypot(echo.error, 5e-4 * value),
                 fmt::format("{} um, {} off", um, deg));
      EXPECT_LT(echo.error, 2e-3 * value);
    }
  family.judge();
}

/// Photons of the laser near a film, wide lenses above it and below it.
std::string wide_lenses() {
  return "[source]\nwavelength_nm = 355.0\nposition_m = [0.0, 0.0, 1.0]\n"
         "direction = [0.3, 0.0, -1.0]\ndiameter_m = 0.05\nhalf_divergence_mrad = 50.0\n"
         "[[telescope]]\nname = \"above\"\nposition_m = [0.8, 0.2, 1.0]\n"
         "direction = [-0.2, 0.0, -1.0]\ndiameter_m = 1.5\nfocal_length_m = 3.0\n"
         "half_field_of_view_mrad = 700.0\n"
         "[[telescope]]\nname = \"below\"\nposition_m = [0.3, 0.0, -1.0]\n"
         "direction = [0.2, 0.1, 1.0]\ndiameter_m = 1.0\nfocal_length_m = 2.0\n"
         "half_field_of_view_mrad = 800.0\n";
}

/// A lidar's text without the telescopes below the surface.
std::string above_water(const std::string& lidar) {
  return lidar.substr(0, lidar.find("[[telescope]]\nname = \"below\""));
}

// Process by process and order by order: the film's own light, straight, of light that comes back
// from below, and by way of the water; Raman and elastic light through the film. Analog photons
// know nothing of closed forms: they are refracted, reflected, absorbed and emitted one by one.
// Seen red: with emission from below taken for one from above; without the weight of those who are
// not converted; with all that does not pass the film reflected.
TEST(OilFilm, IsThatWhichPhotonsMeetByChance) {
  for (const double um : {2.0, 30.0}) {
    const std::string scene =
        wide_lenses() + channel("oil") + channel("raman") + channel("elastic") +
        film(um, "yield = 0.45\n") +
        "[[sea.layer]]\nbottom_depth_m = 3.0\niop = [{ wavelength_nm = 355.0, a_per_m = 0.05, "
        "b_per_m = 0.5 }, { wavelength_nm = 800.0, a_per_m = 0.05, b_per_m = 0.5 }]\n"
        "phase_function = { model = \"henyey-greenstein\", g = 0.3 }\n[bottom]\nalbedo = 0.4\n"
        "[gates]\nstart_ns = 5.0\nstop_ns = 245.0\nstep_ns = 16.0\n";
    const auto forward = run_in_lanes(read(scene + simulation(1e6, 7, "directed_fraction = 0.0")));
    const auto analog = run_in_lanes(read(scene + simulation(1e7, 8, "", "analog")));
    ZFamily family(0.01);
    std::size_t of_oil = 0;
    const auto compare = [&](const tally::Estimates& f, const tally::Estimates& a,
                             const char* what) {
      for (std::size_t i = 0; i < f.mean.size(); ++i) {
        const double error = std::hypot(f.standard_error[i], a.standard_error[i]);
        if (!(error < 0.1 * a.mean[i] && f.standard_error[i] < 0.03 * a.mean[i])) continue;
        family.add(f.mean[i], a.mean[i], error, fmt::format("{} um, {} {}", um, what, i));
        if (i % (f.mean.size() / 2) < f.mean.size() / 6) ++of_oil;
      }
    };
    compare(forward.echo_by_process, analog.echo_by_process, "process");
    compare(forward.echo_by_order, analog.echo_by_order, "order");
    std::printf("%g um: %zu cells, %zu of oil, rms z %.2f\n", um, family.size(), of_oil,
                family.rms());
    EXPECT_GE(family.size(), 30U);
    EXPECT_LT(family.rms(), 1.3);
    family.judge();
    EXPECT_NEAR(forward.ledger.sum(), 1, 5 * forward.ledger_standard_error + 1e-6);
    EXPECT_NEAR(analog.ledger.sum(), 1, 5 * analog.ledger_standard_error + 1e-6);
    EXPECT_NEAR(forward.ledger.oil, analog.ledger.oil, 0.01 * analog.ledger.oil);
  }
}

/// The integral over all slopes of what facets under oil send back to the lidar, nadir or not, per
/// solid angle.
double over_facets(const optics::SlopeLaw& law, double off_nadir_deg,
                   const std::function<double(double)>& emission) {
  constexpr int steps = 400;
  constexpr double reach = 6;
  const double t = off_nadir_deg * radian_per_degree;
  const double up = std::sqrt(law.upwind_variance), across = std::sqrt(law.crosswind_variance);
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < steps; ++k) {
      const double x = reach * up * (2 * (i + 0.5) / steps - 1);
      const double y = reach * across * (2 * (k + 0.5) / steps - 1);
      const double nz = 1 / std::sqrt(1 + x * x + y * y);
      const double cosine = nz * (std::cos(t) + x * std::sin(t));
      if (cosine <= 0) continue;
      const double seen = cosine / (std::cos(t) * nz);
      sum += law.density(x, y) * seen * emission(cosine);
    }
  return sum * 4 * reach * reach * up * across / (steps * steps);
}

// Facets under oil, of slick waves seen towards the wind: light comes straight back.
// Seen red: with the film level under its facets.
TEST(OilFilm, ShinesOnWavesAsItsFacetsDo) {
  const optics::Library library(optics::find_data_folder());
  const auto oil = optics::oil(library, "weakly-absorbing-crude");
  ZFamily family(0.01);
  for (const double deg : {0.0, 40.0}) {
    constexpr double um = 30, wind = 12;
    const auto r = run_in_lanes(
        read(instrument(12, deg, 355) + "[[channel]]\nname = \"c\"\ncentre_nm = 455.0\n" +
             "fwhm_nm = 2.0\n" + film(um) +
             "[sea]\nsurface = { model = \"cox-munk\", wind_speed_m_s = 12.0, slick = false, "
             "wind_direction_deg = 0.0 }\n" +
             clear_water + two_gates + simulation(4e5, 5)));
    const auto on_water = [&](double nm) {
      return optics::FilmOnWater<double>{
          {oil.refractive_index(nm), oil.absorption_per_m(nm) * um * 1e-6},
          optics::refractive_index(nm, 35, 20)};
    };
    const double distance = 12 / std::cos(deg * radian_per_degree);
    const double per_photon =
        over_facets(optics::cox_munk_slopes(wind, false, true), deg, [&](double cosine) {
          return optics::film_emission(on_water(355), true, cosine, on_water(455), true, cosine);
        });
    const double value = optics::emission_above(oil, 355).photons(454, 456) * per_photon * pi *
                         0.04 / (distance * distance);
    const Echo echo = first_order(r, 0);
    family.add(echo.mean, value, std::hypot(echo.error, 5e-4 * value), fmt::format("{} off", deg));
    EXPECT_LT(echo.error, 3e-3 * value);
  }
  family.judge();
}

/// Of a gate, in an environment and in its own run, where both are known well.
void compare_environment(const tally::Result& all, std::size_t e, const tally::Result& own,
                         ZFamily& family, const std::string& what) {
  const std::size_t cells = own.echo.mean.size();
  for (std::size_t i = 0; i < cells; ++i) {
    const double other = all.environment_echo.standard_error[e * cells + i];
    const double error = std::hypot(other, own.echo.standard_error[i]);
    const bool known =
        own.convergence_flags[i] == 0 && all.environment_convergence_flags[e * cells + i] == 0;
    if (!known || !(error < 0.1 * own.echo.mean[i])) continue;
    family.add(all.environment_echo.mean[e * cells + i], own.echo.mean[i], error,
               fmt::format("{} cell {}", what, i));
  }
}

struct OtherFilm {
  const char* name;
  std::string set, own;
};
const std::vector<OtherFilm>& other_films() {
  static const std::vector<OtherFilm> all{
      {"thinner", "\"oil.thickness_um\" = 3.0", film(3)},
      {"none", "\"oil.thickness_um\" = 0.0", film(0)},
      {"darker", "\"oil.absorption_factor\" = 2.5", film(12, "absorption_factor = 2.5\n")},
      {"brighter", "\"oil.yield\" = 0.05", film(12, "yield = 0.05\n")}};
  return all;
}

// Films of environments are those of their own runs: flat and on waves, of all light.
// Seen red: with the crossings left out, of all ways, of walks' legs, or of ways to telescopes;
// with the emission's ratio left out.
void expect_films_are_their_own_runs(const std::string& lidar, const std::string& surface,
                                     const std::string& estimator, double photons,
                                     std::size_t least) {
  const auto scene = [&](const std::string& oil, const std::string& more, std::uint64_t seed) {
    return read(lidar + oil + "[sea]\nsurface = { " + surface + " }\n" + clear_water +
                "[gates]\ndepth_min_m = -1.0\ndepth_max_m = 8.0\ndepth_step_m = 3.0\n" + more +
                simulation(photons, seed, "", estimator));
  };
  std::string environments;
  for (const auto& f : other_films())
    environments += fmt::format("[[environment]]\nname = \"{}\"\nset = {{ {} }}\n", f.name, f.set);
  const auto all = run_in_lanes(scene(film(12), environments, 21));
  ZFamily family(0.01);
  for (std::size_t e = 0; e < other_films().size(); ++e)
    compare_environment(all, e, run_in_lanes(scene(other_films()[e].own, "", 22 + e)), family,
                        other_films()[e].name);
  std::printf("%s, %s: %zu cells, rms z %.2f\n", estimator.c_str(), surface.c_str(), family.size(),
              family.rms());
  EXPECT_GE(family.size(), least);
  family.judge();
}
const std::string flat = R"(model = "flat")";
const std::string waves = R"(model = "cox-munk", wind_speed_m_s = 7.0)";
const std::string of_water = channel("raman") + channel("elastic");

TEST(OilFilm, OfEnvironmentsIsThatOfItsOwnRun) {
  const std::string lidar = instrument(12, 15, 355) + of_water + channel("oil");
  expect_films_are_their_own_runs(lidar, flat, "forward", 1e6, 20);
  expect_films_are_their_own_runs(lidar, waves, "forward", 1e6, 10);
}
TEST(OilFilm, OfEnvironmentsIsThatOfItsOwnRunByWalks) {
  const std::string lidar = instrument(12, 15, 355) + of_water + channel("oil");
  expect_films_are_their_own_runs(lidar, flat, "bidirectional", 2e5, 16);
  expect_films_are_their_own_runs(lidar, waves, "bidirectional", 2e5, 16);
}

// One run tells films from none: the thickness from the Raman light that they take, by the formula
// with interfaces. What it leaves out is 6e-4 um here: a film also sends back more of the light
// that comes from the water.
TEST(OilFilm, IsAsThickAsTheMissingRamanLightTells) {
  for (const auto& [um, within] : {std::pair{10.0, 1e-3}, {1.0, 1e-3}, {0.1, 1e-2}}) {
    const auto r =
        run_in_lanes(read(instrument(12, 0, 355) + channel("raman") + film(um) + clear_water +
                          "[gates]\ndepth_max_m = 4.0\ndepth_step_m = 4.0\n"
                          "[[environment]]\nset = { \"oil.thickness_um\" = 0.0 }\n" +
                          simulation(2e5, 9)));
    const double ratio = r.echo.mean[0] / r.environment_echo.mean[0];
    const double found =
        (-std::log(ratio) + std::log(r.film_interface_ratio[0])) / r.film_attenuation_per_m[0];
    EXPECT_NEAR(found * 1e6, um, within * um) << um;
  }
}

// The derivative by the thickness is that of films a little thicker and thinner.
void expect_derivatives_by_the_film(const std::string& estimator, double photons) {
  const auto r = run_in_lanes(read("sensitivity = [\"oil.thickness_um\", \"oil.yield\"]\n" +
                                   instrument(12, 15, 355) + of_water + channel("oil") +
                                   film(5, "yield = 0.02\n") + clear_water + two_gates +
                                   "[[environment]]\nset = { \"oil.thickness_um\" = 5.05 }\n"
                                   "[[environment]]\nset = { \"oil.thickness_um\" = 4.95 }\n" +
                                   simulation(photons, 11, "", estimator)));
  const std::size_t cells = r.echo.mean.size();
  for (std::size_t i = 0; i < cells; ++i) {
    if (r.echo.mean[i] == 0) continue;
    const double by_steps = (r.environment_echo.mean[i] - r.environment_echo.mean[cells + i]) / 0.1;
    EXPECT_NEAR(r.sensitivity.mean[i], by_steps, 1e-3 * std::abs(by_steps)) << i;
    const bool of_oil = i / r.gates() == 2;
    const double by_yield = r.sensitivity.mean[cells + i] * 0.02;
    EXPECT_NEAR(by_yield, of_oil ? r.echo.mean[i] : 0, 1e-4 * r.echo.mean[i]) << i;
  }
}
TEST(OilFilm, HasDerivativesByItsThickness) {
  expect_derivatives_by_the_film("forward", 1e5);
  expect_derivatives_by_the_film("bidirectional", 2e4);
}

// Both estimators have the same light of the water, by gates and by orders: down and up through the
// film, and sent back by it, of all from below that cannot leave the water, too.
// Seen red: with what the film absorbs of light that facets send back left to walks from
// telescopes.
TEST(OilFilm, IsCrossedAlikeByBothEstimators) {
  for (const auto& [surface, sets] : {std::pair{flat, 5e4}, {waves, 2e5}}) {
    const std::string scene =
        instrument(12, 10, 355) + of_water + film(25) + "[sea]\nsurface = { " + surface + " }\n" +
        "[[sea.layer]]\nbottom_depth_m = 6.0\niop = [{ wavelength_nm = 355.0, a_per_m = 0.02, "
        "b_per_m = 0.6 }, { wavelength_nm = 800.0, a_per_m = 0.02, b_per_m = 0.6 }]\n"
        "phase_function = { model = \"henyey-greenstein\", g = 0.3 }\n[bottom]\nalbedo = 0.5\n"
        "[gates]\ndepth_max_m = 20.0\ndepth_step_m = 4.0\n";
    const auto forward = run_in_lanes(read(scene + simulation(10 * sets, 31)));
    const auto walks = run_in_lanes(read(scene + simulation(sets, 32, "", "bidirectional")));
    ZFamily family(0.01);
    const auto& f = forward.echo_by_order;
    const auto& b = walks.echo_by_order;
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
        run_in_lanes(read(scene + simulation(4e4, 33, "directed_fraction = 0.0"))).ledger;
    const auto walks =
        run_in_lanes(read(scene + simulation(1e4, 34, no_free_walks, "bidirectional")));
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
  ZFamily family(0.01);
  const auto compare = [&](const tally::Estimates& f, const tally::Estimates& b, const char* what) {
    for (std::size_t i = 0; i < f.mean.size(); ++i) {
      const double error = std::hypot(f.standard_error[i], b.standard_error[i]);
      if (!(error < 0.05 * f.mean[i])) continue;
      family.add(b.mean[i], f.mean[i], error, fmt::format("{}, {} {}", c.name, what, i));
    }
  };
  compare(forward.echo_by_process, walks.echo_by_process, "process");
  compare(forward.echo_by_order, walks.echo_by_order, "order");
  std::printf("%s: %zu cells, rms z %.2f\n", c.name, family.size(), family.rms());
  EXPECT_GE(family.size(), c.least) << c.name;
  family.judge();
  // The accounts are the walks', to whom what the film emits is absorbed.
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
       5e5, 5e5, 8, undirected});
  expect_both_estimators_agree(
      {"three layers over a bed",
       wide_lenses() + bright + "[[sea.layer]]\nbottom_depth_m = 1.0\n" + grey +
           "[[sea.layer]]\nbottom_depth_m = 2.0\nchlorophyll_mg_m3 = 2.0\n" +
           "[[sea.layer]]\nbottom_depth_m = 5.0\n" + grey + "[bottom]\nalbedo = 0.4\n" + gates,
       5e5, 5e5, 8, undirected});
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
