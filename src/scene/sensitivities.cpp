#include "scene/sensitivities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "scene/changes.hpp"
#include "scene/format.hpp"
#include "scene/other_water.hpp"
#include "scene/override.hpp"
#include "scene/suggest.hpp"

namespace photic::scene {
namespace {

/// The step, relative to a parameter's value. The error of a central difference of smooth functions
/// goes with its square: 1e-6 of the derivative.
constexpr double relative_step = 1e-3;

/// The keys of a table.
std::vector<std::string> keys_in(const Node& node) {
  std::vector<std::string> keys;
  if (const auto* table = node.as<Node::Table>())
    for (const Entry& entry : *table) keys.push_back(entry.key);
  return keys;
}

/// One path on its way to a parameter. Problems are reported at its place.
class ParameterReader {
 public:
  ParameterReader(const Reference& reference, std::string path_of_path, const Node& element,
                  Findings& findings)
      : reference_(reference),
        path_of_path_(std::move(path_of_path)),
        element_(element),
        findings_(findings) {}

  /// The path as it stands; nothing if no water has it.
  std::optional<std::string> text() {
    const auto* path = element_.as<std::string>();
    if (!path)
      return refuse(fmt::format("'sensitivity' must hold paths, not {}", found_text(element_)),
                    R"(write "sea.layer.0.chlorophyll_mg_m3")");
    if (!leads_to_medium(*path))
      return refuse(
          fmt::format("there is no derivative with respect to '{}': {}", *path, may_differ),
          fmt::format("name paths that begin with {}", media));
    return *path;
  }

  /// The path by numbers, if it leads to a parameter; its value goes into the sensitivity.
  std::optional<std::string> find(Sensitivity& sensitivity) {
    auto numbered = numbers_of(sensitivity.path);
    if (!numbered) return std::nullopt;
    const Node* node = node_at(reference_.written, *numbered);
    if (!node) return refuse_unknown(*numbered);
    const auto* value = node->as<double>();
    if (!value)
      return refuse(fmt::format("'{}' is {}, not a number", sensitivity.path, found_text(*node)),
                    "name the path of a number");
    if (*value == 0)
      return refuse(fmt::format("'{}' is 0: the derivative may be infinite there, and no step is "
                                "small relative to it",
                                sensitivity.path),
                    "give it a small value instead");
    sensitivity.value = *value;
    sensitivity.step = relative_step * std::fabs(*value);
    return numbered;
  }

  void read_steps(Sensitivity& sensitivity) {
    if (read_water(sensitivity, sensitivity.value - sensitivity.step, sensitivity.below))
      read_water(sensitivity, sensitivity.value + sensitivity.step, sensitivity.above);
  }

  std::nullopt_t refuse(const std::string& reason, const std::string& suggestion) {
    findings_.add(path_of_path_, element_.place, reason, suggestion);
    return std::nullopt;
  }

 private:
  std::optional<std::string> numbers_of(const std::string& path) {
    Node trial = reference_.written;
    Findings own(trial, {});
    auto numbered = assign(path, to_node(0.0), {}, trial, own);
    for (const Finding& finding : own.problems())
      refuse(finding.what.reason, finding.what.suggestion);
    return numbered;
  }

  std::nullopt_t refuse_unknown(const std::string& numbered) {
    std::string parent;
    const Node* node = &reference_.written;
    for (const std::string& key : components(numbered)) {
      const std::string path = below(parent, key);
      const Node* next = node_at(reference_.written, path);
      if (!next)
        return refuse(fmt::format("there is no '{}' in {}", key,
                                  parent.empty() ? "the scene" : fmt::format("'{}'", parent)),
                      suggestion_for(key, keys_in(*node), "known there"));
      parent = path;
      node = next;
    }
    return std::nullopt;
  }

  bool read_water(const Sensitivity& sensitivity, double value, Environment& environment) {
    OtherWater water(reference_);
    water.change(sensitivity.path, to_node(value), element_.place);
    const Scene read = water.read();
    if (!water.findings().problems().empty()) {
      const Diagnostic& d = water.findings().problems().front().what;
      refuse(fmt::format("no step of '{}' to {:.6g} can be made: {}", sensitivity.path, value,
                         d.reason),
             d.suggestion);
      return false;
    }
    environment = {.name = fmt::format("{} = {:.6g}", sensitivity.path, value),
                   .set = {{sensitivity.path, format_value(to_node(value))}},
                   .optics = read.optics,
                   .sea = read.sea,
                   .bottom = read.bottom,
                   .oil = read.oil,
                   .atmosphere = read.atmosphere};
    return true;
  }

  const Reference& reference_;
  std::string path_of_path_;
  const Node& element_;
  Findings& findings_;
};

}  // namespace

/// A value that is no text is an empty path here, and refused where paths are looked at.
std::optional<Refusal> check(const Parameters&, const Node& node, std::vector<Sensitivity>& value) {
  const auto* array = node.as<Node::Array>();
  if (!array)
    return Refusal{fmt::format("must be an array of paths, not {}", found_text(node)),
                   R"(write ["sea.layer.0.chlorophyll_mg_m3"])"};
  for (const Node& element : *array) {
    const auto* path = element.as<std::string>();
    value.push_back({.path = path ? *path : ""});
  }
  return std::nullopt;
}

Node schema_of(const Parameters&) {
  Node schema = empty_table();
  schema.add("type", to_node("array"));
  schema.add("items", schema_of(Text{}));
  return schema;
}

Node to_node(const std::vector<Sensitivity>& value) {
  Node::Array array;
  for (const Sensitivity& sensitivity : value) array.push_back(to_node(sensitivity.path));
  return {.value = std::move(array)};
}

void read_sensitivities(const Node& document, const Check& check, Scene& scene,
                        Findings& findings) {
  if (scene.sensitivity.empty()) return;
  // Water with problems has unknown contents; if anything has, the effects of other water are
  // unknown.
  const bool water_good = findings.good({"sea", "optics", "bottom", "oil", "atmosphere"});
  const bool all_good = findings.problems().empty();
  const Node as_written = written(scene);
  const NetcdfFiles no_files;  // a scene that is written names none
  const Reference reference{as_written, {std::nullopt, no_files}, nullptr, as_written, findings,
                            check};
  const auto& elements = *document.find("sensitivity")->as<Node::Array>();
  std::set<std::string> seen;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    Sensitivity& sensitivity = scene.sensitivity[i];
    if (!findings.good({below("sensitivity", i)})) continue;
    ParameterReader reader(reference, below("sensitivity", i), elements[i], findings);
    if (!reader.text() || !water_good) continue;
    const auto numbered = reader.find(sensitivity);
    if (!numbered) continue;
    if (!seen.insert(*numbered).second)
      reader.refuse(fmt::format("'{}' appears twice", sensitivity.path), "name each path once");
    else if (all_good)
      reader.read_steps(sensitivity);
  }
}

}  // namespace photic::scene
