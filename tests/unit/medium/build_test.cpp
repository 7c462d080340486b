// Lines, channels and the balance of photons in the medium.
#include "optics/fluorescence.hpp"
#include "optics/raman.hpp"
#include "optics/refractive_index.hpp"
#include "unit/medium/scenes.hpp"

namespace photic::medium {
namespace {

/// Whether a channel counts light, all of it or nothing.
bool counts(const scene::Channel& channel, Process process, double nm) {
  const auto scene = scene_of({iop_layer()}, {channel});
  const double share = counted_by(scene, filters_of(scene), process, nm).at(0);
  EXPECT_TRUE(share == 0 || share == 1);
  return share == 1;
}

// Seen red: with the full width on either side.
TEST(Channel, CountsItsProcessOrWhatPassesItsFilter) {
  EXPECT_TRUE(counts(test::channel_of(Process::elastic), Process::elastic, 532));
  EXPECT_FALSE(counts(test::channel_of(Process::elastic), Process::raman, 649));
  EXPECT_TRUE(counts(test::channel_of(Process::raman), Process::raman, 649));
  EXPECT_FALSE(counts(test::channel_of(Process::raman), Process::chlorophyll, 685));
  EXPECT_TRUE(counts(test::channel_of(Process::chlorophyll), Process::chlorophyll, 685));
  EXPECT_TRUE(counts(test::filter(650, 10), Process::raman, 649));
  EXPECT_TRUE(counts(test::filter(654, 10), Process::raman, 649));  // on its edge
  EXPECT_FALSE(counts(test::filter(654.1, 10), Process::raman, 649));
  EXPECT_FALSE(counts(test::filter(643.9, 10), Process::raman, 649));
  EXPECT_TRUE(counts(test::filter(667, 40), Process::raman, 649));
  EXPECT_TRUE(counts(test::filter(667, 40), Process::chlorophyll, 685));
  EXPECT_FALSE(counts(test::filter(667, 40), Process::elastic, 532));
}

TEST(BuildMedium, HasTheLinesThatChannelsCount) {
  const auto processes = [](const std::vector<scene::Channel>& channels) {
    std::vector<Process> out;
    for (const Line& line : medium_of(scene_of({iop_layer()}, channels)).line)
      out.push_back(line.process);
    return out;
  };
  using P = std::vector<Process>;
  EXPECT_EQ(processes({test::channel_of(Process::elastic)}), (P{Process::elastic}));
  EXPECT_EQ(processes({test::channel_of(Process::raman)}),
            (P{Process::elastic, Process::raman}));  // the laser's always
  EXPECT_EQ(processes(all_channels), (P{Process::elastic, Process::raman, Process::chlorophyll}));
  EXPECT_EQ(processes({test::filter(667, 40)}),
            (P{Process::elastic, Process::raman, Process::chlorophyll}));
  EXPECT_EQ(processes({test::filter(685, 10)}), (P{Process::elastic, Process::chlorophyll}));
  EXPECT_EQ(processes({test::filter(600, 10)}), (P{Process::elastic}));
}

TEST(BuildMedium, GivesEachLineItsIndices) {
  const auto m = medium_of(scene_of({iop_layer()}, all_channels));
  for (const Line& line : m.line) {
    EXPECT_EQ(line.refractive_index, optics::refractive_index(line.wavelength_nm, 35, 20));
    EXPECT_EQ(line.group_index, optics::group_index(line.wavelength_nm, 35, 20));
  }
  EXPECT_GT(m.line[0].group_index, m.line[0].refractive_index + 0.02);

  auto scene = scene_of({iop_layer()}, all_channels);
  scene.sea.refractive_index = 1.334;
  for (const Line& line : medium_of(scene).line) {
    EXPECT_EQ(line.refractive_index, 1.334);
    EXPECT_EQ(line.group_index, optics::group_index(line.wavelength_nm, 35, 20));  // geometry only
  }
  scene.sea.group_index = 1.36;
  for (const Line& line : medium_of(scene).line) EXPECT_EQ(line.group_index, 1.36);
}

// Photons that are emitted at another wavelength are taken out of the absorption: c = a + b with or
// without them, and what becomes of a collision adds up to 1. Seen red: with b_R added to c; with
// the emitted photons absorbed as well.
TEST(BuildMedium, TakesInelasticPhotonsOutOfTheAbsorption) {
  const auto without = medium_of(scene_of({iop_layer()}, {test::channel_of(Process::elastic)}));
  const auto with = medium_of(scene_of({iop_layer()}, all_channels));
  EXPECT_EQ(with.c[0], without.c[0]);
  EXPECT_EQ(with.albedo[0], without.albedo[0]);
  EXPECT_GT(with.conversion[1], 0);
  EXPECT_GT(with.conversion[2], 0);
  EXPECT_NEAR(with.absorption[0], without.absorption[0] - with.conversion[1] - with.conversion[2],
              1e-15);
  EXPECT_NEAR(with.absorption[0] + with.albedo[0] + with.conversion[1] + with.conversion[2], 1,
              1e-15);
  for (std::size_t l = 1; l < 3; ++l) EXPECT_NEAR(with.absorption[l] + with.albedo[l], 1, 1e-15);
  EXPECT_EQ(with.conversion[0], 0);
}

// Seen red: with c of the emitted line under the coefficient.
TEST(BuildMedium, ConvertsAsMuchAsTheCoefficientsSay) {
  auto layer = iop_layer();
  const auto scene = scene_of({layer}, all_channels);
  const auto m = medium_of(scene);
  const auto raman = optics::raman(library(), "bartlett", 532).line.value();
  EXPECT_NEAR(m.conversion[1] * m.c[0], raman.coefficient, 1e-18);
  EXPECT_EQ(m.line[1].wavelength_nm, raman.wavelength_nm);
  EXPECT_NEAR(m.conversion[2] * m.c[0], 0.0164 * 0.01, 1e-18);
}

TEST(BuildMedium, PutsEveryLayerWhereItIs) {
  auto top = iop_layer("top");
  top.bottom_depth_m = 7.5;
  auto middle = iop_layer("middle");
  middle.bottom_depth_m = 20;
  for (auto& entry : middle.iop) entry.b_per_m *= 3;
  for (auto& entry : middle.iop) entry.a_phytoplankton_per_m = 0;
  middle.phase_function = henyey_greenstein(0.5);
  auto bottom = iop_layer("bottom");
  const auto m = medium_of(scene_of({top, middle, bottom}, all_channels));
  EXPECT_EQ(m.layers(), 3);
  EXPECT_EQ(m.top, (std::vector<double>{0, 7.5, 20, std::numeric_limits<double>::infinity()}));
  EXPECT_NEAR(m.c[1], 0.082 + 3 * 0.168, 1e-15);
  EXPECT_EQ(m.c[2], m.c[0]);
  EXPECT_EQ(m.elastic_phase[2], m.elastic_phase[0]);
  EXPECT_NE(m.elastic_phase[1], m.elastic_phase[0]);
  const auto view = m.view();
  EXPECT_EQ(view.convertible_count[0], 2);
  EXPECT_EQ(view.convertible_count[1], 1);    // no phytoplankton in the middle
  EXPECT_EQ(view.convertible[1 * 2 + 0], 0);  // Raman light's band
  EXPECT_EQ(m.conversion[2 * 3 + 1], 0);
  EXPECT_GT(m.conversion[2 * 3 + 2], 0);
  EXPECT_NEAR(view.optical_depth(0, view.level(2, 25.0)), 7.5 * m.c[0] + 12.5 * m.c[1] + 5 * m.c[2],
              1e-12);
}

// A bed where the last layer ends.
TEST(BuildMedium, EndsAtTheBedOfTheLastLayer) {
  auto layer = iop_layer();
  layer.bottom_depth_m = 30;
  EXPECT_EQ(medium_of(scene_of({layer}, all_channels)).top, (std::vector<double>{0, 30}));
}

TEST(BuildMedium, ListsWhereItsNumbersComeFrom) {
  const auto m = medium_of(scene_of({iop_layer()}, all_channels));
  const auto lists = [&](const std::string& what) {
    return std::any_of(m.sources.begin(), m.sources.end(), [&](const Source& s) {
      return source_line(s).find(what) != std::string::npos;
    });
  };
  EXPECT_TRUE(lists("given in the scene"));
  EXPECT_TRUE(lists("raman light, 6"));
  EXPECT_TRUE(lists("chlorophyll light, 685 nm: "));
  EXPECT_TRUE(lists("Bartlett"));
}

}  // namespace
}  // namespace photic::medium
