// A netCDF-4 file made in memory. The disk then gets finished bytes (io/atomic_file.hpp), so that a
// full disk is reported as a full disk and not as the netCDF library's "HDF error".
#pragma once

#include <cstdint>
#include <limits>
#include <map>
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

/// The number that stands where a file has none.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Blocks of zeros are written to the file, or left out of it and read as the fill value, 0. The
/// latter takes next to no time, and is for values that no other program reads.
enum class Zeros { written, left_out };

class NetcdfImage {
 public:
  NetcdfImage();
  NetcdfImage(const NetcdfImage&) = delete;
  NetcdfImage& operator=(const NetcdfImage&) = delete;
  ~NetcdfImage();

  /// Whatever is added afterwards goes into this group; it may use the dimensions added before.
  void enter_group(const std::string& name);
  void add_dimension(const std::string& name, std::size_t size);
  void add_global(const std::string& name, const AttributeValue& value);
  /// Values with the last dimension fastest, compressed where the variable has more than one
  /// dimension.
  void add_variable(const std::string& name, const std::vector<std::string>& dimensions,
                    Values values, const Attributes& attributes, Zeros zeros = Zeros::written);
  /// The finished file; nothing can be added afterwards.
  [[nodiscard]] std::string finish();

 private:
  void put_attribute(int variable, const std::string& name, const AttributeValue& value);

  int file_ = -1, group_ = -1;
  std::map<std::string, std::pair<int, std::size_t>> dimensions_;  ///< name: id, size
};

}  // namespace photic::io
