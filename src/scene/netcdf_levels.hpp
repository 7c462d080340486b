// One profile of a netCDF file as floats write them, variable by variable.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/netcdf_columns.hpp"

namespace photic::scene {

/// More levels than any instrument writes; bounds the time that cutting takes.
inline constexpr std::size_t most_levels = 100'000;

/// One profile of a variable: values by level, NaN where there are none.
struct Levels {
  std::string prefix;  ///< of the index of a level: "CHLA[0, "
  std::vector<double> value;
  std::string flagged = {};  ///< what quality flags have taken out; empty if nothing

  [[nodiscard]] std::string at(std::size_t level) const;
};

/// A variable with the dimensions (levels) or (profiles, levels), and its quality flags, NAME_QC,
/// where the file has them. All functions throw InputError.
class ProfileVariable {
 public:
  ProfileVariable(const NetcdfColumns& file, std::string name);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const NetcdfVariable& variable() const { return variable_; }
  [[nodiscard]] std::string shape() const { return shape_text(name_, variable_); }
  [[nodiscard]] std::size_t profiles() const;  ///< 1 of (levels)

  /// Without the levels that flags call bad.
  [[nodiscard]] Levels levels(std::size_t profile) const;
  /// The same; what has the dimension (levels) holds for all profiles.
  [[nodiscard]] Levels levels_for(std::size_t profile) const;

 private:
  /// What belongs to a profile, of the values or of the flags.
  [[nodiscard]] std::vector<double> row(const NetcdfVariable& of, std::size_t profile) const;
  void read_flags();
  void drop_flagged(std::size_t profile, Levels& levels) const;

  const NetcdfColumns& file_;
  const std::string name_, flags_name_;
  const NetcdfVariable variable_;
  std::optional<NetcdfVariable> flags_;
};

/// What may serve where a profile has no two levels with a depth and a value.
[[nodiscard]] std::string instead_of(const NetcdfColumns& file, const ProfileVariable& depth,
                                     const ProfileVariable& value, std::size_t profile);

}  // namespace photic::scene
