// A small good scene, and what the reader says of scenes made from it by editing lines.
#pragma once

#include <string>
#include <vector>

#include "scene/read.hpp"

namespace photic::scene {

using Texts = std::vector<std::string>;

/// Lines first … last become `text`, which may be several lines; "" removes them.
struct Edit {
  int first;
  int last;
  std::string text;
};

/// A scene with something wrong, and all that is to be said about it.
struct Case {
  const char* name;
  std::vector<Edit> edits;
  std::vector<std::string> expected;
};

/// The lines of the base scene, numbered in base_scene.cpp.
const std::vector<std::string>& base_lines();

/// The base scene after these edits, given in the order of the lines.
std::string edited(const std::vector<Edit>& edits);

/// The texts of the diagnostics of a scene called scene.toml; empty if it is good.
std::vector<std::string> diagnostics_of(const std::string& text,
                                        const std::vector<Override>& overrides = {},
                                        const Check& check = {});

/// A scene called scene.toml; it must be good.
Scene read_text(const std::string& text, const std::vector<Override>& overrides = {});

/// The base scene with these overrides; it must be good.
Scene base_scene(const std::vector<Override>& overrides = {});

}  // namespace photic::scene
