#include <fmt/format.h>

#include "core/error.hpp"
#include "scene/read.hpp"
#include "scene/starter_scenes.hpp"
#include "scene/suggest.hpp"

namespace photic::scene {

std::string starter_scene(const std::string& kind) {
  std::vector<std::string> kinds;
  for (const StarterScene& starter : starter_scenes()) {
    if (starter.kind == kind) return starter.text;
    kinds.push_back(starter.kind);
  }
  throw InputError({{"", 0, 0, fmt::format("there is no starter scene '{}'", kind),
                     suggestion_for(kind, kinds, "choose from")}});
}

std::vector<StarterFile> starter_files(const std::string& kind) {
  std::vector<StarterFile> files;
  const auto [first, last] = all_starter_files().equal_range(kind);
  for (auto it = first; it != last; ++it) files.push_back(it->second);
  return files;
}

std::vector<StarterKind> starter_kinds() {
  std::vector<StarterKind> kinds;
  for (const StarterScene& starter : starter_scenes()) {
    const std::string line = starter.text.substr(0, starter.text.find('\n'));
    expect(line.starts_with("# "), "a starter scene begins with a comment");
    kinds.push_back({starter.kind, line.substr(2)});
  }
  return kinds;
}

}  // namespace photic::scene
