// The air above the sea as a profile of levels: how much of what there is at which altitude.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "optics/data_table.hpp"

namespace photic::optics {

/// The regions into which LOWTRAN 7 divides the air, each with aerosols of its own.
enum AerosolRegion : std::size_t {
  boundary_layer,    ///< 0 to 2 km
  troposphere,       ///< 2 to 10 km
  stratosphere,      ///< 10 to 30 km
  upper_atmosphere,  ///< 30 to 100 km
  aerosol_regions
};

/// Values at levels. Densities and extinctions are exponential between two levels (a straight line
/// where one of them is 0), outside all levels there is nothing.
struct AirProfile {
  std::vector<double> z_km;  ///< two or more, strictly ascending
  std::vector<double> pressure_hpa, temperature_k;
  std::vector<double> air_per_m3, ozone_per_m3;  ///< molecules
  std::vector<double> relative_humidity_percent;
  std::vector<double> aerosol_z_km;  ///< of the aerosols: the levels, and more between
  std::array<std::vector<double>, aerosol_regions> aerosols_per_km;  ///< extinction at 550 nm
  std::vector<double> edges_km;  ///< of its layers, ascending: the levels, and more between
  std::string source;
  std::vector<std::string> remarks;  ///< on what was missing where it was read

  friend bool operator==(const AirProfile&, const AirProfile&) = default;
};

// The limits of what air can be: other numbers are in another unit.
/// The lowest pressure stands for what a file prints as 0.
inline constexpr double min_hpa = 1e-12;
inline constexpr double max_hpa = 2000, lowest_k = 50, highest_k = 5000;
inline constexpr double max_aerosols_per_km = 1e6;

/// Columns z_km, p_hpa, t_k; and as they are known air_per_cm3 (else p / kT), ozone_per_cm3,
/// relative_humidity_percent or water_vapour_per_cm3, aerosol extinction at 550 nm by region as
/// boundary_layer_per_km, troposphere_per_km, stratosphere_per_km, upper_atmosphere_per_km (else
/// 0). Throws InputError, of a profile that no air has, too (optics/air_plausibility.hpp). The
/// source is the table's name.
AirProfile air_profile(const DataTable& table);

/// The table with a humidity, or water vapour, where a row has none (a gap, or NaN), and a remark
/// on that. Throws InputError where other numbers that this takes are wrong.
DataTable with_all_humidities(DataTable table);

/// Humidities that are not known (NaN) lie on straight lines between those that are, beyond them
/// they are as the nearest; where none is known they are 0. Returns a remark; none if all are
/// known.
std::optional<std::string> fill_humidities(const std::vector<double>& z_km,
                                           std::vector<double>& humidity);

/// The ratio of water vapour to its saturation over water, at most 100. LOWTRAN 7's formula
/// (Kneizys et al. 1988, AFGL-TR-88-0177) [verified: gives the humidities that it prints].
double relative_humidity_percent(double water_vapour_per_m3, double temperature_k);

/// The profile in more layers, with edges in any order between its own. The values stay as they
/// are.
AirProfile with_edges(AirProfile profile, const std::vector<double>& more_km);

/// The layers of a profile below an altitude, which they must cover.
AirProfile up_to(AirProfile whole, double top_km);

/// The mean of what has the values at the levels z_km, between two altitudes. The levels must cover
/// them.
double mean_between(const std::vector<double>& z_km, const std::vector<double>& values,
                    double from_km, double to_km);

}  // namespace photic::optics
