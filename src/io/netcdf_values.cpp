#include "io/netcdf_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace photic::io {
namespace {

/// 80 MB of doubles. A file of a few bytes may claim to hold any number of them.
constexpr std::size_t max_values = 10'000'000;

int variable_called(const NetcdfReader& file, const std::string& name) {
  int id = -1;
  const int status = nc_inq_varid(file.id(), name.c_str(), &id);
  if (status != NC_NOERR)
    file.refuse(fmt::format("{}: cannot be read: {}", name, nc_strerror(status)));
  return id;
}

int number_of_variables(const NetcdfReader& file) {
  int count = 0;
  if (nc_inq_nvars(file.id(), &count) != NC_NOERR) file.refuse("has no list of variables");
  return count;
}

/// The numbers of its dimensions; none if they cannot be read.
std::vector<int> dimensions_of(const NetcdfReader& file, int variable) {
  int count = 0;
  if (nc_inq_varndims(file.id(), variable, &count) != NC_NOERR) return {};
  std::vector<int> ids(static_cast<std::size_t>(count));
  if (count > 0 && nc_inq_vardimid(file.id(), variable, ids.data()) != NC_NOERR) return {};
  return ids;
}

}  // namespace

std::string name_by(const NetcdfReader& file, const std::function<int(char*)>& inquire) {
  const auto buffer = std::make_unique_for_overwrite<char[]>(file.size() + NC_MAX_NAME + 1);
  return inquire(buffer.get()) == NC_NOERR ? buffer.get() : "";
}

std::vector<std::string> variable_names(const NetcdfReader& file) {
  std::vector<std::string> names;
  for (int id = 0; id < number_of_variables(file); ++id) {
    names.push_back(name_by(file, [&](char* name) { return nc_inq_varname(file.id(), id, name); }));
    if (names.back().empty()) file.refuse("has a variable without name");
  }
  return names;
}

std::set<int> dimensions_of_values(const NetcdfReader& file) {
  std::set<int> found;
  for (int id = 0; id < number_of_variables(file); ++id) {
    nc_type type = NC_NAT;
    if (nc_inq_vartype(file.id(), id, &type) != NC_NOERR || type == NC_CHAR) continue;
    const auto dimensions = dimensions_of(file, id);
    found.insert(dimensions.begin(), dimensions.end());
  }
  return found;
}

NetcdfValues::NetcdfValues(const NetcdfReader& file, const std::string& name,
                           const std::set<int>& of_values)
    : file_(file), id_(variable_called(file, name)), attributes_(file, id_, name) {
  check(nc_inq_vartype(file.id(), id_, &type_));
  const std::vector<int> ids = dimensions_of(file, id_);
  for (const int id : ids) {
    dimension_.push_back(
        name_by(file, [&](char* to) { return nc_inq_dimname(file.id(), id, to); }));
    check(nc_inq_dimlen(file.id(), id, &length_.emplace_back()));
  }
  if (type_ != NC_CHAR || ids.empty() || of_values.contains(ids.back())) return;
  characters_ = length_.back();
  dimension_.pop_back();
  length_.pop_back();
}

std::size_t NetcdfValues::count() const {
  std::size_t product = 1;
  for (const std::size_t length : length_) {
    if (length > 0 && product > max_values / length)
      attributes_.refuse(fmt::format("has more than {} values", max_values));
    product *= length;
  }
  return product;
}

std::vector<double> NetcdfValues::numbers() const {
  if (!holds_numbers(type_)) attributes_.refuse("does not hold numbers");
  std::vector<double> value(count());
  if (!value.empty()) check(nc_get_var_double(file_.id(), id_, value.data()));
  return value;
}

std::vector<std::string> NetcdfValues::texts() const {
  if (type_ == NC_CHAR) return characters();
  if (type_ == NC_STRING) return strings();
  attributes_.refuse("does not hold numbers or texts");
}

std::vector<std::string> NetcdfValues::characters() const {
  const std::size_t size = count();
  if (characters_ > 0 && size > max_values / characters_)
    attributes_.refuse(fmt::format("has more than {} characters", max_values));
  std::string all(size * characters_, ' ');
  if (!all.empty()) check(nc_get_var_text(file_.id(), id_, all.data()));
  std::vector<std::string> out;
  for (std::size_t i = 0; i < size; ++i) out.push_back(all.substr(i * characters_, characters_));
  return out;
}

std::vector<std::string> NetcdfValues::strings() const {
  std::vector<char*> raw(count());
  if (raw.empty()) return {};
  check(nc_get_var_string(file_.id(), id_, raw.data()));
  std::vector<std::string> out;
  for (const char* text : raw) out.emplace_back(text ? text : "");
  nc_free_string(raw.size(), raw.data());
  return out;
}

}  // namespace photic::io
