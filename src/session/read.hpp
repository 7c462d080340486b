// Scenes, read and checked whole: with their optics, and with the netCDF files that they name.
#pragma once

#include <string>
#include <vector>

#include "scene/read.hpp"
#include "session/context.hpp"

namespace photic::session {

struct SceneText {
  std::string text;
  std::string name;    ///< in messages, for the file
  std::string folder;  ///< of the files that it names
};

/// Throws InputError with every problem, EnvironmentError for files that cannot be read.
scene::Reading read(const Context& context, const SceneText& scene,
                    const std::vector<scene::Override>& overrides = {});

/// The same of a scene file.
scene::Reading read_file(const Context& context, const std::string& path,
                         const std::vector<scene::Override>& overrides = {});

/// The folder of a file, of which the files that a scene names are seen.
std::string folder_of(const std::string& file);

}  // namespace photic::session
