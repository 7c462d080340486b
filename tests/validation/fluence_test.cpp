// Fluences in water that absorbs and does not scatter, cell by cell against quadrature.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "core/constants.hpp"
#include "support/absorbers.hpp"
#include "support/lit_scenes.hpp"
#include "support/runs.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

constexpr double lamp_x = 2.0, lamp_depth = 1.5;

/// Calls f(row, column) for all cells between edges.
template <class F>
void each_cell(const std::vector<double>& depths, const std::vector<double>& aside, F f) {
  for (std::size_t row = 0; row + 1 < depths.size(); ++row)
    for (std::size_t column = 0; column + 1 < aside.size(); ++column) f(row, column);
}

/// Over depths, in pieces between which the integrand is not smooth: at the lamp and the edge.
template <class F>
double over_depths(F f, double from, double to) {
  double sum = 0;
  for (const double kink : {TwoAbsorbers::edge_m, lamp_depth}) {
    if (kink <= from || kink >= to) continue;
    sum += integral(f, from, kink);
    from = kink;
  }
  return sum + integral(f, from, to);
}

/// Of light to all sides from the lamp, at a distance aside from the vertical through it.
double fluence_at(double depth, double aside) {
  const double down = std::abs(depth - lamp_depth), far = std::hypot(down, aside);
  return std::exp(-TwoAbsorbers::between(depth, lamp_depth, far / down)) / (4 * pi * far * far);
}
/// The same, along a line in y.
double fluence_of_line(double depth, double x) {
  const double down = std::abs(depth - lamp_depth), far = std::hypot(down, x);
  const double straight = TwoAbsorbers::between(depth, lamp_depth, far / down);
  return 2 *
         integral([&](double angle) { return std::exp(-straight / std::cos(angle)); }, 0, pi / 2) /
         (4 * pi * far);
}

const std::string lamp =
    light("cone", fmt::format("position_m = [{}, -1.0, {}]\ndirection = [0, 0, -1]\n"
                              "half_angle_deg = 180",
                              lamp_x, -lamp_depth));

// In rings, and in strips along y, of cells across the layers' edge and beside the lamp. False
// alarms: one in a hundred. Seen red: with weights that do not fall along flights; with one weight
// in all columns that a flight passes.
TEST(Fluence, OfALampToAllSides) {
  const std::vector<double> depths{0.2, 0.7, 1.2, 1.4, 1.6, 2.0, 2.9}, radii{0.0, 0.3, 0.8, 1.5},
      x{1.0, 1.6, 1.9, 2.4, 4.0};
  const auto r = run_in_lanes(
      read(lamp +
           tally_of("fluence", {depths},
                    fmt::format("name = \"rings\"\nradius_m = [{}]", fmt::join(radii, ", "))) +
           tally_of("fluence", {depths},
                    fmt::format("name = \"strips\"\nx_m = [{}]", fmt::join(x, ", "))) +
           TwoAbsorbers::scene(1) + simulation(1e6 * static_cast<double>(seeds_of_tests()), 5)));
  ZFamily family(0.01);
  const auto add = [&](const std::string& name, std::size_t cell, double expected) {
    const Known fluence = known(r, name, cell);
    family.add(fluence.value, expected, fluence.error,
               fmt::format("{} {}: {} for {}", name, cell, fluence.value, expected));
  };
  each_cell(depths, radii, [&](std::size_t row, std::size_t ring) {
    if (row == 3 && ring == 0) return;  // the lamp's own: not smooth
    const double in = radii[ring], out = radii[ring + 1];
    const double sum = over_depths(
        [&](double z) {
          return integral([&](double aside) { return 2 * aside * fluence_at(z, aside); }, in, out);
        },
        depths[row], depths[row + 1]);
    add("fluence_rings", row * 3 + ring,
        sum / ((out * out - in * in) * (depths[row + 1] - depths[row])));
  });
  each_cell(depths, x, [&](std::size_t row, std::size_t strip) {
    if (row == 3 && strip == 2) return;
    const double sum = over_depths(
        [&](double z) {
          return integral([&](double at) { return fluence_of_line(z, at - lamp_x); }, x[strip],
                          x[strip + 1]);
        },
        depths[row], depths[row + 1]);
    add("fluence_strips", row * 4 + strip,
        sum / ((x[strip + 1] - x[strip]) * (depths[row + 1] - depths[row])));
  });
  std::printf("fluence of a lamp: %zu cells, rms z %.2f\n", family.size(), family.rms());
  EXPECT_EQ(family.size(), 40U);
  family.judge();
}

