// The commented scenes that are built into the program.
#pragma once

#include <string>
#include <vector>

namespace photic::scene {

struct StarterScene {
  std::string kind;
  std::string text;
};

const std::vector<StarterScene>& starter_scenes();

}  // namespace photic::scene
