// Echoes over a rough sea: closed forms of the surface's own, numbers of other programs, and the
// forward estimator against photons that chance alone leads from facet to facet.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/constants.hpp"
#include "optics/fresnel.hpp"
#include "optics/sea_slopes.hpp"
#include "support/lidars_over_waves.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

/// Sum over the gates of a process, and the error of that.
struct Echo {
  double mean = 0, error = 0;
};
Echo echo_of(const tally::Result& r, const std::string& process, std::size_t telescope = 0) {
  const auto names = r.process_names();
  const auto p = static_cast<std::size_t>(std::ranges::find(names, process) - names.begin());
  EXPECT_LT(p, names.size()) << process;
  Echo out;
  for (std::size_t g = 0; g < r.gates(); ++g) {
    const std::size_t i = ((telescope * r.channels() + 0) * names.size() + p) * r.gates() + g;
    out.mean += r.grid("echo_by_process").mean[i];
    out.error = std::hypot(out.error, r.grid("echo_by_process").standard_error[i]);
  }
  return out;
}

/// Of 2 m, one of them above the sea.
const std::string gates = "[gates]\ndepth_min_m = -2.0\ndepth_max_m = 4.0\ndepth_step_m = 2.0\n";
const std::string some_water = water(0.06, 0.10, R"({ model = "henyey-greenstein", g = 0.5 })");

// F0 p A / (4 H^2 cos^3), p being the density of slopes that look back (Cox & Munk's law of 5 m/s,
// from any side of the wind).
TEST(Glint, IsWhatTheSlopesThatLookBackReflect) {
  const double n = 1.34, reflectance = std::pow((n - 1) / (n + 1), 2);
  const auto law = optics::cox_munk_slopes(5, false, true);
  ZFamily family(0.01);
  for (const Lidar& l : {Lidar{}, Lidar{.off_nadir = 10}, Lidar{.off_nadir = 10, .azimuth = 180},
                         Lidar{.off_nadir = 15, .azimuth = 75},
                         Lidar{.height = 705e3, .lens = 1, .view_mrad = 1, .divergence_mrad = 0.01},
                         Lidar{.height = 300,
                         .off_nadir = 20,
                         .azimuth = 200,
                         .lens = 0.3,
                         .view_mrad = 20,
                         .divergence_mrad = 0.1}}) {
    constexpr double wind_from = 30;
    const auto r = run_in_lanes(
        read(instrument(l) + channel("elastic") +
             sea(fmt::format("model = \"cox-munk\", wind_speed_m_s = 5.0, wind_direction_deg = {}, "
                             "whitecaps = false",
                             wind_from),
                 "refractive_index = 1.34\n") +
             some_water + gates + simulation(1e5, 3)));
    const auto [mean, error] = echo_of(r, "surface");
    const double t = l.off_nadir * radian_per_degree;
    // A facet that looks back rises in the direction in which the lidar looks.
    const double away = (l.azimuth - wind_from) * radian_per_degree;
    const double density = law.density(std::tan(t) * std::cos(away), std::tan(t) * std::sin(away));
    const double area = pi * l.lens * l.lens / 4;
    const double expected =
        reflectance * density * area / (4 * l.height * l.height * std::pow(std::cos(t), 3));
    // Half vectors over the lens and the beam differ from the axis by a thousandth.
    family.add(mean, expected, std::hypot(error, 1e-3 * expected),
               fmt::format("{} m, {} off", l.height, l.off_nadir));
    EXPECT_LT(error, 3e-3 * expected);
  }
  family.judge();
}

