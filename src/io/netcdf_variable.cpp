#include "io/netcdf_variable.hpp"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include "io/netcdf_attributes.hpp"
#include "io/netcdf_packing.hpp"
#include "io/netcdf_reader.hpp"

namespace photic::io {
namespace {

using namespace std::string_literals;

constexpr const char* what_is_wanted = "is it the file you mean?";
/// 80 MB of doubles. A file of a few bytes may claim to hold any number of them.
constexpr std::size_t most_values = 10'000'000;

int variable_called(const NetcdfReader& file, const std::string& name) {
  int id = -1;
  const int status = nc_inq_varid(file.id(), name.c_str(), &id);
  if (status != NC_NOERR)
    file.refuse(fmt::format("{}: cannot be read: {}", name, nc_strerror(status)));
  return id;
}

constexpr double no_flag = std::numeric_limits<double>::quiet_NaN();

double digit(char c) { return c >= '0' && c <= '9' ? c - '0' : no_flag; }

/// One variable of an open file; nothing in the file is believed.
class Variable {
 public:
  Variable(const NetcdfReader& file, const std::string& name)
      : file_(file), id_(variable_called(file, name)), attributes_(file, id_, name) {}

  [[nodiscard]] scene::NetcdfVariable flags(std::size_t rank) const {
    if (attributes_.type("flag_masks") != NC_NAT)
      attributes_.refuse("its flags are single bits (flag_masks), which are not understood");
    scene::NetcdfVariable out = holds_numbers(type()) ? read() : digits(rank);
    out.meaning = meanings();
    return out;
  }

  [[nodiscard]] scene::NetcdfVariable read() const {
    if (!holds_numbers(type())) attributes_.refuse("does not hold numbers");
    scene::NetcdfVariable out;
    read_shape(out);
    out.units = attributes_.text("units");
    out.standard_name = attributes_.text("standard_name");
    out.positive = attributes_.text("positive");
    out.value.resize(count(out));
    if (!out.value.empty()) check(nc_get_var_double(file_.id(), id_, out.value.data()));
    const Packing packing(attributes_, type());
    for (double& x : out.value) x = packing.unpacked(x);
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
        attributes_.refuse(fmt::format("has more than {} values", most_values));
      product *= length;
    }
    return product;
  }

  /// Flags that are characters or texts.
  [[nodiscard]] scene::NetcdfVariable digits(std::size_t rank) const {
    if (type() != NC_CHAR && type() != NC_STRING)
      attributes_.refuse("does not hold numbers or texts");
    scene::NetcdfVariable out;
    read_shape(out);
    const std::size_t size = count(out);
    std::size_t of_text = 1;  // characters of one flag
    if (type() == NC_CHAR && out.length.size() == rank + 1) {
      of_text = std::max<std::size_t>(out.length.back(), 1);
      out.length.pop_back();
      out.dimension.pop_back();
    }
    for (const std::string& text : type() == NC_CHAR ? characters(size, of_text) : texts(size))
      out.value.push_back(flag_in(text));
    return out;
  }

  [[nodiscard]] std::vector<std::string> characters(std::size_t size, std::size_t of_text) const {
    std::string all(size, ' ');
    if (size > 0) check(nc_get_var_text(file_.id(), id_, all.data()));
    std::vector<std::string> out;
    for (std::size_t i = 0; i < size; i += of_text) out.push_back(all.substr(i, of_text));
    return out;
  }

  [[nodiscard]] std::vector<std::string> texts(std::size_t size) const {
    std::vector<char*> raw(size);
    if (size > 0) check(nc_get_var_string(file_.id(), id_, raw.data()));
    std::vector<std::string> out;
    for (const char* text : raw) out.emplace_back(text ? text : "");
    if (size > 0) nc_free_string(size, raw.data());
    return out;
  }

  /// "4", or "4.0" and "nan" as programs write what were numbers.
  [[nodiscard]] double flag_in(const std::string& text) const {
    const auto first = text.find_first_not_of(" \0"s);
    if (first == std::string::npos) return no_flag;
    const std::string word = text.substr(first, text.find_last_not_of(" \0"s) + 1 - first);
    if (word.size() == 1) return digit(word[0]);
    double value = 0;
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc{} || stop != end)
      attributes_.refuse(fmt::format("\"{}\" is no flag", word));
    return value;
  }

  [[nodiscard]] std::map<double, std::string> meanings() const {
    const std::vector<double> values = flag_values();
    std::istringstream words(attributes_.text("flag_meanings"));
    std::map<double, std::string> out;
    std::size_t i = 0;
    for (std::string word; words >> word; ++i)
      if (i < values.size()) out[values[i]] = word;
    if (i > 0 && i != values.size())
      attributes_.refuse(fmt::format("has {} flag_values and {} flag_meanings", values.size(), i));
    return out;
  }

  /// Of characters they are characters, which some files divide by blanks or commas.
  [[nodiscard]] std::vector<double> flag_values() const {
    const nc_type stored = attributes_.type("flag_values");
    if (stored != NC_CHAR && stored != NC_STRING) return attributes_.numbers("flag_values");
    std::vector<double> out;
    for (const char c : attributes_.text("flag_values"))
      if (std::isfinite(digit(c))) out.push_back(digit(c));
    return out;
  }

  void check(int status) const { attributes_.check(status); }

  const NetcdfReader& file_;
  const int id_;
  const NetcdfAttributes attributes_;
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

scene::NetcdfVariable netcdf_flags(const std::string& path, const std::string& name,
                                   std::size_t rank) {
  const NetcdfReader file(path, what_is_wanted);
  return Variable(file, name).flags(rank);
}

scene::NetcdfFiles netcdf_files() { return {netcdf_names, netcdf_variable, netcdf_flags}; }

}  // namespace photic::io
