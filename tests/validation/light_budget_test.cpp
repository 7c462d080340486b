// The ends of light, and the rest of it on the way: sums that hold in any water.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "support/lit_scenes.hpp"
#include "support/lit_worlds.hpp"
#include "support/runs.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

const std::vector<std::string>& constituents_in(const tally::Result& r) {
  return tally_named(r, "absorbed").grid.dimensions.at(1).coordinates.front().labels;
}

const std::string forward_peaked = R"({ model = "henyey-greenstein", g = 0.8 })";

// d(E_d - E_u) / d(depth) = -a E_0 (Gershun 1939): what goes through the upper level of a slab and
// not through the lower one is absorbed in between. In three layers, of which each is one slab; the
// mean over a layer of E_0 is path length over thickness. False alarms: one in a hundred. Seen red:
// without absorption along flights.
TEST(NetIrradiance, FallsByWhatIsAbsorbed) {
  const std::vector<double> a{0.3, 0.05, 0.8}, edges{0, 1, 2, 3};
  std::string layers;
  for (std::size_t i = 0; i < 3; ++i) layers += layer_to(edges[i + 1], a[i], 0.9, forward_peaked);
  // Levels at the edges, and in the middle of layers with slabs as thick as these.
  const auto run = [&](const std::vector<double>& depths, const std::string& keys) {
    return run_in_lanes(read(sun_at(40) + tally_of("irradiance", {depths}, keys) +
                             tally_of("boundaries") + "[sea]\nrefractive_index = 1.34\n" + layers +
                             "[bottom]\nalbedo = 0.3\n" + simulation(4e5, 31)));
  };
  const auto at_edges = run(edges, "");
  const auto in_layers = run({0.5, 1.5, 2.5}, "slab_m = 1.0\n");
  ZFamily family(0.01);
  const double sun = std::cos(40 * radian_per_degree);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto net = [&](std::size_t level) {
      return known(at_edges, "irradiance_down", level).value -
             known(at_edges, "irradiance_up", level).value;
    };
    const Known down = known(in_layers, "scalar_irradiance_down", i),
                up = known(in_layers, "scalar_irradiance_up", i);
    const double thickness = edges[i + 1] - edges[i];
    const double absorbed = a[i] * thickness * (down.value + up.value);
    const Known booked = known(in_layers, "absorbed", i);
    // The two are of the same histories, flight by flight: only floats differ.
    EXPECT_NEAR(absorbed, sun * booked.value, 2e-4 * absorbed) << "layer " << i;
    double variance = 0;
    for (const std::size_t level : {i, i + 1})
      for (const char* name : {"irradiance_down", "irradiance_up"})
        variance += std::pow(known(at_edges, name, level).error, 2);
    variance += std::pow(a[i] * thickness * std::hypot(down.error, up.error), 2);
    std::printf("layer %zu: net %.5f, absorbed %.5f +- %.5f\n", i, net(i) - net(i + 1), absorbed,
                std::sqrt(variance));
    family.add(net(i) - net(i + 1), absorbed, std::sqrt(variance), fmt::format("layer {}", i));
  }
  family.judge();
}

// The net irradiance is the same on both sides of the surface, flat or rough, and what it loses
// between levels of the air is absorbed there. False alarms: one in a hundred.
TEST(NetIrradiance, PassesTheSurface) {
  const double sun = std::cos(50 * radian_per_degree);
  ZFamily family(0.01);
  for (const std::string& surface : {std::string(), wavy}) {
    const auto r = run_in_lanes(read(
        sun_at(50) + tally_of("irradiance", {{0}, {0, 1, 2}}) + tally_of("boundaries") + two_airs +
        two_layers_and_bed(surface) + simulation(2e5 * static_cast<double>(seeds_of_tests()), 33)));
    const auto net = [&](std::size_t level) {
      const Known down = known(r, "irradiance_down", level), up = known(r, "irradiance_up", level);
      return Known{down.value - up.value, std::hypot(down.error, up.error)};
    };
    const auto add = [&](double one, double other, double error, const std::string& what) {
      std::printf("%s: %.5f, %.5f +- %.5f\n", what.c_str(), one, other, error);
      family.add(one, other, error, what);
    };
    const Known top = net(0), middle = net(1), above = net(2), below = net(3);
    add(above.value, below.value, std::hypot(above.error, below.error), "surface");
    const auto& names = tally_named(r, "absorbed").grid.dimensions.at(0).coordinates[0].labels;
    const auto absorbed = [&](const std::string& layer) {
      const auto found = std::ranges::find(names, layer);
      const Known cell =
          known(r, "absorbed",
                static_cast<std::size_t>(found - names.begin()) * constituents_in(r).size());
      return Known{sun * cell.value, sun * cell.error};
    };
    const Known upper = absorbed("air1"), lower = absorbed("air0");
    add(top.value - middle.value, upper.value, std::hypot(top.error, middle.error, upper.error),
        "upper air");
    add(middle.value - above.value, lower.value, std::hypot(middle.error, above.error, lower.error),
        "lower air");
    EXPECT_LT(below.error, 5e-3);
  }
  family.judge();
}