// Numbers that were integrated elsewhere, of the paper's waves and of one-dimensional slick ones
// under the ship's laser and lens.
TEST(Glint, OfWavesOfOneDirectionIsWhatTheyReflect) {
  const Lidar ship{.lens = 0.4, .divergence_mrad = 5, .laser = 0.04};
  const auto glint = [&](const std::string& surface) {
    return echo_of(run_in_lanes(read(instrument(ship) + channel("elastic") +
                                     sea(surface, "refractive_index = 1.34\n") + some_water +
                                     gates + simulation(1e6, 4))),
                   "surface");
  };
  ZFamily family(0.01);
  const auto paper = glint(R"(model = "paper", wind_speed_m_s = 5.0, wind_direction_deg = 25.0)");
  family.add(paper.mean, 4.4720e-4, std::hypot(paper.error, 1e-8), "paper");
  const auto slick = glint(
      R"(model = "gaussian", upwind_slope_variance = 0.0, crosswind_slope_variance = 0.0158)");
  family.add(slick.mean, 1.0424e-3, std::hypot(slick.error, 2.4e-7), "slick");
  EXPECT_LT(paper.error, 2e-3 * paper.mean);
  family.judge();
}

// Whitecaps at 10 m/s: W R / pi A / H^2 more than what facets leave.
TEST(Whitecaps, HaveAnEchoOfTheirOwn) {
  const auto glint = [&](const std::string& more) {
    return echo_of(
        run_in_lanes(
            read(instrument({}) + channel("elastic") +
                 sea("model = \"cox-munk\", wind_speed_m_s = 10.0, gram_charlier = false" + more) +
                 some_water + gates + simulation(4e5, 5))),
        "surface");
  };
  const auto with = glint(""), without = glint(", whitecaps = false");
  constexpr double fraction = 9.768e-3;
  const double expected = 2.149e-7 / 0.36 * 0.01;  // of a lens of 0.4 m of which 0.36 sees it
  EXPECT_NEAR(with.mean - (1 - fraction) * without.mean, expected,
              4 * std::hypot(with.error, without.error) + 1e-3 * expected);
  EXPECT_LT(with.error, 0.01 * expected);
}

TEST(Waves, BringSingleScatteringToALens) {
  expect_single_scattering(run_in_lanes(single_scattering_through_waves(3e6, "", "forward")), 1e-8);
}

struct Case {
  const char* name;
  std::string surface;
  double off_nadir;
  std::size_t least;  ///< cells that are to be compared
};
/// A laser that shines on the sea from a metre above it, a wide lens on the other side that looks
/// there, and one in the water that looks up.
std::string above_and_below(double off_nadir) {
  const double t = off_nadir * radian_per_degree;
  return fmt::format(
             "[source]\nwavelength_nm = 532.0\nposition_m = [{0}, 0.0, 1.0]\n"
             "direction = [{1}, 0.0, {2}]\ndiameter_m = 0.05\nhalf_divergence_mrad = 50.0\n"
             "[[telescope]]\nname = \"above\"\nposition_m = [{3}, 0.2, 1.0]\n"
             "direction = [{4}, 0.0, {2}]\ndiameter_m = 1.5\nfocal_length_m = 3.0\n"
             "half_field_of_view_mrad = 600.0\n[[telescope]]\nname = \"below\"\n"
             "position_m = [0.3, 0.0, -1.0]\ndirection = [0.2, 0.1, 1.0]\ndiameter_m = 1.0\n"
             "focal_length_m = 2.0\nhalf_field_of_view_mrad = 800.0\n",
             -std::tan(t), std::sin(t), -std::cos(t), std::tan(t), -std::sin(t)) +
         channel("elastic");
}
/// Directions are drawn from the phase functions alone: products of their ratios have a tail.
const std::string plain = "directed_fraction = 0.0";
const std::string ten_gates = "[gates]\nstart_ns = 5.0\nstop_ns = 85.0\nstep_ns = 8.0\n";

/// 3 m of it, which scatter much and far aside.
std::string broad_water(double a_per_m) {
  return "[[sea.layer]]\nbottom_depth_m = 3.0\n" +
         water(a_per_m, 0.4, R"({ model = "henyey-greenstein", g = 0.3 })").substr(14);
}

