// A scene that can be changed value by value, and is checked as a whole each time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/node.hpp"
#include "scene/read.hpp"
#include "session/context.hpp"
#include "session/read.hpp"

namespace photic::session {

/// A value and the path to which it goes, in the style of --set; none: what is there is taken away.
struct Change {
  std::string path;
  std::optional<scene::Node> value;
};

/// Its functions throw InputError with every problem of the scene, EnvironmentError for files that
/// cannot be read; then nothing has changed.
class Document {
 public:
  /// `changes` are made before anything is checked.
  Document(const Context& context, const SceneText& scene, const std::vector<Change>& changes = {});
  /// A tree of values without places, which are named by their paths in messages. `folder`: of the
  /// files that it names.
  Document(const Context& context, scene::Node values, std::string folder,
           const std::vector<Change>& changes = {});

  /// Makes all changes, or none.
  void change(const std::vector<Change>& changes);

  /// The value that a path leads to: as it was given, or else as the scene has it by default. None
  /// if there is no such value.
  [[nodiscard]] std::optional<scene::Node> find(const std::string& path) const;

  /// The scene as it was given, as TOML: the very text as long as it has not been changed.
  [[nodiscard]] std::string toml() const;

  [[nodiscard]] const scene::Reading& reading() const { return reading_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::string& folder() const { return folder_; }

 private:
  Context context_;
  std::string name_, folder_;
  std::optional<std::string> text_;  ///< none once it has been changed
  scene::Node given_;
  scene::Reading reading_;
};

}  // namespace photic::session
