// What free paths of walks are drawn from where a scene leaves it open.
#include "estimator/walk_attenuation.hpp"

#include <string>
#include <utility>
#include <vector>

#include "estimator/model.hpp"
#include "scene/read.hpp"
#include "support/tables.hpp"
#include "unit/medium/scenes.hpp"
#include "unit/medium/two_layers.hpp"
#include "unit/scene/base_scene.hpp"

namespace photic::estimator {
namespace {

using medium::iop_layer;
using medium::medium_of;
using medium::scene_of;
using Shares = std::vector<double>;

// Seen red: with the candidate below the limit kept; with the smallest candidate for the usual one.
TEST(WalkAttenuation, IsNotFarBelowTheAlbedo) {
  EXPECT_EQ(walk_attenuations(0.38), (Shares{0.35, 0.6, 0.9}));
  EXPECT_EQ(walk_attenuations(0.4), (Shares{0.6, 0.9}));
  EXPECT_EQ(walk_attenuations(0.66), (Shares{0.6, 0.9}));
  EXPECT_EQ(walk_attenuations(0.75), (Shares{0.75, 0.9}));
  EXPECT_EQ(walk_attenuations(0.85), (Shares{0.85}));
  EXPECT_EQ(walk_attenuations(1), (Shares{0.9}));
  EXPECT_EQ(usual_walk_attenuation(0), 0.6);
  EXPECT_EQ(usual_walk_attenuation(0.66), 0.6);
  EXPECT_EQ(usual_walk_attenuation(0.67), 0.67);
  EXPECT_EQ(usual_walk_attenuation(1), 0.9);
}

/// Of 1/m, scattering so much of it.
scene::Layer layer_of(double albedo) {
  scene::Layer layer = iop_layer();
  layer.iop = {{532, 1 - albedo, albedo}};
  return layer;
}

/// Two layers, the second of another albedo than the first's 0.1.
scene::Scene scene_above(double albedo) {
  auto scene =
      scene_of({layer_of(0.1), layer_of(albedo)}, {test::channel_of(medium::Process::elastic)});
  scene.sea.layer[0].bottom_depth_m = 5;
  scene.simulation.estimator = scene::Estimator::bidirectional;
  return scene;
}

/// The share of the attenuation of the first layer.
double walked_share(const scene::Scene& scene) {
  return shares_of_free_paths(medium_of(scene), scene.simulation).front();
}

// Of all layers' water, in all of them. Seen red: with the first layer's; with 0.6 for all.
TEST(WalkAttenuation, IsThatOfTheWaterUnlessItIsGiven) {
  EXPECT_NEAR(highest_albedo(medium_of(scene_above(0.95))), 0.95, 1e-15);
  EXPECT_NEAR(walked_share(scene_above(0.65)), 0.6, 1e-12);
  EXPECT_NEAR(walked_share(scene_above(0.95)), 0.9, 1e-12);
  auto given = scene_above(0.95);
  given.simulation.walk_attenuation = 0.5;
  EXPECT_NEAR(walked_share(given), 0.5, 1e-12);
}

// Where it is less than for the layer that scatters most, here the second. Seen red: with the first
// layer alone.
TEST(WalkAttenuation, RemarksOnWalksWhoseWeightsGrow) {
  const auto with = [](const std::string& lines) {
    return scene::read_scene_text(scene::edited({{30, 30, "photons = 1e6\n" + lines}}),
                                  "scene.toml", "/", {"telescope.0.detector_shift_m=0"},
                                  optics_check(test::tables()))
        .remarks;
  };
  using Texts = std::vector<std::string>;
  const std::string reason =
      "is small for water where scattering is 0.625 of the attenuation: weights grow from vertex "
      "to "
      "vertex, and deep echoes are low; 0.6 would do";
  EXPECT_EQ(with("walk_attenuation = 0.5"), Texts{"scene.toml:31:20: 0.5 " + reason});
  EXPECT_EQ(with("estimator = \"bidirectional\"\nwalk_attenuation = 0.5"),
            Texts{"scene.toml:32:20: 0.5 " + reason});
  EXPECT_EQ(with("walk_attenuation = 0.57"), Texts{});
  for (const std::string& text : with("estimator = \"forward\"\nwalk_attenuation = 0.5"))
    EXPECT_EQ(text.find("is small"), std::string::npos) << text;
}

/// Of an albedo in each line and layer.
medium::Medium two_layers(const std::vector<double>& albedo) {
  auto m = medium::two_layers();
  m.albedo = albedo;
  m.finish();
  return m;
}

/// As free paths see them.
struct TwoLayers {
  medium::Medium medium;
  geometry::FreePaths paths;
  geometry::Slabs slabs = paths.slabs(medium);

