#include "io/netcdf_packing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace photic::io {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr double no_bound = std::numeric_limits<double>::infinity();

bool is_floating(nc_type type) { return type == NC_FLOAT || type == NC_DOUBLE; }

/// The values that netCDF puts where nothing was written. Bytes have none: all their values are in
/// use.
std::optional<double> default_fill(nc_type type) {
  switch (type) {
    case NC_FLOAT:
      return static_cast<double>(NC_FILL_FLOAT);
    case NC_DOUBLE:
      return NC_FILL_DOUBLE;
    case NC_SHORT:
      return NC_FILL_SHORT;
    case NC_USHORT:
      return NC_FILL_USHORT;
    case NC_INT:
      return NC_FILL_INT;
    case NC_UINT:
      return NC_FILL_UINT;
    case NC_INT64:
      return static_cast<double>(NC_FILL_INT64);
    case NC_UINT64:
      return static_cast<double>(NC_FILL_UINT64);
    default:
      return std::nullopt;
  }
}

}  // namespace

Packing::Packing(const NetcdfAttributes& attributes, nc_type type)
    : type_(type),
      unsigned_(attributes.type("_Unsigned") != NC_NAT && attributes.text("_Unsigned") == "true"),
      scale_(attributes.number("scale_factor").value_or(1)),
      offset_(attributes.number("add_offset").value_or(0)),
      low_(-no_bound),
      high_(no_bound) {
  if (scale_ == 0) attributes.refuse("its attribute scale_factor is 0");
  if (const auto fill = attributes.number("_FillValue"))
    missing_.push_back(as_stored(*fill));
  else if (const auto usual = default_fill(type))
    missing_.push_back(as_unsigned(*usual));
  for (const double x : attributes.numbers("missing_value")) missing_.push_back(as_stored(x));
  read_range(attributes);
}

/// Bounds of another type than whole numbers' own are in units of what they stand for, says the
/// Users Guide; CF has them of the same type, and packed.
void Packing::read_range(const NetcdfAttributes& attributes) {
  for (const char* attribute : {"valid_min", "valid_max", "valid_range"})
    if (is_floating(attributes.type(attribute)) && !is_floating(type_)) bounds_unpacked_ = true;
  narrow(attributes.number("valid_min"), attributes.number("valid_max"));
  const auto range = attributes.numbers("valid_range");
  if (range.size() == 2)
    narrow(range[0], range[1]);
  else if (!range.empty())
    attributes.refuse("its attribute valid_range is not two numbers");
}

void Packing::narrow(const std::optional<double>& low, const std::optional<double>& high) {
  const auto bound = [&](double x) { return bounds_unpacked_ ? x : as_stored(x); };
  if (low) low_ = std::max(low_, bound(*low));
  if (high) high_ = std::min(high_, bound(*high));
}

/// 0.1 in an attribute of doubles is the 0.1 of floats.
double Packing::as_stored(double x) const {
  const bool narrower = type_ == NC_FLOAT && std::fabs(x) <= std::numeric_limits<float>::max();
  return as_unsigned(narrower ? static_cast<double>(static_cast<float>(x)) : x);
}

double Packing::as_unsigned(double x) const { return unsigned_ && x < 0 ? x + span_of(type_) : x; }

bool Packing::is_missing(double stored) const {
  return std::find(missing_.begin(), missing_.end(), as_unsigned(stored)) != missing_.end();
}

double Packing::value_of(double stored) const { return as_unsigned(stored) * scale_ + offset_; }

double Packing::unpacked(double stored) const {
  if (is_missing(stored)) return no_value;
  const double value = value_of(stored);
  const double bounded = bounds_unpacked_ ? value : as_unsigned(stored);
  return bounded >= low_ && bounded <= high_ ? value : no_value;
}

double span_of(nc_type type) {
  switch (type) {
    case NC_BYTE:
      return 0x1p8;
    case NC_SHORT:
      return 0x1p16;
    case NC_INT:
      return 0x1p32;
    default:
      return 0;
  }
}

}  // namespace photic::io
