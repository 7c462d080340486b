// Reading a netCDF file back through the C API, the way another program would.
#pragma once

#include <gtest/gtest.h>
#include <netcdf.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace photic::test {

class NetcdfFile {
 public:
  explicit NetcdfFile(const std::string& path) {
    check(nc_open(path.c_str(), NC_NOWRITE, &id_), path);
  }
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;
  ~NetcdfFile() { nc_close(id_); }

  [[nodiscard]] int id() const { return id_; }

  [[nodiscard]] int variable(const std::string& name) const {
    int id = 0;
    check(nc_inq_varid(id_, name.c_str(), &id), name);
    return id;
  }
  [[nodiscard]] bool has_variable(const std::string& name) const {
    int id = 0;
    return nc_inq_varid(id_, name.c_str(), &id) == NC_NOERR;
  }
  [[nodiscard]] std::vector<std::string> variables() const {
    int count = 0;
    check(nc_inq_nvars(id_, &count), "variables");
    std::vector<std::string> names;
    for (int v = 0; v < count; ++v) {
      char name[NC_MAX_NAME + 1] = {};
      check(nc_inq_varname(id_, v, name), "name");
      names.emplace_back(name);
    }
    return names;
  }
  [[nodiscard]] std::vector<std::string> dimensions(int variable) const {
    int count = 0;
    check(nc_inq_varndims(id_, variable, &count), "dimensions");
    std::vector<int> ids(static_cast<std::size_t>(count));
    check(nc_inq_vardimid(id_, variable, ids.data()), "dimensions");
    std::vector<std::string> names;
    for (const int dimension : ids) {
      char name[NC_MAX_NAME + 1] = {};
      check(nc_inq_dimname(id_, dimension, name), "dimension");
      names.emplace_back(name);
    }
    return names;
  }
  [[nodiscard]] std::size_t size(const std::string& dimension) const {
    int id = 0;
    std::size_t length = 0;
    check(nc_inq_dimid(id_, dimension.c_str(), &id), dimension);
    check(nc_inq_dimlen(id_, id, &length), dimension);
    return length;
  }
  [[nodiscard]] nc_type type(int variable) const {
    nc_type type = NC_NAT;
    check(nc_inq_vartype(id_, variable, &type), "type");
    return type;
  }
  [[nodiscard]] std::vector<double> numbers(const std::string& name) const {
    const int v = variable(name);
    std::vector<double> values(count(v));
    check(nc_get_var_double(id_, v, values.data()), name);
    return values;
  }
  [[nodiscard]] std::vector<std::string> texts(const std::string& name) const {
    const int v = variable(name);
    std::vector<char*> raw(count(v));
    check(nc_get_var_string(id_, v, raw.data()), name);
    std::vector<std::string> values(raw.begin(), raw.end());
    nc_free_string(raw.size(), raw.data());
    return values;
  }

  [[nodiscard]] bool has_attribute(int variable, const std::string& name) const {
    return nc_inq_attid(id_, variable, name.c_str(), nullptr) == NC_NOERR;
  }
  [[nodiscard]] nc_type attribute_type(int variable, const std::string& name) const {
    nc_type type = NC_NAT;
    check(nc_inq_atttype(id_, variable, name.c_str(), &type), name);
    return type;
  }
  template <class Number>
  [[nodiscard]] std::vector<Number> attribute(int variable, const std::string& name) const {
    std::size_t length = 0;
    check(nc_inq_attlen(id_, variable, name.c_str(), &length), name);
    std::vector<Number> values(length);
    check(nc_get_att(id_, variable, name.c_str(), values.data()), name);
    return values;
  }
  /// Whether stored as characters or as one string.
  [[nodiscard]] std::string text(int variable, const std::string& name) const {
    if (attribute_type(variable, name) == NC_CHAR) {
      const auto characters = attribute<char>(variable, name);
      return {characters.begin(), characters.end()};
    }
    char* raw = nullptr;
    check(nc_get_att_string(id_, variable, name.c_str(), &raw), name);
    std::string value = raw;
    nc_free_string(1, &raw);
    return value;
  }
  [[nodiscard]] std::string text(const std::string& name) const { return text(NC_GLOBAL, name); }

 private:
  static void check(int status, const std::string& what) {
    if (status != NC_NOERR) throw std::runtime_error(what + ": " + nc_strerror(status));
  }
  [[nodiscard]] std::size_t count(int variable) const {
    std::size_t product = 1;
    for (const auto& dimension : dimensions(variable)) product *= size(dimension);
    return product;
  }

  int id_ = -1;
};

/// Equal to the last bit, NaN included.
inline void expect_same(std::span<const double> file, std::span<const double> result) {
  ASSERT_EQ(file.size(), result.size());
  for (std::size_t i = 0; i < file.size(); ++i) {
    if (std::isnan(result[i]))
      EXPECT_TRUE(std::isnan(file[i])) << "at " << i;
    else
      EXPECT_EQ(file[i], result[i]) << "at " << i;
  }
}

}  // namespace photic::test
