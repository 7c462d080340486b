#include "scene/profile_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <tuple>

#include "optics/data_table.hpp"
#include "optics/pressure.hpp"
#include "scene/netcdf_columns.hpp"

namespace photic::scene {
namespace {

/// More levels than any instrument writes; bounds the time that cutting takes.
constexpr std::size_t most_levels = 100'000;
constexpr double latitude_by_default_deg = 45;

std::optional<Refusal> refusal_of(const Number& rule, double value) {
  double checked = 0;
  return check(rule, to_node(value), checked);
}

// --- netCDF --------------------------------------------------------------------------------------

/// One profile of a variable: values by level, NaN where there are none.
struct Levels {
  std::string prefix;  ///< of the index of a level: "CHLA[0, "
  std::vector<double> value;

  [[nodiscard]] std::string at(std::size_t level) const {
    return fmt::format("{}{}]", prefix, level);
  }
};

/// The profile that is asked for, of a variable with the dimensions (levels) or (profiles, levels).
Levels levels_of(const NetcdfColumns& file, const std::string& name, const NetcdfVariable& variable,
                 std::size_t profile) {
  const auto& length = variable.length;
  if (length.empty() || length.size() > 2)
    file.fail(shape_text(name, variable),
              fmt::format("has {} dimensions, not (levels) or (profiles, levels)", length.size()));
  if (length.back() > most_levels)
    file.fail(shape_text(name, variable),
              fmt::format("has {} levels; at most {} are read", length.back(), most_levels));
  const std::size_t profiles = length.size() == 2 ? length.front() : 1;
  if (profile >= profiles)
    file.fail(shape_text(name, variable),
              fmt::format("there is no profile {}: it has {}, counted from 0", profile, profiles));
  const auto first = variable.value.begin() + static_cast<std::ptrdiff_t>(profile * length.back());
  return {length.size() == 2 ? fmt::format("{}[{}, ", name, profile) : name + "[",
          {first, first + static_cast<std::ptrdiff_t>(length.back())}};
}

/// Of the profile; nothing if the file does not tell.
std::optional<double> latitude_deg(const NetcdfColumns& file, std::size_t profile) {
  if (!file.has("LATITUDE")) return std::nullopt;
  const NetcdfVariable latitude = file.read("LATITUDE");
  const std::size_t i = latitude.value.size() == 1 ? 0 : profile;
  if (i >= latitude.value.size() || !(std::fabs(latitude.value[i]) <= 90)) return std::nullopt;
  return latitude.value[i];
}

bool is_one_of(const std::string& text, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(), [&](const char* word) { return text == word; });
}

bool is_pressure(const NetcdfColumns& file, const std::string& name,
                 const NetcdfVariable& variable) {
  const std::string& units = variable.units;
  if (is_one_of(units, {"decibar", "decibars", "dbar", "db"})) return true;
  if (is_one_of(units, {"m", "meter", "meters", "metre", "metres"})) return false;
  file.fail(name,
            units.empty() ? "has no attribute units" : fmt::format("is in units of \"{}\"", units),
            "depths are in \"m\", pressures in \"decibar\"");
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

/// Quality flags of Argo floats (Argo user's manual, reference table 2; from memory) that say that
/// a value is probably bad, bad, or missing.
bool is_bad(double flag) { return flag == 3 || flag == 4 || flag == 9; }

/// Takes out the levels of a variable NAME that NAME_QC, if there is one, flags; how many they are.
std::size_t drop_flagged(const NetcdfColumns& file, const std::string& name, std::size_t profile,
                         const NetcdfVariable& variable, Levels& levels) {
  const std::string flags_name = name + "_QC";
  if (!file.has(flags_name)) return 0;
  const NetcdfVariable flags = file.read_flags(flags_name);
  if (flags.length != variable.length)
    file.fail(shape_text(flags_name, flags),
              fmt::format("should have a flag for each value of {}", shape_text(name, variable)));
  const auto of_levels = levels_of(file, flags_name, flags, profile);
  std::size_t dropped = 0;
  for (std::size_t i = 0; i < levels.value.size(); ++i) {
    if (!is_bad(of_levels.value[i]) || !std::isfinite(levels.value[i])) continue;
    levels.value[i] = std::numeric_limits<double>::quiet_NaN();
    ++dropped;
  }
  return dropped;
}

std::string flagged_text(const std::string& name, std::size_t dropped, std::size_t levels) {
  return fmt::format(
      "{}_QC flags {} of {} levels of {} as bad (3, 4) or missing (9), "
      "which then have no value",
      name, dropped, levels, name);
}

/// Levels that have both a depth and a value.
struct Known {
  std::vector<std::size_t> level;
  std::vector<double> depth_m, value;
};

Known known_levels(const Levels& depth, const Levels& value) {
  Known known;
  for (std::size_t i = 0; i < value.value.size(); ++i) {
    if (!std::isfinite(value.value[i]) || !std::isfinite(depth.value[i])) continue;
    known.level.push_back(i);
    known.depth_m.push_back(depth.value[i]);
    known.value.push_back(value.value[i]);
  }
  return known;
}

void check_known(const NetcdfColumns& file, const Levels& depth, const Levels& value,
                 const Known& known, const Number& rule) {
  for (std::size_t k = 0; k < known.level.size(); ++k) {
    const std::size_t i = known.level[k];
    if (const auto refusal = refusal_of(rule, known.value[k]))
      file.fail(value.at(i), refusal->reason, refusal->suggestion);
    if (k > 0 && !(known.depth_m[k] > known.depth_m[k - 1]))
      file.fail(depth.at(i),
                fmt::format("a depth of {:.6g} m is not below the {:.6g} m of the level before it",
                            known.depth_m[k], known.depth_m[k - 1]),
                "depths must ascend");
  }
}

/// Which profiles have values: floats write each of their instruments into another one.
std::string others_text(const NetcdfVariable& variable) {
  const std::size_t levels = std::max<std::size_t>(variable.length.back(), 1);
  for (std::size_t i = 0; i < variable.value.size(); ++i)
    if (std::isfinite(variable.value[i]))
      return fmt::format("the first profile with values is {}", i / levels);
  return "no profile has values";
}

/// What may serve where flags leave nothing of a variable.
std::string adjusted_text(const NetcdfColumns& file, const std::string& name) {
  const std::string adjusted = name + "_ADJUSTED";
  return file.has(adjusted) ? fmt::format("there is {}", adjusted) : "take another profile";
}

std::string gaps_text(const std::string& name, std::size_t levels, const Known& known) {
  double widest = 0, from = 0;
  for (std::size_t k = 1; k < known.depth_m.size(); ++k) {
    const double gap = known.depth_m[k] - known.depth_m[k - 1];
    if (gap > widest) from = known.depth_m[k - 1];
    widest = std::max(widest, gap);
  }
  return fmt::format(
      "{} of {} levels of {} have no value or no depth and are left out; the widest "
      "gap is from {:.4g} to {:.4g} m",
      levels - known.level.size(), levels, name, from, from + widest);
}

}  // namespace

ReadProfile profile_of_csv(const ProfileFile& from, const Number& rule) {
  const auto table = optics::DataTable::read(from.file);
  std::vector<double> depth = table.ascending_numbers(from.depth);
  std::vector<double> value = table.numbers(from.column);
  if (depth.size() < 2) table.fail(0, from.depth, "a profile needs at least two rows");
  if (depth.size() > most_levels)
    table.fail(most_levels, from.depth, fmt::format("at most {} rows are read", most_levels));
  for (std::size_t i = 0; i < value.size(); ++i)
    if (const auto refusal = refusal_of(rule, value[i]))
      table.fail(i, from.column, refusal->reason, refusal->suggestion);
  return {{std::move(depth), std::move(value)}, {}};
}

ReadProfile profile_of_netcdf(const ProfileFile& from, const Number& rule,
                              const NetcdfFiles& netcdf) {
  const NetcdfColumns file(from.file, netcdf);
  const NetcdfVariable variable = file.read(from.variable);
  const NetcdfVariable depths = file.read(from.depth);
  const auto profile = static_cast<std::size_t>(from.profile);
  Levels value = levels_of(file, from.variable, variable, profile);
  Levels depth = levels_of(file, from.depth, depths, depths.length.size() == 2 ? profile : 0);
  if (depth.value.size() != value.value.size())
    file.fail(shape_text(from.depth, depths),
              fmt::format("has {} levels where {} has {}", depth.value.size(), from.variable,
                          value.value.size()));
  std::vector<std::string> remarks;
  for (const auto& [name, of, levels] :
       {std::tuple(&from.variable, &variable, &value), {&from.depth, &depths, &depth}}) {
    const std::size_t i = of->length.size() == 2 ? profile : 0;
    if (const std::size_t dropped = drop_flagged(file, *name, i, *of, *levels))
      remarks.push_back(flagged_text(*name, dropped, levels->value.size()));
  }
  const std::string flags = remarks.empty() ? "" : fmt::format(": {}", fmt::join(remarks, ", "));
  if (is_pressure(file, from.depth, depths)) to_depths(file, profile, depth, remarks);
  Known known = known_levels(depth, value);
  if (known.level.size() < 2)
    file.fail(from.variable,
              fmt::format("profile {} has values at {} of {} levels; it takes two{}", from.profile,
                          known.level.size(), value.value.size(), flags),
              flags.empty() ? others_text(variable) : adjusted_text(file, from.variable));
  check_known(file, depth, value, known, rule);
  if (known.level.size() < value.value.size())
    remarks.push_back(gaps_text(from.variable, value.value.size(), known));
  return {{std::move(known.depth_m), std::move(known.value)}, std::move(remarks)};
}

}  // namespace photic::scene
