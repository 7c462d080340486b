// A film of oil on the sea: its light by closed forms, and by photons that chance alone leads
// through it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "core/constants.hpp"
#include "optics/film.hpp"
#include "optics/library.hpp"
#include "optics/oil.hpp"
#include "optics/refractive_index.hpp"
#include "optics/sea_slopes.hpp"
#include "support/films.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

/// Photons of the first order in a channel's first gate, and their error.
struct Echo {
  double mean = 0, error = 0;
};
Echo first_order(const tally::Result& r, std::size_t channel) {
  const std::size_t i = (channel * r.orders() + 1) * r.gates();
  return {r.grid("echo_by_order").mean[i], r.grid("echo_by_order").standard_error[i]};
}

/// Of a narrow filter: the laser's light comes down to a flat film of crude oil and light of the
/// film comes straight back.
double expected(double height, double off_nadir_deg, double laser_nm, double centre_nm,
                double fwhm_nm, double thickness_um) {
  const auto oil = optics::oil(*test::tables(), "weakly-absorbing-crude");
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

/// Water that scatters so many times per metre.
std::string layer(double bottom_depth_m, double b_per_m) {
  return fmt::format(
      "[[sea.layer]]\nbottom_depth_m = {0}\niop = [{{ wavelength_nm = 355.0, a_per_m = 0.05, "
      "b_per_m = {1} }}, {{ wavelength_nm = 800.0, a_per_m = 0.05, b_per_m = {1} }}]\n"
      "phase_function = {{ model = \"henyey-greenstein\", g = 0.3 }}\n",
      bottom_depth_m, b_per_m);
}

// Process by process and order by order: the film's own light, straight, of light that comes back
// from below, and by way of the water; Raman and elastic light through the film. Analog photons
// know nothing of closed forms: they are refracted, reflected, absorbed and emitted one by one.
// Seen red: with emission from below taken for one from above; without the weight of those that are
// not converted; with all that does not pass the film reflected.
//
// The water about the lens below does not scatter. If it does, scores of the forward estimator go
// as 1/r^2 near the lens and have no finite variance: with 0.5/m there, elastic light of the first
// gate is (1.0 +- 0.35) % low with 1e6 photons, and 0.5 +- 0.2 with 5e7, at standard errors of 0.5
// to 1.6 % and of 0.17 %. The bidirectional estimator agrees with analog photons within 0.4 %.
TEST(OilFilm, IsThatWhichPhotonsMeetByChance) {
  for (const double um : {2.0, 30.0}) {
    const std::string scene = wide_lenses() + channel("oil") + channel("raman") +
                              channel("elastic") + film(um, "yield = 0.45\n") + layer(0.4, 0.5) +
                              layer(1.6, 0) + layer(3, 0.5) +
                              "[bottom]\nalbedo = 0.4\n"
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
    compare(forward.grid("echo_by_process"), analog.grid("echo_by_process"), "process");
    compare(forward.grid("echo_by_order"), analog.grid("echo_by_order"), "order");
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
  const auto oil = optics::oil(*test::tables(), "weakly-absorbing-crude");
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

// One run finds films: the thickness from the Raman light that they take, by the formula with
// interfaces. What it leaves out is 6e-4 um here: a film also sends back more of the light that
// comes from the water.
TEST(OilFilm, IsAsThickAsTheMissingRamanLightShows) {
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

}  // namespace
}  // namespace photic::test
