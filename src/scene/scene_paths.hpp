// The places of a scene's values, for --set.
#pragma once

#include <string>
#include <vector>

namespace photic::scene {

struct SceneChoice {
  std::string word, meaning;
};

/// One value of a scene.
struct ScenePath {
  std::string path;                  ///< sea.layer.*.chlorophyll_mg_m3; *: a number or a name
  std::string meaning;               ///< may be empty
  std::vector<SceneChoice> choices;  ///< the only values that it takes; empty: others
};

/// All values that a scene may have, by its schema.
std::vector<ScenePath> scene_paths();

}  // namespace photic::scene
