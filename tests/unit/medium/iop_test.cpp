// Layers whose optical properties are given outright.
#include "unit/medium/scenes.hpp"

namespace photic::medium {
namespace {

double b_of(const Medium& m, std::size_t i) { return m.albedo[i] * m.c[i]; }

// At 532 nm, 0.32 of the way from 500 to 600. Seen red: with the weights of the two entries
// swapped; with b for a in c.
TEST(IopLayer, IsInterpolatedLinearly) {
  const auto m = medium_of(scene_of({iop_layer()}, {test::channel_of(Process::elastic)}));
  EXPECT_NEAR(m.c[0], 0.05 + 0.32 * 0.10 + 0.20 - 0.32 * 0.10, 1e-15);
  EXPECT_NEAR(b_of(m, 0), 0.168, 1e-15);
  EXPECT_NEAR(m.absorption[0], 0.082 / 0.25, 1e-15);
}

TEST(IopLayer, IsExactAtItsEntries) {
  for (const auto& [nm, a, b] :
       {std::tuple{500.0, 0.05, 0.20}, {600.0, 0.15, 0.10}, {700.0, 0.65, 0.08}}) {
    auto scene = scene_of({iop_layer()}, {test::channel_of(Process::elastic)});
    scene.source.wavelength_nm = nm;
    const auto m = medium_of(scene);
    EXPECT_NEAR(m.c[0], a + b, 1e-15) << nm;
    EXPECT_NEAR(b_of(m, 0), b, 1e-15) << nm;
  }
}

// Attenuation on the way back is that of the emitted wavelength: Raman light of 532 nm has 648.79
// nm.
TEST(IopLayer, IsTakenAtTheEmittedWavelengthToo) {
  const auto m = medium_of(scene_of({iop_layer()}, all_channels));
  ASSERT_EQ(m.line.size(), 3U);
  const double t = (m.line[1].wavelength_nm - 600) / 100;
  EXPECT_NEAR(t, 0.4875, 0.005);
  EXPECT_NEAR(m.c[1], 0.15 + 0.5 * t + 0.10 - 0.02 * t, 1e-14);
  EXPECT_NEAR(b_of(m, 1), 0.10 - 0.02 * t, 1e-15);
  EXPECT_EQ(m.line[2].wavelength_nm, 685);
  EXPECT_NEAR(m.c[2], 0.15 + 0.85 * 0.5 + 0.10 - 0.85 * 0.02, 1e-14);
}

scene::Layer single_entry_layer() {
  auto layer = iop_layer("the only layer");
  layer.iop = {{532, 0.06, 0.10, 0.0}};
  return layer;
}

// Seen red: with a reach of 0.5 nm.
TEST(IopLayer, OfASingleEntryHoldsForANanometreAround) {
  for (const double nm : {531.0, 531.7, 532.0, 533.0}) {
    auto scene = scene_of({single_entry_layer()}, {test::channel_of(Process::elastic)});
    scene.source.wavelength_nm = nm;
    EXPECT_NEAR(medium_of(scene).c[0], 0.16, 1e-15) << nm;
  }
}

TEST(IopLayer, IsRefusedOutsideItsWavelengths) {
  auto scene = scene_of({single_entry_layer()}, {test::channel_of(Process::elastic)});
  for (const double nm : {530.9, 533.1}) {
    scene.source.wavelength_nm = nm;
    EXPECT_NE(refusal(scene), "nothing was refused") << nm;
  }
  scene.source.wavelength_nm = 532;
  EXPECT_EQ(refusal(scene), "nothing was refused");
  scene.channel = all_channels;
  EXPECT_EQ(
      refusal(scene),
      "the iop of layer \"the only layer\" covers 531 to 533 nm, not 648.793 nm (add an entry "
      "for it)");
  scene = scene_of({iop_layer()}, {test::channel_of(Process::elastic)});
  for (const double nm : {499.9, 700.1}) {
    scene.source.wavelength_nm = nm;
    EXPECT_NE(refusal(scene), "nothing was refused") << nm;
  }
}

// Chlorophyll fluorescence is excited by the share of a that the layer names: yield x a_ph / c.
// Seen red: with all of a.
TEST(IopLayer, FluorescesByItsNamedShareOfA) {
  auto layer = iop_layer();
  layer.chlorophyll_yield = 0.02;
  const auto m = medium_of(scene_of({layer}, all_channels));
  EXPECT_NEAR(m.conversion[2], 0.02 * (0.01 + 0.32 * 0.02) / m.c[0], 1e-15);
  layer.iop = {{500, 0.05, 0.20, 0}, {700, 0.65, 0.08, 0}};
  EXPECT_EQ(medium_of(scene_of({layer}, all_channels)).line.size(),
            2U);  // no fluorescence, no line
}

}  // namespace
}  // namespace photic::medium
