#include "scene/environment_values.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "scene/changes.hpp"
#include "scene/findings.hpp"
#include "scene/other_water.hpp"
#include "scene/override.hpp"

namespace photic::scene {
namespace {

/// A scene as it is written, with the changes of an environment; and the paths of these, by
/// numbers.
struct Changed {
  Node document;
  std::vector<std::string> paths;

  Changed(const Node& written_scene, const Environment& environment) : document(written_scene) {
    Findings findings(document, {});
    paths = make_changes(environment.set, document, findings);
    take_out_replaced(paths, document);
  }

  /// The number that stands there, if it is one.
  [[nodiscard]] std::optional<double> number_at(const std::string& path) const {
    const Node* node = node_at(document, path);
    if (!node) return std::nullopt;
    if (const auto* whole = node->as<std::int64_t>()) return static_cast<double>(*whole);
    if (const auto* number = node->as<double>()) return *number;
    return std::nullopt;
  }
};

}  // namespace

EnvironmentValues environment_values(const Scene& scene) {
  EnvironmentValues out;
  if (scene.environment.empty()) return out;
  const Node alone = written(scene);
  std::set<std::string> known;
  for (const Environment& environment : scene.environment) {
    const Changed changed(alone, environment);
    for (const std::string& path : changed.paths)
      if (changed.number_at(path) && known.insert(path).second) out.path.push_back(path);
  }
  for (const Environment& environment : scene.environment) {
    const Changed changed(alone, environment);
    for (const std::string& path : out.path)
      out.value.push_back(
          changed.number_at(path).value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  return out;
}

}  // namespace photic::scene
