// Variables of a netCDF file that a scene names, and what is wrong with them.
#pragma once

#include <string>
#include <vector>

#include "scene/netcdf_files.hpp"

namespace photic::scene {

class NetcdfColumns {
 public:
  /// Throws as NetcdfFiles does.
  NetcdfColumns(std::string path, const NetcdfFiles& netcdf);

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] bool has(const std::string& name) const;
  /// Throws InputError with the names there are if this is none of them.
  [[nodiscard]] NetcdfVariable read(const std::string& name) const;
  /// The same of a variable of flags of so many dimensions.
  [[nodiscard]] NetcdfVariable read_flags(const std::string& name, std::size_t rank) const;
  /// Throws the InputError about something in the file.
  [[noreturn]] void fail(const std::string& what, const std::string& reason,
                         const std::string& suggestion = "") const;

 private:
  void expect_variable(const std::string& name) const;

  std::string path_;
  const NetcdfFiles& netcdf_;
  std::vector<std::string> names_;
};

/// "CHLA(N_PROF, N_LEVELS)".
[[nodiscard]] std::string shape_text(const std::string& name, const NetcdfVariable& variable);

}  // namespace photic::scene
