#include "io/netcdf_variable.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <set>

#include "core/error.hpp"
#include "io/netcdf_attributes.hpp"
#include "io/netcdf_packing.hpp"
#include "io/netcdf_reader.hpp"
#include "io/netcdf_values.hpp"

namespace photic::io {
namespace {

/// Attributes that identify a profile (CF-1.10, sections 3.4, 3.5, 4 and 9; "conventions" is
/// Argo's).
constexpr std::array attributes_of_headers{
    "standard_name",    "axis",    "ancillary_variables", "conventions",
    "sample_dimension", "cf_role", "instance_dimension",  "flag_meanings"};

scene::NetcdfHeader header_of(const NetcdfValues& variable) {
  const NetcdfAttributes& attributes = variable.attributes();
  scene::NetcdfHeader header{variable.dimension(), variable.length()};
  header.has_numbers = holds_numbers(variable.type());
  for (const char* name : attributes_of_headers) {
    const nc_type type = attributes.type(name);
    if (type == NC_CHAR || type == NC_STRING)
      header.attribute[name] = fmt::format("{}", fmt::join(attributes.texts(name), " "));
  }
  for (const char* name : {"flag_values", "flag_masks", "flag_meanings"})
    header.has_flags = header.has_flags || attributes.type(name) != NC_NAT;
  return header;
}

std::map<std::string, std::size_t> dimension_lengths(const NetcdfReader& file) {
  int count = 0;
  if (nc_inq_ndims(file.id(), &count) != NC_NOERR) file.refuse("has no list of dimensions");
  std::vector<int> ids(static_cast<std::size_t>(count));
  if (nc_inq_dimids(file.id(), &count, ids.data(), 0) != NC_NOERR)
    file.refuse("has no list of dimensions");
  std::map<std::string, std::size_t> found;
  for (const int id : ids) {
    const std::string name =
        name_by(file, [&](char* to) { return nc_inq_dimname(file.id(), id, to); });
    if (name.empty() || nc_inq_dimlen(file.id(), id, &found[name]) != NC_NOERR)
      file.refuse("has a dimension without name");
  }
  return found;
}

}  // namespace

scene::NetcdfContents netcdf_contents(const std::string& path) {
  const NetcdfReader file(path, what_is_wanted);
  const std::set<int> of_values = dimensions_of_values(file);
  scene::NetcdfContents contents{dimension_lengths(file), {}};
  for (const std::string& name : variable_names(file))
    contents.variable[name] = header_of({file, name, of_values});
  return contents;
}

scene::NetcdfVariable netcdf_variable(const std::string& path, const std::string& name) {
  const NetcdfReader file(path, what_is_wanted);
  const NetcdfValues variable(file, name, dimensions_of_values(file));
  const NetcdfAttributes& attributes = variable.attributes();
  scene::NetcdfVariable out{variable.dimension(), variable.length(), "", variable.numbers()};
  out.units = attributes.text("units");
  out.standard_name = attributes.text("standard_name");
  out.positive = attributes.text("positive");
  const Packing packing(attributes, variable.type());
  for (double& x : out.value) x = packing.unpacked(x);
  return out;
}

scene::NetcdfFiles netcdf_files() { return {netcdf_contents, netcdf_variable, netcdf_codes}; }

}  // namespace photic::io
