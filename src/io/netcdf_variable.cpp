#include "io/netcdf_variable.hpp"

#include <fmt/format.h>
#include <netcdf.h>

#include <cmath>
#include <limits>
#include <optional>

#include "core/error.hpp"
#include "io/netcdf_reader.hpp"

namespace photic::io {
namespace {

constexpr const char* what_is_wanted = "is it the file you mean?";
/// 80 MB of doubles. A file of a few bytes may claim to hold any number of them.
constexpr std::size_t most_values = 10'000'000;

/// One variable of an open file; nothing in the file is believed.
class Variable {
 public:
  Variable(const NetcdfReader& file, std::string name) : file_(file), name_(std::move(name)) {
    check(nc_inq_varid(file_.id(), name_.c_str(), &id_));
  }

  [[nodiscard]] scene::NetcdfVariable flags() const {
    if (type() != NC_CHAR) return read();
    scene::NetcdfVariable out;
    read_shape(out);
    std::string text(count(out), ' ');
    if (!text.empty()) check(nc_get_var_text(file_.id(), id_, text.data()));
    for (const char c : text)
      out.value.push_back(c >= '0' && c <= '9' ? c - '0'
                                               : std::numeric_limits<double>::quiet_NaN());
    return out;
  }

  [[nodiscard]] scene::NetcdfVariable read() const {
    if (type() < NC_BYTE || type() > NC_UINT64 || type() == NC_CHAR)
      refuse("does not hold numbers");
    scene::NetcdfVariable out;
    read_shape(out);
    out.units = units();
    out.value.resize(count(out));
    if (!out.value.empty()) check(nc_get_var_double(file_.id(), id_, out.value.data()));
    const auto fill = attribute("_FillValue"), missing = attribute("missing_value");
    const double scale = attribute("scale_factor").value_or(1);
    const double offset = attribute("add_offset").value_or(0);
    for (double& x : out.value) {
      const bool none = x == fill || x == missing || x == default_fill();
      x = none ? std::numeric_limits<double>::quiet_NaN() : x * scale + offset;
    }
    return out;
  }

 private:
  [[nodiscard]] nc_type type() const {
    nc_type type = NC_NAT;
    check(nc_inq_vartype(file_.id(), id_, &type));
    return type;
  }

  void read_shape(scene::NetcdfVariable& out) const {
    int dimensions = 0;
    check(nc_inq_varndims(file_.id(), id_, &dimensions));
    std::vector<int> ids(static_cast<std::size_t>(dimensions));
    check(nc_inq_vardimid(file_.id(), id_, ids.data()));
    for (const int id : ids) {
      char name[NC_MAX_NAME + 1] = {};
      std::size_t length = 0;
      check(nc_inq_dim(file_.id(), id, name, &length));
      out.dimension.emplace_back(name);
      out.length.push_back(length);
    }
  }

  [[nodiscard]] std::size_t count(const scene::NetcdfVariable& shape) const {
    std::size_t product = 1;
    for (const std::size_t length : shape.length) {
      if (length > 0 && product > most_values / length)
        refuse(fmt::format("has more than {} values", most_values));
      product *= length;
    }
    return product;
  }

  /// The text of an attribute, whichever way it is stored; nothing if there is none.
  [[nodiscard]] std::string units() const {
    nc_type type = NC_NAT;
    std::size_t length = 0;
    if (nc_inq_att(file_.id(), id_, "units", &type, &length) != NC_NOERR) return "";
    if (type == NC_STRING && length == 1) {
      char* raw = nullptr;
      check(nc_get_att_string(file_.id(), id_, "units", &raw));
      std::string text = raw == nullptr ? "" : raw;
      nc_free_string(1, &raw);
      return text;
    }
    constexpr std::size_t longest = 1000;
    if (type != NC_CHAR || length > longest) refuse("its attribute units is not a word");
    std::string text(length, '\0');
    check(nc_get_att_text(file_.id(), id_, "units", text.data()));
    return text.substr(0, text.find('\0'));
  }

  /// A single number; nothing if there is none.
  [[nodiscard]] std::optional<double> attribute(const char* attribute_name) const {
    nc_type type = NC_NAT;
    std::size_t length = 0;
    if (nc_inq_att(file_.id(), id_, attribute_name, &type, &length) != NC_NOERR)
      return std::nullopt;
    if (length != 1 || type < NC_BYTE || type > NC_UINT64 || type == NC_CHAR)
      refuse(fmt::format("its attribute {} is not a number", attribute_name));
    double value = 0;
    check(nc_get_att_double(file_.id(), id_, attribute_name, &value));
    return value;
  }

  /// What netCDF puts where nothing was written. Bytes have none: all their values are in use.
  [[nodiscard]] std::optional<double> default_fill() const {
    switch (type()) {
      case NC_FLOAT:
        return static_cast<double>(NC_FILL_FLOAT);
      case NC_DOUBLE:
        return NC_FILL_DOUBLE;
      case NC_SHORT:
        return NC_FILL_SHORT;
      case NC_INT:
        return NC_FILL_INT;
      default:
        return std::nullopt;
    }
  }

  void check(int status) const {
    if (status != NC_NOERR) refuse(fmt::format("cannot be read: {}", nc_strerror(status)));
  }
  [[noreturn]] void refuse(const std::string& reason) const {
    file_.refuse(fmt::format("{}: {}", name_, reason));
  }

  const NetcdfReader& file_;
  const std::string name_;
  int id_ = -1;
};

}  // namespace

std::vector<std::string> netcdf_names(const std::string& path) {
  const NetcdfReader file(path, what_is_wanted);
  int count = 0;
  if (nc_inq_nvars(file.id(), &count) != NC_NOERR) file.refuse("has no list of variables");
  std::vector<std::string> names;
  for (int id = 0; id < count; ++id) {
    char name[NC_MAX_NAME + 1] = {};
    if (nc_inq_varname(file.id(), id, name) != NC_NOERR) file.refuse("has a variable without name");
    names.emplace_back(name);
  }
  return names;
}

scene::NetcdfVariable netcdf_variable(const std::string& path, const std::string& name) {
  const NetcdfReader file(path, what_is_wanted);
  return Variable(file, name).read();
}

scene::NetcdfVariable netcdf_flags(const std::string& path, const std::string& name) {
  const NetcdfReader file(path, what_is_wanted);
  return Variable(file, name).flags();
}

scene::NetcdfFiles netcdf_files() { return {netcdf_names, netcdf_variable, netcdf_flags}; }

}  // namespace photic::io
