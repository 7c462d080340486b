// What free paths of walks are drawn from where a scene leaves it open.
#include "medium/walk_attenuation.hpp"

#include <vector>

#include "unit/medium/scenes.hpp"

namespace photic::medium {
namespace {

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
  auto scene = scene_of({layer_of(0.1), layer_of(albedo)}, {test::channel_of(Process::elastic)});
  scene.sea.layer[0].bottom_depth_m = 5;
  scene.simulation.estimator = scene::Estimator::bidirectional;
  return scene;
}

/// The share of the attenuation of the first layer.
double walked_share(const scene::Scene& scene) {
  const Medium medium = medium_of(scene);
  return 1 / gather<double>(medium.view().collision_gain, 0);
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

}  // namespace
}  // namespace photic::medium
