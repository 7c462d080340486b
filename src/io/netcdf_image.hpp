// A netCDF-4 file made in memory. The disk then gets finished bytes (io/atomic_file.hpp), so that a
// full disk is reported as a full disk and not as the netCDF library's "HDF error".
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "io/dataset.hpp"
#include "io/netcdf_lock.hpp"

namespace photic::io {

/// Blocks of zeros are written to the file, or left out of it and read as the fill value, 0. The
/// latter takes next to no time, and is for values that no other program reads.
enum class Zeros { written, left_out };

class NetcdfImage : public Dataset {
 public:
  NetcdfImage();
  ~NetcdfImage() override;

  /// Whatever is added afterwards goes into this group; it may use the dimensions added before.
  void enter_group(const std::string& name);
  void add_dimension(const std::string& name, std::size_t size) override;
  void add_global(const std::string& name, const AttributeValue& value) override;
  /// Compressed where the variable has more than one dimension.
  void add_variable(const std::string& name, const std::vector<std::string>& dimensions,
                    Values values, const Attributes& attributes) override {
    add_variable(name, dimensions, values, attributes, Zeros::written);
  }
  void add_variable(const std::string& name, const std::vector<std::string>& dimensions,
                    Values values, const Attributes& attributes, Zeros zeros);
  /// The finished file; nothing can be added afterwards.
  [[nodiscard]] std::string finish();

 private:
  void put_attribute(int variable, const std::string& name, const AttributeValue& value);

  NetcdfLock lock_;
  int file_ = -1, group_ = -1;
  std::map<std::string, std::pair<int, std::size_t>> dimensions_;  ///< name: id, size
};

}  // namespace photic::io
