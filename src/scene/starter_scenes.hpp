// The commented scenes that are built into the program, and the files that they read.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/read.hpp"

namespace photic::scene {

struct StarterScene {
  std::string kind;
  std::string text;
};

const std::vector<StarterScene>& starter_scenes();

/// By the kind of the scene that reads them.
const std::multimap<std::string, StarterFile>& all_starter_files();

}  // namespace photic::scene
