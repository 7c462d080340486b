// Everything wrong with a scene, collected while it is read and checked.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "scene/node.hpp"

namespace photic::scene {

/// Something found at a place, and the path of the value; "" where it has none of its own.
struct Finding {
  Diagnostic what;
  std::string path;
};

/// Paths are those of --set: "sea.layer.0.iop". "" is the whole scene.
class Findings {
 public:
  /// `document` must outlive the findings; `end` is the end of the file.
  Findings(const Node& document, Place end) : document_(document), end_(std::move(end)) {}

  /// Something is wrong at a place, but with no value that other checks look at.
  void add_at(const Place& place, std::string reason, std::string suggestion);
  /// Something is wrong with the value at `path`, seen at `place`.
  void add(const std::string& path, const Place& place, std::string reason, std::string suggestion);
  /// Adds the problems of a file that the value at `path` names, at `place`: in lines of its own,
  /// or, of a netCDF file, which has none, at that place.
  void add_from_file(const std::string& path, const Place& place, const InputError& error);
  /// The same at the place of the value, or of the table that lacks it.
  void add(const std::string& path, std::string reason, std::string suggestion);
  /// No check that needs the value at `path` makes sense any more.
  void spoil(const std::string& path) { spoilt_.push_back(path); }
  /// Not wrong, but worth knowing.
  void remark(const std::string& path, const std::string& text);
  void remark_at(const Place& place, const std::string& text);

  /// Returns whether nothing is wrong with these values: checks across keys ask this first.
  [[nodiscard]] bool good(std::initializer_list<std::string> paths) const;
  [[nodiscard]] bool given(const std::string& path) const;
  [[nodiscard]] Place place_of(const std::string& path) const;
  /// The place of a key, dots and all, in the table at `path`; of the table if it does not have it.
  [[nodiscard]] Place place_in(const std::string& path, const std::string& key) const;
  [[nodiscard]] const Place& end() const { return end_; }

  /// Throws InputError with all that was found, in the order of the file; then what was found in
  /// files that the scene names, then --set.
  void raise() const;
  [[nodiscard]] std::vector<std::string> remarks() const;

  /// All that is wrong, and all that is worth knowing, in the order it was found.
  [[nodiscard]] const std::vector<Finding>& problems() const { return problems_; }
  [[nodiscard]] const std::vector<Finding>& remarked() const { return remarked_; }

 private:
  const Node& document_;
  Place end_;
  std::vector<Finding> problems_, remarked_;
  std::vector<std::string> spoilt_;
};

/// Returns whether a was written before b: in the order of the file, and the file before --set.
bool before(const Place& a, const Place& b);

/// The parts of a path between its dots.
std::vector<std::string> components(const std::string& path);

/// The node that a path leads to by numbers; null if there is none.
const Node* node_at(const Node& root, const std::string& path);

/// path + "." + key, without the dot at the top.
std::string below(const std::string& path, const std::string& key);
std::string below(const std::string& path, std::size_t index);

}  // namespace photic::scene
