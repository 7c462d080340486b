#include "optics/atmosphere.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "core/interpolation.hpp"
#include "optics/air_plausibility.hpp"
#include "optics/table_text.hpp"

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
    if (column.empty()) continue;  // it has no name
    const std::string there_are = fmt::format("there are: {}", fmt::join(known, ", "));
    if (std::find(known.begin(), known.end(), column) == known.end())
      table.fail_columns(table.may_be_quoted() ? fmt::format("unknown column \"{}\"", shown(column))
                                               : fmt::format("{}: unknown column", no_numbers),
                         there_are);
    if (std::count(table.columns().begin(), table.columns().end(), column) > 1)
      table.fail_columns(fmt::format("column \"{}\" appears twice", column));
  }
  if (has(table, humidity_column) && has(table, vapour_column)) {
    table.fail_columns(
        fmt::format("both {} and {}: which one counts?", humidity_column, vapour_column),
        "leave one out");
  }
}

constexpr double max_per_cm3 = 1e20;

/// A column of numbers from min to max; what may have been meant by others is asked.
std::vector<double> numbers(const DataTable& table, const char* column, double min, double max,
                            const char* if_below = "", const char* if_above = "") {
  std::vector<double> out = table.numbers(column);
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (out[i] < min)
      table.fail(i, column, fmt::format("{} {:g} is below {:g}", column, out[i], min), if_below);
    if (out[i] > max)
      table.fail(i, column, fmt::format("{} {:g} is above {:g}", column, out[i], max), if_above);
  }
  return out;
}

std::vector<double> temperatures(const DataTable& table) {
  return numbers(table, temperature_column, lowest_k, highest_k,
                 "is it in degrees Celsius, and not in K?");
}

double saturated_vapour_per_m3(double temperature_k) {
  constexpr double grams_per_mol = 18.015;  // of water
  const double a = 273.15 / temperature_k;
  const double saturated_g_m3 = a * std::exp(18.9766 - 14.9595 * a - 2.43882 * a * a);
  return saturated_g_m3 * avogadro_per_mol / grams_per_mol;
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
    std::vector<double> out =
        numbers(table, air_column, 1, max_per_cm3, "", "is it in 1/m3, and not in 1/cm3?");
    scale(out, per_m3_of_cm3);
    return out;
  }
  std::vector<double> out;  // the ideal gas
  for (std::size_t i = 0; i < table.rows(); ++i)
    out.push_back(profile.pressure_hpa[i] * pa_per_hpa /
                  (boltzmann_j_k * profile.temperature_k[i]));
  return out;
}

/// The uncertainty of pressures by the digits that they are written with.
double rounding_hpa(const DataTable& table, const std::vector<double>& pressure_hpa) {
  double out = max_hpa;
  const std::vector<std::string> texts = table.texts(pressure_column);
  for (std::size_t i = 0; i < texts.size(); ++i)
    if (pressure_hpa[i] > min_hpa) out = std::min(out, half_last_digit(texts[i]));
  return out;
}

const char* column_of(AirFault::Of of) {
  return of == AirFault::Of::altitude   ? altitude_column
         : of == AirFault::Of::pressure ? pressure_column
                                        : air_column;
}

std::vector<double> humidity(const DataTable& table, const AirProfile& profile) {
  if (!has(table, vapour_column)) return numbers_or_0(table, humidity_column, 100);
  std::vector<double> out = numbers(table, vapour_column, 0, max_per_cm3);
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = relative_humidity_percent(per_m3_of_cm3 * out[i], profile.temperature_k[i]);
  return out;
}

