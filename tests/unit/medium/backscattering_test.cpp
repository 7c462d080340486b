// Layers whose phase function is set by their backscattering coefficient.
#include "medium/layer_optics.hpp"
#include "unit/medium/scenes.hpp"

namespace photic::medium {
namespace {

scene::Layer backscattering_layer(double bb_500, double bb_600) {
  scene::Layer layer;
  layer.name = "top";
  layer.iop = {{500, 0.05, 0.20, 0, bb_500}, {600, 0.15, 0.10, 0, bb_600}};
  return layer;
}

double fraction_in(const scene::Scene& scene) {
  const LayerOptics optics_of(scene, library());
  const auto& layer = scene.sea.layer[0];
  const WaterOptics water = optics_of(layer, scene.source.wavelength_nm);
  return optics::PhaseTable(optics_of.phase(layer, scene.source.wavelength_nm, water))
      .backscatter_fraction();
}

// b_b and b are linear between entries, and not their quotient. Seen red: with the quotient's
// interpolation.
TEST(Backscattering, IsThatOfThePhaseFunction) {
  for (const auto& [bb_500, bb_600] : {std::pair{0.0001, 0.00002}, {0.002, 0.003}, {0.08, 0.04}}) {
    auto scene =
        scene_of({backscattering_layer(bb_500, bb_600)}, {test::channel_of(Process::elastic)});
    for (const double nm : {500.0, 532.0, 600.0}) {
      const double t = (nm - 500) / 100;
      scene.source.wavelength_nm = nm;
      const double fraction = ((1 - t) * bb_500 + t * bb_600) / (0.2 - 0.1 * t);
      EXPECT_NEAR(fraction_in(scene) / fraction, 1, 1e-4) << nm;
    }
  }
}

TEST(Backscattering, IsNamedAmongTheSources) {
  const auto m = medium_of(
      scene_of({backscattering_layer(0.004, 0.004)}, {test::channel_of(Process::elastic)}));
  const std::string source =
      "given in the scene; b_b/b = 0.02381, too: phase function Fournier-Forand with that b_b/b, "
      "Mobley, Sundman & Boss 2002 [verified]";
  EXPECT_TRUE(
      std::ranges::any_of(m.sources, [&](const auto& s) { return s.source.ends_with(source); }));
}

TEST(Backscattering, OfNoScatteringIsNothing) {
  auto layer = backscattering_layer(0, 0);
  for (auto& entry : layer.iop) entry.b_per_m = 0;
  EXPECT_EQ(medium_of(scene_of({layer}, {test::channel_of(Process::elastic)})).albedo[0], 0);
}

// Seen red: with tables of environments distinguished by the name of their phase function alone.
TEST(Backscattering, OfAnEnvironmentIsItsOwn) {
  auto scene = scene_of({backscattering_layer(0.002, 0.002)}, {test::channel_of(Process::elastic)});
  const auto other =
      scene_of({backscattering_layer(0.02, 0.02)}, {test::channel_of(Process::elastic)});
  scene.environment.push_back({"other", {}, scene.optics, other.sea});
  const Medium all = medium_of(scene);
  const MediumView view = all.view();
  EXPECT_EQ(view.environments.count, 1);
  EXPECT_EQ(view.environments.parts, 2);
}

}  // namespace
}  // namespace photic::medium
