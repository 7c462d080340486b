// Echoes against a walk that shares nothing with Photic's: analog photons, each absorbed or not,
// Henyey-Greenstein angles from its inverse, libstdc++'s Mersenne twister, and a real lens and
// detector that a photon hits or misses.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <thread>
#include <vector>

#include "support/runs.hpp"
#include "support/scenes.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

// A big lens high over turbid water, so that analog photons hit it; n, group index and water in
// numbers.
constexpr double height = 30.0, lens_radius = 1.5, focal_length = 2.0, detector_radius = 0.5,
                 detector_shift = 0.06;
constexpr double obstruction_radius = 0.6, index = 1.34, group = 1.36, a = 0.05, b = 0.45, g = 0.4;
constexpr double laser_divergence = 0.02;
constexpr int gates = 8;
constexpr double gate_depth = 1.5;

constexpr double bed_depth = 4.1;  // where there is one

/// Its albedo by the cosine to the vertical of the light that comes down: straight lines over the
/// angle, as the scene has it.
double bed_albedo(double cosine) {
  const double zenith_deg = std::acos(cosine) * 180 / M_PI;
  return zenith_deg < 40 ? 0.3 + 0.3 * zenith_deg / 40 : 0.6 + 0.4 * (zenith_deg - 40) / 50;
}

struct Counts {
  std::array<double, gates> by_gate{}, of_bed{};  ///< all, and what touched the bed
};

struct Detected {
  int gate = -1;  ///< -1: it is not
  bool of_bed = false;
};

/// One photon's life, over a bed or in deep water.
Detected analog_photon(std::mt19937_64& random, bool over_bed) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto direction_cosine = [&] {
    const double s = (1 - g * g) / (1 - g + 2 * g * uniform(random));
    return (1 + g * g - s * s) / (2 * g);
  };
  // A point source on the axis with a narrow cone.
  const double tilt = std::acos(1 - uniform(random) * (1 - std::cos(laser_divergence)));
  double azimuth = 2 * M_PI * uniform(random);
  double kx = std::sin(tilt) * std::cos(azimuth), ky = std::sin(tilt) * std::sin(azimuth),
         kz = -std::cos(tilt);
  double x = height * kx / -kz, y = height * ky / -kz, z = 0, path = height / -kz;
  const auto reflectance = [](double n1, double n2, double c1) {
    const double s2 = n1 / n2 * std::sqrt(1 - c1 * c1);
    if (s2 >= 1) return 1.0;
    const double c2 = std::sqrt(1 - s2 * s2);
    const double rs = (n1 * c1 - n2 * c2) / (n1 * c1 + n2 * c2);
    const double rp = (n1 * c2 - n2 * c1) / (n1 * c2 + n2 * c1);
    return (rs * rs + rp * rp) / 2;
  };
  bool of_bed = false;
  if (uniform(random) < reflectance(1, index, -kz)) return {};
  kx /= index, ky /= index, kz = -std::sqrt(1 - kx * kx - ky * ky);
  while (true) {
    const double s = -std::log(1 - uniform(random)) / (a + b);
    if (z + s * kz > 0) {
      const double to_surface = -z / kz;
      x += to_surface * kx, y += to_surface * ky, z = 0, path += to_surface * group;
      if (uniform(random) >= reflectance(index, 1, kz)) break;  // out
      kz = -kz;
      continue;
    }
    if (over_bed && z + s * kz < -bed_depth) {
      const double to_bed = (-bed_depth - z) / kz;
      x += to_bed * kx, y += to_bed * ky, z = -bed_depth, path += to_bed * group;
      if (uniform(random) >= bed_albedo(-kz)) return {};
      of_bed = true;
      const double sine = std::sqrt(uniform(random));
      azimuth = 2 * M_PI * uniform(random);
      kx = sine * std::cos(azimuth), ky = sine * std::sin(azimuth), kz = std::sqrt(1 - sine * sine);
      continue;
    }
    x += s * kx, y += s * ky, z += s * kz, path += s * group;
    if (path > 2 * height + 2 * (gates * gate_depth + 1) * group) return {};
    if (uniform(random) >= b / (a + b)) return {};
    const double c = direction_cosine();
    const double sine = std::sqrt(1 - c * c);
    azimuth = 2 * M_PI * uniform(random);
    const double cx = std::cos(azimuth) * sine, cy = std::sin(azimuth) * sine;
    const double across = std::sqrt(1 - kz * kz);
    if (across < 1e-8) {
      kx = cx, ky = cy, kz = kz > 0 ? c : -c;
    } else {
      const double nx = (kx * kz * cx - ky * cy) / across + kx * c;
      const double ny = (ky * kz * cx + kx * cy) / across + ky * c;
      kz = -across * cx + kz * c, kx = nx, ky = ny;
    }
  }
  // Refracted into the air, to the lens, through it, onto the detector.
  kx *= index, ky *= index, kz = std::sqrt(1 - kx * kx - ky * ky);
  const double to_lens = height / kz;
  x += to_lens * kx, y += to_lens * ky, path += to_lens;
  const double r = std::hypot(x, y);
  if (r > lens_radius || r < obstruction_radius) return {};
  const double distance = focal_length + detector_shift;
  const double dx = x + distance * (kx / kz - x / focal_length),
               dy = y + distance * (ky / kz - y / focal_length);
  if (std::hypot(dx, dy) > detector_radius) return {};
  const double depth = (path - 2 * height) / (2 * group);
  return {depth < gates * gate_depth ? static_cast<int>(depth / gate_depth) : -1, of_bed};
}

