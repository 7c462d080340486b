#include "io/netcdf_attributes.hpp"

#include <fmt/format.h>

#include <utility>

namespace photic::io {
namespace {

/// Longer ones are no words, and no lists of flags.
constexpr std::size_t longest_attribute = 1000;
/// Nor lists of names or meanings.
constexpr std::size_t longest_text = 100'000;

}  // namespace

NetcdfAttributes::NetcdfAttributes(const NetcdfReader& file, int variable,
                                   std::string variable_name)
    : file_(file), variable_(variable), name_(std::move(variable_name)) {}

nc_type NetcdfAttributes::type(const char* attribute) const {
  nc_type type = NC_NAT;
  const int status = nc_inq_atttype(file_.id(), variable_, attribute, &type);
  return status == NC_NOERR ? type : NC_NAT;
}

std::size_t NetcdfAttributes::length(const char* attribute) const {
  std::size_t length = 0;
  check(nc_inq_attlen(file_.id(), variable_, attribute, &length));
  return length;
}

std::string NetcdfAttributes::text(const char* attribute) const {
  const auto all = texts(attribute);
  if (all.size() > 1 || (all.size() == 1 && all.front().size() > longest_attribute))
    refuse(fmt::format("its attribute {} is not a word", attribute));
  return all.empty() ? "" : all.front();
}

std::vector<std::string> NetcdfAttributes::texts(const char* attribute) const {
  const nc_type stored = type(attribute);
  if (stored == NC_NAT) return {};
  const std::size_t size = length(attribute);
  if ((stored != NC_CHAR && stored != NC_STRING) || size > longest_text)
    refuse(fmt::format("its attribute {} is not a word", attribute));
  if (stored == NC_CHAR) {
    std::string text(size, '\0');
    check(nc_get_att_text(file_.id(), variable_, attribute, text.data()));
    return {text.substr(0, text.find('\0'))};
  }
  std::vector<char*> raw(size);
  if (size > 0) check(nc_get_att_string(file_.id(), variable_, attribute, raw.data()));
  std::vector<std::string> all;
  for (const char* text : raw) all.emplace_back(text == nullptr ? "" : text);
  if (size > 0) nc_free_string(size, raw.data());
  return all;
}

std::vector<double> NetcdfAttributes::numbers(const char* attribute) const {
  const nc_type stored = type(attribute);
  if (stored == NC_NAT) return {};
  const std::size_t size = length(attribute);
  if (size == 0 || size > longest_attribute || !holds_numbers(stored))
    refuse(fmt::format("its attribute {} is not a number", attribute));
  std::vector<double> values(size);
  check(nc_get_att_double(file_.id(), variable_, attribute, values.data()));
  return values;
}

std::optional<double> NetcdfAttributes::number(const char* attribute) const {
  const auto values = numbers(attribute);
  if (values.size() > 1) refuse(fmt::format("its attribute {} is not a number", attribute));
  return values.empty() ? std::nullopt : std::optional(values.front());
}

void NetcdfAttributes::check(int status) const {
  if (status != NC_NOERR) refuse(fmt::format("cannot be read: {}", nc_strerror(status)));
}

void NetcdfAttributes::refuse(const std::string& reason) const {
  file_.refuse(fmt::format("{}: {}", name_, reason));
}

bool holds_numbers(nc_type type) { return type >= NC_BYTE && type <= NC_UINT64 && type != NC_CHAR; }

}  // namespace photic::io
