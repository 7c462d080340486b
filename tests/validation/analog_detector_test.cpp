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

struct Counts {
  std::array<double, gates> by_gate{};
};

/// One photon's life; returns the gate in which the detector counts it, or -1.
int analog_photon(std::mt19937_64& random) {
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
  if (uniform(random) < reflectance(1, index, -kz)) return -1;
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
    x += s * kx, y += s * ky, z += s * kz, path += s * group;
    if (path > 2 * height + 2 * (gates * gate_depth + 1) * group) return -1;
    if (uniform(random) >= b / (a + b)) return -1;
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
  if (r > lens_radius || r < obstruction_radius) return -1;
  const double distance = focal_length + detector_shift;
  const double dx = x + distance * (kx / kz - x / focal_length),
               dy = y + distance * (ky / kz - y / focal_length);
  if (std::hypot(dx, dy) > detector_radius) return -1;
  const double depth = (path - 2 * height) / (2 * group);
  return depth < gates * gate_depth ? static_cast<int>(depth / gate_depth) : -1;
}

Counts analog_counts(std::uint64_t photons) {
  constexpr unsigned streams = 4;
  std::array<Counts, streams> counts;
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < streams; ++i) {
    threads.emplace_back([&counts, i, photons] {
      std::mt19937_64 random(1234 + i);
      for (std::uint64_t n = 0; n < photons / streams; ++n) {
        const int gate = analog_photon(random);
        if (gate >= 0) counts[i].by_gate[static_cast<std::size_t>(gate)] += 1;
      }
    });
  }
  threads.clear();
  for (unsigned i = 1; i < streams; ++i) {
    for (std::size_t k = 0; k < gates; ++k) counts[0].by_gate[k] += counts[i].by_gate[k];
  }
  return counts[0];
}

// Seen red: obstruction ignored; refraction factor without n^2.
TEST(AnalogDetector, CountsWhatTheLocalEstimateExpects) {
  const auto scene = read(
      fmt::format(R"(
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
[gates]
depth_max_m = {depth}
depth_step_m = {step}
[simulation]
photons = 2000000
seed = 3
)",
                  fmt::arg("height", height), fmt::arg("divergence", laser_divergence * 1e3),
                  fmt::arg("lens", 2 * lens_radius), fmt::arg("focal", focal_length),
                  fmt::arg("detector", 2 * detector_radius), fmt::arg("shift", detector_shift),
                  fmt::arg("obstruction", 2 * obstruction_radius), fmt::arg("index", index),
                  fmt::arg("group", group), fmt::arg("a", a), fmt::arg("b", b), fmt::arg("g", g),
                  fmt::arg("depth", gates * gate_depth), fmt::arg("step", gate_depth)));
  const auto result = run_in_lanes(scene);
  constexpr std::uint64_t photons = 40'000'000;
  const Counts counts = analog_counts(photons);
  ZFamily family(0.01);
  for (std::size_t k = 0; k < gates; ++k) {
    const double share = counts.by_gate[k] / static_cast<double>(photons);
    const double error = std::sqrt(share / static_cast<double>(photons));
    EXPECT_GT(counts.by_gate[k], 200) << "gate " << k;
    family.add(result.echo.mean[k], share, std::hypot(error, result.echo.standard_error[k]),
               fmt::format("gate {}: {} +- {}, analog {} +- {}", k, result.echo.mean[k],
                           result.echo.standard_error[k], share, error));
    // Most of it is multiple scattering, or the test would show little.
    if (k == gates - 1) {
      EXPECT_LT(result.echo_by_order.mean[gates + k], 0.5 * result.echo.mean[k]);
    }
  }
  family.judge();
}

}  // namespace
}  // namespace photic::test
