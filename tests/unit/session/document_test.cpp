// Scenes that are changed value by value.
#include "session/document.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "scene/format.hpp"
#include "scene/tree.hpp"
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

/// The airborne starter, its sea of a layer that is cut into many and one more.
Document cut_sea(const std::string& sea) {
  const std::string text = scene::starter_scene("airborne");
  const auto before = text.find("[[sea.layer]]"), after = text.find("[gates]");
  return Document(test::context(), {text.substr(0, before) + sea + text.substr(after), "a", ""});
}

std::string text_at(const Document& scene, const std::string& path) {
  const auto node = scene.find(path);
  return node ? scene::format_value(*node) : "none";
}

constexpr const char* layers = R"(
[[LAYERS]]
bottom_depth_m = 10
cdom_a440_per_m = 0.07
chlorophyll_mg_m3 = { depth_m = [0, 3, 10], value = [1, 2, 3.0] }
[[LAYERS]]
chlorophyll_mg_m3 = 0.1
)";

std::string layers_of(const std::string& path) {
  std::string text = layers;
  for (auto at = text.find("LAYERS"); at != std::string::npos; at = text.find("LAYERS"))
    text.replace(at, 6, path);
  return text;
}

// Seen red: with the layers by default counted as they are cut.
TEST(Document, HasDefaultsOfTheLayersThatItHas) {
  const Document one = cut_sea("[sea]" + layers_of("sea.layer"));
  const Document many = cut_sea("[[sea.column]]\nx_max_m = 1" + layers_of("sea.column.layer") +
                                "[[sea.column]]" + layers_of("sea.column.layer"));
  for (const auto& [scene, sea] : {std::pair(&one, "sea."), std::pair(&many, "sea.column.0."),
                                   std::pair(&many, "sea.column.column1.")}) {
    SCOPED_TRACE(sea);
    const auto at = [&](const std::string& path) { return text_at(*scene, sea + path); };
    EXPECT_GT(scene->reading().multiples.rbegin()->second.front(), 2U);
    EXPECT_EQ(at("layer.0.cdom_a440_per_m"), "0.07");
    EXPECT_EQ(at("layer.1.cdom_a440_per_m"), "0.0");
    EXPECT_EQ(at("layer.layer1.cdom_a440_per_m"), "0.0");
    EXPECT_EQ(at("layer.1.bottom_depth_m"), "none");
    EXPECT_EQ(at("layer.0.name"), R"("layer0")");
    EXPECT_EQ(at("layer.1.name"), R"("layer1")");
    EXPECT_EQ(at("layer.2.name"), "none");
    EXPECT_EQ(at("layer.7.name"), "none");
  }
}

// Seen red: with channels counted as they are in the scene.
TEST(Document, HasDefaultsOfTheChannelsAndEnvironmentsThatItHas) {
  Node values = without_places(scene::document_of(scene::starter_scene("ship"), "ship.toml"));
  Node::Array channels{scene::empty_table(), scene::empty_table()};
  Node steps = scene::empty_table();
  for (const auto& [key, nm] : {std::pair("from", 600.0), {"to", 640.0}, {"step", 10.0}})
    steps.add(key, scene::to_node(nm));
  channels[0].add("name", scene::to_node("red"));
  channels[0].add("centre_nm", steps);
  channels[0].add("fwhm_nm", scene::to_node(5.0));
  channels[1].add("name", scene::to_node("green"));
  channels[1].add("process", scene::to_node("elastic"));
  values.find("channel")->value = channels;
  const Document ship(test::context(), values, starters);
  EXPECT_EQ(ship.reading().scene.channel.size(), 6U);
  EXPECT_EQ(text_at(ship, "channel.1.fwhm_nm"), "none");
  EXPECT_EQ(text_at(ship, "channel.2.name"), "none");
}

void add_paths(const Node& node, const std::string& path, std::set<std::string>& paths) {
  if (!path.empty()) paths.insert(path);
  if (const auto* array = node.as<Node::Array>())
    for (std::size_t i = 0; i < array->size(); ++i)
      add_paths((*array)[i], scene::below(path, i), paths);
  if (const auto* table = node.as<Node::Table>())
    for (const scene::Entry& entry : *table)
      add_paths(entry.value, scene::below(path, entry.key), paths);
}

// Seen red: with the layers by default counted as they are cut.
TEST(Document, IsTheSameWithAnyOfItsValuesGivenAgain) {
  for (const auto& [kind, summary] : scene::starter_kinds()) {
    SCOPED_TRACE(kind);
    const Document scene = starter(kind);
    std::set<std::string> paths;
    add_paths(scene::tree_of(scene.reading().scene), "", paths);
    add_paths(scene::document_of(scene::starter_scene(kind), kind), "", paths);
    for (const std::string& path : paths) {
      const auto value = scene.find(path);
      if (!value) continue;
      Document again = scene;
      if (problems([&] { again.change({{path, without_places(*value)}}); }) != "none") continue;
      EXPECT_EQ(scene::write_scene(again.reading().scene),
                scene::write_scene(scene.reading().scene))
          << path;
    }
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
