// The meaning of each flag of a variable of quality flags (CF-1.10, section 3.5).
#pragma once

#include <string>
#include <vector>

#include "scene/flag_meaning.hpp"
#include "scene/netcdf_columns.hpp"

namespace photic::scene {

/// One of the different flags of a variable.
struct FlagCode {
  Quality quality = Quality::unclear;
  std::string text;    ///< with its meaning, where the file has one
  std::string misfit;  ///< reason why the flag should not be there; empty if it may
};

struct FlagCodes {
  std::vector<FlagCode> code;  ///< in the order of NetcdfCodes
  bool by_table = false;       ///< numbers that Argo's table explains, for want of flag_meanings
};

/// Throws InputError for attributes that contradict each other.
[[nodiscard]] FlagCodes flag_codes(const NetcdfColumns& file, const std::string& name,
                                   const NetcdfCodes& codes);

}  // namespace photic::scene
