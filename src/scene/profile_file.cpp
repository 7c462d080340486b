#include "scene/profile_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "optics/data_table.hpp"
#include "optics/pressure.hpp"
#include "scene/measured.hpp"
#include "scene/netcdf_instead.hpp"
#include "scene/netcdf_latitude.hpp"
#include "scene/netcdf_units.hpp"
#include "scene/units.hpp"

namespace photic::scene {
namespace {

constexpr double latitude_by_default_deg = 45;
constexpr Unit metre{0, 0, 1, 0}, decibar{4, 0, 0, 1};

/// The profile of levels that are all there is.
LinearProfile profile_of(Measured& measured, const ProfileFile& from, const ProfiledKey& key,
                         const RefuseLevel& refuse, std::vector<std::string>& remarks) {
  if (!from.negative.empty()) zero_negatives(measured, remarks);
  check_values(measured, key.rule, refuse);
  const std::size_t first = measured.level.front();
  put_in_order(measured, remarks);
  if (measured.depth_m.size() < 2)
    refuse(first, {fmt::format("all {} are at a depth of {:.6g} m", measured.levels,
                               measured.depth_m.front()),
                   "a profile needs two depths"});
  return {measured.depth_m, measured.value};
}

// --- netCDF --------------------------------------------------------------------------------------

/// Makes depths of pressures.
void to_depths(std::optional<double> latitude, Levels& depth, std::vector<std::string>& remarks) {
  if (!latitude)
    remarks.push_back(
        fmt::format("no LATITUDE in the file: depths are those of the pressures at "
                    "{:g} degrees",
                    latitude_by_default_deg));
  for (double& z : depth.value)
    z = optics::depth_of_pressure_m(z, latitude.value_or(latitude_by_default_deg));
}

/// Makes depths in m of what a file holds.
void convert_depths(const NetcdfColumns& file, const ProfileVariable& from, const Layout& layout,
                    const Cast& cast, Levels& depth, std::vector<std::string>& remarks) {
  const NetcdfVariable& variable = from.variable();
  const auto unit = unit_called(variable.units);
  const auto length = unit ? conversion(*unit, metre) : std::nullopt;
  const auto pressure = unit ? conversion(*unit, decibar) : std::nullopt;
  if (!length && !pressure)
    file.fail(from.name(), units_text(variable), "depths are in \"m\", pressures in \"decibar\"");
  for (double& z : depth.value) z = length ? (*length)(z) : (*pressure)(z);
  if (points_up(file, from.name(), variable))
    for (double& z : depth.value) z = 0 - z;
  if (pressure) to_depths(latitude_deg(file, layout, cast), depth, remarks);
}

/// Checks whether salinities are said to be practical.
void check_salinities(const NetcdfColumns& file, const ProfileVariable& from, const Levels& levels,
                      std::vector<std::string>& remarks) {
  const NetcdfVariable& variable = from.variable();
  if (is_absolute_salinity(variable.units, variable.standard_name))
    return remarks.push_back(fmt::format(
        "{} is an absolute salinity: practical ones are 35/35.16504 of it in g/kg", from.name()));
  double greatest = 0;
  for (const double x : levels.value) greatest = std::max(greatest, x);  // NaN is none of them
  constexpr double largest_fraction = 0.05;
  const bool is_ratio =
      variable.units == "1" || variable.units == "1e-3" || variable.units == "0.001";
  if (is_ratio && greatest > 0 && greatest < largest_fraction)
    file.fail(from.name(),
              fmt::format("salinities of {:.4g} at most, in units of \"{}\", are fractions of mass "
                          "and not practical salinities",
                          greatest, variable.units),
              "give its units as \"kg/kg\"");
}

/// Makes values in the key's unit of what a file holds.
void convert_values(const NetcdfColumns& file, const ProfileVariable& from, const std::string& key,
                    Levels& levels, std::vector<std::string>& remarks) {
  const NetcdfVariable& variable = from.variable();
  if (variable.units.empty()) {  // as of a CSV file's column, but those have no place for them
    remarks.push_back(fmt::format("{} has no attribute units: its values are taken to be in {}",
                                  from.name(), unit_of(key)));
    return;
  }
  const Conversion convert = conversion_of(file, from.name(), variable, key);
  for (double& x : levels.value) x = convert(x);
  if (key == "salinity_psu") check_salinities(file, from, levels, remarks);
}

Measured measured_of(const ProfileVariable& from, const ProfileVariable& depth_from,
                     const Levels& depth, const Levels& value) {
  Measured measured{"levels", depth_from.name(), from.name(), {}, {}, {}};
  for (std::size_t i = 0; i < value.value.size(); ++i) {
    if (!std::isfinite(value.value[i]) || !std::isfinite(depth.value[i])) continue;
    measured.level.push_back(i);
    measured.depth_m.push_back(depth.value[i]);
    measured.value.push_back(value.value[i]);
  }
  return measured;
}

std::string gaps_text(std::size_t known, std::size_t levels, const Measured& ordered) {
  double widest = 0, from = 0;
  for (std::size_t k = 1; k < ordered.depth_m.size(); ++k) {
    const double gap = ordered.depth_m[k] - ordered.depth_m[k - 1];
    if (gap > widest) from = ordered.depth_m[k - 1];
    widest = std::max(widest, gap);
  }
  return fmt::format(
      "{} of {} levels of {} have no value or no depth and are left out; the widest "
      "gap is from {:.4g} to {:.4g} m",
      levels - known, levels, ordered.name, from, from + widest);
}

std::vector<std::string> without_repeats(const std::vector<std::string>& texts) {
  std::vector<std::string> out;
  for (const std::string& text : texts)
    if (std::ranges::find(out, text) == out.end()) out.push_back(text);
  return out;
}

}  // namespace

ReadProfile profile_of_text(const ProfileFile& from, const ProfiledKey& key) {
  constexpr const char *depth = "depth", *value = "column";
  const auto file = optics::DataTable::read(from.file);
  const auto table = file.with({{depth, from.depth}, {value, from.column}});
  refuse_other_units(table, depth, "depth_m");
  refuse_other_units(table, value, key.key);
  Measured measured{
      "rows", file.name_of_column(from.depth), file.name_of_column(from.column), {}, {}, {}};
  measured.depth_m = table.numbers(depth);
  measured.value = table.numbers(value);
  const std::size_t rows = measured.depth_m.size();
  if (rows < 2) table.fail(0, depth, "a profile needs at least two rows");
  if (rows > max_levels)
    table.fail(max_levels, depth, fmt::format("at most {} rows are read", max_levels));
  for (std::size_t i = 0; i < rows; ++i) measured.level.push_back(i);
  const auto refuse = [&](std::size_t row, const Refusal& refusal) {
    table.fail(row, value, refusal.reason, refusal.suggestion);
  };
  std::vector<std::string> remarks;
  LinearProfile profile = profile_of(measured, from, key, refuse, remarks);
  return {std::move(profile), std::move(remarks)};
}

ReadProfile profile_of_netcdf(const ProfileFile& from, const ProfiledKey& key,
                              const NetcdfFiles& netcdf) {
  const NetcdfColumns file(from.file, netcdf);
  const ProfileVariable variable(file, from.variable), depths(file, from.depth.name);
  const Casts casts(file, variable, depths);
  const Cast cast = casts.chosen(from.profile);
  Levels value = variable.levels(cast.value), depth = depths.levels(cast.depth);
  std::vector<std::string> remarks = casts.remarks();
  if (!cast.label.empty())
    remarks.push_back(fmt::format("profile {} is that of {}", cast.number, cast.label));
  std::vector<std::string> flagged = value.flagged;
  flagged.insert(flagged.end(), depth.flagged.begin(), depth.flagged.end());
  for (const auto* more : {&flagged, &value.remarks, &depth.remarks})
    remarks.insert(remarks.end(), more->begin(), more->end());
  const std::string flags = flagged.empty() ? "" : fmt::format(": {}", fmt::join(flagged, ", "));
  convert_depths(file, depths, casts.layout(), cast, depth, remarks);
  convert_values(file, variable, key.key, value, remarks);
  Measured measured = measured_of(variable, depths, depth, value);
  const std::size_t known = measured.level.size(), levels = value.value.size();
  if (known < 2)
    file.fail(from.variable,
              fmt::format("profile {} has values at {} of {} levels; it takes two{}", cast.number,
                          known, levels, flags),
              instead_of(file, casts, cast, variable, depths));
  const auto refuse = [&](std::size_t level, const Refusal& refusal) {
    file.fail(variable.at(cast.value[level]), refusal.reason, refusal.suggestion);
  };
  LinearProfile profile = profile_of(measured, from, key, refuse, remarks);
  if (known < levels) remarks.push_back(gaps_text(known, levels, measured));
  return {std::move(profile), without_repeats(remarks)};
}

}  // namespace photic::scene
