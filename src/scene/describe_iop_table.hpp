// The keys of a table of inherent optical properties that replaces all layers.
#pragma once

#include <optional>
#include <string>

#include "scene/describe_sea.hpp"

namespace photic::scene {

struct IopTable {
  std::string file;
  std::optional<PhaseFunction> phase_function;
};

inline constexpr const char* file_key = "file";

template <class V>
void describe(V& v, IopTable& t) {
  v.required(file_key, t.file, File{},
             "a CSV or netCDF file (.nc) of depth_m, wavelength_nm, a_per_m, b_per_m or c_per_m");
  v.table_or_word("phase_function", t.phase_function, model_key,
                  "the phase function of all scattering, where the file has no bb_per_m");
}

}  // namespace photic::scene
