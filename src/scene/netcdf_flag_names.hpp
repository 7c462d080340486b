// Finds the variables of a netCDF file that are quality flags of another one.
#pragma once

#include <string>
#include <vector>

#include "scene/netcdf_columns.hpp"

namespace photic::scene {

/// The variables of flags, and those that look like flags and are not understood.
struct FlagNames {
  std::vector<std::string> listed;  ///< by the attribute ancillary_variables (CF-1.10, section 3.4)
  std::vector<std::string> named;   ///< after the variable: CHLA_QC, chla_qc
  std::vector<std::string> remarks;
};

[[nodiscard]] FlagNames flag_names_of(const NetcdfColumns& file, const std::string& variable);

}  // namespace photic::scene
