// Rows of filters, their shapes, and the choices of emitted light.
#include <gtest/gtest.h>

#include "unit/scene/base_scene.hpp"

namespace photic::scene {
namespace {

std::string with_centre(const std::string& centre) {
  return edited({{16, 17, "name = \"f\"\ncentre_nm = " + centre + "\nfwhm_nm = 6"}});
}

Texts diagnostics(const std::string& centre) { return diagnostics_of(with_centre(centre), {}, {}); }

// Seen red: with the last step left out.
TEST(ChannelSteps, MakeAChannelOfEach) {
  const Scene scene = read_text(with_centre("{ from = 380, to = 381, step = 0.2 }"));
  Texts names;
  for (const Channel& channel : scene.channel) names.push_back(channel.name);
  EXPECT_EQ(names, (Texts{"f_380", "f_380.2", "f_380.4", "f_380.6", "f_380.8", "f_381"}));
  EXPECT_EQ(scene.channel[3].centre_nm, 380 + 3 * 0.2);
  EXPECT_EQ(scene.channel[5].fwhm_nm, 6);
  EXPECT_EQ(read_text(write_scene(scene)), scene);
  EXPECT_EQ(read_text(with_centre("{ from = 380, to = 384.9, step = 5 }")).channel.size(), 1U);
}

TEST(ChannelSteps, SayWhatIsWrongWithThem) {
  EXPECT_EQ(diagnostics("{ from = 380, to = 300, step = 5 }"),
            (Texts{"scene.toml:17:13: 'centre_nm' goes from 380 to 300 nm (give the shorter "
                   "wavelength first)"}));
  EXPECT_EQ(diagnostics("{ from = 380, to = 390 }"),
            (Texts{"scene.toml:17:13: 'centre_nm' lacks 'step' (write { from = 380, to = 700, step "
                   "= 5 })"}));
  EXPECT_EQ(diagnostics("{ from = 380, to = 390, step = 5, by = 5 }"),
            (Texts{"scene.toml:17:13: 'centre_nm' has other keys than from, to and step (write { "
                   "from = 380, to = 700, step = 5 })"}));
  EXPECT_EQ(diagnostics("{ from = 380, to = 390, step = 0 }").size(), 1U);
  EXPECT_EQ(diagnostics("{ from = nan, to = 390, step = 5 }").size(), 1U);
  EXPECT_EQ(diagnostics("{ from = 100, to = 1000000099, step = 1 }"),
            (Texts{"scene.toml:17:13: 'centre_nm' makes 1e+09 channels (at most 1000 are possible: "
                   "take longer steps)"}));
}

TEST(Emission, IsInSpectraUnlessIopsAreGiven) {
  EXPECT_EQ(read_text(edited({})).optics.emission, Emission::lines);
  EXPECT_EQ(read_text(edited({{23, 25, ""}})).optics.emission, Emission::spectra);
  EXPECT_EQ(
      read_text(edited({{18, 18, "[optics]\nset = \"paper\""}, {23, 25, ""}})).optics.emission,
      Emission::lines);
  EXPECT_EQ(read_text(edited({{18, 18, "[optics]\nemission = \"spectra\""}})).optics.emission,
            Emission::spectra);
}

TEST(CdomFluorescence, NeedsAFileForATable) {
  const auto with = [](const std::string& lines) {
    return diagnostics_of(edited({{18, 18, "[optics]\n" + lines}}), {}, {});
  };
  EXPECT_EQ(with("cdom_fluorescence = \"hawes\"").size(), 0U);
  EXPECT_EQ(with("cdom_fluorescence = \"table\"").size(), 1U);
  EXPECT_EQ(with("cdom_fluorescence_file = \"eem.csv\"").size(), 1U);
}

}  // namespace
}  // namespace photic::scene
