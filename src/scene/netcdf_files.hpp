// What the reader of scenes asks of netCDF files. The library that reads them has its place on a
// higher floor, which hands this down (io/netcdf_variable.hpp).
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace photic::scene {

/// A variable of numbers. Missing values are NaN.
struct NetcdfVariable {
  std::vector<std::string> dimension;
  std::vector<std::size_t> length;  ///< of each dimension
  std::string units;                ///< its attribute; empty if there is none
  std::vector<double> value;        ///< the last dimension fastest
};

/// All throw InputError for a file of no use, EnvironmentError for one that cannot be read.
struct NetcdfFiles {
  std::function<std::vector<std::string>(const std::string& path)> names;  ///< of the variables
  std::function<NetcdfVariable(const std::string& path, const std::string& name)> read;
  /// A variable of flags: numbers, or the characters 0 to 9 (others are NaN).
  std::function<NetcdfVariable(const std::string& path, const std::string& name)> flags;
};

/// The same, each list and variable being read once and kept: environments ask for them again.
[[nodiscard]] NetcdfFiles read_once(const NetcdfFiles& files);

}  // namespace photic::scene