// A constituent of known absorption absorbs that times E_0: 0.5 and 0.2 per m of CDOM at
// 440 nm, beside water and phytoplankton, in layers that the slabs of E_0 fill. False alarms: one
// in a hundred. Seen red: with the shares of the last layer's and the first one's constituents
// swapped.
TEST(NetIrradiance, IsAbsorbedByConstituents) {
  const auto r = run_in_lanes(
      read("[source]\nkind = \"beam\"\nwavelength_nm = 440.0\nzenith_deg = 40\n" +
           tally_of("irradiance", {{0.5, 1.5}}, "slab_m = 1.0") + tally_of("boundaries") +
           "[[sea.layer]]\nbottom_depth_m = 1\nchlorophyll_mg_m3 = 2\ncdom_a440_per_m = 0.5\n"
           "[[sea.layer]]\nbottom_depth_m = 2\ncdom_a440_per_m = 0.2\n" +
           simulation(2e5, 32)));
  const auto& constituents = constituents_in(r);
  const auto cdom =
      static_cast<std::size_t>(std::ranges::find(constituents, "CDOM") - constituents.begin());
  ZFamily family(0.01);
  const double sun = std::cos(40 * radian_per_degree);
  for (const std::size_t layer : {0U, 1U}) {
    const double a = layer == 0 ? 0.5 : 0.2;
    const Known absorbed = known(r, "absorbed", layer * constituents.size() + cdom);
    const Known down = known(r, "scalar_irradiance_down", layer),
                up = known(r, "scalar_irradiance_up", layer);
    family.add(sun * absorbed.value, a * (down.value + up.value),
               std::hypot(sun * absorbed.error, a * std::hypot(down.error, up.error)),
               fmt::format("layer {}", layer));
    EXPECT_LT(absorbed.error, 2e-3 * absorbed.value);
  }
  family.judge();
}

/// The light that escapes has been in the water or not.
void expect_escaped_apart(const tally::Result& r, bool has_sea) {
  const double apart = has_sea
                           ? known(r, "reflected_by_surface").value + known(r, "left_water").value
                           : sum_of(r, "escaped");
  EXPECT_NEAR(sum_of(r, "escaped"), apart, 1e-9);
}

class LightBudget : public testing::TestWithParam<LitWorld> {};

// All light ends somewhere: in the mean by the forward estimator, and one by one, but for what
// floats round off, if chance decides. Over waves each facet that analog photons meet weighs them.
// Seen red: without absorption along flights; without that of collisions, where free paths are
// drawn more often than light collides; with constituents' shares of another layer.
TEST_P(LightBudget, IsBalanced) {
  const LitWorld& world = GetParam();
  const bool has_sea = world.scene.find("[sea]") != std::string::npos;
  const bool has_waves = world.scene.find("cox-munk") != std::string::npos;
  for (const std::string estimator : {"forward", "analog"}) {
    SCOPED_TRACE(estimator);
    const auto r = run_in_lanes(read(world.scene + simulation(2e4, 71, "", estimator)));
    const Known balance = known(r, "balance");
    std::printf("%s, %s: %.6f +- %.6f\n", world.name.c_str(), estimator.c_str(), balance.value,
                balance.error);
    const bool one_by_one = estimator == "analog" && !has_waves;
    EXPECT_NEAR(balance.value, 1, one_by_one ? 1e-5 : 3 * balance.error);
    EXPECT_LT(balance.error, 0.02);
    expect_escaped_apart(r, has_sea);
  }
}
INSTANTIATE_TEST_SUITE_P(Worlds, LightBudget, testing::ValuesIn(lit_worlds()), name_of_world);

}  // namespace
}  // namespace photic::test
