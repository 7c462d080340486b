// A result as named arrays with attributes, after CF-1.10
// (https://cfconventions.org/Data/cf-conventions/cf-conventions-1.10/). It is described once
// (io/describe.hpp), for whatever carries it: a file, or arrays in memory.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace photic::io {

/// A text of any length, stored as NC_STRING: netCDF-4 cannot hold an attribute of characters above
/// 64 kB.
struct LongText {
  std::string text;
};

using AttributeValue =
    std::variant<std::string, LongText, double, float, std::int32_t, std::uint64_t,
                 std::vector<std::int32_t>, std::vector<std::int8_t>>;
using Attributes = std::vector<std::pair<std::string, AttributeValue>>;
using Values = std::variant<std::span<const double>, std::span<const float>,
                            std::span<const std::int32_t>, std::span<const std::int8_t>,
                            std::span<const std::uint64_t>, std::span<const std::string>>;

/// The number that stands where a dataset has none.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Takes dimensions, variables and global attributes in their order. A variable's dimensions have
/// been added before it. It copies what it keeps.
class Dataset {
 public:
  Dataset() = default;
  Dataset(const Dataset&) = delete;
  Dataset& operator=(const Dataset&) = delete;
  virtual ~Dataset() = default;

  /// `size`: at least 1.
  virtual void add_dimension(const std::string& name, std::size_t size) = 0;
  virtual void add_global(const std::string& name, const AttributeValue& value) = 0;
  /// Values with the last dimension fastest, as many as the dimensions ask for.
  virtual void add_variable(const std::string& name, const std::vector<std::string>& dimensions,
                            Values values, const Attributes& attributes) = 0;
};

}  // namespace photic::io