  TwoLayers(medium::Medium m, const scene::Simulation& simulation)
      : medium(std::move(m)), paths(free_paths(medium, simulation)) {}
};

// Free paths are drawn from scattering alone, but from no less than a fifth of c. Seen red: without
// that limit; with c for the walk's coefficient.
TEST(FreePaths, AreDrawnFromScatteringAlone) {
  scene::Simulation forward;
  forward.estimator = scene::Estimator::forward;
  const TwoLayers two(two_layers({0.5, 0.6, 0.3, 0.01}), forward);
  const geometry::Slabs& v = two.slabs;
  EXPECT_NEAR(v.walk_c.first[0], 0.1, 1e-16);
  EXPECT_NEAR(v.walk_c.first[1], 0.3, 1e-16);
  EXPECT_NEAR(v.walk_c.first[2], 0.21, 1e-16);
  EXPECT_NEAR(v.walk_c.first[3], 0.18, 1e-16);
  EXPECT_NEAR(v.walk_optical_depth(0, v.level(1, 12.0)), 10 * 0.1 + 2 * 0.3, 1e-15);
  EXPECT_NEAR(v.walk_slant_optical_depth(0, v.level(0, 4.0), v.level(1, 12.0), 16.0),
              2 * (6 * 0.1 + 2 * 0.3), 1e-14);
  EXPECT_NEAR(v.continuous_column(0, v.level(1, 12.0)).integral, 10 * 0.1 + 2 * 0.2, 1e-15);
}

// Where walks are connected, those in emitted light go farther, unless it is scattered much. Seen
// red: with the laser's share for all lines; without regard to scattering.
TEST(FreePaths, GoFartherInEmittedLight) {
  auto m = two_layers({0.9, 0.6, 0.3, 0.5});
  scene::Simulation walks;
  walks.estimator = scene::Estimator::bidirectional;
  walks.walk_attenuation = 0.6;
  const auto shares = shares_of_free_paths(m, walks);
  EXPECT_NEAR(shares[0], 0.6, 1e-15);
  EXPECT_NEAR(shares[1], 0.6, 1e-15);
  EXPECT_NEAR(shares[2], 0.6 * 0.6, 1e-15);
  EXPECT_NEAR(shares[3], 0.5, 1e-15);
  m.albedo[3] = 0.9;
  EXPECT_NEAR(shares_of_free_paths(m, walks)[3], 0.6, 1e-15);
}

// Seen red: with the forward estimator's.
TEST(FreePaths, OfAnalogPhotonsAreTheLightsOwn) {
  scene::Simulation analog;
  analog.estimator = scene::Estimator::analog;
  EXPECT_EQ(shares_of_free_paths(two_layers({0.5, 0.6, 0.3, 0.01}), analog), (Shares{1, 1, 1, 1}));
}

// Seen red: without the limit of the change; with what attenuates most left out; with the scene's
// scattering for the environment's; with those that look at tangents.
TEST(FreePaths, LieBetweenThoseOfAllEnvironments) {
  const auto water = [](double a_per_m, double b_per_m) {
    auto layer = iop_layer();
    layer.iop = {{532, a_per_m, b_per_m}};
    return layer;
  };
  const auto walk_c = [&](const std::vector<scene::Layer>& others, bool tangent = false) {
    auto scene = scene_of({water(0.06, 0.10)}, {test::channel_of(medium::Process::elastic)});
    scene.simulation.estimator = scene::Estimator::forward;
    for (const auto& other : others) {
      const scene::Environment same{"", {}, scene.optics, scene.sea};
      auto changed = same;
      changed.sea.layer[0] = other;
      if (tangent)
        scene.sensitivity.push_back({"sea.layer.0.b", 0.1, 1e-4, same, changed});
      else
        scene.environment.push_back(changed);
    }
    const auto medium = medium_of(scene);
    return medium.c[0] * shares_of_free_paths(medium, scene.simulation).front();
  };
  EXPECT_NEAR(walk_c({}), 0.10, 1e-15);
  EXPECT_EQ(walk_c({water(0.06, 0.10)}), walk_c({}));
  EXPECT_NEAR(walk_c({water(0.024, 0.04), water(0.15, 0.25)}), (0.04 + 0.25) / 2, 1e-15);
  EXPECT_NEAR(walk_c({water(0.5, 0.06)}), (0.10 + 0.2 * 0.56) / 2, 1e-15);  // hardly scatters
  EXPECT_NEAR(walk_c({water(0.6, 1.0)}), 0.10 * 1.5, 1e-15);
  EXPECT_NEAR(walk_c({water(0.001, 0.001)}), 0.10 / 1.5, 1e-15);
  EXPECT_EQ(walk_c({water(0.6, 1.0)}, true), walk_c({}));
}

}  // namespace
}  // namespace photic::estimator
