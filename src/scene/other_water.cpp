#include "scene/other_water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "scene/changes.hpp"
#include "scene/checks.hpp"
#include "scene/format.hpp"
#include "scene/override.hpp"
#include "scene/tree.hpp"

namespace photic::scene {
namespace {

void move_to(const Place& place, Node& node) {
  node.place = place;
  if (auto* array = node.as<Node::Array>())
    for (Node& element : *array) move_to(place, element);
  if (auto* table = node.as<Node::Table>()) {
    for (Entry& entry : *table) {
      entry.place = place;
      move_to(place, entry.value);
    }
  }
}

// --- What the histories need to be alike ---------------------------------------------------------

struct Fixed {
  const char* key;
  const char* why;
};

constexpr const char* bends =
    "it bends the light, whose histories are the same in all environments";
constexpr const char* times =
    "it times the light, whose histories are the same in all environments";
constexpr const char* weighs =
    "it weighs the light, whose histories are the same in all environments";
constexpr const char* bends_and_times =
    "it bends and times the light, whose histories are the same in all environments";
constexpr const char* borders =
    "light crosses from layer to layer in the same way in all environments";
constexpr const char* beside =
    "light crosses from column to column in the same way in all environments";
constexpr const char* called = "all environments have the same layers";
constexpr const char* called_columns = "all environments have the same columns";

constexpr Fixed fixed_of_optics[] = {{"chlorophyll_lifetime_ns", times},
                                     {"cdom_lifetime_ns", times}};
constexpr Fixed fixed_of_sea[] = {{"salinity_psu", bends_and_times},
                                  {"temperature_c", bends_and_times},
                                  {"refractive_index", bends},
                                  {"group_index", times},
                                  {"y_min_m", beside},
                                  {"y_max_m", beside}};
constexpr Fixed fixed_of_columns[] = {
    {"name", called_columns}, {"x_min_m", beside}, {"x_max_m", beside}};
constexpr Fixed fixed_of_layers[] = {{"name", called}, {"bottom_depth_m", borders}};
/// The model, which decides what other keys there are, comes first. Slopes and whitecaps may differ
/// (medium/surface.cpp).
constexpr Fixed fixed_of_surface[] = {{"model", bends},
                                      {"wind_direction_deg", bends},
                                      {"gram_charlier", bends},
                                      {"facets", weighs},
                                      {"whitecap_reflectance", bends}};

/// Things whose number is as in the scene, and the reason.
constexpr Fixed layers{"layers", borders}, columns{"columns", beside};

/// The kind of air, by a profile or by layers, is a matter of the first key.
constexpr Fixed fixed_of_air[] = {{"profile", bends_and_times},
                                  {"top_km", borders},
                                  {"refraction", bends},
                                  {"geometry", borders}};
constexpr Fixed fixed_of_gases[] = {{"top_km", borders}};
constexpr Fixed fixed_of_air_layers[] = {{"name", called},
                                         {"bottom_height_m", borders},
                                         {"top_height_m", borders},
                                         {"refractive_index", bends_and_times}};

constexpr const char* shines = "the film's light has the same lines in all environments";
constexpr Fixed fixed_of_oil[] = {{"class", shines}, {"file", shines}, {"lifetime_ns", times}};

/// Looks at values with which nothing is wrong in the scene and in the environment.
class Comparison {
 public:
  Comparison(const Findings& of_scene, Findings& findings)
      : of_scene_(of_scene), findings_(findings) {}

  void compare_optics(const Node& scene, const Node& here) {
    for (const Fixed& fixed : fixed_of_optics) compare(scene, here, "optics", fixed);
  }

  /// A film where the scene has none is refused where its optics are looked at.
  void compare_oils(const std::string& path, const Node* scene, const Node* here) {
    if (!scene || !here) return;
    for (const Fixed& fixed : fixed_of_oil) compare(*scene, *here, path, fixed);
  }

  void compare_airs(const Node* scene, const Node* here) {
    if (!here) return;
    if (!scene)
      return findings_.add("atmosphere", "the scene itself has no air above the sea",
                           "give it an [atmosphere], of little aerosol if need be");
    for (const Fixed& fixed : fixed_of_air) compare(*scene, *here, "atmosphere", fixed);
    compare_all(layers, "atmosphere.gases", scene->find("gases"), here->find("gases"),
                fixed_of_gases);
    compare_all(layers, "atmosphere.layer", scene->find("layer"), here->find("layer"),
                fixed_of_air_layers);
  }

  void compare_seas(const Node& scene, const Node& here) {
    for (const Fixed& fixed : fixed_of_sea) compare(scene, here, "sea", fixed);
    compare_surfaces(*scene.find("surface"), *here.find("surface"));
    compare_all(layers, "sea.layer", scene.find("layer"), here.find("layer"), fixed_of_layers);
    compare_columns(scene.find("column"), here.find("column"));
  }

