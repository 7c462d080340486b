// One variable of other programs' netCDF files as it is stored; nothing in the file is believed.
#pragma once

#include <netcdf.h>

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "io/netcdf_attributes.hpp"
#include "io/netcdf_reader.hpp"

namespace photic::io {

/// The question that the NetcdfReader of such files asks.
inline constexpr const char* what_is_wanted = "is it the file you mean?";

/// The name that a function of the library writes to a buffer; "" if it fails. Classic files may
/// have longer names than the library allows, which it writes none the less.
[[nodiscard]] std::string name_by(const NetcdfReader& file,
                                  const std::function<int(char*)>& inquire);

/// The names of the variables outside all groups.
[[nodiscard]] std::vector<std::string> variable_names(const NetcdfReader& file);

/// The dimensions that any variable has which holds no characters. A variable of characters whose
/// last dimension is none of these holds texts, of that many characters each.
[[nodiscard]] std::set<int> dimensions_of_values(const NetcdfReader& file);

class NetcdfValues {
 public:
  /// `of_values` is dimensions_of_values(file). Throws InputError if there is no such variable.
  NetcdfValues(const NetcdfReader& file, const std::string& name, const std::set<int>& of_values);

  [[nodiscard]] const NetcdfAttributes& attributes() const { return attributes_; }
  [[nodiscard]] nc_type type() const { return type_; }

  // The names of the dimensions, but for that of the characters of texts.
  [[nodiscard]] const std::vector<std::string>& dimension() const { return dimension_; }
  [[nodiscard]] const std::vector<std::size_t>& length() const { return length_; }

  // Throw InputError if it holds nothing of that kind, or more than a table has.
  [[nodiscard]] std::vector<double> numbers() const;
  [[nodiscard]] std::vector<std::string> texts() const;

  void check(int status) const { attributes_.check(status); }

 private:
  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] std::vector<std::string> characters() const;
  [[nodiscard]] std::vector<std::string> strings() const;

  const NetcdfReader& file_;
  int id_ = -1;
  NetcdfAttributes attributes_;
  nc_type type_ = NC_NAT;
  std::vector<std::string> dimension_;
  std::vector<std::size_t> length_;
  std::size_t characters_ = 1;  ///< of each text
};

}  // namespace photic::io
