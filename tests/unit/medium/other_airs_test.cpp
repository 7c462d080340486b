// The tables of other airs: what environments have more or less than the scene's.
#include "medium/other_airs.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "medium/outside_column.hpp"
#include "medium/upside_down.hpp"
#include "unit/medium/alike.hpp"
#include "unit/medium/scenes.hpp"

namespace photic::medium {
namespace {

scene::Atmosphere rural(double visibility_km) {
  scene::Atmosphere air;
  air.profile = "us-standard";
  air.visibility_km = visibility_km;
  return air;
}
scene::AirLayer layer(double bottom_m, double top_m, double a, double b) {
  scene::AirLayer out;
  out.name = fmt::format("from {:g} m", bottom_m);
  out.bottom_height_m = bottom_m;
  out.top_height_m = top_m;
  scene::IopEntry blue, red;
  blue.wavelength_nm = 532, blue.a_per_m = a, blue.b_per_m = b;
  red.wavelength_nm = 700, red.a_per_m = 2 * a, red.b_per_m = 0.5 * b;
  out.iop = {blue, red};
  return out;
}
scene::Atmosphere two_layers(double low_b, double high_b, double g) {
  scene::Atmosphere air;
  air.layer = {layer(0, 100, 1e-4, low_b), layer(100, 900, 0, high_b)};
  air.layer[0].phase_function.emplace();
  air.layer[0].phase_function->model = scene::PhaseModel::henyey_greenstein;
  air.layer[0].phase_function->g = g;
  return air;
}
scene::Scene with_air(const scene::Atmosphere& air, const std::vector<scene::Atmosphere>& others,
                      const std::vector<scene::Channel>& channels = all_channels) {
  auto scene = scene_of({scene::Layer{}}, channels);
  scene.atmosphere = air;
  for (const auto& other : others) {
    scene.environment.push_back({"other", {}, scene.optics, scene.sea});
    scene.environment.back().atmosphere = other;
  }
  return scene;
}

/// Every environment's air is what it would be in a medium of its own, in the same layers and
/// straight up to heights.
Medium expect_own(const scene::Scene& scene) {
  const Medium sea = medium_of(scene);
  const AirBuilder build(scene, library(), sea.line);
  const Air here = build(scene);
  const auto airs = other_airs(scene, library(), sea.line);
  const Medium all = upside_down(here, airs, sea, 500, 20e3);
  const std::vector<double> heights{12, 500, 20e3};
  const auto excess = excess_depths(airs, heights);
  for (std::size_t e = 0; e < scene.environment.size(); ++e) {
    SCOPED_TRACE(e);
    const Air own = build(scene::scene_in(scene, scene.environment[e]));
    expect_meets_alike(all, e, upside_down(own, {}, sea, 500, 20e3));
    for (std::size_t h = 0; h < heights.size(); ++h)
      for (std::size_t l = 0; l < sea.line.size(); ++l) {
        const double expected = column_to(own, heights[h]).optical_depth[l];
        EXPECT_NEAR(column_to(here, heights[h]).optical_depth[l] +
                        excess[(e * heights.size() + h) * sea.line.size() + l],
                    expected, 1e-12 + 1e-9 * expected);
      }
  }
  return all;
}

// The molecules are the same in all: aerosols of one kind are one part of the scattering. Between
// 2 and 3 km there are those of the boundary layer and the ones above it. Seen red: with the
// scattering of the scene's mixture for that of a part; with the laser's phase functions for all
// lines.
TEST(OtherAirs, AreWhatTheirOwnWouldBe) {
  const std::vector<scene::Channel> lasers{test::channel_of(Process::elastic)};
  EXPECT_EQ(expect_own(with_air(rural(23), {rural(8), rural(60)}, lasers)).environments.parts, 2);
  auto maritime = rural(23);
  maritime.aerosol = "maritime";
  EXPECT_EQ(expect_own(with_air(rural(23), {maritime, rural(23)}, lasers)).environments.parts, 2);
  expect_own(with_air(rural(23), {maritime, rural(8)}));
  auto damp = rural(15);
  damp.relative_humidity_percent = 90;
  expect_own(with_air(rural(23), {damp}));
}

scene::Atmosphere of_depth(double aerosol_optical_depth_550) {
  scene::Atmosphere air;
  air.profile = "us-standard";
  air.aerosol_optical_depth_550 = aerosol_optical_depth_550;
  return air;
}

// Seen red: with the profile as its visibility has it.
TEST(OtherAirs, OfOpticalDepthsAreWhatTheirOwnWouldBe) {
  const auto scene = with_air(of_depth(0.3), {of_depth(0.12), of_depth(0.9), rural(8)});
  expect_own(scene);
  const auto airs = other_airs(scene, library(), medium_of(scene).line);
  EXPECT_NEAR(airs[0].from.depths->aerosols_550, 0.3, 1e-12);
  EXPECT_NEAR(airs[0].to.depths->aerosols_550, 0.12, 1e-12);
  EXPECT_NEAR(airs[1].to.depths->aerosols_550, 0.9, 1e-12);
  expect_own(with_air(rural(23), {of_depth(0.2)}));
}
TEST(OtherAirs, OfLayersAreWhatTheirOwnWouldBe) {
  expect_own(with_air(
      two_layers(1e-3, 1e-5, 0.6),
      {two_layers(2e-3, 1e-5, 0.6), two_layers(1e-3, 4e-6, 0.6), two_layers(5e-4, 1e-5, 0.8)}));
}

// An environment leaves the scene's own echo as it is. Seen red: with layers that are thin enough
// for the environment's air, too.
TEST(OtherAirs, LeaveTheLayersOfTheScenesAir) {
  const auto layers = [](const std::vector<scene::Atmosphere>& others) {
    const auto scene = with_air(rural(100), others);
    return build_air(scene, library(), medium_of(scene).line)->height_m;
  };
  EXPECT_EQ(layers({rural(2)}), layers({}));
}

// A tangent is the difference of its steps, in units of the parameter's share.
TEST(OtherAirs, OfTangentsAreTheirSteps) {
  auto scene = with_air(two_layers(1e-3, 1e-5, 0.6), {});
  scene.environment.clear();
  scene::Environment below{"", {}, scene.optics, scene.sea}, above = below;
  below.atmosphere = two_layers(0.999e-3, 1e-5, 0.6);
  above.atmosphere = two_layers(1.001e-3, 1e-5, 0.6);
  scene.sensitivity.push_back({"atmosphere.layer.0.iop.0.b_per_m", 1e-3, 1e-6, below, above});
  const Medium sea = medium_of(scene);
  const auto excess = excess_depths(other_airs(scene, library(), sea.line), {50});
  EXPECT_NEAR(excess[0], 1e-3 * 50, 1e-9);  // b d(tau) / db
}

// No history is scattered where the scene's own air is empty.
TEST(OtherAirs, ThatScatterWhereTheScenesDoesNotAreRefused) {
  const auto scene = with_air(two_layers(1e-3, 0, 0.6), {two_layers(1e-3, 1e-6, 0.6)});
  try {
    other_airs(scene, library(), medium_of(scene).line);
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().front().reason,
              "environment \"other\": the layer of air \"from 100 m\" scatters light, but not in "
              "the scene itself");
  }
}

}  // namespace
}  // namespace photic::medium
