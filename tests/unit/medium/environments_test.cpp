// The tables of environments: what their waters have more or less than the scene's.
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
  EXPECT_NE(all.find("environment \"other\": layer \"top\" " + what + ", and not in the scene"),
            std::string::npos)
      << all;
}

// Scattering at an angle, attenuation and emission, line by line. Seen red: with the scattering of
// the parts over that of the environment; with the scene's emission.
TEST(MediumOfEnvironments, IsWhatTheirOwnWouldBe) {
  const auto scene = scene_of({algae(0.5), algae(0.1)}, all_channels);
  const auto other = scene_of({algae(1.5), algae(0.02)}, all_channels);
  auto layered = scene, layered_other = other;
  layered.sea.layer[0].bottom_depth_m = layered_other.sea.layer[0].bottom_depth_m = 5;
  const Medium all = medium_of(with(layered, layered_other.sea));
  const Medium own = medium_of(layered_other);
  const MediumView a = all.view(), o = own.view();
  ASSERT_EQ(a.environments.count, 1);
  ASSERT_EQ(a.environments.parts, 1);  // the algae: the water is the same
  for (std::size_t i = 0; i < all.c.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_NEAR(all.c[i] + all.environments.excess_c[i], own.c[i], 1e-15);
    if (i >= 2) {
      const double here = all.c[i % 2] * all.conversion[i];
      EXPECT_NEAR(here * (1 + all.environments.excess_emitted[i]), own.c[i % 2] * own.conversion[i],
                  1e-12 * here);
    }
    const double b = all.albedo[i] * all.c[i];
    for (const double x : {1e-6, 1e-3, 0.1, 1.0, 1.9}) {
      const double p = a.phases.value<double>(x, all.elastic_phase[i]);
      const double part = a.phases.value<double>(x, all.environments.part_phase[i]);
      const double scattered = b * (p + all.environments.excess_part[i] * part);
      const double expected =
          own.albedo[i] * own.c[i] * o.phases.value<double>(x, own.elastic_phase[i]);
      EXPECT_NEAR(scattered, expected, 2e-4 * expected) << x;
    }
  }
}

// Seen red: with the scene's parts alone.
TEST(MediumOfEnvironments, HasTwoPartsWhereAPhaseFunctionIsAnother) {
  const auto scene = scene_of({iop_layer()}, {test::channel_of("elastic")});
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
  auto black = scene_of({iop_layer()}, {test::channel_of("elastic")});
  const auto scatters = black.sea;
  for (auto& entry : black.sea.layer[0].iop) entry.b_per_m = 0;
  expect_refused(with(black, scatters), "scatters light");
  EXPECT_NO_THROW(medium_of(with(scene_of({algae(0.1)}, all_channels), clear.sea)));
}

}  // namespace
}  // namespace photic::medium