 private:
  /// The first difference is enough: others may follow from it, and none is allowed.
  void compare_surfaces(const Node& scene, const Node& here) {
    for (const Fixed& fixed : fixed_of_surface)
      if (!compare(scene, here, "sea.surface", fixed)) return;
  }

  void compare_columns(const Node* of_scene, const Node* of_here) {
    if (!compare_all(columns, "sea.column", of_scene, of_here, fixed_of_columns) || !of_scene)
      return;
    const auto &scene = *of_scene->as<Node::Array>(), &here = *of_here->as<Node::Array>();
    for (std::size_t i = 0; i < scene.size(); ++i) {
      const std::string path = below("sea.column", i);
      compare_all(layers, below(path, "layer"), scene[i].find("layer"), here[i].find("layer"),
                  fixed_of_layers);
      compare_oils(below(path, "oil"), scene[i].find("oil"), here[i].find("oil"));
    }
  }

  /// Returns whether there are as many of them, and nothing is wrong.
  bool compare_all(const Fixed& them, const std::string& path, const Node* of_scene,
                   const Node* of_here, std::span<const Fixed> all_fixed) {
    if (!good(path)) return false;
    static const Node::Array none;
    const auto& scene = of_scene ? *of_scene->as<Node::Array>() : none;
    const auto& here = of_here ? *of_here->as<Node::Array>() : none;
    if (scene.size() != here.size()) {
      findings_.add(path,
                    fmt::format("there must be as many {} as in the scene, {}, not {}: {}",
                                them.key, scene.size(), here.size(), them.why),
                    suggestion);
      return false;
    }
    for (std::size_t i = 0; i < scene.size(); ++i)
      for (const Fixed& fixed : all_fixed) compare(scene[i], here[i], below(path, i), fixed);
    return true;
  }

  /// Returns whether they are alike, or not known.
  bool compare(const Node& scene, const Node& here, const std::string& table, const Fixed& fixed) {
    const std::string path = below(table, fixed.key);
    const Node* left = scene.find(fixed.key);
    const Node* right = here.find(fixed.key);
    if (alike(left, right) || !good(path)) return true;
    findings_.add(path,
                  fmt::format("'{}' must be as in the scene, {}, not {}: {}", fixed.key,
                              left ? found_text(*left) : "which has none",
                              right ? found_text(*right) : "none", fixed.why),
                  suggestion);
    return false;
  }

  [[nodiscard]] bool good(const std::string& path) const {
    return of_scene_.good({path}) && findings_.good({path});
  }
  static bool alike(const Node* a, const Node* b) {
    return a && b ? format_value(*a) == format_value(*b) : a == b;
  }

  static constexpr const char* suggestion = "simulate that in a scene of its own";
  const Findings& of_scene_;
  Findings& findings_;
};

}  // namespace

Node written(const Scene& scene) { return tree_of(scene_alone(scene)); }

OtherWater::OtherWater(const Reference& reference)
    : reference_(reference),
      document_(reference.document),
      findings_(document_, reference.findings.end()) {}

void OtherWater::change(const std::string& path, Node value, const Place& place) {
  changes_.push_back({path, place});
  if (const auto refusal = check_change(path, value))
    return findings_.add_at(place, refusal->reason, refusal->suggestion);
  move_to(place, value);
  const auto numbered = assign(path, std::move(value), place, document_, findings_);
  if (!numbered) return;
  if (std::any_of(changes_.begin(), changes_.end() - 1, [&](const PlacedChange& earlier) {
        return (earlier.path + '.').starts_with(*numbered + '.');
      }))
    findings_.add_at(place, fmt::format("'{}' sets what an entry before it has set", path),
                     "set each value once");
  changes_.back().path = *numbered;
}

Scene OtherWater::read() {
  std::vector<std::string> changed;
  for (const PlacedChange& change : changes_) changed.push_back(change.path);
  take_out_replaced(changed, document_);
  if (reference_.cuts) expand_layers(document_, reference_.files, reference_.cuts, findings_);
  Scene scene = scene_of(document_, reference_.files.folder, findings_);
  check_sea(scene, findings_);
  check_bottom(scene, findings_);
  check_oil(scene, findings_);
  check_columns(scene, findings_);
  check_atmosphere(scene, findings_);
  check_instrument(scene, findings_);
  check_gates(scene, findings_);
  const Node here = written(scene);
  Comparison comparison(reference_.findings, findings_);
  comparison.compare_optics(*reference_.written.find("optics"), *here.find("optics"));
  if (const Node *sea = reference_.written.find("sea"), *sea_here = here.find("sea");
      sea && sea_here)
    comparison.compare_seas(*sea, *sea_here);
  comparison.compare_airs(reference_.written.find("atmosphere"), here.find("atmosphere"));
  comparison.compare_oils("oil", reference_.written.find("oil"), here.find("oil"));
  if (reference_.check) reference_.check(scene, findings_, Asked::of_environment);
  return scene;
}

}  // namespace photic::scene
