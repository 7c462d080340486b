#include "scene/environments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "scene/changes.hpp"
#include "scene/checks.hpp"
#include "scene/format.hpp"
#include "scene/override.hpp"
#include "scene/parse.hpp"
#include "scene/tree.hpp"

namespace photic::scene {
namespace {

bool same_place(const Diagnostic& d, const Place& place) {
  return d.file == place.file && d.line == place.line && d.column == place.column;
}

bool contains(const std::vector<Finding>& all, const Diagnostic& d) {
  return std::any_of(all.begin(), all.end(), [&](const Finding& known) {
    return same_place(d, {known.what.file, known.what.line, known.what.column}) &&
           known.what.reason == d.reason;
  });
}

/// How many parts two paths have in common from their beginning.
std::size_t in_common(const std::string& a, const std::string& b) {
  const auto left = components(a);
  const auto right = components(b);
  const auto end = std::mismatch(left.begin(), left.end(), right.begin(), right.end()).first;
  return static_cast<std::size_t>(end - left.begin());
}

/// Of a key; of its value where --set gave it.
Place place_of(const Entry& entry) {
  return entry.value.place.line == 0 ? entry.value.place : entry.place;
}

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

Node without_environments(Node document) {
  auto& table = std::get<Node::Table>(document.value);
  table.erase(std::remove_if(table.begin(), table.end(),
                             [](const Entry& entry) { return entry.key == "environment"; }),
              table.end());
  return document;
}

bool begins_with(const std::string& path, const char* start) { return path.rfind(start, 0) == 0; }

/// Why a change must not be, as far as its path and value alone tell.
std::optional<Refusal> check_change(const std::string& path, const Node& value) {
  if (path == "sea" || path == "optics")
    return Refusal{fmt::format("'{}' cannot be set as a whole in an environment", path),
                   R"(quote the whole path: "sea.layer.0.chlorophyll_mg_m3" = 0.5)"};
  if (!begins_with(path, "sea.") && !begins_with(path, "optics."))
    return Refusal{fmt::format("'{}' cannot be set in an environment: only the water may differ, "
                               "for the histories are the same",
                               path),
                   "set paths that begin with sea. or optics."};
  if (!is_value(value))
    return Refusal{fmt::format("'{}' must be made of finite numbers, texts, true and false, not {}",
                               path, found_text(value)),
                   ""};
  return std::nullopt;
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
constexpr const char* bends_and_times =
    "it bends and times the light, whose histories are the same in all environments";
constexpr const char* borders = "light crosses from layer to layer alike in all environments";
constexpr const char* called = "all environments have the same layers";

constexpr Fixed fixed_of_sea[] = {{"salinity_psu", bends_and_times},
                                  {"temperature_c", bends_and_times},
                                  {"refractive_index", bends},
                                  {"group_index", times}};
constexpr Fixed fixed_of_layers[] = {{"name", called}, {"bottom_depth_m", borders}};
constexpr Fixed fixed_of_surface[] = {{"model", bends}};

/// Looks at values with which nothing is wrong in the scene and in the environment.
class Comparison {
 public:
  Comparison(const Findings& of_scene, Findings& findings)
      : of_scene_(of_scene), findings_(findings) {}

  void compare_seas(const Node& scene, const Node& here) {
    for (const Fixed& fixed : fixed_of_sea) compare(scene, here, "sea", fixed);
    for (const Fixed& fixed : fixed_of_surface)
      compare(*scene.find("surface"), *here.find("surface"), "sea.surface", fixed);
    if (!good("sea.layer")) return;
    compare_layers(*scene.find("layer")->as<Node::Array>(), *here.find("layer")->as<Node::Array>());
  }

 private:
  void compare_layers(const Node::Array& scene, const Node::Array& here) {
    if (scene.size() != here.size())
      return findings_.add("sea.layer",
                           fmt::format("there must be as many layers as in the scene, {}, not {}: "
                                       "{}",
                                       scene.size(), here.size(), borders),
                           suggestion);
    for (std::size_t i = 0; i < scene.size(); ++i)
      for (const Fixed& fixed : fixed_of_layers)
        compare(scene[i], here[i], below("sea.layer", i), fixed);
  }

  void compare(const Node& scene, const Node& here, const std::string& table, const Fixed& fixed) {
    const std::string path = below(table, fixed.key);
    const Node* left = scene.find(fixed.key);
    const Node* right = here.find(fixed.key);
    if (alike(left, right) || !good(path)) return;
    findings_.add(path,
                  fmt::format("'{}' must be as in the scene, {}, not {}: {}", fixed.key,
                              left ? found_text(*left) : "which has none",
                              right ? found_text(*right) : "none", fixed.why),
                  suggestion);
  }

  [[nodiscard]] bool good(const std::string& path) const {
    return of_scene_.good({path}) && findings_.good({path});
  }
  static bool alike(const Node* a, const Node* b) {
    return a && b ? format_value(*a) == format_value(*b) : a == b;
  }

  static constexpr const char* suggestion = "simulate that water in a scene of its own";
  const Findings& of_scene_;
  Findings& findings_;
};

// --- Changes that the scene keeps when it is written ---------------------------------------------

/// The tree of a scene as it is written, its environments aside.
Node written(Scene scene) {
  scene.environment.clear();
  return tree_of(std::move(scene));
}

/// Whether the changes make the environment's water of a written scene, which has every default in
/// it and may be read from another folder.
bool hold(const std::vector<Change>& changes, const Scene& scene, const Environment& environment) {
  constexpr const char* nowhere = "/dev/null";  // no file is below it
  Node document = written(scene);
  Findings findings(document, {});
  for (const Change& change : changes)
    if (auto value = parse_value(change.value, {}))
      assign(change.path, std::move(*value), {}, document, findings);
  const Scene read = scene_of(document, nowhere, findings);
  return findings.problems().empty() && read.optics == environment.optics &&
         read.sea == environment.sea;
}

/// Every key of one table is in the other one.
bool has_keys_of(const Node& table, const Node& other) {
  const auto& entries = *other.as<Node::Table>();
  return std::all_of(entries.begin(), entries.end(),
                     [&](const Entry& entry) { return table.find(entry.key) != nullptr; });
}

/// The changes that make one tree of another. A table that loses a key is another table.
void collect(const Node& from, const Node& to, const std::string& path, std::vector<Change>& out) {
  const auto* left = from.as<Node::Array>();
  const auto* right = to.as<Node::Array>();
  if (from.as<Node::Table>() && to.as<Node::Table>() && has_keys_of(to, from)) {
    for (const Entry& entry : *to.as<Node::Table>()) {
      const std::string inner = below(path, entry.key);
      if (const Node* old = from.find(entry.key))
        collect(*old, entry.value, inner, out);
      else
        out.push_back({inner, format_value(entry.value)});
    }
  } else if (left && right && left->size() == right->size()) {
    for (std::size_t i = 0; i < left->size(); ++i)
      collect((*left)[i], (*right)[i], below(path, i), out);
  } else if (format_value(from) != format_value(to)) {
    out.push_back({path, format_value(to)});
  }
}

/// Changes that do not hold are replaced by all that they come to.
void settle(Environment& environment, const Scene& scene) {
  if (hold(environment.set, scene, environment)) return;
  environment.set.clear();
  collect(written(scene), written(scene_in(scene, environment)), "", environment.set);
}

// --- One environment -----------------------------------------------------------------------------

/// A change, and the path it has by numbers alone.
struct PlacedChange {
  std::string path;
  Place place;
};

class EnvironmentReader {
 public:
  EnvironmentReader(const Node& document, const Entry& set, const Scene& scene, Findings& findings)
      : document_(without_environments(document)),
        set_(set),
        scene_(scene),
        findings_(findings),
        own_(document_, findings.end()) {}

  void read(const std::string& folder, const Check& check, const std::string& path,
            Environment& environment) {
    for (const Entry& entry : *set_.value.as<Node::Table>()) apply(entry);
    const Scene read = scene_of(document_, folder, own_);
    check_sea(read, own_);
    check_instrument(read, own_);
    check_gates(read, own_);
    Comparison(findings_, own_)
        .compare_seas(*written(scene_).find("sea"), *written(read).find("sea"));
    if (check) check(read, own_);
    tell(path, environment.name);
    environment.optics = read.optics;
    environment.sea = read.sea;
  }

 private:
  void apply(const Entry& entry) {
    const Place place = place_of(entry);
    changes_.push_back({entry.key, place});
    if (const auto refusal = check_change(entry.key, entry.value))
      return own_.add_at(place, refusal->reason, refusal->suggestion);
    Node value = entry.value;
    move_to(place, value);
    if (const auto path = assign(entry.key, std::move(value), place, document_, own_))
      changes_.back().path = *path;
  }

  /// What the scene has, too, has been told.
  void tell(const std::string& path, const std::string& name) {
    for (const Finding& finding : own_.problems()) {
      if (contains(findings_.problems(), finding.what)) continue;
      const auto [place, reason] = seen_here(finding, name);
      findings_.add(path, place, reason, finding.what.suggestion);
    }
    for (const Finding& finding : own_.remarked()) {
      if (contains(findings_.remarked(), finding.what)) continue;
      const auto [place, text] = seen_here(finding, name);
      findings_.remark_at(place, text);
    }
  }

  /// Findings at a change, or in a file that the change names, keep their place. Others stand where
  /// nothing is wrong in the scene itself: they go to a change.
  [[nodiscard]] std::pair<Place, std::string> seen_here(const Finding& finding,
                                                        const std::string& name) const {
    const Diagnostic& d = finding.what;
    const bool at_change =
        std::any_of(changes_.begin(), changes_.end(),
                    [&](const PlacedChange& change) { return same_place(d, change.place); });
    const bool elsewhere = d.line > 0 && d.file != findings_.end().file;
    if (at_change || elsewhere) return {{d.file, d.line, d.column}, d.reason};
    return {nearest(finding.path), fmt::format("in environment {}: {}", quoted(name), d.reason)};
  }

  /// The place of the change that has most in common with a path, or else of all of them.
  [[nodiscard]] Place nearest(const std::string& path) const {
    Place place = place_of(set_);
    std::size_t most = 0;
    for (const PlacedChange& change : changes_) {
      const std::size_t common = in_common(change.path, path);
      if (common > most) place = change.place;
      most = std::max(most, common);
    }
    return place;
  }

  Node document_;
  const Entry& set_;
  const Scene& scene_;
  Findings& findings_;
  Findings own_;
  std::vector<PlacedChange> changes_;
};

const Entry& set_of(const Node& document, std::size_t i) {
  const auto& environments = *document.find("environment")->as<Node::Array>();
  const auto& keys = *environments[i].as<Node::Table>();
  return *std::find_if(keys.begin(), keys.end(),
                       [](const Entry& entry) { return entry.key == "set"; });
}

}  // namespace

void read_environments(const Node& document, const std::string& folder, const Check& check,
                       Scene& scene, Findings& findings) {
  for (std::size_t i = 0; i < scene.environment.size(); ++i) {
    const std::string path = below(below("environment", i), "set");
    if (!findings.good({path})) continue;
    EnvironmentReader reader(document, set_of(document, i), scene, findings);
    reader.read(folder, check, path, scene.environment[i]);
  }
  if (!findings.problems().empty()) return;
  for (Environment& environment : scene.environment) settle(environment, scene);
}

}  // namespace photic::scene
