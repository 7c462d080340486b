// Files of other programs, made by tests.
#pragma once

#include <gtest/gtest.h>
#include <netcdf.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace photic::test {

inline void must(int status) {
  if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
}

/// A file in the way of a BGC-Argo float's, of any of netCDF's formats.
class FloatFile {
 public:
  FloatFile(const std::string& path, int format) {
    must(nc_create(path.c_str(), NC_CLOBBER | format, &id_));
    must(nc_def_dim(id_, "N_PROF", 2, &dimensions_[0]));
    must(nc_def_dim(id_, "N_LEVELS", 3, &dimensions_[1]));
  }
  FloatFile(const FloatFile&) = delete;
  FloatFile& operator=(const FloatFile&) = delete;
  ~FloatFile() { nc_close(id_); }

  int define(const char* name, nc_type type, int rank = 2) {
    int variable = 0;
    must(nc_def_var(id_, name, type, rank, dimensions_, &variable));
    return variable;
  }
  void attribute(int variable, const char* name, nc_type type, double value) {
    must(nc_put_att_double(id_, variable, name, type, 1, &value));
  }
  void text(int variable, const char* name, const std::string& value) {
    must(nc_put_att_text(id_, variable, name, value.size(), value.c_str()));
  }
  void put(int variable, const std::vector<double>& values) {
    nc_enddef(id_);  // of no use, and an error, in netCDF-4
    must(nc_put_var_double(id_, variable, values.data()));
  }
  [[nodiscard]] int id() const { return id_; }

 private:
  int id_ = -1, dimensions_[2] = {};
};

inline std::string refusal_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

inline const double missing = std::numeric_limits<double>::quiet_NaN();

inline void expect_values(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    if (std::isnan(expected[i]))
      EXPECT_TRUE(std::isnan(found[i])) << i << ": " << found[i];
    else
      EXPECT_NEAR(found[i], expected[i], 1e-6 * std::fabs(expected[i])) << i;
}

}  // namespace photic::test
