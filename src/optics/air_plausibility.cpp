#include "optics/air_plausibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/constants.hpp"

namespace photic::optics {
namespace {

// U.S. Standard Atmosphere 1976 (NOAA-S/T 76-1562).
constexpr double gas_constant_j_kmol_k = 8314.32, dry_air_kg_kmol = 28.9644, gravity_m_s2 = 9.80665;
/// R / (M g), 29.27 m/K: over this and the temperature the pressure falls by a factor of e.
constexpr double km_per_k = 1e-3 * gas_constant_j_kmol_k / (dry_air_kg_kmol * gravity_m_s2);
constexpr double standard_hpa = 1013.25;

/// The factor left open by mean temperatures of wide steps, humidity, gravity aloft and rounding.
constexpr double tolerance = 1.5;
/// Above some 95 km air is no longer mixed, and its molecules are lighter.
constexpr double min_mixed_hpa = 1e-3;
/// Nearer levels are compared with others: differences of soundings' neighbours are noise.
constexpr double near_km = 0.5;

/// Returns whether a number is another one times a factor.
bool fits(double value, double factor) {
  return value > factor / tolerance && value < factor * tolerance;
}

struct Mistake {
  double factor;
  const char* question;
};

template <std::size_t n>
std::string question_for(double factor, const std::array<Mistake, n>& mistakes,
                         const std::string& otherwise) {
  const auto found =
      std::ranges::find_if(mistakes, [&](const Mistake& m) { return fits(factor, m.factor); });
  return found == mistakes.end() ? otherwise : found->question;
}

constexpr std::array of_altitudes{
    Mistake{1e3, "are the altitudes in m, and not in km?"},
    Mistake{3280.84, "are the altitudes in feet, and not in km?"},
    Mistake{3.28084, "are the altitudes in 1000 feet, and not in km?"}};
// Factors of the upper pressure over its expected value.
constexpr std::array of_pressures{Mistake{1e2, "is this pressure in Pa, and not in hPa?"},
                                  Mistake{1e-2, "is the pressure below it in Pa, and not in hPa?"},
                                  Mistake{1e-1, "is this pressure in kPa, and not in hPa?"},
                                  Mistake{1e1, "is the pressure below it in kPa, and not in hPa?"}};
// Factors of the pressure at the sea over the standard one.
constexpr std::array of_all_pressures{Mistake{1e-1, "are the pressures in kPa, and not in hPa?"},
                                      Mistake{1e-3, "are the pressures in bar, and not in hPa?"}};

/// The logarithm of a pressure over one above it, within the bounds of their rounding.
struct Logarithm {
  double least, most;
};

/// Pressures that are printed as 0 are 0.
double known_hpa(double hpa) { return hpa > min_hpa ? hpa : 0; }

Logarithm logarithm(double below_hpa, double above_hpa, double rounding_hpa) {
  const auto of = [](double below, double above) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    return below <= 0 ? -infinite : above <= 0 ? infinite : std::log(below / above);
  };
  const double below = known_hpa(below_hpa), above = known_hpa(above_hpa);
  return {of(below - rounding_hpa, above + rounding_hpa),
          of(below + rounding_hpa, above - rounding_hpa)};
}

/// Two levels, the lower one first.
struct Pair {
  std::size_t below, above;
};

/// A level with the next one that is far enough above it, or else, near the top, below it.
Pair compared(const std::vector<double>& z_km, std::size_t level) {
  const auto above = std::ranges::lower_bound(z_km, z_km[level] + near_km);
  if (above != z_km.end()) return {level, static_cast<std::size_t>(above - z_km.begin())};
  const auto below = std::ranges::upper_bound(z_km, z_km[level] - near_km);
  return {below == z_km.begin() ? 0 : static_cast<std::size_t>(below - z_km.begin()) - 1, level};
}

AirFault not_hydrostatic(const AirProfile& air, const Pair& pair, double scale_km,
                         double rounding_hpa) {
  const double z0 = air.z_km[pair.below], z1 = air.z_km[pair.above];
  const double p0 = air.pressure_hpa[pair.below], p1 = air.pressure_hpa[pair.above];
  const double expected_hpa = p0 * std::exp((z0 - z1) / scale_km);
  const bool upside_down = std::ranges::is_sorted(air.pressure_hpa);
  const std::string of_pressure =
      upside_down ? "are the pressures listed from the top down?"
                  : question_for(p1 / expected_hpa, of_pressures,
                                 "altitudes are in km, pressures in hPa, temperatures in K");
  if (p1 >= p0)
    return {pair.above, AirFault::Of::pressure,
            fmt::format("the pressure does not fall from {:g} to {:g} km: it is {:g} and {:g} hPa",
                        z0, z1, p0, p1),
            of_pressure};
  const double takes_km = scale_km * std::log(p0 / std::max(known_hpa(p1), rounding_hpa));
  return {pair.above, AirFault::Of::altitude,
          fmt::format("the pressure falls from {:g} to {:g} hPa between {:g} and {:g} km: in "
                      "hydrostatic air of {:g} K that takes {:.3g} km",
                      p0, p1, z0, z1, scale_km / km_per_k, takes_km),
          question_for((z1 - z0) / takes_km, of_altitudes, of_pressure)};
}

std::optional<AirFault> hydrostatic_fault(const AirProfile& air, double rounding_hpa) {
  for (std::size_t i = 0; i < air.z_km.size(); ++i) {
    const Pair pair = compared(air.z_km, i);
    const double below = air.pressure_hpa[pair.below], above = air.pressure_hpa[pair.above];
    if (pair.below == pair.above || std::max(below, above) < min_mixed_hpa) continue;
    const double scale_km =
        km_per_k * (air.temperature_k[pair.below] + air.temperature_k[pair.above]) / 2;
    const double way = (air.z_km[pair.above] - air.z_km[pair.below]) / scale_km;
    const Logarithm log = logarithm(below, above, rounding_hpa);
    if (way < log.least / tolerance || way > log.most * tolerance)
      return not_hydrostatic(air, pair, scale_km, rounding_hpa);
  }
  return std::nullopt;
}

/// The sea may be a lake in the mountains: a third of the standard pressure is that of the highest.
std::optional<AirFault> fault_at_the_sea(const AirProfile& air) {
  constexpr double min_share = 0.3, high_km = 5;  // above it the way down is too far to guess
  const double z_km = air.z_km.front(), hpa = air.pressure_hpa.front();
  if (z_km > high_km) return std::nullopt;
  const double at_sea = hpa * std::exp(z_km / (km_per_k * air.temperature_k.front()));
  const double share = at_sea / standard_hpa;
  if (share > min_share && share < tolerance) return std::nullopt;
  return AirFault{0, AirFault::Of::pressure,
                  fmt::format("air at {:g} km has no pressure of {:g} hPa: at the sea it is some "
                              "{:g}",
                              z_km, hpa, standard_hpa),
                  question_for(share, of_all_pressures, "pressures are in hPa")};
}

std::optional<AirFault> fault_of_density(const AirProfile& air, double rounding_hpa) {
  constexpr double pa_per_hpa = 100, cm3_per_m3 = 1e6;
  for (std::size_t i = 0; i < air.z_km.size(); ++i) {
    const double hpa = known_hpa(air.pressure_hpa[i]), k = air.temperature_k[i];
    if (hpa < min_mixed_hpa) continue;
    const auto ideal = [&](double of_hpa) { return pa_per_hpa * of_hpa / (boltzmann_j_k * k); };
    const double n = air.air_per_m3[i];
    if (n > ideal(hpa - rounding_hpa) / tolerance && n < ideal(hpa + rounding_hpa) * tolerance)
      continue;
    return AirFault{i, AirFault::Of::density,
                    fmt::format("{:.4g} molecules of air per cm3 do not go with {:g} hPa and {:g} "
                                "K: an ideal gas has {:.4g}",
                                n / cm3_per_m3, hpa, k, ideal(hpa) / cm3_per_m3),
                    "without a column of them there are as many as in the ideal gas"};
  }
  return std::nullopt;
}

}  // namespace