Counts analog_counts(std::uint64_t photons, bool over_bed) {
  constexpr unsigned streams = 4;
  std::array<Counts, streams> counts;
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < streams; ++i) {
    threads.emplace_back([&counts, i, photons, over_bed] {
      std::mt19937_64 random(1234 + i);
      for (std::uint64_t n = 0; n < photons / streams; ++n) {
        const auto [gate, of_bed] = analog_photon(random, over_bed);
        if (gate < 0) continue;
        counts[i].by_gate[static_cast<std::size_t>(gate)] += 1;
        if (of_bed) counts[i].of_bed[static_cast<std::size_t>(gate)] += 1;
      }
    });
  }
  threads.clear();
  for (unsigned i = 1; i < streams; ++i) {
    for (std::size_t k = 0; k < gates; ++k) {
      counts[0].by_gate[k] += counts[i].by_gate[k];
      counts[0].of_bed[k] += counts[i].of_bed[k];
    }
  }
  return counts[0];
}

std::string scene_of(const std::string& estimator, double photons, bool over_bed) {
  const std::string bed = fmt::format(
      "bottom_depth_m = {}\n[bottom]\nalbedo = {{ zenith_deg = [0, 40, 90], albedo = "
      "[0.3, 0.6, 1.0] }}\n",
      bed_depth);
  return fmt::format(R"(
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, {height}]
direction = [0.0, 0.0, -1.0]
diameter_m = 1e-6
half_divergence_mrad = {divergence}
[[telescope]]
position_m = [0.0, 0.0, {height}]
direction = [0.0, 0.0, -1.0]
diameter_m = {lens}
focal_length_m = {focal}
detector_diameter_m = {detector}
detector_shift_m = {shift}
obstruction_diameter_m = {obstruction}
[[channel]]
name = "elastic"
process = "elastic"
[sea]
refractive_index = {index}
group_index = {group}
[[sea.layer]]
iop = [ {{ wavelength_nm = 532.0, a_per_m = {a}, b_per_m = {b} }} ]
phase_function = {{ model = "henyey-greenstein", g = {g} }}
{bed}[gates]
depth_max_m = {depth}
depth_step_m = {step}
[simulation]
estimator = "{estimator}"
photons = {photons:.0f}
seed = 3
)",
                     fmt::arg("height", height), fmt::arg("divergence", laser_divergence * 1e3),
                     fmt::arg("lens", 2 * lens_radius), fmt::arg("focal", focal_length),
                     fmt::arg("detector", 2 * detector_radius), fmt::arg("shift", detector_shift),
                     fmt::arg("obstruction", 2 * obstruction_radius), fmt::arg("index", index),
                     fmt::arg("group", group), fmt::arg("a", a), fmt::arg("b", b), fmt::arg("g", g),
                     fmt::arg("depth", gates * gate_depth), fmt::arg("step", gate_depth),
                     fmt::arg("bed", over_bed ? bed : ""), fmt::arg("estimator", estimator),
                     fmt::arg("photons", photons));
}

constexpr double min_counts = 200;

/// Adds an echo, or a part of it, and counts of so many photons that it is to be the mean of.
void add(ZFamily& family, const tally::Estimates& echo, std::size_t first,
         const std::array<double, gates>& counts, std::uint64_t photons) {
  for (std::size_t k = 0; k < gates; ++k) {
    if (counts[k] < min_counts) continue;
    const double share = counts[k] / static_cast<double>(photons);
    const double error = std::sqrt(share / static_cast<double>(photons));
    family.add(echo.mean[first + k], share, std::hypot(error, echo.standard_error[first + k]),
               fmt::format("gate {}: {} +- {}, analog {} +- {}", k, echo.mean[first + k],
                           echo.standard_error[first + k], share, error));
  }
}

// Seen red: obstruction ignored; refraction factor without n^2.
TEST(AnalogDetector, CountsWhatTheLocalEstimateExpects) {
  const auto result = run_in_lanes(read(scene_of("forward", 2e6, false)));
  constexpr std::uint64_t photons = 40'000'000;
  ZFamily family(0.01);
  add(family, result.echo, 0, analog_counts(photons, false).by_gate, photons);
  EXPECT_EQ(family.size(), gates);
  // Most of it is multiple scattering, or the test would show little.
  EXPECT_LT(result.grid("echo_by_order").mean[2 * gates - 1], 0.5 * result.echo.mean[gates - 1]);
  family.judge();
}

// All three estimators, over a bed whose albedo depends on the angle. Seen red: with the cosine
// left out of the density of Lambert's law, in photons and in walks.
TEST(AnalogDetector, CountsWhatTheBedReflects) {
  constexpr std::uint64_t photons = 12'000'000;
  const Counts counts = analog_counts(photons, true);
  for (const auto& [estimator, histories] :
       {std::pair{"forward", 1e6}, {"bidirectional", 2e5}, {"analog", 4e6}}) {
    SCOPED_TRACE(estimator);
    const auto result = run_in_lanes(read(scene_of(estimator, histories, true)));
    ZFamily family(0.01);
    add(family, result.echo, 0, counts.by_gate, photons);
    ASSERT_EQ(result.process_names()[1], "bottom");
    add(family, result.grid("echo_by_process"), gates, counts.of_bed, photons);
    EXPECT_GE(family.size(), 9U);
    family.judge();
  }
}

}  // namespace
}  // namespace photic::test
