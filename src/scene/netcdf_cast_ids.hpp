// The variables that differ between the casts in one dimension of a netCDF file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/netcdf_columns.hpp"
#include "scene/netcdf_layout.hpp"

namespace photic::scene {

/// Values of one cast have the same one.
struct CastId {
  std::string name;
  std::vector<std::size_t> value;  ///< of each value of a profile; NetcdfCodes::none in no cast
  std::optional<std::size_t> casts = {};  ///< for values that number so many casts
  NetcdfCodes codes = {};                 ///< else the value is one of these, which have no values

  /// "58" of a cycle_number.
  [[nodiscard]] std::string label(std::size_t code) const;
};

/// The profiles of two dimensions; counts and indices of ragged arrays (CF-1.10, section 9.3),
/// which come before all others; variables that are known by their cf_role or their name. Throws
/// InputError for counts and indices that are wrong.
[[nodiscard]] std::vector<CastId> cast_ids(const NetcdfColumns& file, const Layout& layout);

/// Times and places of the values: both, places alone, times alone.
[[nodiscard]] std::vector<std::vector<CastId>> times_and_places(const NetcdfColumns& file,
                                                                const Layout& layout);

}  // namespace photic::scene
