// The starter scenes.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>

#include "core/error.hpp"
#include "unit/scene/base_scene.hpp"

namespace photic::scene {
namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// Seen red: with rov.toml left out of the list in src/scene/CMakeLists.txt.
TEST(Starter, EverySceneIsOne) {
  std::set<std::string> kinds, files;
  for (const auto& [kind, summary] : starter_kinds()) {
    kinds.insert(kind);
    EXPECT_TRUE(summary.ends_with('.')) << summary;
  }
  for (const auto& entry : std::filesystem::directory_iterator(PHOTIC_SOURCE_DIR "/scenes")) {
    const std::string text = text_of(entry.path());
    EXPECT_FALSE(text.empty());
    if (entry.path().extension() != ".toml") continue;
    EXPECT_EQ(starter_scene(entry.path().stem().string()), text);
    files.insert(entry.path().stem().string());
  }
  EXPECT_EQ(kinds, files);
}

// Seen red: with argo-profile.csv left out of the list in src/scene/CMakeLists.txt.
TEST(Starter, EveryFileOfAScene) {
  std::map<std::string, std::string> known, there;
  for (const auto& [kind, summary] : starter_kinds())
    for (const auto& [name, text] : starter_files(kind)) known[name] = text;
  for (const auto& entry : std::filesystem::directory_iterator(PHOTIC_SOURCE_DIR "/scenes"))
    if (entry.path().extension() != ".toml") there[entry.path().filename()] = text_of(entry.path());
  EXPECT_EQ(known, there);
  EXPECT_FALSE(known.empty());
}

// Benchmarks are the same work each time; the others end where they are good enough.
// Seen red: with photons in ship.toml.
TEST(Starter, EndsByATargetOrATime) {
  for (const auto& [kind, summary] : starter_kinds()) {
    const auto reading = read_scene_text(starter_scene(kind), kind, PHOTIC_SOURCE_DIR "/scenes");
    const Simulation s = reading.scene.simulation;
    const bool benchmark = kind.starts_with("benchmark");
    EXPECT_EQ(s.photons.has_value(), benchmark) << kind;
    EXPECT_EQ(s.target_relative_error.has_value() && s.max_time_s.has_value(), !benchmark) << kind;
  }
}

TEST(Starter, NamesTheKindsThereAre) {
  const auto said = [](const std::string& kind) -> std::string {
    try {
      return starter_scene(kind);
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(said("shop"), "there is no starter scene 'shop' (did you mean 'ship'?)");
  EXPECT_EQ(
      said("satellite"),
      "there is no starter scene 'satellite' (choose from: ship, ship-tilted, "
      "ship-waves, biaxial, airborne, airborne-waves, bathymetric, airborne-high, spaceborne, "
      "spaceborne-waves, rov, fluorosensor-355, oil-spill, oil-spill-airborne, plume, argo, "
      "three-layers, sun, cone, minimal, benchmark-peaked, benchmark-hg)");
}

}  // namespace
}  // namespace photic::scene
