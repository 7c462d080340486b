// Other water: a scene with some of its values changed, and what is wrong with that.
#pragma once

#include <string>
#include <vector>

#include "scene/expand_layers.hpp"
#include "scene/findings.hpp"
#include "scene/node.hpp"
#include "scene/read.hpp"
#include "scene/scene.hpp"

namespace photic::scene {

/// The tree of a scene as it is written, but for its environments and sensitivities.
Node written(const Scene& scene);

/// The scene that other waters are made of.
struct Reference {
  const Node& document;  ///< without environments and sensitivities
  OtherFiles files;
  const std::vector<Cuts>* cuts;  ///< of the scene's layers; null where the document has layers as
                                  ///< they are
  const Node& written;            ///< the scene as it is written
  const Findings& findings;
  const Check& check;
};

class OtherWater {
 public:
  /// A change, and the path it has by numbers alone.
  struct PlacedChange {
    std::string path;
    Place place;
  };

  explicit OtherWater(const Reference& reference);
  OtherWater(const OtherWater&) = delete;  // its findings look at its document
  OtherWater& operator=(const OtherWater&) = delete;
  ~OtherWater() = default;

  /// Puts a value where a path leads, where none has been put before. It stands at `place` from now
  /// on, and so does all in it.
  void change(const std::string& path, Node value, const Place& place);
  /// The scene with the changes, checked, and compared with the scene that it is made of: what the
  /// histories depend on must be the same. To be called once, at last.
  Scene read();

  [[nodiscard]] const std::vector<PlacedChange>& changes() const { return changes_; }
  [[nodiscard]] const Findings& findings() const { return findings_; }

 private:
  const Reference& reference_;
  Node document_;
  Findings findings_;
  std::vector<PlacedChange> changes_;
};

}  // namespace photic::scene
