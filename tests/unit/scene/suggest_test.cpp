// What is proposed for words that are not known, and what is not.
#include "scene/suggest.hpp"

#include <gtest/gtest.h>

#include "unit/scene/base_scene.hpp"

namespace photic::scene {
namespace {

const std::vector<std::string> some_keys{
    "wavelength_nm",     "position_m",        "half_divergence_mrad", "half_field_of_view_mrad",
    "chlorophyll_yield", "chlorophyll_mg_m3", "cdom_a440_per_m",      "cdom_slope_per_nm",
    "depth_min_m",       "depth_max_m",       "fournier-forand",      "elastic"};

std::string proposed(const std::string& word) {
  return suggestion_for(word, some_keys, "choose from");
}

// Seen red: without `longer`.
TEST(Suggest, WhatIsAlikeButForCaseUnitOrWords) {
  const std::map<std::string, std::string> expected{
      {"wavelenght_nm", "did you mean 'wavelength_nm'?"},
      {"Wavelength_nm", "did you mean 'wavelength_nm'?"},
      {"WAVELENGTH-NM", "did you mean 'wavelength_nm'?"},
      {"ELASTIC", "did you mean 'elastic'?"},
      {"fournier", "did you mean 'fournier-forand'?"},
      {"chlorophyll", "did you mean 'chlorophyll_mg_m3'?"},
      {"chlorophyll_ug_l", "did you mean 'chlorophyll_mg_m3'? it is in mg/m3"},
      {"wavelength_um", "did you mean 'wavelength_nm'? it is in nm"},
      {"divergence_mrad", "did you mean 'half_divergence_mrad'? it is half of the full angle"},
      {"full_divergence_mrad", "did you mean 'half_divergence_mrad'? it is half of the full angle"},
      {"field_of_view_deg",
       "did you mean 'half_field_of_view_mrad'? it is half of the full angle, in mrad"},
      {"half_divergence", "did you mean 'half_divergence_mrad'?"},
      {"cdom", "did you mean 'cdom_a440_per_m' or 'cdom_slope_per_nm'?"},
      {"depth", "did you mean 'depth_min_m' or 'depth_max_m'?"}};
  for (const auto& [word, text] : expected) EXPECT_EQ(proposed(word), text) << word;
}

// Seen red: with `longer` for words of one letter; with as many misspelt letters as a word has.
// One letter of two is half of the word: type IA of Jerlov is no misspelt IB.
TEST(Suggest, NothingForShortWords) {
  EXPECT_EQ(suggestion_for("IA", {"IB", "II", "III"}, "there are"), "there are: IB, II, III");
}

TEST(Suggest, OtherTimes) {
  EXPECT_EQ(suggestion_for("max_time_min", {"max_time_s", "seed"}, "there are"),
            "did you mean 'max_time_s'? it is in s");
}

TEST(Suggest, NothingThatIsFar) {
  for (const std::string word : {"", "m", "nm", "of", "banana", "photons", "temperature_c",
                                 "chlorophyll_lifetime_ns", "a_per_m", "satellite"})
    EXPECT_TRUE(proposed(word).starts_with("choose from: wavelength_nm, ")) << word;
  EXPECT_EQ(suggestion_for("chlorophyll_mg_m3", {"name", "chlorophyll_yield"}, "there"),
            "there: name, chlorophyll_yield");
}

// Seen red: with the sections of experts among them.
TEST(Suggest, TheSectionThatAKeyBelongsIn) {
  const std::vector<Case> all{
      {"Below",
       {{30, 30, "photons = 1\nDepth_step_m = 1"}},
       {"scene.toml:31:1: unknown key 'Depth_step_m' in [simulation] (it belongs in [gates])"}},
      {"InOneOfTwo",
       {{30, 30, "photons = 1\nsalinity_psu = 1"}},
       {"scene.toml:31:1: unknown key 'salinity_psu' in [simulation] (it belongs in [sea] or "
        "[[sea.layer]])"}},
      {"AtTheTop",
       {{1, 1, "seed = 1"}},
       {"scene.toml:1:1: unknown key 'seed' in the scene (it belongs in [simulation])"}},
      {"ASection",
       {{1, 1, "surface = {}\nlayer = 1"}},
       {"scene.toml:1:1: unknown key 'surface' in the scene (it belongs in [sea] or [atmosphere])",
        "scene.toml:2:1: unknown key 'layer' in the scene (write [[sea.layer]])"}},
      {"NotThoseOfExperts",
       {{27, 27, "depth_m = 1\ndepth_max_m = 20"}},
       {"scene.toml:27:1: unknown key 'depth_m' in [gates] (did you mean 'depth_min_m', "
        "'depth_max_m' or 'depth_step_m'?)"}}};
  for (const Case& c : all) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(diagnostics_of(edited(c.edits)), c.expected);
  }
}

}  // namespace
}  // namespace photic::scene
