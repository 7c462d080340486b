// Profiles in files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/describe_profile.hpp"
#include "scene/netcdf_files.hpp"
#include "scene/profile.hpp"
#include "scene/rules.hpp"

namespace photic::scene {

/// A key of a layer that may be a profile, and what its values may be.
struct ProfiledKey {
  std::string key;
  Number rule;
  std::optional<double> scale;  ///< the measure of departures (Varying)
};

/// A profile, and what its user should know.
struct ReadProfile {
  LinearProfile profile;
  std::vector<std::string> remarks;
};

/// A column of a file of text; each value obeys the key's rule. Throws InputError at its line and
/// column.
ReadProfile profile_of_text(const ProfileFile& from, const ProfiledKey& key);

/// A variable of a netCDF file with the dimensions (levels) or (profiles, levels), of which the
/// levels may be those of several casts, in units that become the key's. Depths are lengths, or
/// pressures, which become depths at the file's latitude. Levels without a value, and those that
/// quality flags call bad, are left out. Throws InputError naming file, variable and level.
ReadProfile profile_of_netcdf(const ProfileFile& from, const ProfiledKey& key,
                              const NetcdfFiles& netcdf);

}  // namespace photic::scene
