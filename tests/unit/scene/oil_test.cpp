// The film of oil of a scene: what is filled in, and what is said of one that is amiss.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "scene/read.hpp"
#include "unit/scene/base_scene.hpp"

namespace photic::scene {
namespace {

const Override crude{"oil={ class = \"weakly-absorbing-crude\", thickness_um = 1 }"};
const Override wind{"sea.surface={ model = \"cox-munk\", wind_speed_m_s = 7 }"};

Texts reported(const std::vector<Override>& overrides) {
  return diagnostics_of(edited({}), overrides);
}

TEST(Oil, IsNoneByItself) { EXPECT_FALSE(base_scene().oil); }

// Seen red: with the default of a clean sea.
TEST(Oil, DampsTheWavesUnlessTheSceneSaysNot) {
  const Surface under = base_scene({wind, crude}).sea.surface;
  EXPECT_TRUE(under.slick);
  EXPECT_FALSE(under.has_whitecaps());
  const Surface rough = base_scene({wind, crude, {"sea.surface.slick=false"}}).sea.surface;
  EXPECT_FALSE(rough.slick);
  EXPECT_FALSE(rough.has_whitecaps());
  EXPECT_FALSE(base_scene({wind}).sea.surface.slick);
  EXPECT_TRUE(base_scene({wind}).sea.surface.has_whitecaps());
}

TEST(Oil, IsWrittenAsItWasRead) {
  const Scene scene = base_scene({wind, crude, {"oil.yield=0.02"}, {"sea.surface.slick=false"}});
  EXPECT_EQ(read_text(write_scene(scene)), scene);
}

constexpr const char* columns = "wavelength_nm,n,a_per_m,emission_per_nm\n";
constexpr const char* oil_rows = "300,1.5,1e5,0\n900,1.5,1e3,1\n";

/// The scene with an oil from a file, of this process: tests run side by side.
struct OilFile {
  std::string folder;
  explicit OilFile(const std::string& text)
      : folder(::testing::TempDir() + std::to_string(getpid()) + '.') {
    std::ofstream(folder + "photic-oil.csv") << text;
  }
  [[nodiscard]] std::vector<Override> overrides() const {
    return {{"oil={ file = \"" + folder + "photic-oil.csv\", thickness_um = 1 }"}};
  }
};

// What a file gives stands in the written scene, which needs no file.
TEST(Oil, OfAFileHasItsYieldAndLifetime) {
  const OilFile file(std::string("# yield: 0.05\n# lifetime_ns: 7\n") + columns + oil_rows);
  const Scene scene = base_scene(file.overrides());
  EXPECT_EQ(scene.oil->yield, 0.05);
  EXPECT_EQ(scene.oil->lifetime_ns, 7);
  EXPECT_EQ(read_text(write_scene(scene)), scene);
  auto given = file.overrides();
  given.push_back({"oil.yield=0.1"});
  EXPECT_EQ(base_scene(given).oil->yield, 0.1);
}
TEST(Oil, OfAFileWithoutThemIsRefused) {
  const OilFile file(std::string("# yield: 0.05\n") + columns + oil_rows);
  const Texts all = reported(file.overrides());
  ASSERT_EQ(all.size(), 1U);
  EXPECT_TRUE(
      all[0].ends_with("photic-oil.csv:1:1: no line \"# lifetime_ns: …\" (add it, or give "
                       "lifetime_ns in [oil])"))
      << all[0];
}

// Seen red: with the numbers of the file before the scene's.
TEST(Oil, GivesInTheSceneWhatItsFileDoesNot) {
  const OilFile bare(std::string(columns) + oil_rows);
  auto given = bare.overrides();
  given.push_back({"oil.yield=0.1"});
  EXPECT_TRUE(
      reported(given).at(0).ends_with("no line \"# lifetime_ns: …\" (add it, or give "
                                      "lifetime_ns in [oil])"));
  given.push_back({"oil.lifetime_ns=3"});
  EXPECT_EQ(reported(given), Texts{});
  EXPECT_EQ(base_scene(given).oil->lifetime_ns, 3);
  const OilFile full(std::string("# yield: much\n# lifetime_ns: 7\n") + columns + oil_rows);
  EXPECT_EQ(reported(given), Texts{});
  EXPECT_EQ(base_scene(given).oil->yield, 0.1);
}

/// Columns in the scene, with more beside them.
Override oil_of_columns(const std::string& beside, const std::string& more = "") {
  return {
      "oil={ thickness_um = 1, file = { wavelength_nm = [300, 900], n = [1.5, 1.4], a_per_m = "
      "[1e5, 1e3]" +
      beside + " }" + more + " }"};
}
const std::string shining = ", emission_per_nm = [0, 1]";

// Seen red: with the numbers beside the columns before those of [oil].
TEST(Oil, OfColumnsInTheSceneMayHaveYieldAndLifetimeBesideThem) {
  const std::string beside = shining + ", yield = 0.05, lifetime_ns = 7";
  const Scene scene = base_scene({oil_of_columns(beside)});
  EXPECT_EQ(scene.oil->yield, 0.05);
  EXPECT_EQ(scene.oil->lifetime_ns, 7);
  EXPECT_EQ(read_text(write_scene(scene)), scene);
  const Scene other = base_scene({oil_of_columns(beside, ", yield = 0.1, lifetime_ns = 2")});
  EXPECT_EQ(other.oil->yield, 0.1);
  EXPECT_EQ(other.oil->lifetime_ns, 2);
  EXPECT_EQ(reported({oil_of_columns(shining)}),
            (Texts{"--set oil: 'yield' is missing in [oil] (add it, there or in 'file')",
                   "--set oil: 'lifetime_ns' is missing in [oil] (add it, there or in 'file')"}));
  EXPECT_EQ(reported({oil_of_columns(shining + ", yield = 2, lifetime_ns = -1")}),
            (Texts{"--set oil: 'yield' must be a finite number, at least 0 and at most 1, not 2",
                   "--set oil: 'lifetime_ns' must be a finite number, at least 0, not -1"}));
}

// Seen red: with a lifetime asked for.
TEST(Oil, ThatDoesNotShineNeedsNoSpectrum) {
  EXPECT_EQ(base_scene({oil_of_columns(", yield = 0")}).oil->lifetime_ns, 0);
  const Scene scene = base_scene({oil_of_columns("", ", yield = 0, lifetime_ns = 2")});
  EXPECT_EQ(scene.oil->lifetime_ns, 2);
  EXPECT_EQ(read_text(write_scene(scene)), scene);
  const OilFile file("# yield: 0\nwavelength_nm,n,a_per_m\n300,1.5,1e5\n900,1.5,1e3\n");
  EXPECT_EQ(reported(file.overrides()), Texts{});
}

TEST(Oil, EveryTextOfWhatIsWrong) {
  const auto with = [](const Override& more) { return reported({crude, more}); };
  EXPECT_EQ(reported({{"oil={ thickness_um = 1 }"}}),
            Texts{"--set oil: [oil] needs 'class' or 'file'"});
  EXPECT_EQ(
      reported({{"oil={ class = \"light-refined\" }"}}),
      Texts{"--set oil: 'thickness_um' is missing in [oil] (add it: the thickness of the film "
            "in um; at 0 there is none)"});
  EXPECT_EQ(with({"oil.thickness_um=-1"}),
            Texts{"--set oil.thickness_um: 'thickness_um' must be a finite number, at least 0, not "
                  "-1"});
  EXPECT_EQ(reported({wind, crude, {"sea.surface.whitecaps=true"}}),
            Texts{"--set sea.surface.whitecaps: there are no whitecaps on a film of oil (leave it "
                  "out, or leave [oil] out)"});
  EXPECT_EQ(reported({wind, crude, {"sea.surface.whitecap_fraction=0.1"}}),
            Texts{"--set sea.surface.whitecap_fraction: there are no whitecaps on a film of oil "
                  "(leave it out, or leave [oil] out)"});
  EXPECT_EQ(with({"simulation.reception=overlap"}),
            Texts{"--set simulation.reception: a film of oil lights the lens unevenly: the mean "
                  "over the lens is not known (write reception = \"ray\")"});
  EXPECT_EQ(with({"simulation.tools={ forced_collisions = 2 }"}),
            Texts{"--set simulation.tools: how much light leaves the water is known only for a "
                  "clean surface (write forced_collisions = 0, or leave [oil] out)"});
  EXPECT_EQ(reported({crude, {"channel.0.process=oil"}, {"simulation.estimator=bidirectional"}}),
            Texts{});
  EXPECT_EQ(reported({crude, wind, {"simulation.estimator=analog"}}), Texts{});
  EXPECT_EQ(reported({crude, {"oil.yield=0.6"}, {"simulation.estimator=analog"}}),
            Texts{"--set simulation.estimator: analog photons are emitted with a probability below "
                  "1, and so by oils with a yield up to 0.5 (write estimator = \"forward\")"});
}

TEST(Oil, AsThickAsAMillimetreIsRemarkedOn) {
  const auto remarks = [](const Override& thickness) {
    return read_scene_text(edited({}), "scene.toml", "/", {crude, thickness}).remarks;
  };
  EXPECT_EQ(remarks({"oil.thickness_um=1000"}), Texts{});
  EXPECT_EQ(remarks({"oil.thickness_um=1001"}),
            Texts{"--set oil.thickness_um: oil of more than 1 mm is not a film: scattering in it, "
                  "and the sideways shift of light, are left out"});
}

TEST(Oil, MayDifferInEnvironmentsButForWhatTimesItsLight) {
  const auto in = [](const std::string& set) {
    return reported({crude, {"environment=[{ set = { " + set + " } }]"}});
  };
  EXPECT_EQ(in("\"oil.thickness_um\" = 0"), Texts{});
  EXPECT_EQ(in("\"oil.yield\" = 0.1, \"oil.absorption_factor\" = 2"), Texts{});
  for (const char* key : {"\"oil.lifetime_ns\" = 3", "\"oil.class\" = \"light-refined\""}) {
    const Texts all = in(key);
    ASSERT_EQ(all.size(), 1U) << key;
    EXPECT_NE(all[0].find("must be as in the scene"), std::string::npos) << all[0];
  }
  const Scene scene = base_scene({crude, {"environment=[{ set = { \"oil.thickness_um\" = 0 } }]"}});
  EXPECT_EQ(scene.environment[0].oil->thickness_um, 0);
  EXPECT_EQ(scene_in(scene, scene.environment[0]).oil->thickness_um, 0);
  EXPECT_EQ(read_text(write_scene(scene)), scene);
}

}  // namespace
}  // namespace photic::scene
