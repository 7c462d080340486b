// Environments as they are written, and read back.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "unit/scene/environment_scenes.hpp"

namespace photic::scene {
namespace {

void expect_to_read_back(const Scene& scene) {
  const std::string text = write_scene(scene);
  const Scene again = read_scene_text(text, "written.toml", "/elsewhere").scene;
  EXPECT_TRUE(again == scene) << text;
  EXPECT_EQ(write_scene(again), text);
}

// Seen red: with keys written bare.
TEST(Environment, IsWrittenAsItWasRead) {
  const Scene scene = read_text(with_environments(R"([[environment]]
name = "murky \"x\""
set = { "sea.layer.a=\"b\"\\.chlorophyll_mg_m3" = 0.30000000000000004, 'sea.layer.1.phase_function' = {model="mie", max_radius_um=3}, "optics.raman" = 'marshall-smith' }
[[environment]]
set = {})"),
                                {R"(sea.layer.0.name=a="b"\)"});
  const std::string text = write_scene(scene);
  EXPECT_EQ(text.substr(text.find("\n[[environment]]")), R"(
[[environment]]
name = "murky \"x\""
set = { "sea.layer.a=\"b\"\\.chlorophyll_mg_m3" = 0.30000000000000004, "sea.layer.1.phase_function" = { model = "mie", max_radius_um = 3 }, "optics.raman" = "marshall-smith" }

[[environment]]
name = "environment1"
set = {}
)");
  expect_to_read_back(scene);
  const auto json = nlohmann::ordered_json::parse(write_scene_json(scene));
  EXPECT_EQ(json["environment"][0]["name"], "murky \"x\"");
  EXPECT_EQ(json["environment"][0]["set"]["sea.layer.a=\"b\"\\.chlorophyll_mg_m3"], 0.1 + 0.2);
  EXPECT_EQ(json["environment"][0]["set"]["sea.layer.1.phase_function"]["max_radius_um"], 3);
  EXPECT_EQ(json["environment"][1]["set"], nlohmann::ordered_json::object());
}

// What is written has every default in it and may be read from another folder: there the changes
// alone would not do.
// Seen red, each for itself: with the changes written as they stand; keys that a table loses left
// in it.
TEST(Environment, IsWrittenWithAllThatItsChangesComeTo) {
  const Scene paper = read_text(setting(R"("optics.set" = "paper")"));
  EXPECT_EQ(paper.environment[0].set,
            (std::vector<Change>{{"optics.set", R"("paper")"},
                                 {"optics.water_absorption", R"("smith-baker")"},
                                 {"optics.water_scattering", R"("smith-baker")"},
                                 {"optics.water_depolarisation", "0.17"},
                                 {"optics.phytoplankton", R"("prieur-sathyendranath")"},
                                 {"optics.phytoplankton_phase", R"("mie")"},
                                 {"optics.minerals", R"("mie")"},
                                 {"optics.minerals_phase", R"("mie")"},
                                 {"optics.raman", R"("marshall-smith")"}}));
  expect_to_read_back(paper);
  const Scene constituents = read_text(edited({{22, 22, ""}}) +
                                       R"([[environment]]
set = { "sea.layer.0.phase_function" = "petzold", "sea.layer.0.iop" = [{ wavelength_nm = 532, a_per_m = 0.06, b_per_m = 0.1 }] }
)");
  EXPECT_EQ(constituents.environment[0].set[0].path, "sea.layer.0");
  EXPECT_EQ(constituents.environment[0].set.size(), 1U);
  expect_to_read_back(constituents);
}

// Seen red: with the name of the file kept as it stands.
TEST(Environment, FilesAreRelativeToTheScene) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "photic_environment_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "vsf.csv") << "angle_deg,phase_function_per_sr\n0,1\n180,1\n";
  std::ofstream(folder / "scene.toml")
      << setting(R"("sea.layer.1.phase_function" = { model = "table", file = "vsf.csv" })");
  const Scene scene = read_scene((folder / "scene.toml").string()).scene;
  EXPECT_EQ(scene.environment[0].sea.layer[1].phase_function->table.data().name(),
            (folder / "vsf.csv").lexically_normal());
  expect_to_read_back(scene);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace photic::scene
