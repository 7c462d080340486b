#include "unit/scene/base_scene.hpp"

#include "core/error.hpp"

namespace photic::scene {

const std::vector<std::string>& base_lines() {
  // clang-format off
  static const std::vector<std::string> lines{
      /*  1 */ R"(title = "Base")",
      /*  2 */ "[source]",
      /*  3 */ "wavelength_nm = 532.0",
      /*  4 */ "position_m = [0, 0, 12]",
      /*  5 */ "direction = [0, 0, -1]",
      /*  6 */ "diameter_m = 0.04",
      /*  7 */ "half_divergence_mrad = 5",
      /*  8 */ "[[telescope]]",
      /*  9 */ R"(name = "t")",
      /* 10 */ "position_m = [0, 0, 12]",
      /* 11 */ "direction = [0, 0, -1]",
      /* 12 */ "diameter_m = 0.4",
      /* 13 */ "focal_length_m = 2",
      /* 14 */ "detector_diameter_m = 0.04",
      /* 15 */ "[[channel]]",
      /* 16 */ R"(name = "elastic")",
      /* 17 */ R"(process = "elastic")",
      /* 18 */ "[optics]",
      /* 19 */ "[sea]",
      /* 20 */ "[[sea.layer]]",
      /* 21 */ "bottom_depth_m = 20",
      /* 22 */ "chlorophyll_mg_m3 = 0.1",
      /* 23 */ "[[sea.layer]]",
      /* 24 */ "iop = [{ wavelength_nm = 532, a_per_m = 0.06, b_per_m = 0.1 }]",
      /* 25 */ R"(phase_function = { model = "henyey-greenstein", g = 0.9 })",
      /* 26 */ "[gates]",
      /* 27 */ "depth_max_m = 50",
      /* 28 */ "depth_step_m = 1",
      /* 29 */ "[simulation]",
      /* 30 */ "photons = 1e6",
  };
  // clang-format on
  return lines;
}

std::string edited(const std::vector<Edit>& edits) {
  std::string text;
  auto edit = edits.begin();
  const auto& lines = base_lines();
  for (int number = 1; number <= static_cast<int>(lines.size()); ++number) {
    while (edit != edits.end() && edit->last < number) ++edit;
    const bool inside = edit != edits.end() && edit->first <= number;
    if (!inside) text += lines[static_cast<std::size_t>(number - 1)] + '\n';
    if (inside && number == edit->first && !edit->text.empty()) text += edit->text + '\n';
  }
  return text;
}

std::vector<std::string> diagnostics_of(const std::string& text,
                                        const std::vector<Override>& overrides,
                                        const Check& check) {
  std::vector<std::string> texts;
  try {
    read_scene_text(text, "scene.toml", "/", overrides, check);
  } catch (const InputError& error) {
    for (const Diagnostic& diagnostic : error.diagnostics()) texts.push_back(diagnostic.text());
  }
  return texts;
}

Scene read_text(const std::string& text, const std::vector<Override>& overrides) {
  return read_scene_text(text, "scene.toml", "/", overrides).scene;
}

Scene base_scene(const std::vector<Override>& overrides) {
  return read_scene_text(edited({}), "scene.toml", "/", overrides).scene;
}

}  // namespace photic::scene
