#include "scene/netcdf_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "scene/suggest.hpp"

namespace photic::scene {

NetcdfColumns::NetcdfColumns(std::string path, const NetcdfFiles& netcdf)
    : path_(std::move(path)), netcdf_(netcdf) {
  expect(netcdf_.names && netcdf_.read && netcdf_.flags,
         "whoever reads scenes hands down how netCDF files are read");
  names_ = netcdf_.names(path_);
}

bool NetcdfColumns::has(const std::string& name) const {
  return std::find(names_.begin(), names_.end(), name) != names_.end();
}

NetcdfVariable NetcdfColumns::read(const std::string& name) const {
  expect_variable(name);
  return netcdf_.read(path_, name);
}

NetcdfVariable NetcdfColumns::read_flags(const std::string& name, std::size_t rank) const {
  expect_variable(name);
  return netcdf_.flags(path_, name, rank);
}

void NetcdfColumns::expect_variable(const std::string& name) const {
  if (!has(name))
    fail("", fmt::format("no variable \"{}\"", name), suggestion_for(name, names_, "there are"));
}

void NetcdfColumns::fail(const std::string& what, const std::string& reason,
                         const std::string& suggestion) const {
  throw InputError({{.file = what.empty() ? path_ : path_ + ": " + what,
                     .reason = reason,
                     .suggestion = suggestion}});
}

std::string shape_text(const std::string& name, const NetcdfVariable& variable) {
  return fmt::format("{}({})", name, fmt::join(variable.dimension, ", "));
}

}  // namespace photic::scene
