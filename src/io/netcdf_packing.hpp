// The meaning of the stored numbers of a netCDF variable (CF-1.10, sections 2.5.1 and 8.1; NetCDF
// Users Guide, attribute conventions).
#pragma once

#include <optional>
#include <vector>

#include "io/netcdf_attributes.hpp"

namespace photic::io {

class Packing {
 public:
  Packing(const NetcdfAttributes& attributes, nc_type type);

  /// NaN for what is missing.
  [[nodiscard]] double unpacked(double stored) const;

  // The same in parts, for what has no range.
  [[nodiscard]] bool is_missing(double stored) const;
  [[nodiscard]] double value_of(double stored) const;

  /// A number in an attribute as it is where it stands among the stored ones.
  [[nodiscard]] double as_stored(double x) const;

 private:
  [[nodiscard]] double as_unsigned(double x) const;
  void read_range(const NetcdfAttributes& attributes);
  void narrow(const std::optional<double>& low, const std::optional<double>& high);

  const nc_type type_;
  bool unsigned_ = false;
  std::vector<double> missing_;
  double scale_ = 1, offset_ = 0;
  double low_, high_;
  /// True if these bound the unpacked numbers: numbers that are not whole say nothing of whole
  /// ones.
  bool bounds_unpacked_ = false;
};

/// 2 to the number of bits of whole numbers that have a sign, up to 32; 0 of all others.
[[nodiscard]] double span_of(nc_type type);

}  // namespace photic::io
