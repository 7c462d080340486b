// The base scene after edits, as the check of its optics finds it.
#pragma once

#include "medium/check.hpp"
#include "unit/medium/scenes.hpp"
#include "unit/scene/base_scene.hpp"

namespace photic::medium {

using scene::edited;
using Texts = std::vector<std::string>;

inline void check(const scene::Scene& scene, scene::Findings& findings, scene::Asked) {
  check_medium(scene, library(), findings);
}

inline Texts problems(const std::vector<scene::Edit>& edits, const Texts& overrides = {}) {
  return scene::diagnostics_of(edited(edits), overrides, check);
}

inline Texts remarks(const std::vector<scene::Edit>& edits) {
  return scene::read_scene_text(edited(edits), "scene.toml", "/", {}, check).remarks;
}

inline const std::string raman_channel = "name = \"r\"\nprocess = \"raman\"";

}  // namespace photic::medium