std::optional<AirFault> fault_of(const AirProfile& profile, double rounding_hpa) {
  if (auto fault = hydrostatic_fault(profile, rounding_hpa)) return fault;
  if (auto fault = fault_at_the_sea(profile)) return fault;
  return fault_of_density(profile, rounding_hpa);
}

std::vector<std::string> doubts_about(const AirProfile& profile) {
  std::vector<std::string> out;
  // Measured at sea level, or reduced to it (WMO's archive of extremes).
  constexpr double lowest_hpa = 870, highest_hpa = 1085;
  const double hpa = profile.pressure_hpa.front();
  constexpr double hpa_per_mm_hg = 1.33322;
  const auto usual = [](double x) { return x >= lowest_hpa && x <= highest_hpa; };
  if (profile.z_km.front() == 0 && !usual(hpa))
    out.push_back(fmt::format(
        "the pressure at the sea is {:g} hPa, where {:g} to {:g} have been "
        "measured{}",
        hpa, lowest_hpa, highest_hpa, usual(hpa * hpa_per_mm_hg) ? ": is it in mmHg?" : ""));
  const double humidity = std::ranges::max(profile.relative_humidity_percent);
  if (humidity > 0 && humidity <= 1)
    out.push_back(
        fmt::format("the relative humidity is {:g} % at most: is it a fraction?", humidity));
  constexpr double min_per_m3 = 1e15, max_per_m3 = 1e20, per_cm3 = 1e-6;
  const double ozone = std::ranges::max(profile.ozone_per_m3);
  if (ozone > 0 && (ozone < min_per_m3 || ozone > max_per_m3))
    out.push_back(
        fmt::format("there are {:.3g} molecules of ozone per cm3 at most, where air has "
                    "some 5e+12",
                    per_cm3 * ozone));
  constexpr double foggiest_per_km = 20;  // a visibility of 0.2 km
  for (const auto& aerosols : profile.aerosols_per_km)
    if (const double most = std::ranges::max(aerosols); most > foggiest_per_km)
      out.push_back(
          fmt::format("aerosols have an extinction of {:g} per km, more than fog of 0.2 "
                      "km visibility: is it in 1/Mm?",
                      most));
  return out;
}

}  // namespace photic::optics
