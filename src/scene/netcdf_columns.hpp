// Variables of a netCDF file that a scene names, and what is wrong with them.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "scene/netcdf_files.hpp"

namespace photic::scene {

class NetcdfColumns {
 public:
  /// Throws as NetcdfFiles does.
  NetcdfColumns(std::string path, const NetcdfFiles& netcdf);

  [[nodiscard]] const NetcdfContents& contents() const { return contents_; }
  /// The names of the variables, in the order of the alphabet.
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] bool has(const std::string& name) const;
  // Throw InputError with the names there are if this is none of them.
  [[nodiscard]] const NetcdfHeader& header(const std::string& name) const;
  [[nodiscard]] NetcdfVariable read(const std::string& name) const;
  [[nodiscard]] NetcdfCodes codes(const std::string& name) const;
  /// Throws the InputError about something in the file.
  [[noreturn]] void fail(const std::string& what, const std::string& reason,
                         const std::string& suggestion = "") const;

 private:
  std::string path_;
  const NetcdfFiles& netcdf_;
  NetcdfContents contents_;
};

/// "CHLA(N_PROF, N_LEVELS)".
template <class Variable>
[[nodiscard]] std::string shape_text(const std::string& name, const Variable& variable) {
  return fmt::format("{}({})", name, fmt::join(variable.dimension, ", "));
}

}  // namespace photic::scene
