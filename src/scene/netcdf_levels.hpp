// One variable of profiles in a netCDF file, and the flags of it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/netcdf_columns.hpp"
#include "scene/netcdf_flags.hpp"

namespace photic::scene {

/// More levels than any instrument writes; bounds the time that cutting takes.
inline constexpr std::size_t max_levels = 100'000;

/// One profile of a variable: values by level, NaN where there are none or flags call them bad.
struct Levels {
  std::vector<double> value;
  std::vector<std::string> flagged;  ///< values that quality flags have taken out
  std::vector<std::string> remarks;
};

/// All functions throw InputError.
class ProfileVariable {
 public:
  ProfileVariable(const NetcdfColumns& file, const std::string& name);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const NetcdfVariable& variable() const { return variable_; }
  /// "CHLA[0, 3]".
  [[nodiscard]] std::string at(std::size_t position) const;
  [[nodiscard]] Levels levels(const std::vector<std::size_t>& positions) const;

 private:
  const std::string name_;
  const NetcdfVariable variable_;
  const QualityFlags flags_;
};

}  // namespace photic::scene
