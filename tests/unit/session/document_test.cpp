// Scenes that are changed value by value.
#include "session/document.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.hpp"
#include "session_support.hpp"

namespace photic::session {
namespace {

using scene::Node;

const std::string starters = PHOTIC_SOURCE_DIR "/scenes";

Document starter(const std::string& kind) {
  return Document(test::context(), {scene::starter_scene(kind), kind + ".toml", starters});
}

/// The values of a scene without their places, as those who make a scene of values have them.
Node without_places(Node node) {
  node.place = {};
  node.section = false;
  if (auto* array = node.as<Node::Array>())
    for (Node& element : *array) element = without_places(std::move(element));
  if (auto* table = node.as<Node::Table>())
    for (scene::Entry& entry : *table) {
      entry.place = {};
      entry.value = without_places(std::move(entry.value));
    }
  return node;
}

std::string problems(const std::function<void()>& use) {
  try {
    use();
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Document, HasTheValuesAsTheyAreGivenOrElseByDefault) {
  const Document ship = starter("ship");
  EXPECT_EQ(*ship.find("source.wavelength_nm")->as<double>(), 532.0);
  EXPECT_EQ(ship.find("source.wavelength_nm")->place.line > 0, true);
  EXPECT_EQ(*ship.find("sea.salinity_psu")->as<double>(), ship.reading().scene.sea.salinity_psu);
  EXPECT_EQ(*ship.find("telescope.0.name")->as<std::string>(), "ship");
  EXPECT_EQ(*ship.find("telescope.ship.name")->as<std::string>(), "ship");
  EXPECT_FALSE(ship.find("sea.no_such_key"));
  EXPECT_FALSE(ship.find(""));
}

// Seen red: with `given_` set before the check; with the text kept.
TEST(Document, ChangesAltogetherOrNotAtAll) {
  Document ship = starter("ship");
  const std::string before = ship.toml();
  EXPECT_EQ(before, scene::starter_scene("ship"));
  EXPECT_EQ(problems([&] {
              ship.change({{"sea.salinity_psu", scene::to_node(30.0)},
                           {"gates.depth_max_m", scene::to_node(-5.0)}});
            }).find("gates.depth_max_m: "),
            0U);
  EXPECT_EQ(ship.toml(), before);
  EXPECT_EQ(ship.reading().scene.sea.salinity_psu, 35.0);
  ship.change({{"sea.salinity_psu", scene::to_node(30.0)},
               {"sea.layer.0.chlorophyll_mg_m3", scene::to_node(0.25)}});
  EXPECT_EQ(ship.reading().scene.sea.salinity_psu, 30.0);
  EXPECT_EQ(*ship.find("sea.layer.0.chlorophyll_mg_m3")->as<double>(), 0.25);
  const Document again(test::context(), {ship.toml(), "ship.toml", starters});
  EXPECT_EQ(scene::write_scene(again.reading().scene), scene::write_scene(ship.reading().scene));
}

TEST(Document, GivesUpValues) {
  Document ship = starter("ship");
  ship.change({{"sea.salinity_psu", scene::to_node(30.0)}});
  ship.change({{"sea.salinity_psu", std::nullopt}});
  EXPECT_EQ(ship.reading().scene.sea.salinity_psu, 35.0);
  EXPECT_EQ(problems([&] {
              ship.change({{"sea.salinity_psu", std::nullopt}});
            }),
            "sea.salinity_psu: there is no 'salinity_psu' to take away");
  EXPECT_EQ(problems([&] {
              ship.change({{"telescope.boat", std::nullopt}});
            }),
            "telescope.boat: there is no 'boat' to take away");
  EXPECT_EQ(problems([&] {
              ship.change({{"telescope.0", std::nullopt}});
            }).find("ship.toml:"),
            0U);  // a scene needs one
}

// A scene of values is that of its text, and goes through a text. Seen red: with values that are no
// tables put under headers, too.
TEST(Document, OfValuesIsThatOfTheirText) {
  for (const auto& [kind, summary] : scene::starter_kinds()) {
    SCOPED_TRACE(kind);
    const Document text = starter(kind);
    const Document values(
        test::context(),
        without_places(scene::document_of(scene::starter_scene(kind), kind + ".toml")), starters);
    EXPECT_EQ(scene::write_scene(values.reading().scene), scene::write_scene(text.reading().scene));
    const Document again(test::context(), {values.toml(), kind + ".toml", starters});
    EXPECT_EQ(scene::write_scene(again.reading().scene), scene::write_scene(text.reading().scene));
  }
}

TEST(Document, OfValuesHasPathsForPlaces) {
  Node values = without_places(scene::document_of(scene::starter_scene("ship"), "ship.toml"));
  scene::Findings none(values, {});
  for (scene::Entry& entry : *values.as<Node::Table>())
    if (entry.key == "source") entry.value.add("wavelength_mn", scene::to_node(532.0));
  EXPECT_EQ(problems([&] {
              Document(test::context(), values, "");
            }).find("source.wavelength_mn: unknown key"),
            0U)
      << problems([&] { Document(test::context(), values, ""); });
}

}  // namespace
}  // namespace photic::session
