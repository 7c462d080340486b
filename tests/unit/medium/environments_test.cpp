// The tables of environments: what their waters have more or less than the scene's.
#include "unit/medium/alike.hpp"
#include "unit/medium/scenes.hpp"

namespace photic::medium {
namespace {

scene::Scene with(scene::Scene scene, const scene::Sea& other) {
  scene.environment.push_back({"other", {}, scene.optics, other});
  return scene;
}

scene::Layer algae(double chlorophyll_mg_m3) {
  scene::Layer layer;
  layer.name = "top";
  layer.chlorophyll_mg_m3 = chlorophyll_mg_m3;
  return layer;
}

void expect_refused(const scene::Scene& scene, const std::string& what) {
  const std::string all = refusal(scene);
  EXPECT_NE(all.find("environment \"other\": layer \"top\" " + what + ", but not in the scene"),
            std::string::npos)
      << all;
}

/// Scattering at an angle, attenuation and emission of the only environment of one medium are
/// those of the other, line by line. Two layers.
void expect_alike(const Medium& all, const Medium& own) {
  ASSERT_EQ(all.environments.count, 1);
  expect_meets_alike(all, 0, own);
  for (std::size_t i = 2; i < all.c.size(); ++i) {
    const double here = all.c[i % 2] * all.conversion[i];
    EXPECT_NEAR(here * (1 + all.environments.excess_emitted[i]), own.c[i % 2] * own.conversion[i],
                1e-12 * here)
        << i;
  }
}

// Seen red: with the scattering of the parts over that of the environment; with the scene's
// emission.
TEST(MediumOfEnvironments, IsWhatTheirOwnWouldBe) {
  auto scene = scene_of({algae(0.5), algae(0.1)}, all_channels);
  auto other = scene_of({algae(1.5), algae(0.02)}, all_channels);
  scene.sea.layer[0].bottom_depth_m = other.sea.layer[0].bottom_depth_m = 5;
  const Medium all = medium_of(with(scene, other.sea));
  EXPECT_EQ(all.environments.parts, 1);  // the algae: the water is the same
  expect_alike(all, medium_of(other));
}

// More minerals in a layer that has some beside algae, and in one that has algae alone: there, they
// are the second part of the scattering, as the algae are elsewhere. Seen red: with the phase
// functions of minerals taken for those of algae; with what algae scatter distinguished by
// rounding.
TEST(MediumOfEnvironments, IsWhatTheirOwnWouldBeWithMinerals) {
  const auto with_minerals = [](scene::Layer layer, double minerals_g_m3) {
    layer.minerals_g_m3 = minerals_g_m3;
    return layer;
  };
  auto scene = scene_of({with_minerals(algae(0.5), 0.3), algae(0)}, all_channels);
  auto other =
      scene_of({with_minerals(algae(0.5), 0.6), with_minerals(algae(0), 0.2)}, all_channels);
  scene.sea.layer[0].bottom_depth_m = other.sea.layer[0].bottom_depth_m = 5;
  const Medium all = medium_of(with(scene, other.sea));
  EXPECT_EQ(all.environments.parts, 1);
  expect_alike(all, medium_of(other));
}

// An environment of the paper's optics: all parts have other phase functions.
TEST(MediumOfEnvironments, IsWhatTheirOwnWouldBeWithOtherMinerals) {
  auto layer = algae(0.5);
  layer.minerals_g_m3 = 0.3;
  auto scene = scene_of({layer, layer}, {test::channel_of(Process::elastic)});
  scene.sea.layer[0].bottom_depth_m = 5;
  auto other = scene;
  other.optics.minerals_phase = scene::ParticlePhase::petzold;
  other.optics.minerals_power_law.b_555_m2_per_g = 0.7;
  auto both = scene;
  both.environment.push_back({"other", {}, other.optics, other.sea});
  const Medium all = medium_of(both);
  EXPECT_EQ(all.environments.parts, 2);
  expect_alike(all, medium_of(other));
}

// A parameter's tangent stands behind the environments and is none of them. Seen red: with half the
// step; with the derivative for that times the parameter.
TEST(MediumOfEnvironments, HasTangentsBehindThem) {
  auto layer = algae(0.5);
  layer.cdom_a440_per_m = 0.1;
  auto scene = scene_of({layer}, {test::channel_of(Process::elastic)});
  const auto with_cdom = [&](double a440_per_m) {
    scene::Environment out{"", {}, scene.optics, scene.sea};
    out.sea.layer[0].cdom_a440_per_m = a440_per_m;
    return out;
  };
  scene.environment.push_back(with_cdom(0.0));
  scene.sensitivity.push_back(
      {"sea.layer.0.cdom_a440_per_m", 0.1, 1e-4, with_cdom(0.0999), with_cdom(0.1001)});
  const Medium m = medium_of(scene);
  ASSERT_EQ(m.environments.count, 2);
  ASSERT_EQ(m.environments.first_tangent, 1);
  const auto& excess = m.environments.excess_c;
  ASSERT_EQ(excess.size(), 2U);
  EXPECT_LT(excess[0], 0);
  EXPECT_NEAR(excess[1], -excess[0], 1e-10 * excess[1]);  // attenuation goes with it
  EXPECT_EQ(m.view().environments.stride % environment_padding, 0);
}

// Seen red: with the scene's parts alone.
TEST(MediumOfEnvironments, HasTwoPartsWhereAPhaseFunctionIsAnother) {
  const auto scene = scene_of({iop_layer()}, {test::channel_of(Process::elastic)});
  auto other = scene.sea;
  other.layer[0].phase_function = henyey_greenstein(0.8);
  const Medium m = medium_of(with(scene, other));
  ASSERT_EQ(m.environments.parts, 2);
  EXPECT_EQ(m.environments.excess_part, (std::vector<double>{-1, 1}));
}

// Seen red: without either refusal.
TEST(MediumOfEnvironments, RefusesWhatTheSceneNeverDoes) {
  const auto clear = scene_of({algae(0)}, all_channels);
  expect_refused(with(clear, scene_of({algae(0.1)}, all_channels).sea), "emits chlorophyll light");
  auto black = scene_of({iop_layer()}, {test::channel_of(Process::elastic)});
  const auto scatters = black.sea;
  for (auto& entry : black.sea.layer[0].iop) entry.b_per_m = 0;
  expect_refused(with(black, scatters), "scatters light");
  EXPECT_NO_THROW(medium_of(with(scene_of({algae(0.1)}, all_channels), clear.sea)));
}

}  // namespace
}  // namespace photic::medium
