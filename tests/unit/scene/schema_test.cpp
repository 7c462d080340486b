// The JSON Schema of scenes.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "unit/scene/base_scene.hpp"
#include "unit/scene/lit_scene.hpp"
#include "unit/scene/row_scene.hpp"

namespace photic::scene {
namespace {

using nlohmann::json;

/// The schemas of all keys, wherever they stand.
void collect_properties(const json& schema, std::multimap<std::string, json>& found) {
  if (schema.is_object() && schema.value("type", "") == "object" && schema.contains("properties"))
    for (const auto& [key, value] : schema["properties"].items()) found.emplace(key, value);
  if (schema.is_structured())
    for (const auto& part : schema) collect_properties(part, found);
}

void collect_keys(const json& value, std::set<std::string>& keys) {
  if (value.is_object())
    for (const auto& [key, part] : value.items()) keys.insert(key);
  if (value.is_structured())
    for (const auto& part : value) collect_keys(part, keys);
}

/// Whether it is the key of a column of a file: by its name or its number.
bool names_a_column(const json& schema) {
  return schema.contains("anyOf") && schema["anyOf"][0].value("type", "") == "string" &&
         schema["anyOf"][1].value("type", "") == "integer";
}

/// Scenes that together use every key but those of other files, and but those that are written as
/// what they stand for: a grid, a table, profiles, the steps of a row of channels.
std::set<std::string> keys_of_scenes() {
  std::set<std::string> keys{"file",       "environment_grid",
                             "from",       "to",
                             "step",       "iop_table",
                             "column",     "profile_tolerance",
                             "variable",   "profile",
                             "depth",      "negative",
                             "above",      "below",
                             "background", "maximum",
                             "width_m"};
  for (const std::vector<Override>& overrides : std::vector<std::vector<Override>>{
           {"sea={ refractive_index = 1.3, group_index = 1.4, layer = [{ bottom_depth_m = 60 }] }",
            "simulation={ photons = 1, target_relative_error = 0.1, max_time_s = 1, max_order = 1, "
            "estimator_reason = \"why\", walk_attenuation = 0.9, directed_fraction = 0.5, "
            "batch_photons = 500, "
            "scored_points = 4, tools = { importance = [{ depth_m "
            "= 1, value = 2 }] } }"},
           {"telescope.0={ position_m = [0, 0, 12], direction = [0, 0, -1], diameter_m = 0.4, "
            "focal_length_m = 2, half_field_of_view_mrad = 10, focus_m = 12 }",
            "channel.0={ name = \"green\", centre_nm = 532, fwhm_nm = 3 }",
            "gates={ range_min_m = 10, range_max_m = 20, range_step_m = 1 }",
            "sea.layer.1.phase_function={ model = \"mixture\", components = [{ fraction = 0.5, "
            "model = \"fournier-forand\", refractive_index = 1.1, slope = 3.6 }, { fraction = 0.5, "
            "model = \"rayleigh\", depolarisation = 0.04 }] }"},
           {"sea.layer.1.phase_function=mie",
            "sea.layer.0={ jerlov = \"II\", bottom_depth_m = 1 }"},
           {"optics={ phytoplankton = \"table\", phytoplankton_file = { wavelength_nm = [500, "
            "600], a_m2_per_mg = [1, 2], b_m2_per_mg = [1, 2], a_exciting_m2_per_mg = [1, 1] }, "
            "cdom_fluorescence = \"table\", cdom_fluorescence_file = { excitation_nm = [500, 500], "
            "emission_nm = [550, 600], yield_per_nm = [1, 2] } }"},
           {"channel.0={ name = \"green\", transmission_file = { wavelength_nm = [500, 600], "
            "transmission = [1, 1] } }",
            "sea.layer.1.phase_function={ model = \"table\", file = { angle_deg = [0, 180], "
            "phase_function_per_sr = [0.1, 0.06] } }"},
           {"sea.layer.1={ iop = [{ wavelength_nm = 532, a_per_m = 1, b_per_m = 1, bb_per_m = 0.02 "
            "}] }"},
           {"sea.layer.1.bottom_depth_m=60",
            "bottom={ albedo = { zenith_deg = [0, 90], albedo = [0.1, 0.2] } }"},
           {"sea.surface={ model = \"cox-munk\", wind_speed_m_s = 5, whitecap_fraction = 0.01 }"},
           {"sea.surface={ model = \"gaussian\", upwind_slope_variance = 0.1, "
            "crosswind_slope_variance = 0 }"},
           {"oil={ class = \"light-refined\", thickness_um = 1, yield = 0.1, lifetime_ns = 3 }"},
           {"oil={ file = { wavelength_nm = [300, 900], n = [1.5, 1.5], a_per_m = [1e4, 1e3], "
            "emission_per_nm = [0, 1] }, thickness_um = 1, yield = 0.1, lifetime_ns = 3 }"},
           {"atmosphere={ profile = { z_km = [0, 9], p_hpa = [1000, 300], t_k = [290, 230], "
            "air_per_cm3 = [1e19, 1e18], ozone_per_cm3 = [0, 0], relative_humidity_percent = [1, "
            "1], water_vapour_per_cm3 = [0, 0], boundary_layer_per_km = [0, 0], "
            "troposphere_per_km = [0, 0], stratosphere_per_km = [0, 0], upper_atmosphere_per_km = "
            "[0, 0] }, visibility_km = 9, relative_humidity_percent = 80, gases = [{ top_km = 2, "
            "file = { wavelength_nm = [300, 900], optical_depth = [0, 0] } }] }"},
           {"atmosphere={ profile = \"us-standard\", aerosol_optical_depth_550 = 0.2 }"},
           {"atmosphere={ layer = [{ bottom_height_m = 0, top_height_m = 9, iop = [{ "
            "wavelength_nm = 532, a_per_m = 0, b_per_m = 1 }] }] }"},
           {"environment=[{ set = {} }]", "sensitivity=['sea.layer.0.chlorophyll_mg_m3']"},
           {"gates={ start_ns = 90, stop_ns = 200, step_ns = 2 }",
            "simulation.free_telescope_meetings=1", "simulation.free_laser_meetings=1",
            "simulation.conversion_probability=0.5", "simulation.walks=3", "simulation.meetings=10",
            "simulation.connected_fraction=0.5"}})
    collect_keys(json::parse(write_scene_json(base_scene(overrides))), keys);
  const std::string maps =
      "[[tally]]\nkind = \"fluence\"\nname = \"a\"\ndepth_m = [0, 1]\nradius_m = [0, 1]\n"
      "[[tally]]\nkind = \"fluence\"\nname = \"b\"\nheight_m = [0, 1]\nx_m = [0, 1]";
  const std::string levels =
      "[[tally]]\nkind = \"irradiance\"\ndepth_m = [1]\nslab_m = 0.1\n"
      "[[tally]]\nkind = \"radiance\"\ndepth_m = [1]\ndirection_deg = [[0, 0]]";
  const std::string rough = std::string(water) +
                            "\n[sea]\nsurface = { model = \"cox-munk\", wind_speed_m_s = 5, facets "
                            "= \"conserving\" }";
  for (const std::string& text :
       {lit_scene(std::string(sun) + "\nirradiance_w_m2 = 1", levels),
        lit_scene(std::string(lamp) + "\npower_w = 1", maps), lit_scene(sun, balance, rough),
        lit_scene(std::string(laser) + "\nenergy_j = 1"),
        lit_scene(std::string(laser) + "\nphotons_per_pulse = 1"),
        lit_scene(sun, balance, air_alone), row_scene(),
        lit_scene(sun, "[[tally]]\nkind = \"irradiance\"\nheight_m = [1]\nzone_deg = [0, 90]",
                  std::string(air_alone) + "\ngeometry = \"spherical\"\nplanet_radius_km = 6000")})
    collect_keys(json::parse(write_scene_json(read_text(text))), keys);
  return keys;
}

// Seen red: properties without a description; the keys of inline tables left out.
TEST(Schema, DescribesEveryKey) {
  std::multimap<std::string, json> properties;
  collect_properties(json::parse(scene_schema("1.2.3")), properties);
  const std::set<std::string> keys = keys_of_scenes();
  EXPECT_GE(keys.size(), 70U);
  for (const std::string& key : keys) EXPECT_EQ(properties.count(key) > 0, true) << key;
  for (const auto& [key, schema] : properties) {
    EXPECT_TRUE(keys.count(key) || names_a_column(schema)) << key << " is in no scene";
    EXPECT_FALSE(schema.value("description", "").empty()) << key;
    const std::string level = schema.value("x-level", "");
    EXPECT_TRUE(level == "basic" || level == "expert") << key << ": " << level;
  }
}

/// All schemas of one word, wherever they stand but in conditions.
void collect_words(const json& schema, std::vector<json>& found) {
  if (schema.is_object() && schema.contains("const")) found.push_back(schema);
  if (!schema.is_structured()) return;
  for (const auto& [key, part] : schema.items())
    if (key != "if") collect_words(part, found);
}

// Seen red: with "" for the meaning of "flat".
TEST(Schema, ExplainsEveryChoice) {
  std::vector<json> words;
  collect_words(json::parse(scene_schema("1.2.3")), words);
  EXPECT_GE(words.size(), 60U);
  for (const json& word : words) EXPECT_FALSE(word.value("description", "").empty()) << word;
}

bool holds_numbers(const json& schema) {
  if (schema.contains("anyOf")) return holds_numbers(schema["anyOf"][0]);
  const std::string type = schema.value("type", "");
  return type == "number" || type == "integer" ||
         (type == "array" && schema["items"].is_object() && holds_numbers(schema["items"]));
}

// Seen red: without "_um" in the table of units.
TEST(Schema, GivesTheUnitOfEveryQuantity) {
  std::multimap<std::string, json> properties;
  collect_properties(json::parse(scene_schema("1.2.3")), properties);
  const std::set<std::string> without{"seed", "profile", "value", "background", "maximum"};
  const std::map<std::string, std::string> units{{"wavelength_nm", "nm"},
                                                 {"position_m", "m"},
                                                 {"direction", "1"},
                                                 {"half_divergence_mrad", "mrad"},
                                                 {"chlorophyll_mg_m3", "mg/m3"},
                                                 {"minerals_g_m3", "g/m3"},
                                                 {"cdom_a440_per_m", "1/m"},
                                                 {"cdom_slope_per_nm", "1/nm"},
                                                 {"temperature_c", "degrees Celsius"},
                                                 {"salinity_psu", "PSU"},
                                                 {"max_radius_um", "um"},
                                                 {"max_time_s", "s"},
                                                 {"step_ns", "ns"},
                                                 {"a_m2_per_mg", "m2/mg"},
                                                 {"minerals_a_443_m2_per_g", "m2/g"},
                                                 {"angle_deg", "deg"},
                                                 {"phase_function_per_sr", "1/sr"},
                                                 {"photons", "1"},
                                                 {"g", "1"},
                                                 {"zenith_deg", "deg"},
                                                 {"albedo", "1"},
                                                 {"wind_speed_m_s", "m/s"},
                                                 {"wind_direction_deg", "deg"},
                                                 {"upwind_slope_variance", "1"},
                                                 {"whitecap_fraction", "1"},
                                                 {"slick", ""},
                                                 {"energy_j", "J"},
                                                 {"power_w", "W"},
                                                 {"irradiance_w_m2", "W/m2"},
                                                 {"direction_deg", "deg"},
                                                 {"radius_m", "m"},
                                                 {"from", "nm"}};
  std::set<std::string> seen;
  for (const auto& [key, schema] : properties) {
    const std::string unit = schema.value("x-unit", "");
    if (!holds_numbers(schema)) {
      EXPECT_EQ(unit, "") << key;
    } else if (without.count(key) == 0) {
      EXPECT_NE(unit, "") << key;
    }
    if (names_a_column(schema)) continue;
    if (const auto known = units.find(key); known != units.end()) {
      EXPECT_EQ(unit, known->second) << key;
      seen.insert(key);
    }
  }
  EXPECT_EQ(seen.size(), units.size());
}

// Seen red: with every key basic.
TEST(Schema, MarksWhatIsForExperts) {
  const json schema = json::parse(scene_schema("1.2.3"))["properties"];
  EXPECT_EQ(schema["source"]["properties"]["wavelength_nm"]["x-level"], "basic");
  EXPECT_EQ(schema["simulation"]["properties"]["photons"]["x-level"], "basic");
  EXPECT_EQ(schema["simulation"]["properties"]["meetings"]["x-level"], "expert");
  EXPECT_EQ(schema["simulation"]["properties"]["tools"]["x-level"], "expert");
}

// Seen red: with any text for a word.
TEST(Schema, WordsForAPhaseFunctionAreThoseThatNeedNothingElse) {
  const json sea = json::parse(scene_schema("1.2.3"))["properties"]["sea"];
  const json& words =
      sea["properties"]["layer"]["items"]["properties"]["phase_function"]["anyOf"][0]["oneOf"];
  std::vector<std::string> names;
  for (const json& word : words) names.push_back(word["const"]);
  EXPECT_EQ(names, (std::vector<std::string>{"petzold", "isotropic", "mie"}));
}

// Seen red: with [[environment]] required as the other arrays of tables are.
TEST(Schema, SaysTypesRangesChoicesAndDefaults) {
  const json schema = json::parse(scene_schema("1.2.3"));
  EXPECT_EQ(schema["$id"], "urn:photic:scene:1.2.3");
  EXPECT_FALSE(schema["title"].get<std::string>().empty());
  EXPECT_FALSE(schema["description"].get<std::string>().empty());
  EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
  EXPECT_EQ(schema["additionalProperties"], false);
  EXPECT_EQ(schema["required"], json({"source", "simulation"}));
  EXPECT_EQ(schema["properties"]["sensitivity"]["items"],
            json({{"type", "string"}, {"minLength", 1}}));
  EXPECT_EQ(schema["properties"]["sensitivity"]["default"], json::array());
  EXPECT_EQ(schema["properties"]["environment_grid"]["additionalProperties"],
            json({{"type", "array"}, {"minItems", 1}}));
  const json& source = schema["properties"]["source"];
  EXPECT_EQ(source["additionalProperties"], false);
  EXPECT_EQ(source["required"], json({"wavelength_nm"}));
  EXPECT_EQ(
      source["properties"]["kind"]["oneOf"][0],
      json({{"const", "laser"}, {"description", "a disc that emits light uniformly into a cone"}}));
  EXPECT_EQ(source["properties"]["position_m"]["minItems"], 3);
  const json& orders = schema["properties"]["simulation"]["properties"]["orders_kept"];
  EXPECT_EQ(orders["type"], "integer");
  EXPECT_EQ(orders["minimum"], 1);
  EXPECT_EQ(orders["maximum"], 1000);
  EXPECT_EQ(orders["default"], 6);
  const json& phase_function = schema["$defs"]["phase_function"];
  EXPECT_EQ(phase_function["properties"]["g"]["minimum"], -0.4);
  EXPECT_EQ(phase_function["allOf"][0]["if"]["properties"]["model"]["const"], "henyey-greenstein");
  EXPECT_EQ(phase_function["allOf"][0]["then"]["required"], json::array({"g"}));
  EXPECT_EQ(phase_function["properties"]["components"]["items"]["$ref"],
            "#/$defs/mixture_component");
}

// A source without a kind is a laser.
// Seen red: with every choice asked for by name.
TEST(Schema, EveryKindOfSourceHasKeysOfItsOwn) {
  const json kinds = json::parse(scene_schema("1.2.3"))["properties"]["source"]["allOf"];
  ASSERT_EQ(kinds.size(), 4U);
  EXPECT_FALSE(kinds[0]["if"].contains("required"));
  EXPECT_EQ(kinds[0]["then"]["required"],
            json({"position_m", "direction", "diameter_m", "half_divergence_mrad"}));
  EXPECT_EQ(kinds[0]["then"]["properties"]["power_w"], false);
  EXPECT_EQ(kinds[1]["if"]["required"], json::array({"kind"}));
  EXPECT_EQ(kinds[1]["if"]["properties"]["kind"]["const"], "beam");
  EXPECT_EQ(kinds[1]["then"]["allOf"][0]["oneOf"][1]["required"], json::array({"zenith_deg"}));
  EXPECT_FALSE(kinds[1]["then"]["properties"].contains("position_m"));
  EXPECT_EQ(kinds[3]["then"]["required"], json({"position_m", "direction", "half_angle_deg"}));
}

// Seen red: with channels let through without telescopes.
TEST(Schema, SectionsThatOthersAskFor) {
  const json sections = json::parse(scene_schema("1.2.3"))["allOf"];
  ASSERT_EQ(sections.size(), 4U);
  EXPECT_EQ(sections[0]["anyOf"],
            json::array({{{"required", {"telescope"}}}, {{"required", {"tally"}}}}));
  EXPECT_EQ(sections[1]["if"]["required"], json::array({"telescope"}));
  EXPECT_EQ(sections[1]["then"]["required"], json::array({"channel"}));
  EXPECT_EQ(sections[1]["else"]["properties"]["channel"], false);
  EXPECT_EQ(sections[2]["if"]["properties"]["atmosphere"]["required"], json::array({"surface"}));
  EXPECT_EQ(sections[2]["then"]["properties"]["sea"], false);
  EXPECT_EQ(sections[2]["else"]["required"], json::array({"sea"}));
  EXPECT_EQ(sections[3]["then"]["required"], json::array({"gates"}));
}

// Where the choice is not made the set makes it: the file of another choice is not asked for then.
// Seen red: with the condition met by a table without the choice.
TEST(Schema, AsksForAFileWhereItsChoiceIsMade) {
  const json condition = json::parse(scene_schema("1.2.3"))["properties"]["optics"]["allOf"][0];
  EXPECT_EQ(condition["if"]["properties"]["phytoplankton"]["const"], "table");
  EXPECT_EQ(condition["if"].value("required", json::array()), json::array({"phytoplankton"}));
  EXPECT_EQ(condition["then"]["required"], json::array({"phytoplankton_file"}));
  EXPECT_EQ(condition["else"]["properties"]["phytoplankton_file"], false);
}

// Seen red: with [[sea.layer]] required beside a table.
TEST(Schema, ConstituentsMayBeProfilesAndLayersATable) {
  const json schema = json::parse(scene_schema("1.2.3"));
  const json& sea = schema["properties"]["sea"];
  const json& chlorophyll = sea["properties"]["layer"]["items"]["properties"]["chlorophyll_mg_m3"];
  EXPECT_EQ(chlorophyll["anyOf"][0], json({{"type", "number"}, {"minimum", 0}}));
  EXPECT_EQ(chlorophyll["anyOf"][1]["$ref"], "#/$defs/profile");
  EXPECT_EQ(chlorophyll["default"], 0);
  EXPECT_EQ(schema["$defs"]["profile"]["anyOf"].size(), 3U);
  EXPECT_FALSE(sea.contains("required"));
  EXPECT_EQ(sea["allOf"][0]["oneOf"][0]["required"], json::array({"layer"}));
  EXPECT_EQ(sea["allOf"][0]["oneOf"][1]["required"], json::array({"column"}));
  EXPECT_EQ(sea["allOf"][0]["oneOf"][2]["required"], json::array({"iop_table"}));
  EXPECT_EQ(sea["allOf"][0]["oneOf"][0]["properties"]["column"], false);
}

TEST(Schema, EnvironmentsSetAnyPath) {
  const json schema = json::parse(scene_schema("1.2.3"));
  const json& environment = schema["properties"]["environment"];
  EXPECT_EQ(environment["type"], "array");
  EXPECT_EQ(environment["items"]["required"], json::array({"set"}));
  EXPECT_EQ(environment["items"]["properties"]["name"]["type"], "string");
  EXPECT_EQ(environment["items"]["properties"]["set"]["type"], "object");
  EXPECT_EQ(environment["items"]["properties"]["set"]["additionalProperties"], true);
}

TEST(Schema, KeysThatExcludeEachOther) {
  const json schema = json::parse(scene_schema("1.2.3"));
  const json& ways = schema["properties"]["telescope"]["items"]["allOf"][0]["oneOf"];
  EXPECT_EQ(ways[0]["required"], json::array({"detector_diameter_m"}));
  EXPECT_EQ(ways[0]["properties"]["half_field_of_view_mrad"], false);
  EXPECT_EQ(ways[1]["required"], json::array({"half_field_of_view_mrad"}));
  EXPECT_EQ(ways[1]["properties"]["detector_diameter_m"], false);
  const json& focus = schema["properties"]["telescope"]["items"]["allOf"][1]["oneOf"];
  EXPECT_EQ(focus[0]["properties"]["focus_m"], false);
  EXPECT_EQ(focus[1]["required"], json::array({"focus_m"}));
  EXPECT_EQ(focus[1]["properties"]["detector_shift_m"], false);
  EXPECT_EQ(schema["properties"]["simulation"]["allOf"][0]["anyOf"][2]["required"],
            json::array({"max_time_s"}));
}

}  // namespace
}  // namespace photic::scene
