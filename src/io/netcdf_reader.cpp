#include "io/netcdf_reader.hpp"

#include <fmt/format.h>
#include <netcdf.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <numeric>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "io/netcdf.hpp"

namespace photic::io {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_file(const std::string& path, const std::string& reason,
                              const std::string& suggestion) {
  throw InputError({{.file = path, .reason = reason, .suggestion = suggestion}});
}

int open_file(const std::string& path, const std::string& wanted) {
  // Asked of the file system first: netCDF would take some paths for addresses on the network.
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    if (error && error != std::errc::no_such_file_or_directory)
      throw EnvironmentError(fmt::format("{}: cannot read the file: {}", path, error.message()));
    refuse_file(path, fs::exists(path, error) ? "not a file" : "there is no such file", wanted);
  }
  // Files of the system that have no end have a size of 0.
  if (fs::file_size(path, error) == 0) refuse_file(path, "not a netCDF file", wanted);
  int file = -1;
  const int status = nc_open(path.c_str(), NC_NOWRITE, &file);
  if (status > 0)  // an errno of the system
    throw EnvironmentError(fmt::format("{}: cannot read the file: {}", path, nc_strerror(status)));
  if (status == NC_ENOTNC) refuse_file(path, "not a netCDF file", wanted);
  if (status != NC_NOERR)
    refuse_file(path, fmt::format("a damaged netCDF file: {}", nc_strerror(status)), wanted);
  return file;
}

}  // namespace

NetcdfReader::NetcdfReader(std::string path, std::string wanted)
    : path_(std::move(path)),
      wanted_(std::move(wanted)),
      file_(open_file(path_, wanted_)),
      group_(file_) {}

NetcdfReader::~NetcdfReader() { nc_close(file_); }

std::size_t NetcdfReader::size() const {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path_, error);
  return error ? 0 : static_cast<std::size_t>(size);
}

double NetcdfReader::format() const {
  if (!has("photic_format"))
    refuse("a netCDF file, but not a result of Photic: it has no attribute photic_format");
  return number("photic_format");
}

void NetcdfReader::expect_result() const {
  if (!(format() <= photic_format))
    refuse_file(path_,
                fmt::format("written by a newer Photic (result format {}; this program reads up to "
                            "{})",
                            format(), photic_format),
                "use the newer Photic");
}

bool NetcdfReader::has(const std::string& attribute) const {
  return nc_inq_attid(group_, NC_GLOBAL, attribute.c_str(), nullptr) == NC_NOERR;
}

std::string NetcdfReader::other_content() const {
  if (!has("photic_content")) return "";
  const std::string content = text("photic_content");
  return content == "optics" ? "the optics of layers" : content;
}

bool NetcdfReader::enter_group(const std::string& name) {
  return nc_inq_grp_ncid(file_, name.c_str(), &group_) == NC_NOERR;
}

std::string NetcdfReader::text(const std::string& name) const {
  std::size_t length = 0;
  if (!is_single(name, NC_STRING)) {
    nc_type type = NC_NAT;
    if (nc_inq_att(group_, NC_GLOBAL, name.c_str(), &type, &length) != NC_NOERR || type != NC_CHAR)
      refuse(fmt::format("a damaged result: it has no attribute {} that is a text", name));
    std::string characters(length, ' ');
    check(nc_get_att_text(group_, NC_GLOBAL, name.c_str(), characters.data()), name);
    return characters;
  }
  char* text = nullptr;
  check(nc_get_att_string(group_, NC_GLOBAL, name.c_str(), &text), name);
  std::string copy = text == nullptr ? "" : text;
  nc_free_string(1, &text);
  return copy;
}

std::uint64_t NetcdfReader::count(const std::string& name) const {
  if (is_single(name, NC_UINT64)) {
    std::uint64_t value = 0;
    check(nc_get_att(group_, NC_GLOBAL, name.c_str(), &value), name);
    return value;
  }
  // The result as another program wrote it again has int64, or the substitute of netCDF-3.
  constexpr double whole_below = 9007199254740992.0;  // 2^53
  const double value = is_single_number(name) ? number(name) : -1;
  if (!(value >= 0 && value <= whole_below && value == std::floor(value)))
    refuse(fmt::format("a damaged result: it has no attribute {} that is a count", name));
  return static_cast<std::uint64_t>(value);
}

double NetcdfReader::number(const std::string& name) const {
  if (!is_single_number(name))
    refuse(fmt::format("a damaged result: it has no attribute {} that is a number", name));
  double value = 0;
  check(nc_get_att_double(group_, NC_GLOBAL, name.c_str(), &value), name);
  return value;
}

std::vector<double> NetcdfReader::numbers(const std::string& name,
                                          const std::vector<std::size_t>& lengths) const {
  return values<double>(name, NC_DOUBLE, lengths);
}

std::vector<std::uint64_t> NetcdfReader::counts(const std::string& name,
                                                const std::vector<std::size_t>& lengths) const {
  return values<std::uint64_t>(name, NC_UINT64, lengths);
}

void NetcdfReader::refuse(const std::string& reason) const { refuse_file(path_, reason, wanted_); }

template <class T>
std::vector<T> NetcdfReader::values(const std::string& name, int type,
                                    const std::vector<std::size_t>& lengths) const {
  int variable = 0;
  nc_type found = NC_NAT;
  if (nc_inq_varid(group_, name.c_str(), &variable) != NC_NOERR ||
      nc_inq_vartype(group_, variable, &found) != NC_NOERR || found != type ||
      lengths_of(variable) != lengths)
    refuse(fmt::format("a damaged result: it has no variable {} of the size of its scene", name));
  std::vector<T> out(
      std::accumulate(lengths.begin(), lengths.end(), std::size_t{1}, std::multiplies<>()));
  check(nc_get_var(group_, variable, out.data()), name);
  return out;
}

bool NetcdfReader::is_single_number(const std::string& name) const {
  nc_type found = NC_NAT;
  std::size_t length = 0;
  return nc_inq_att(group_, NC_GLOBAL, name.c_str(), &found, &length) == NC_NOERR && length == 1 &&
         found >= NC_BYTE && found <= NC_UINT64 && found != NC_CHAR;
}

bool NetcdfReader::is_single(const std::string& name, int type) const {
  nc_type found = NC_NAT;
  std::size_t length = 0;
  return nc_inq_att(group_, NC_GLOBAL, name.c_str(), &found, &length) == NC_NOERR &&
         found == type && length == 1;
}

std::vector<std::size_t> NetcdfReader::lengths_of(int variable) const {
  int count = 0;
  check(nc_inq_varndims(group_, variable, &count), "dimensions");
  std::vector<int> dimensions(static_cast<std::size_t>(count));
  check(nc_inq_vardimid(group_, variable, dimensions.data()), "dimensions");
  std::vector<std::size_t> lengths(dimensions.size());
  for (std::size_t i = 0; i < lengths.size(); ++i)
    check(nc_inq_dimlen(group_, dimensions[i], &lengths[i]), "dimensions");
  return lengths;
}

void NetcdfReader::check(int status, const std::string& name) const {
  if (status != NC_NOERR)
    refuse(fmt::format("a damaged result: {}: {}", name, nc_strerror(status)));
}

}  // namespace photic::io
