// What the reader of scenes asks of netCDF files. The library that reads them has its place on a
// higher floor, which hands this down (io/netcdf_variable.hpp).
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace photic::scene {

/// A variable of numbers. Missing values are NaN. Texts are attributes, empty if there are none.
struct NetcdfVariable {
  std::vector<std::string> dimension;
  std::vector<std::size_t> length;  ///< of each dimension
  std::string units;
  std::vector<double> value;  ///< the last dimension fastest
  std::string standard_name = {};
  std::string positive = {};                   ///< up or down, of depths
  std::map<double, std::string> meaning = {};  ///< of flags: flag_values and flag_meanings
};

/// All throw InputError for a file of no use, EnvironmentError for one that cannot be read.
struct NetcdfFiles {
  std::function<std::vector<std::string>(const std::string& path)> names;  ///< of the variables
  std::function<NetcdfVariable(const std::string& path, const std::string& name)> read;
  /// A variable of flags of so many dimensions: numbers, or the digits 0 to 9 as characters or
  /// texts (others are NaN).
  std::function<NetcdfVariable(const std::string& path, const std::string& name, std::size_t rank)>
      flags;
};

/// The same, each list and variable being read once and kept: environments ask for them again.
[[nodiscard]] NetcdfFiles read_once(const NetcdfFiles& files);

}  // namespace photic::scene
