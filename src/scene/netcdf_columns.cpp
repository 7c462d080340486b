#include "scene/netcdf_columns.hpp"

#include <utility>

#include "core/error.hpp"
#include "scene/suggest.hpp"

namespace photic::scene {

NetcdfColumns::NetcdfColumns(std::string path, const NetcdfFiles& netcdf)
    : path_(std::move(path)), netcdf_(netcdf) {
  expect(netcdf_.contents && netcdf_.read && netcdf_.codes,
         "whoever reads scenes hands down how netCDF files are read");
  contents_ = netcdf_.contents(path_);
}

std::vector<std::string> NetcdfColumns::names() const {
  std::vector<std::string> names;
  for (const auto& [name, header] : contents_.variable) names.push_back(name);
  return names;
}

bool NetcdfColumns::has(const std::string& name) const { return contents_.variable.contains(name); }

const NetcdfHeader& NetcdfColumns::header(const std::string& name) const {
  const auto found = contents_.variable.find(name);
  if (found == contents_.variable.end())
    fail("", fmt::format("no variable \"{}\"", name), suggestion_for(name, names(), "there are"));
  return found->second;
}

NetcdfVariable NetcdfColumns::read(const std::string& name) const {
  static_cast<void>(header(name));
  return netcdf_.read(path_, name);
}

NetcdfCodes NetcdfColumns::codes(const std::string& name) const {
  static_cast<void>(header(name));
  return netcdf_.codes(path_, name);
}

void NetcdfColumns::fail(const std::string& what, const std::string& reason,
                         const std::string& suggestion) const {
  throw InputError({{.file = what.empty() ? path_ : path_ + ": " + what,
                     .reason = reason,
                     .suggestion = suggestion}});
}

}  // namespace photic::scene