/// The mean between two altitudes of an exponential, or of a straight line.
double mean_of(double bottom, double top, bool straight) {
  if (straight || bottom == 0 || top == 0) return (bottom + top) / 2;
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
  out.remarks = table.remarks();
  out.z_km = table.ascending_numbers(altitude_column);
  if (out.z_km.size() < 2) table.fail(0, altitude_column, "a profile needs two levels or more");
  if (out.z_km.front() < 0) table.fail(0, altitude_column, "altitudes begin at the sea level, 0");
  out.edges_km = out.aerosol_z_km = out.z_km;
  out.pressure_hpa =
      numbers(table, pressure_column, min_hpa, max_hpa, "", "is it in Pa, and not in hPa?");
  out.temperature_k = temperatures(table);
  out.air_per_m3 = air_per_m3(table, out);
  out.ozone_per_m3 = numbers_or_0(table, ozone_column, max_per_cm3);
  scale(out.ozone_per_m3, per_m3_of_cm3);
  out.relative_humidity_percent = humidity(table, out);
  for (std::size_t k = 0; k < aerosol_regions; ++k)
    out.aerosols_per_km[k] = numbers_or_0(table, aerosol_column[k], max_aerosols_per_km);
  if (const auto fault = fault_of(out, rounding_hpa(table, out.pressure_hpa)))
    table.fail(fault->level, column_of(fault->of), fault->reason, fault->suggestion);
  return out;
}

DataTable with_all_humidities(DataTable table) {
  for (const char* column : {humidity_column, vapour_column}) {
    if (!table.has(column)) continue;
    const std::vector<std::string> texts = table.texts(column);
    const auto gap = [&](std::size_t row) { return is_gap(texts[row]); };
    for (std::size_t row = 0; row < texts.size(); ++row)
      if (gap(row)) table.put(row, column, "0");
    std::vector<double> values = table.numbers(column), saturated(values.size(), 1.0);
    if (column == vapour_column)
      std::ranges::transform(temperatures(table), saturated.begin(), saturated_vapour_per_m3);
    for (std::size_t row = 0; row < values.size(); ++row)
      values[row] = gap(row) ? std::nan("") : values[row] / saturated[row];
    const auto remark = fill_humidities(table.ascending_numbers(altitude_column), values);
    for (std::size_t row = 0; row < values.size(); ++row)
      if (gap(row)) table.put(row, column, fmt::format("{}", values[row] * saturated[row]));
    if (remark) table.remark(fmt::format("{} {}", column, *remark));
  }
  return table;
}

std::optional<std::string> fill_humidities(const std::vector<double>& z_km,
                                           std::vector<double>& humidity) {
  std::vector<double> known_z, known;
  std::optional<double> first_z;
  for (std::size_t i = 0; i < z_km.size(); ++i) {
    if (!std::isnan(humidity[i])) {
      known_z.push_back(z_km[i]);
      known.push_back(humidity[i]);
    } else if (!first_z) {
      first_z = z_km[i];
    }
  }
  if (!first_z) return std::nullopt;
  if (known.empty()) {
    std::ranges::fill(humidity, 0.0);
    return "is missing at all levels: the air is dry";
  }
  for (std::size_t i = 0; i < z_km.size(); ++i)
    if (std::isnan(humidity[i]))
      humidity[i] =
          known.size() == 1
              ? known.front()
              : LinearTable(known_z, known)(std::clamp(z_km[i], known_z.front(), known_z.back()));
  return fmt::format(
      "is missing at {} of {} levels, the first at {:g} km: there it follows from "
      "the levels beside it",
      z_km.size() - known.size(), z_km.size(), *first_z);
}

double relative_humidity_percent(double water_vapour_per_m3, double temperature_k) {
  return std::min(100.0, 100 * water_vapour_per_m3 / saturated_vapour_per_m3(temperature_k));
}

AirProfile with_edges(AirProfile profile, const std::vector<double>& more_km) {
  auto& edges = profile.edges_km;
  const double bottom = edges.front(), top = edges.back();
  edges.insert(edges.end(), more_km.begin(), more_km.end());
  std::ranges::sort(edges);
  const auto same = std::ranges::unique(edges);
  edges.erase(same.begin(), same.end());
  expect(edges.front() == bottom && edges.back() == top, "edges are added between others");
  return profile;
}

AirProfile up_to(AirProfile whole, double top_km) {
  AirProfile profile = with_edges(std::move(whole), {top_km});
  auto& edges = profile.edges_km;
  edges.erase(std::ranges::upper_bound(edges, top_km), edges.end());
  expect(edges.size() > 1, "there is air below the top");
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
    const bool straight = values[i - 1] == 0 || values[i] == 0;
    integral += (top - bottom) * mean_of(at(bottom), at(top), straight);
  }
  return integral / (to_km - from_km);
}

}  // namespace photic::optics