// Gate by gate, process by process and order by order, of facets and whitecaps, upright and flat
// along the sea, in the air and in the water.
TEST(Waves, AreThoseThatPhotonsMeetByChance) {
  const std::string layer = broad_water(0.05) + "[bottom]\nalbedo = 0.3\n";
  for (const Case& c :
       {Case{"cox-munk",
             "model = \"cox-munk\", wind_speed_m_s = 12.0, wind_direction_deg = 30.0, "
             "whitecap_fraction = 0.3",
             10, 38},
        Case{"flat along the sea",
             "model = \"cox-munk\", wind_speed_m_s = 15.0, "
             "gram_charlier = false, whitecaps = false",
             75, 18},
        Case{"one direction",
             "model = \"paper\", wind_speed_m_s = 3.0, wind_direction_deg = 60.0, "
             "whitecap_fraction = 0.1",
             20, 35}}) {
    const std::string scene = above_and_below(c.off_nadir) + sea(c.surface) + layer + ten_gates;
    const auto forward = run_in_lanes(read(scene + simulation(1e6, 7, plain)));
    const auto analog = run_in_lanes(read(scene + simulation(3e6, 8, "", "analog")));
    ZFamily family(0.01);
    const auto compare = [&](const tally::Estimates& f, const tally::Estimates& a,
                             const char* what) {
      for (std::size_t i = 0; i < f.mean.size(); ++i) {
        const double error = std::hypot(f.standard_error[i], a.standard_error[i]);
        // Counts enough for a Gaussian, and no tail of light near a lens.
        if (!(error < 0.1 * a.mean[i] && f.standard_error[i] < 0.03 * a.mean[i])) continue;
        family.add(f.mean[i], a.mean[i], error, fmt::format("{}, {} {}", c.name, what, i));
      }
    };
    compare(forward.grid("echo_by_process"), analog.grid("echo_by_process"), "process");
    compare(forward.grid("echo_by_order"), analog.grid("echo_by_order"), "order");
    std::printf("%s: %zu cells, rms z %.2f\n", c.name, family.size(), family.rms());
    EXPECT_GE(family.size(), c.least) << c.name;
    EXPECT_LT(family.rms(), 1.3) << c.name;
    family.judge();
    for (std::size_t t : {0U, 1U}) {  // the surface's own echo is among them
      const auto own = echo_of(analog, "surface", t);
      EXPECT_LT(own.error, 0.05 * own.mean) << c.name << " " << t;
    }
    const double sum = forward.ledger.sum(), analog_sum = analog.ledger.sum();
    EXPECT_NEAR(sum, 1, 5 * forward.ledger_standard_error + 1e-6);
    EXPECT_NEAR(analog_sum, 1, 5 * analog.ledger_standard_error + 1e-6);
  }
}

// In peaked water light is sent where the facets by which it will be scored lead it on. Aimed at
// the way by a level surface, errors are three times as large, and lack the rarest light.
TEST(Waves, OfPeakedWaterAreAimedAtByTheirFacets) {
  const auto r = run_in_lanes(read(
      ship_instrument + channel("elastic") + sea("model = \"cox-munk\", wind_speed_m_s = 7.0") +
      water(0.05, 0.1, peaked_phase) + depth_gates(16, 2) + simulation(1e6, 3)));
  double log_error = 0;
  for (std::size_t g = 1; g < r.gates(); ++g)
    log_error +=
        std::log(r.echo.standard_error[g] / r.echo.mean[g]) / static_cast<double>(r.gates() - 1);
  std::printf("error of gates, as a geometric mean: %.4f\n", std::exp(log_error));
  EXPECT_LT(std::exp(log_error), 0.02);
}

// The echo in other water is that of its own run.
TEST(Waves, OverOtherWaterAreItsOwnRun) {
  const auto scene = [&](double a, const std::string& more, std::uint64_t seed) {
    return read(above_and_below(20) +
                sea("model = \"cox-munk\", wind_speed_m_s = 7.0, whitecap_fraction = 0.05") +
                broad_water(a) + more + ten_gates + simulation(1e6, seed, plain));
  };
  const auto all = run_in_lanes(
      scene(0.05, "[[environment]]\nset = { \"sea.layer.0.iop.0.a_per_m\" = 0.15 }\n", 9));
  const auto own = run_in_lanes(scene(0.15, "", 10));
  expect_environment_is(all, own, 6);
}

}  // namespace
}  // namespace photic::test
