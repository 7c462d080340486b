#include "optics/atmosphere.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "core/interpolation.hpp"

namespace photic::optics {
namespace {

constexpr double per_m3_of_cm3 = 1e6, pa_per_hpa = 100;

// The columns of an air profile.
constexpr const char* altitude_column = "z_km";
constexpr const char* pressure_column = "p_hpa";
constexpr const char* temperature_column = "t_k";
constexpr const char* air_column = "air_per_cm3";
constexpr const char* ozone_column = "ozone_per_cm3";
constexpr const char* humidity_column = "relative_humidity_percent";
constexpr const char* vapour_column = "water_vapour_per_cm3";
constexpr std::array<const char*, aerosol_regions> aerosol_column{
    "boundary_layer_per_km", "troposphere_per_km", "stratosphere_per_km",
    "upper_atmosphere_per_km"};

std::vector<std::string> all_columns() {
  std::vector<std::string> out{altitude_column, pressure_column, temperature_column, air_column,
                               ozone_column,    humidity_column, vapour_column};
  out.insert(out.end(), aerosol_column.begin(), aerosol_column.end());
  return out;
}

bool has(const DataTable& table, const std::string& column) {
  return std::find(table.columns().begin(), table.columns().end(), column) != table.columns().end();
}

void check_columns(const DataTable& table) {
  const std::vector<std::string> known = all_columns();
  for (const std::string& column : table.columns()) {
    const std::string there_are = fmt::format("there are: {}", fmt::join(known, ", "));
    if (std::find(known.begin(), known.end(), column) == known.end())
      table.fail_columns(fmt::format("unknown column \"{}\"", column), there_are);
    if (std::count(table.columns().begin(), table.columns().end(), column) > 1)
      table.fail_columns(fmt::format("column \"{}\" appears twice", column));
  }
  if (has(table, humidity_column) && has(table, vapour_column)) {
    table.fail_columns(
        fmt::format("both {} and {}: which one counts?", humidity_column, vapour_column),
        "leave one out");
  }
}

constexpr double most_per_cm3 = 1e20;

/// A column of numbers from min to max.
std::vector<double> numbers(const DataTable& table, const char* column, double min, double max) {
  std::vector<double> out = table.numbers(column);
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (out[i] < min)
      table.fail(i, column, fmt::format("{} {:g} is below {:g}", column, out[i], min));
    if (out[i] > max)
      table.fail(i, column, fmt::format("{} {:g} is above {:g}", column, out[i], max));
  }
  return out;
}

/// From 0, or zeros if there is no such column.
std::vector<double> numbers_or_0(const DataTable& table, const char* column, double max) {
  return has(table, column) ? numbers(table, column, 0, max)
                            : std::vector<double>(table.rows(), 0.0);
}

void scale(std::vector<double>& values, double factor) {
  for (double& value : values) value *= factor;
}

std::vector<double> air_per_m3(const DataTable& table, const AirProfile& profile) {
  if (has(table, air_column)) {
    std::vector<double> out = numbers(table, air_column, 1, most_per_cm3);
    scale(out, per_m3_of_cm3);
    return out;
  }
  std::vector<double> out;  // the ideal gas
  for (std::size_t i = 0; i < table.rows(); ++i)
    out.push_back(profile.pressure_hpa[i] * pa_per_hpa /
                  (boltzmann_j_k * profile.temperature_k[i]));
  return out;
}

std::vector<double> humidity(const DataTable& table, const AirProfile& profile) {
  if (!has(table, vapour_column)) return numbers_or_0(table, humidity_column, 100);
  std::vector<double> out = numbers(table, vapour_column, 0, most_per_cm3);
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = relative_humidity_percent(per_m3_of_cm3 * out[i], profile.temperature_k[i]);
  return out;
}

/// The mean between two levels: of an exponential, of a straight line if one of them is 0.
double mean_of(double bottom, double top) {
  if (bottom == 0 || top == 0) return (bottom + top) / 2;
  const double log_ratio = std::log(top) - std::log(bottom);
  if (std::abs(log_ratio) > 1) return (top - bottom) / log_ratio;
  const double change = (top - bottom) / bottom;  // may be small
  return change == 0 ? bottom : bottom * change / std::log1p(change);
}

}  // namespace

