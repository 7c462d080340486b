// The sea surface of a scene: what it becomes, in environments, how it is written.
#include <gtest/gtest.h>

#include <cmath>

#include <nlohmann/json.hpp>

#include "core/constants.hpp"
#include "scene/waves.hpp"
#include "unit/scene/surface_scenes.hpp"

namespace photic::scene {
namespace {

// --- What it becomes -----------------------------------------------------------------------------

TEST(Surface, HasTheDefaultsOfItsModel) {
  const Surface sea = surface_of(waves);
  EXPECT_EQ(sea.model, SurfaceModel::cox_munk);
  EXPECT_EQ(sea.wind_speed_m_s, 5.0);
  EXPECT_EQ(sea.wind_direction_deg, 0.0);
  EXPECT_FALSE(sea.slick);
  EXPECT_TRUE(sea.gram_charlier);
  EXPECT_FALSE(sea.whitecap_fraction);
  EXPECT_EQ(sea.whitecap_law, WhitecapLaw::monahan1980);
  EXPECT_EQ(sea.whitecap_reflectance, WhitecapReflectance::koepke1984);
}

// What is on by default is filled in, for effective scenes to show it. Seen red: without that; with
// whitecaps of slicks.
TEST(Surface, SaysWhetherThereAreWhitecaps) {
  const auto whitecaps = [](const std::string& keys) { return surface_of(keys).whitecaps; };
  const std::string sea = waves, calm = R"(model = "cox-munk", wind_speed_m_s = 0)";
  const std::string paper = R"(model = "paper", wind_speed_m_s = 5)";
  const std::string own =
      R"(model = "gaussian", upwind_slope_variance = 0.02, crosswind_slope_variance = 0.01)";
  EXPECT_EQ(whitecaps(sea), true);
  EXPECT_EQ(whitecaps(sea + ", whitecaps = false"), false);
  EXPECT_EQ(whitecaps(sea + ", slick = true"), false);
  EXPECT_EQ(whitecaps(sea + ", slick = true, whitecaps = true"), true);
  EXPECT_EQ(whitecaps(sea + ", slick = true, whitecap_fraction = 0.1"), true);
  EXPECT_EQ(whitecaps(paper), false);
  EXPECT_EQ(whitecaps(paper + ", whitecaps = true"), true);
  EXPECT_EQ(whitecaps(own), false);
  EXPECT_EQ(whitecaps(own + ", whitecap_fraction = 0.1"), true);
  EXPECT_EQ(whitecaps(calm), std::nullopt);
  EXPECT_EQ(whitecaps(R"(model = "flat")"), std::nullopt);
}

// Seen red: with every model but "flat" rough.
TEST(Surface, IsFlatWithoutWindAndWithoutSlopes) {
  const auto is_rough = [](const std::string& keys) { return surface_of(keys).is_rough(); };
  const std::string own = "model = \"gaussian\", upwind_slope_variance = ";
  EXPECT_TRUE(is_rough(waves));
  EXPECT_FALSE(is_rough(R"(model = "flat")"));
  EXPECT_FALSE(is_rough(R"(model = "cox-munk", wind_speed_m_s = 0)"));
  EXPECT_FALSE(is_rough(R"(model = "paper", wind_speed_m_s = 0.0)"));
  EXPECT_FALSE(is_rough(own + "0, crosswind_slope_variance = 0"));
  EXPECT_TRUE(is_rough(own + "0.01, crosswind_slope_variance = 0"));
  EXPECT_TRUE(is_rough(own + "0, crosswind_slope_variance = 0.01"));
}

// What a flat surface can do, all surfaces without waves can.
TEST(Surface, WithoutWavesMayHaveAllEstimators) {
  for (const std::string model : {"cox-munk", "paper"})
    EXPECT_EQ(diagnostics_of(
                  edited(with_surface("model = \"" + model + "\", wind_speed_m_s = 0",
                                      "estimator = \"bidirectional\"\nreception = \"overlap\""))),
              Texts{});
  for (const std::string estimator : {"auto", "forward", "analog"})
    EXPECT_EQ(diagnostics_of(edited(with_surface(waves, "estimator = \"" + estimator + '"'))),
              Texts{});
}

TEST(Surface, IsReachedBySet) {
  const auto set = [](const std::string& keys, const Override& change) {
    return read_text(edited(with_surface(keys)), {change}).sea.surface;
  };
  EXPECT_EQ(set(waves, "sea.surface.wind_speed_m_s=7.5").wind_speed_m_s, 7.5);
  EXPECT_EQ(set(waves, "sea.surface.slick=true").slick, true);
  EXPECT_EQ(set(waves, "sea.surface.model=paper").model, SurfaceModel::paper);
  EXPECT_EQ(base_scene({"sea.surface.model=cox-munk", "sea.surface.wind_speed_m_s=3"}).sea.surface,
            surface_of("model = \"cox-munk\", wind_speed_m_s = 3"));
  EXPECT_EQ(diagnostics_of(edited({}), {"sea.surface.wind_speed_m_s=5"}),
            Texts{"--set sea.surface.wind_speed_m_s: 'wind_speed_m_s' does not belong to model = "
                  "\"flat\" (it belongs to \"cox-munk\" and \"paper\")"});
  EXPECT_EQ(diagnostics_of(edited(with_surface(waves)), {"sea.surface.wind_speed_m_s=50"}),
            Texts{"--set sea.surface.wind_speed_m_s: 'wind_speed_m_s' must be a finite number, at "
                  "least 0 and at most 30, not 50"});
}

// --- Environments and derivatives ----------------------------------------------------------------

// The first difference is reported, not what follows from it. Seen red: with all keys reported;
// with the wind left out.
TEST(Surface, DiffersBySlopesAndWhitecapsAlone) {
  const auto reported = [](const std::string& changes) {
    return diagnostics_of(edited(with_surface(waves)) + "[[environment]]\nset = { " + changes +
                          " }\n");
  };
  const auto other = [](const std::string& key, const std::string& here, const std::string& there) {
    return Texts{"scene.toml:34:9: '" + key + "' must be as in the scene, " + here + ", not " +
                 there +
                 ": it bends the light, whose histories are the same in all environments (simulate "
                 "that in a scene of its own)"};
  };
  EXPECT_EQ(reported(R"("sea.surface.wind_speed_m_s" = 5.0, "sea.surface.slick" = false)"),
            Texts{});
  EXPECT_EQ(reported(R"("sea.surface.whitecaps" = true)"), Texts{});
  EXPECT_EQ(reported(R"("sea.surface.wind_speed_m_s" = 6)"), Texts{});
  EXPECT_EQ(reported(R"("sea.surface.wind_speed_m_s" = 0)"), Texts{});
  EXPECT_EQ(reported(R"("sea.surface.wind_direction_deg" = 90)"),
            other("wind_direction_deg", "0", "90"));
  EXPECT_EQ(reported(R"("sea.surface.slick" = true)"), Texts{});
  EXPECT_EQ(reported(R"("sea.surface.gram_charlier" = false)"),
            other("gram_charlier", "true", "false"));
  EXPECT_EQ(reported(R"("sea.surface.whitecaps" = false)"), Texts{});
  EXPECT_EQ(reported(R"("sea.surface.whitecap_fraction" = 0.1)"), Texts{});
  EXPECT_EQ(reported(R"("sea.surface.whitecap_law" = "stramska2003")"), Texts{});
  EXPECT_EQ(reported(R"("sea.surface.whitecap_reflectance" = "frouin1996")"),
            other("whitecap_reflectance", "text \"koepke1984\"", "text \"frouin1996\""));
  EXPECT_EQ(reported(R"("sea.surface" = { model = "flat" })"),
            other("model", "text \"cox-munk\"", "text \"flat\""));
  EXPECT_EQ(
      reported(
          R"("sea.surface" = { model = "gaussian", upwind_slope_variance = 0.1, crosswind_slope_variance = 0 })"),
      other("model", "text \"cox-munk\"", "text \"gaussian\""));
}

TEST(Surface, HasDerivatives) {
  EXPECT_EQ(diagnostics_of("sensitivity = ['sea.surface.wind_speed_m_s']\n" +
                           edited(with_surface(waves))),
            Texts{});
}

// --- How it is written ---------------------------------------------------------------------------

// Seen red: with the optional keys not written; with keys of other models written.
TEST(Surface, IsWrittenWithTheKeysOfItsModel) {
  const auto written = [](const std::string& keys) {
    const Scene scene = read_text(edited(with_surface(keys)));
    const std::string text = write_scene(scene);
    EXPECT_EQ(read_text(text), scene) << text;
    EXPECT_EQ(write_scene(read_text(text)), text);
    const auto begin = text.find("surface = ");
    return text.substr(begin, text.find('\n', begin) - begin);
  };
  EXPECT_EQ(written(waves),
            "surface = { model = \"cox-munk\", wind_speed_m_s = 5.0, wind_direction_deg = 0.0, "
            "slick = false, gram_charlier = true, whitecaps = true, whitecap_law = "
            "\"monahan1980\", whitecap_reflectance = \"koepke1984\" }");
  EXPECT_EQ(
      written(
          R"(model = "cox-munk", wind_speed_m_s = 0.1, slick = true, whitecap_fraction = 0.30000000000000004)"),
      "surface = { model = \"cox-munk\", wind_speed_m_s = 0.1, wind_direction_deg = 0.0, "
      "slick = true, gram_charlier = true, whitecaps = true, whitecap_fraction = "
      "0.30000000000000004, whitecap_law = \"monahan1980\", whitecap_reflectance = "
      "\"koepke1984\" }");
  EXPECT_EQ(written(R"(model = "cox-munk", wind_speed_m_s = 0)"),
            "surface = { model = \"cox-munk\", wind_speed_m_s = 0.0, wind_direction_deg = 0.0, "
            "slick = false, gram_charlier = true, whitecap_law = \"monahan1980\", "
            "whitecap_reflectance = \"koepke1984\" }");
  EXPECT_EQ(
      written(
          R"(model = "gaussian", upwind_slope_variance = 0.02, crosswind_slope_variance = 0, wind_direction_deg = -90)"),
      "surface = { model = \"gaussian\", wind_direction_deg = -90.0, upwind_slope_variance = "
      "0.02, crosswind_slope_variance = 0.0, whitecaps = false, whitecap_reflectance = "
      "\"koepke1984\" }");
  EXPECT_EQ(written(R"(model = "paper", wind_speed_m_s = 7)"),
            "surface = { model = \"paper\", wind_speed_m_s = 7.0, wind_direction_deg = 0.0, "
            "whitecaps = false, whitecap_law = \"monahan1980\", whitecap_reflectance = "
            "\"koepke1984\" }");
  EXPECT_EQ(written(R"(model = "flat")"), "surface = { model = \"flat\" }");
}

TEST(Surface, IsTheSameInJson) {
  const auto written = nlohmann::ordered_json::parse(write_scene_json(
      read_text(edited(with_surface(std::string(waves) + ", whitecap_fraction = 0.25")))));
  EXPECT_EQ(written["sea"]["surface"],
            nlohmann::ordered_json({{"model", "cox-munk"},
                                    {"wind_speed_m_s", 5.0},
                                    {"wind_direction_deg", 0.0},
                                    {"slick", false},
                                    {"gram_charlier", true},
                                    {"whitecaps", true},
                                    {"whitecap_fraction", 0.25},
                                    {"whitecap_law", "monahan1980"},
                                    {"whitecap_reflectance", "koepke1984"}}));
}

// --- Its schema ----------------------------------------------------------------------------------

nlohmann::json condition_for(const nlohmann::json& surface, const std::string& key) {
  for (const auto& condition : surface["allOf"])
    if (condition["else"]["properties"].contains(key)) return condition;
  return {};
}

// Seen red: with the first of several models alone.
TEST(Surface, KeysOfSeveralModelsHaveOneConditionInTheSchema) {
  using nlohmann::json;
  const json surface =
      json::parse(scene_schema("1.2.3"))["properties"]["sea"]["properties"]["surface"];
  EXPECT_EQ(surface["properties"]["slick"]["type"], "boolean");
  EXPECT_EQ(surface["properties"]["slick"]["default"], false);
  EXPECT_EQ(surface["properties"]["gram_charlier"]["default"], true);
  EXPECT_FALSE(surface["properties"]["whitecaps"].contains("default"));
  EXPECT_EQ(surface["properties"]["wind_speed_m_s"]["maximum"], 30);
  const json wind = condition_for(surface, "wind_speed_m_s");
  EXPECT_EQ(wind["if"]["properties"]["model"], json({{"enum", {"cox-munk", "paper"}}}));
  EXPECT_EQ(wind["if"]["required"], json::array({"model"}));
  EXPECT_EQ(wind["then"]["required"], json::array({"wind_speed_m_s"}));
  EXPECT_EQ(wind["else"]["properties"]["wind_speed_m_s"], false);
  const json slick = condition_for(surface, "slick");
  EXPECT_EQ(slick["if"]["properties"]["model"], json({{"const", "cox-munk"}}));
  EXPECT_EQ(slick["then"]["required"], json::array());
  EXPECT_EQ(condition_for(surface, "whitecaps")["if"]["properties"]["model"]["enum"],
            json({"cox-munk", "gaussian", "paper"}));
  EXPECT_EQ(condition_for(surface, "upwind_slope_variance")["then"]["required"],
            json({"upwind_slope_variance", "crosswind_slope_variance"}));
}

// What the bidirectional estimator cannot do is reported before a run.
TEST(Surface, WhatTheBidirectionalEstimatorHasNot) {
  Scene scene = read_text(edited(with_surface(waves)));
  EXPECT_EQ(bidirectional_lacks(scene), std::nullopt);
  const auto looks_off_vertical = [&](double degrees) {
    const double angle = degrees * radian_per_degree;
    scene.telescope[0].direction = {std::sin(angle), 0, -std::cos(angle)};
  };
  scene.telescope[0].detector_diameter_m = 0.4;  // 5.7 degrees to each side
  looks_off_vertical(74);
  EXPECT_EQ(bidirectional_lacks(scene), std::nullopt);
  scene.sea.surface = surface_of(
      R"(model = "gaussian", upwind_slope_variance = 0.0, crosswind_slope_variance = 0.02)");
  EXPECT_EQ(bidirectional_lacks(scene),
            "one-dimensional waves seen by rays within 12 degrees of the horizontal");
  looks_off_vertical(71);
  EXPECT_EQ(bidirectional_lacks(scene), std::nullopt);
  looks_off_vertical(74);
  scene.telescope[0].position_m.z = -1;
  EXPECT_EQ(bidirectional_lacks(scene), std::nullopt);
  scene.source.position_m.z = -2;
  EXPECT_EQ(bidirectional_lacks(scene), std::nullopt);
  scene.telescope[0].direction.z *= -1;
  EXPECT_EQ(bidirectional_lacks(scene), std::nullopt);
  scene.sea.surface = {};
  EXPECT_EQ(bidirectional_lacks(scene), std::nullopt);
}

}  // namespace
}  // namespace photic::scene
