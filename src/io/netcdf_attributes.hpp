// The attributes of one variable of other programs' netCDF files; nothing in the file is believed.
#pragma once

#include <netcdf.h>

#include <optional>
#include <string>
#include <vector>

#include "io/netcdf_reader.hpp"

namespace photic::io {

class NetcdfAttributes {
 public:
  NetcdfAttributes(const NetcdfReader& file, int variable, std::string variable_name);

  /// NC_NAT if there is none.
  [[nodiscard]] nc_type type(const char* attribute) const;
  /// Whichever way it is stored; "" if there is none.
  [[nodiscard]] std::string text(const char* attribute) const;
  /// The texts of an attribute that may be several texts, or long; none if there is no such
  /// attribute.
  [[nodiscard]] std::vector<std::string> texts(const char* attribute) const;
  /// None if there is no such attribute.
  [[nodiscard]] std::vector<double> numbers(const char* attribute) const;
  [[nodiscard]] std::optional<double> number(const char* attribute) const;

  void check(int status) const;
  /// Throws InputError about the variable.
  [[noreturn]] void refuse(const std::string& reason) const;

 private:
  [[nodiscard]] std::size_t length(const char* attribute) const;

  const NetcdfReader& file_;
  const int variable_;
  const std::string name_;
};

/// Returns whether these are numbers, whole or not.
[[nodiscard]] bool holds_numbers(nc_type type);

}  // namespace photic::io
