#include "scene/iop_grid.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

#include "core/error.hpp"
#include "optics/data_table.hpp"
#include "optics/table_text.hpp"
#include "scene/cut.hpp"
#include "scene/netcdf_columns.hpp"
#include "scene/netcdf_units.hpp"
#include "scene/suggest.hpp"
#include "scene/units.hpp"

namespace photic::scene {
namespace {

constexpr const char* depth_name = "depth_m";
constexpr const char* wavelength_name = "wavelength_nm";
constexpr const char* order = "sort rows by depth, and those of a depth by wavelength";
/// Pairs of a depth and a wavelength: every one of them becomes a line of the effective scene.
constexpr std::size_t max_pairs = 100'000;

bool is_among(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The names in a file that are known here, and the suggestion where one is missing.
struct Contents {
  std::vector<std::string> known;
  std::function<std::string(const std::string& name)> instead_of;
  Place place;
  std::string first = {};  ///< text before all problems
};

/// The names of the values in a file.
std::vector<std::string> value_names(const Contents& file) {
  const auto fail = [&](const std::string& reason, const char* name) {
    throw InputError({{file.place.file, file.place.line, file.place.column, file.first + reason,
                       file.instead_of(name)}});
  };
  for (const char* name : {depth_name, wavelength_name, "a_per_m"})
    if (!is_among(file.known, name)) fail(fmt::format("no \"{}\"", name), name);
  const bool has_b = is_among(file.known, "b_per_m"), has_c = is_among(file.known, "c_per_m");
  if (!has_b && !has_c) fail(R"(neither "b_per_m" nor "c_per_m")", "b_per_m");
  std::vector<std::string> names{"a_per_m", has_b ? "b_per_m" : "c_per_m"};
  for (const char* optional : {"bb_per_m", "a_phytoplankton_per_m", "a_cdom_per_m"})
    if (is_among(file.known, optional)) names.emplace_back(optional);
  return names;
}

/// "did you mean …?" with one of the names in a file, or else the list of them. A name that is
/// known here is not suggested in place of another.
std::string hint(const std::string& name, const std::vector<std::string>& there,
                 const IopNames& names, const std::string& what_there_is) {
  std::vector<std::string> strange;
  std::copy_if(there.begin(), there.end(), std::back_inserter(strange), [&](const std::string& n) {
    return std::ranges::find(names, n, &IopNames::value_type::first) == names.end();
  });
  const std::string close = suggestion_for(name, strange, "");
  return close.starts_with("did you mean") ? close : what_there_is;
}

std::string size_refusal(std::size_t depths, std::size_t wavelengths) {
  if (depths <= max_cuts && wavelengths <= max_pairs / std::max<std::size_t>(depths, 1)) return "";
  return fmt::format("{} depths with {} wavelengths are too many: at most {} depths, and {} pairs",
                     depths, wavelengths, max_cuts, max_pairs);
}

// --- Text ----------------------------------------------------------------------------------------

/// Takes the rows of a table one by one, and learns its depths and wavelengths.
class RowReader {
 public:
  RowReader(const optics::DataTable& table, IopGrid& grid) : table_(table), grid_(grid) {}

  void add(std::size_t row, double depth, double wavelength) {
    if (row == 0 && depth != 0)
      fail(row, depth_name, fmt::format("the first depth is {:g} m, not 0", depth), "");
    if (row > 0 && depth < grid_.depth_m.back())
      fail(row, depth_name, fmt::format("{:g} m comes after {:g} m", depth, grid_.depth_m.back()),
           order);
    if (row == 0 || depth > grid_.depth_m.back()) {
      if (row > 0) finish(row);
      grid_.depth_m.push_back(depth);
      at_depth_ = 0;
    }
    if (at_depth_ > 0 && !(wavelength > last_))
      fail(row, wavelength_name,
           wavelength == last_ ? fmt::format("{:g} nm appears twice at {:g} m", wavelength, depth)
                               : fmt::format("{:g} nm comes after {:g} nm", wavelength, last_),
           order);
    if (grid_.depth_m.size() == 1)
      grid_.wavelength_nm.push_back(wavelength);
    else
      expect_known(row, depth, wavelength);
    last_ = wavelength;
    ++at_depth_;
  }

  /// Before this row there must be no wavelength left.
  void finish(std::size_t row) const {
    if (at_depth_ < grid_.wavelength_nm.size()) missing(std::min(row, table_.rows() - 1));
  }

 private:
  void expect_known(std::size_t row, double depth, double wavelength) const {
    const auto& known = grid_.wavelength_nm;
    if (at_depth_ < known.size() && wavelength == known[at_depth_]) return;
    if (at_depth_ < known.size() && wavelength > known[at_depth_]) missing(row);
    fail(row, wavelength_name,
         fmt::format("{:g} nm at {:g} m, and not at {:g} m", wavelength, depth, grid_.depth_m[0]),
         "all depths have the same wavelengths");
  }

  [[noreturn]] void missing(std::size_t row) const {
    fail(row, wavelength_name,
         fmt::format("the row of {:g} m and {:g} nm is missing", grid_.depth_m.back(),
                     grid_.wavelength_nm[at_depth_]),
         "all depths have the same wavelengths");
  }

  [[noreturn]] void fail(std::size_t row, const char* column, const std::string& reason,
                         const std::string& suggestion) const {
    table_.fail(row, column, reason, suggestion);
  }

  const optics::DataTable& table_;
  IopGrid& grid_;
  std::size_t at_depth_ = 0;  ///< rows read of the last depth
  double last_ = 0;           ///< wavelength
};

IopGrid grid_of_text(const std::string& path, const IopNames& names_in_file) {
  const auto file = optics::DataTable::read(path);
  const auto table = file.with(names_in_file);
  Contents contents{table.columns(), {}, {path, table.column_line(), 1}};
  contents.instead_of = [&](const std::string& name) {
    return file.may_be_quoted() ? hint(name, file.columns(), names_in_file, file.what_there_is())
                                : file.what_there_is();
  };
  if (!file.may_be_quoted()) contents.first = fmt::format("{}: ", optics::no_numbers);
  const auto names = value_names(contents);
  for (const std::string& column : table.columns()) refuse_other_units(table, column, column);
  const auto depth = table.numbers(depth_name);
  const auto wavelength = table.numbers(wavelength_name);
  IopGrid grid;
  RowReader rows(table, grid);
  for (std::size_t row = 0; row < table.rows(); ++row) rows.add(row, depth[row], wavelength[row]);
  rows.finish(table.rows());
  const auto too_many = size_refusal(grid.depth_m.size(), grid.wavelength_nm.size());
  if (!too_many.empty()) table.fail(0, depth_name, too_many);
  for (const std::string& name : names) grid.value[name] = table.numbers(name);
  grid.place = [table](const std::string& name, std::size_t i) {
    const auto [line, column] = table.place(i, name);
    return Place{table.name(), line, column};
  };
  return grid;
}

// --- netCDF --------------------------------------------------------------------------------------

/// A netCDF file whose variables have names of their own.
class NamedVariables {
 public:
  NamedVariables(const std::string& path, const IopNames& names, const NetcdfFiles& netcdf)
      : file_(path, netcdf) {
    for (const auto& [name, in_file] : names) {
      if (in_file.number > 0)
        file_.fail("", fmt::format("{} is named by a number", name),
                   "variables of netCDF files are called by their names");
      if (in_file.given() || file_.has(name)) called_[name] = in_file.given() ? in_file.name : name;
    }
  }

  [[nodiscard]] const NetcdfColumns& file() const { return file_; }
  [[nodiscard]] const std::map<std::string, std::string>& called() const { return called_; }
  [[nodiscard]] const std::string& called(const std::string& name) const {
    return called_.at(name);
  }
  [[nodiscard]] std::vector<std::string> known() const {
    std::vector<std::string> names;
    for (const auto& [name, in_file] : called_) names.push_back(name);
    return names;
  }

  /// In the unit that the name ends in; unchanged where the variable has no unit.
  [[nodiscard]] NetcdfVariable read(const std::string& name) const {
    const std::string& in_file = called(name);
    NetcdfVariable variable = file_.read(in_file);
    if (!variable.units.empty()) {
      const Conversion convert = conversion_of(file_, in_file, variable, name);
      for (double& x : variable.value) x = convert(x);
    }
    if (name == depth_name && points_up(file_, in_file, variable))
      for (double& x : variable.value) x = 0 - x;
    return variable;
  }

  /// A coordinate: of one dimension, ascending.
  [[nodiscard]] NetcdfVariable coordinate(const std::string& name) const {
    NetcdfVariable variable = read(name);
    if (variable.length.size() != 1 || variable.value.empty())
      file_.fail(shape_text(called(name), variable), "is not of one dimension with values");
    const auto& value = variable.value;
    for (std::size_t i = 0; i < value.size(); ++i) {
      const std::string at = fmt::format("{}[{}]", called(name), i);
      if (!std::isfinite(value[i])) file_.fail(at, "must be a finite number, not missing");
      if (i > 0 && !(value[i] > value[i - 1]))
        file_.fail(at, fmt::format("{:g} does not come after {:g}", value[i], value[i - 1]),
                   "values ascend, each once");
    }
    return variable;
  }

 private:
  NetcdfColumns file_;
  std::map<std::string, std::string> called_;
};

IopGrid grid_of_netcdf(const std::string& path, const IopNames& names_in_file,
                       const NetcdfFiles& netcdf) {
  const NamedVariables variables(path, names_in_file, netcdf);
  const NetcdfColumns& file = variables.file();
  const auto names =
      value_names({variables.known(),
                   [&](const std::string& name) {
                     return hint(name, file.names(), names_in_file,
                                 fmt::format("there are: {}", fmt::join(file.names(), ", ")));
                   },
                   {path, 0, 0}});
  const NetcdfVariable depth = variables.coordinate(depth_name);
  const NetcdfVariable wavelength = variables.coordinate(wavelength_name);
  if (depth.value.front() != 0)
    file.fail(variables.called(depth_name) + "[0]",
              fmt::format("the first depth is {:g} m, not 0", depth.value.front()));
  const auto too_many = size_refusal(depth.value.size(), wavelength.value.size());
  if (!too_many.empty()) file.fail("", too_many);
  IopGrid grid{depth.value, wavelength.value, {}, {}};
  const std::vector<std::string> dimensions{depth.dimension[0], wavelength.dimension[0]};
  for (const std::string& name : names) {
    NetcdfVariable variable = variables.read(name);
    if (variable.dimension != dimensions)
      file.fail(shape_text(variables.called(name), variable),
                fmt::format("its dimensions must be ({}, {})", dimensions[0], dimensions[1]));
    grid.value[name] = std::move(variable.value);
  }
  grid.place = [path, called = variables.called(), per_depth = wavelength.value.size()](
                   const std::string& name, std::size_t i) {
    const std::size_t d = i / per_depth, w = i % per_depth;
    const std::string index = name == depth_name        ? fmt::format("{}", d)
                              : name == wavelength_name ? fmt::format("{}", w)
                                                        : fmt::format("{}, {}", d, w);
    return Place{fmt::format("{}: {}[{}]", path, called.at(name), index), 0, 0};
  };
  return grid;
}

}  // namespace

IopGrid read_iop_grid(const std::string& path, const IopNames& names, const NetcdfFiles& netcdf) {
  const bool is_netcdf = std::filesystem::path(path).extension() == ".nc";
  return is_netcdf ? grid_of_netcdf(path, names, netcdf) : grid_of_text(path, names);
}

}  // namespace photic::scene
