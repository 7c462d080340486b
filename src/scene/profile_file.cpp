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
#include "scene/netcdf_levels.hpp"
#include "scene/netcdf_units.hpp"

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

/// Of the profile; nothing if the file does not tell.
std::optional<double> latitude_deg(const NetcdfColumns& file, std::size_t profile) {
  if (!file.has("LATITUDE")) return std::nullopt;
  const NetcdfVariable latitude = file.read("LATITUDE");
  const std::size_t i = latitude.value.size() == 1 ? 0 : profile;
  if (i >= latitude.value.size() || !(std::fabs(latitude.value[i]) <= 90)) return std::nullopt;
  return latitude.value[i];
}

/// Makes depths of pressures.
void to_depths(const NetcdfColumns& file, std::size_t profile, Levels& depth,
               std::vector<std::string>& remarks) {
  const auto latitude = latitude_deg(file, profile);
  if (!latitude)
    remarks.push_back(
        fmt::format("no LATITUDE in the file: depths are those of the pressures at "
                    "{:g} degrees",
                    latitude_by_default_deg));
  for (double& z : depth.value)
    z = optics::depth_of_pressure_m(z, latitude.value_or(latitude_by_default_deg));
}

/// Makes depths in m of what a file holds.
void convert_depths(const NetcdfColumns& file, const ProfileVariable& from, std::size_t profile,
                    Levels& depth, std::vector<std::string>& remarks) {
  const NetcdfVariable& variable = from.variable();
  const auto unit = unit_called(variable.units);
  const auto length = unit ? conversion(*unit, metre) : std::nullopt;
  const auto pressure = unit ? conversion(*unit, decibar) : std::nullopt;
  if (!length && !pressure)
    file.fail(from.name(), units_text(variable), "depths are in \"m\", pressures in \"decibar\"");
  for (double& z : depth.value) z = length ? (*length)(z) : (*pressure)(z);
  if (points_up(file, from.name(), variable))
    for (double& z : depth.value) z = 0 - z;
  if (pressure) to_depths(file, profile, depth, remarks);
}

/// Salinities that are told to be practical, or are not.
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

/// Levels of one variable are those of the other.
void check_shapes(const NetcdfColumns& file, const ProfileVariable& depth,
                  const ProfileVariable& value) {
  const NetcdfVariable &z = depth.variable(), &x = value.variable();
  if (z.length.back() != x.length.back())
    file.fail(depth.shape(), fmt::format("has {} levels where {} has {}", z.length.back(),
                                         value.name(), x.length.back()));
  const bool turned = x.dimension.size() == 2 && x.dimension.front() == z.dimension.back() &&
                      x.dimension.back() != z.dimension.back();
  if (turned)
    file.fail(value.shape(),
              fmt::format("has its levels first, and {} has them last", depth.shape()),
              "dimensions are (profiles, levels)");
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

}  // namespace

ReadProfile profile_of_csv(const ProfileFile& from, const ProfiledKey& key) {
  const auto table = optics::DataTable::read(from.file);
  Measured measured{"rows", from.depth, from.column, {}, {}, {}};
  measured.depth_m = table.numbers(from.depth);
  measured.value = table.numbers(from.column);
  const std::size_t rows = measured.depth_m.size();
  if (rows < 2) table.fail(0, from.depth, "a profile needs at least two rows");
  if (rows > most_levels)
    table.fail(most_levels, from.depth, fmt::format("at most {} rows are read", most_levels));
  for (std::size_t i = 0; i < rows; ++i) measured.level.push_back(i);
  const auto refuse = [&](std::size_t row, const Refusal& refusal) {
    table.fail(row, from.column, refusal.reason, refusal.suggestion);
  };
  std::vector<std::string> remarks;
  LinearProfile profile = profile_of(measured, from, key, refuse, remarks);
  return {std::move(profile), std::move(remarks)};
}

ReadProfile profile_of_netcdf(const ProfileFile& from, const ProfiledKey& key,
                              const NetcdfFiles& netcdf) {
  const NetcdfColumns file(from.file, netcdf);
  const ProfileVariable variable(file, from.variable), depths(file, from.depth);
  const auto number = static_cast<std::size_t>(from.profile);
  Levels value = variable.levels(number), depth = depths.levels_for(number);
  check_shapes(file, depths, variable);
  std::vector<std::string> remarks;
  for (const Levels* each : {&value, &depth})
    if (!each->flagged.empty()) remarks.push_back(each->flagged);
  const std::string flags = remarks.empty() ? "" : fmt::format(": {}", fmt::join(remarks, ", "));
  convert_depths(file, depths, number, depth, remarks);
  convert_values(file, variable, key.key, value, remarks);
  Measured measured = measured_of(variable, depths, depth, value);
  const std::size_t known = measured.level.size(), levels = value.value.size();
  if (known < 2)
    file.fail(from.variable,
              fmt::format("profile {} has values at {} of {} levels; it takes two{}", from.profile,
                          known, levels, flags),
              instead_of(file, depths, variable, number));
  const auto refuse = [&](std::size_t level, const Refusal& refusal) {
    file.fail(value.at(level), refusal.reason, refusal.suggestion);
  };
  LinearProfile profile = profile_of(measured, from, key, refuse, remarks);
  if (known < levels) remarks.push_back(gaps_text(known, levels, measured));
  return {std::move(profile), std::move(remarks)};
}

}  // namespace photic::scene
