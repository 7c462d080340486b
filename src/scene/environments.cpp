#include "scene/environments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "scene/changes.hpp"
#include "scene/format.hpp"
#include "scene/other_water.hpp"
#include "scene/override.hpp"
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

/// The number of parts that two paths have in common from their beginning.
std::size_t in_common(const std::string& a, const std::string& b) {
  const auto left = components(a);
  const auto right = components(b);
  const auto end = std::mismatch(left.begin(), left.end(), right.begin(), right.end()).first;
  return static_cast<std::size_t>(end - left.begin());
}

Node without_environments(const Node& document) {
  Node alone = empty_table();
  alone.place = document.place;
  for (const Entry& entry : *document.as<Node::Table>())
    if (entry.key != "environment" && entry.key != "sensitivity")
      alone.as<Node::Table>()->push_back(entry);
  return alone;
}

/// The place of a key; of its value where --set gave it.
Place place_of(const Entry& entry) {
  return entry.value.place.line == 0 ? entry.value.place : entry.place;
}

// --- Changes that the scene keeps when it is written ---------------------------------------------

/// Returns whether the changes make the environment's water of a written scene, which has every
/// default in it and names no file.
bool hold(const Node& written_scene, const Environment& environment) {
  Node document = written_scene;
  Findings findings(document, {});
  take_out_replaced(make_changes(environment.set, document, findings), document);
  const Scene read = scene_of(document, std::nullopt, findings);
  return findings.problems().empty() && read.optics == environment.optics &&
         read.sea == environment.sea && read.bottom == environment.bottom &&
         read.oil == environment.oil && read.atmosphere == environment.atmosphere;
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
void settle(Environment& environment, const Scene& scene, const Node& written_scene) {
  if (hold(written_scene, environment)) return;
  environment.set.clear();
  collect(written_scene, written(scene_in(scene, environment)), "", environment.set);
}

// --- What is wrong with an environment -----------------------------------------------------------

/// Reports the findings in an environment's water that are not in the scene; those were reported.
class Reporter {
 public:
  Reporter(const OtherWater& water, const Place& place_of_set, const std::string& name,
           Findings& findings)
      : water_(water), place_of_set_(place_of_set), name_(name), findings_(findings) {}

  void report(const std::string& path) {
    for (const Finding& finding : water_.findings().problems()) {
      if (contains(findings_.problems(), finding.what)) continue;
      const auto [place, reason] = seen_here(finding);
      if (!is_reported(findings_.problems(), place, finding.what.reason))
        findings_.add(path, place, reason, finding.what.suggestion);
    }
    for (const Finding& finding : water_.findings().remarked()) {
      if (contains(findings_.remarked(), finding.what)) continue;
      const auto [place, text] = seen_here(finding);
      if (!is_reported(findings_.remarked(), place, finding.what.reason))
        findings_.remark_at(place, text);
    }
  }

 private:
  /// Many environments of a grid have the same value, and one report is enough.
  static bool is_reported(const std::vector<Finding>& all, const Place& place,
                          const std::string& reason) {
    return std::any_of(all.begin(), all.end(), [&](const Finding& known) {
      return same_place(known.what, place) && known.what.reason.ends_with(reason);
    });
  }

  /// Findings at a change, or in a file that the change names, keep their place. Others stand where
  /// nothing is wrong in the scene itself: they go to a change.
  [[nodiscard]] std::pair<Place, std::string> seen_here(const Finding& finding) const {
    const Diagnostic& d = finding.what;
    const auto& changes = water_.changes();
    const bool at_change = std::any_of(changes.begin(), changes.end(), [&](const auto& change) {
      return same_place(d, change.place);
    });
    const bool elsewhere = d.line > 0 && d.file != findings_.end().file;
    if (at_change || elsewhere) return {{d.file, d.line, d.column}, d.reason};
    return {nearest(finding.path), fmt::format("in environment {}: {}", quoted(name_), d.reason)};
  }

  /// The place of the change that has most in common with a path, or else of all of them.
  [[nodiscard]] Place nearest(const std::string& path) const {
    Place place = place_of_set_;
    std::size_t most = 0;
    for (const auto& change : water_.changes()) {
      const std::size_t common = in_common(change.path, path);
      if (common > most) place = change.place;
      most = std::max(most, common);
    }
    return place;
  }

  const OtherWater& water_;
  const Place place_of_set_;
  const std::string& name_;
  Findings& findings_;
};

void read_environment(const Reference& reference, const Entry& set, const std::string& path,
                      Environment& environment, Findings& findings) {
  OtherWater water(reference);
  for (const Entry& entry : *set.value.as<Node::Table>())
    water.change(entry.key, entry.value, place_of(entry));
  const Scene read = water.read();
  Reporter(water, place_of(set), environment.name, findings).report(path);
  environment.optics = read.optics;
  environment.sea = read.sea;
  environment.bottom = read.bottom;
  environment.oil = read.oil;
  environment.atmosphere = read.atmosphere;
}

const Entry& set_of(const Node& document, std::size_t i) {
  const auto& environments = *document.find("environment")->as<Node::Array>();
  const auto& keys = *environments[i].as<Node::Table>();
  return *std::find_if(keys.begin(), keys.end(),
                       [](const Entry& entry) { return entry.key == "set"; });
}

}  // namespace

void read_environments(const Layered& layered, const Check& check, Scene& scene,
                       Findings& findings) {
  if (scene.environment.empty()) return;
  const Node alone = without_environments(layered.document);
  const Node as_written = written(scene);
  const Reference reference{alone, layered.files, &layered.cuts, as_written, findings, check};
  for (std::size_t i = 0; i < scene.environment.size(); ++i) {
    const std::string path = below(below("environment", i), "set");
    if (findings.good({path}))
      read_environment(reference, set_of(layered.document, i), path, scene.environment[i],
                       findings);
  }
  if (!findings.problems().empty()) return;
  for (Environment& environment : scene.environment) settle(environment, scene, as_written);
}

}  // namespace photic::scene