AirProfile air_profile(const DataTable& table) {
  check_columns(table);
  AirProfile out;
  out.source = table.name();
  out.z_km = table.ascending_numbers(altitude_column);
  if (out.z_km.size() < 2) table.fail(0, altitude_column, "a profile needs two levels or more");
  if (out.z_km.front() < 0) table.fail(0, altitude_column, "altitudes begin at the sea level, 0");
  out.pressure_hpa = numbers(table, pressure_column, 1e-12, most_hpa);
  out.temperature_k = numbers(table, temperature_column, lowest_k, highest_k);
  out.air_per_m3 = air_per_m3(table, out);
  out.ozone_per_m3 = numbers_or_0(table, ozone_column, most_per_cm3);
  scale(out.ozone_per_m3, per_m3_of_cm3);
  out.relative_humidity_percent = humidity(table, out);
  for (std::size_t k = 0; k < aerosol_regions; ++k)
    out.aerosols_per_km[k] = numbers_or_0(table, aerosol_column[k], most_aerosols_per_km);
  return out;
}

double relative_humidity_percent(double water_vapour_per_m3, double temperature_k) {
  constexpr double grams_per_mol = 18.015;  // of water
  const double a = 273.15 / temperature_k;
  const double saturated_g_m3 = a * std::exp(18.9766 - 14.9595 * a - 2.43882 * a * a);
  const double g_m3 = water_vapour_per_m3 * grams_per_mol / avogadro_per_mol;
  return std::min(100.0, 100 * g_m3 / saturated_g_m3);
}

AirProfile with_levels(const AirProfile& profile, const std::vector<double>& more_km) {
  const auto& z = profile.z_km;
  AirProfile out;
  out.source = profile.source;
  std::set_union(z.begin(), z.end(), more_km.begin(), more_km.end(), std::back_inserter(out.z_km));
  expect(out.z_km.front() == z.front() && out.z_km.back() == z.back(),
         "levels are added between others");
  const auto fill = [&](const std::vector<double>& from, std::vector<double>& to,
                        const auto& between) {
    for (const double level_km : out.z_km) {
      const auto [i, t] = interval_of(z, level_km);
      to.push_back(t == 0 ? from[i - 1] : t == 1 ? from[i] : between(from[i - 1], from[i], t));
    }
  };
  const auto straight = [](double a, double b, double t) { return std::lerp(a, b, t); };
  const auto exponential = [](double a, double b, double t) { return geometric_lerp(a, b, t); };
  fill(profile.pressure_hpa, out.pressure_hpa, exponential);
  fill(profile.temperature_k, out.temperature_k, straight);
  fill(profile.air_per_m3, out.air_per_m3, exponential);
  fill(profile.ozone_per_m3, out.ozone_per_m3, exponential);
  fill(profile.relative_humidity_percent, out.relative_humidity_percent, straight);
  for (std::size_t k = 0; k < aerosol_regions; ++k)
    fill(profile.aerosols_per_km[k], out.aerosols_per_km[k], exponential);
  return out;
}

AirProfile up_to(const AirProfile& whole, double top_km) {
  AirProfile profile = with_levels(whole, {top_km});
  const auto levels =
      static_cast<std::size_t>(std::lower_bound(profile.z_km.begin(), profile.z_km.end(), top_km) -
                               profile.z_km.begin() + 1);
  expect(levels > 1, "there is air below the top");
  for (auto* values :
       {&profile.z_km, &profile.pressure_hpa, &profile.temperature_k, &profile.air_per_m3,
        &profile.ozone_per_m3, &profile.relative_humidity_percent})
    values->resize(levels);
  for (auto& aerosols : profile.aerosols_per_km) aerosols.resize(levels);
  return profile;
}

double mean_between(const std::vector<double>& z_km, const std::vector<double>& values,
                    double from_km, double to_km) {
  expect(z_km.front() <= from_km && from_km < to_km && to_km <= z_km.back(),
         "a mean over altitudes is asked for where there are levels");
  double integral = 0;
  for (std::size_t i = 1; i < z_km.size(); ++i) {
    const double bottom = std::max(from_km, z_km[i - 1]), top = std::min(to_km, z_km[i]);
    if (bottom >= top) continue;
    const auto at = [&](double z) {
      return geometric_lerp(values[i - 1], values[i], (z - z_km[i - 1]) / (z_km[i] - z_km[i - 1]));
    };
    integral += (top - bottom) * mean_of(at(bottom), at(top));
  }
  return integral / (to_km - from_km);
}

}  // namespace photic::optics
