// The keys of a table of inherent optical properties that replaces all layers.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "scene/describe_sea.hpp"

namespace photic::scene {

/// The quantities of a file by depth and wavelength, and the keys of their names in it.
struct IopColumn {
  const char *name, *key;
};
inline constexpr std::array iop_columns{IopColumn{"depth_m", "depth"},
                                        IopColumn{"wavelength_nm", "wavelength"},
                                        IopColumn{"a_per_m", "a"},
                                        IopColumn{"b_per_m", "b"},
                                        IopColumn{"c_per_m", "c"},
                                        IopColumn{"bb_per_m", "bb"},
                                        IopColumn{"a_phytoplankton_per_m", "a_phytoplankton"},
                                        IopColumn{"a_cdom_per_m", "a_cdom"}};

struct IopTable {
  std::string file;
  std::array<std::optional<optics::ColumnInFile>, iop_columns.size()> column;
  std::optional<PhaseFunction> phase_function;
};

template <class V>
void describe(V& v, IopTable& t) {
  v.required(file_key, t.file, File{},
             "a file of text or netCDF file (.nc) of depth_m, wavelength_nm, a_per_m, b_per_m or "
             "c_per_m");
  for (std::size_t i = 0; i < iop_columns.size(); ++i) {
    const std::string meaning = meaning_in_file({iop_columns[i].name, ""});
    v.optional(iop_columns[i].key, t.column[i], ColumnOfFile{}, meaning.c_str());
  }
  v.table_or_word("phase_function", t.phase_function, model_key,
                  "the phase function of all scattering, where the file has no bb_per_m");
}

}  // namespace photic::scene
