// The base scene over columns of water in place of its layers.
#pragma once

#include <string>
#include <vector>

#include "unit/scene/base_scene.hpp"

namespace photic::scene {

/// Two columns that end at 20 m, from x = -1 to 2 and from there to 40 m. Their lines are 19 to 37
/// of the file.
inline const std::vector<std::string>& row_lines() {
  // clang-format off
  static const std::vector<std::string> lines{
      /* 19 */ "[sea]",
      /* 20 */ "y_min_m = -50",
      /* 21 */ "y_max_m = 50",
      /* 22 */ "[[sea.column]]",
      /* 23 */ "x_min_m = -1",
      /* 24 */ "x_max_m = 2",
      /* 25 */ "[[sea.column.layer]]",
      /* 26 */ "bottom_depth_m = 20",
      /* 27 */ "chlorophyll_mg_m3 = 0.1",
      /* 28 */ "[[sea.column]]",
      /* 29 */ R"(name = "plume")",
      /* 30 */ "x_max_m = 40",
      /* 31 */ "[[sea.column.layer]]",
      /* 32 */ "bottom_depth_m = 5",
      /* 33 */ "minerals_g_m3 = 5",
      /* 34 */ "[[sea.column.layer]]",
      /* 35 */ "bottom_depth_m = 20",
      /* 36 */ "iop = [{ wavelength_nm = 532, a_per_m = 0.06, b_per_m = 0.1 }]",
      /* 37 */ R"(phase_function = { model = "henyey-greenstein", g = 0.9 })",
  };
  // clang-format on
  return lines;
}

/// The scene with lines of the row, by their numbers in it, in place of others; "" leaves an empty
/// line.
inline std::string row_text(const std::vector<Edit>& edits = {}) {
  constexpr int first = 19;
  std::vector<std::string> lines = row_lines();
  for (const Edit& edit : edits)
    for (int i = edit.first; i <= edit.last; ++i)
      lines[static_cast<std::size_t>(i - first)] = i == edit.first ? edit.text : "";
  std::string row;
  for (const std::string& line : lines) row += (row.empty() ? "" : "\n") + line;
  return edited({{19, 25, row}});
}

inline std::string row_scene() { return row_text(); }

}  // namespace photic::scene
