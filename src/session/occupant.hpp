// The file that stands where a run is to write.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "optics/library.hpp"
#include "scene/scene.hpp"

namespace photic::session {

/// The scene that a result is made from, and the data tables.
struct Origin {
  std::shared_ptr<const optics::Library> library;
  scene::Scene scene;
  std::string scene_file;  ///< seen from the result's folder; empty: not known
};

struct Occupant {
  enum class Kind {
    nobody,        ///< no file, or an empty one
    same_scene,    ///< a result of the same scene: its photons count
    edited_scene,  ///< a result of an earlier state of the same scene file
    some_scene,    ///< a text file, which does not name its scene
    other_scene,   ///< a result of another scene file
    stranger       ///< no result of a run
  };
  Kind kind = Kind::nobody;
  std::uint64_t photons = 0;
  std::string reason;  ///< why no run should replace it
};

/// Throws EnvironmentError if there is something that cannot be read.
Occupant occupant_of(const std::string& file, const Origin& origin);

/// Returns whether the file is a result of a run.
bool holds_echoes(const std::string& file);

}  // namespace photic::session