/// A straight way that begins at a place along x, at a distance from the surface, and gets on by
/// so much x per distance.
struct Way {
  double x = 0, distance = 0, slope = 0;
  /// The part of a range of distances in which it is between two places.
  [[nodiscard]] std::pair<double, double> within(double near, double far, double low,
                                                 double high) const {
    const double a = distance + (low - x) / slope, b = distance + (high - x) / slope;
    return {std::max(near, std::min(a, b)), std::min(far, std::max(a, b))};
  }
};

// A ray at 60 degrees from 2 m above the sea: in strips of the clear air, in which it comes down
// and what is reflected goes up, and of the water; and its irradiances.
TEST(Fluence, OfAPencil) {
  constexpr double height = 2.0, index = 1.34, cosine = 0.5;
  const double aslant = std::sqrt(1 - cosine * cosine) / cosine;
  const auto [reflectance, mu] = refracted(cosine, index);
  const std::vector<double> heights{0, 1, 1.5}, air_x{-5, -1.5, 5}, depths{0.2, 0.8, 2.0},
      water_x{-6, -3.5, -2};
  const auto r = run_in_lanes(read(
      light("beam", fmt::format("position_m = [0.5, 0, {}]\nzenith_deg = 60", height)) +
      tally_of("fluence", {{}, heights},
               fmt::format("name = \"air\"\nx_m = [{}]", fmt::join(air_x, ", "))) +
      tally_of("fluence", {depths},
               fmt::format("name = \"water\"\nx_m = [{}]", fmt::join(water_x, ", "))) +
      tally_of("irradiance", {{0.5, 2.5}, {1}}) + TwoAbsorbers::scene(index) + simulation(2e5, 6)));
  const Way down{0.5, height, aslant};  // towards -x as the height falls
  const Way up{0.5 - height * aslant, 0, -aslant};
  const Way under{up.x, 0, -std::sqrt(1 - mu * mu) / mu};
  const auto left = [&, t = 1 - reflectance, mu = mu](double depth) {
    return t * std::exp(-TwoAbsorbers::optical_depth(depth) / mu);
  };
  each_cell(heights, air_x, [&](std::size_t row, std::size_t strip) {
    double path = 0;
    for (const auto& [way, weight] : {std::pair{down, 1.0}, {up, reflectance}}) {
      const auto [near, far] =
          way.within(heights[row], heights[row + 1], air_x[strip], air_x[strip + 1]);
      path += weight * std::max(0.0, far - near) / cosine;
    }
    expect_known(known(r, "fluence_air", row * 2 + strip),
                 path / ((heights[row + 1] - heights[row]) * (air_x[strip + 1] - air_x[strip])),
                 fmt::format("air {} {}", row, strip));
  });
  each_cell(depths, water_x, [&, mu = mu](std::size_t row, std::size_t strip) {
    const auto [near, far] =
        under.within(depths[row], depths[row + 1], water_x[strip], water_x[strip + 1]);
    const double path = far > near ? over_depths(left, near, far) / mu : 0;
    expect_known(known(r, "fluence_water", row * 2 + strip),
                 path / ((depths[row + 1] - depths[row]) * (water_x[strip + 1] - water_x[strip])),
                 fmt::format("water {} {}", row, strip));
  });
  expect_known(known(r, "irradiance_down", 0), 1, "E_d in the air");
  expect_known(known(r, "scalar_irradiance_up", 0), reflectance / cosine, "E_0u in the air");
  expect_known(known(r, "irradiance_down", 1), left(0.5), "E_d");
  expect_known(known(r, "irradiance_down", 2), left(2.5), "E_d");
}

// A disc of light, straight down: as much per area in all rings within it. False alarms: one in a
// hundred.
TEST(Fluence, OfADisc) {
  const std::vector<double> radii{0.0, 0.4, 0.7, 1.0, 1.3};
  const auto r = run_in_lanes(
      read(light("beam", "position_m = [1, 2, 1]\ndirection = [0, 0, -1]\ndiameter_m = 2") +
           tally_of("fluence", {{1, 1.5}}, fmt::format("radius_m = [{}]", fmt::join(radii, ", "))) +
           TwoAbsorbers::scene(1) + simulation(2e5, 7)));
  const double expected =
      integral([](double z) { return std::exp(-TwoAbsorbers::optical_depth(z)); }, 1, 1.5) / 0.5 /
      pi;
  ZFamily family(0.01);
  for (std::size_t ring = 0; ring < 3; ++ring) {
    const Known fluence = known(r, "fluence", ring);
    family.add(fluence.value, expected, fluence.error, fmt::format("ring {}", ring));
  }
  family.judge();
  EXPECT_EQ(known(r, "fluence", 3).value, 0);
}

}  // namespace
}  // namespace photic::test
