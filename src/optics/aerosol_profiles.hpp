// The amount of aerosol by altitude, for a visibility and a season: LOWTRAN 7's profiles.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "optics/atmosphere.hpp"

namespace photic::optics {

class AirLibrary;

/// Kneizys et al. 1988, AFGL-TR-88-0177, at the visibilities that are tabulated.
struct AerosolProfiles {
  static constexpr std::array<double, 5> visibility_km{50, 23, 10, 5, 2};
  static constexpr std::array<const char*, 2> seasons{"spring-summer", "fall-winter"};

  explicit AerosolProfiles(const DataTable& table);

  std::vector<double> z_km;
  // Extinction at 550 nm [1/km] at these altitudes.
  std::array<std::vector<double>, visibility_km.size()> boundary_layer;
  std::array<std::array<std::vector<double>, 2>, seasons.size()> troposphere;  ///< at 50, 23 km
  std::array<std::vector<double>, seasons.size()> stratosphere;
  std::vector<double> upper_atmosphere;
  std::string source;
};

/// The scattering of molecules at 550 nm at the sea level, as LOWTRAN 7 subtracts it from the
/// extinction that a visibility stands for.
inline constexpr double molecules_at_visibility_per_km = 0.01159;

/// The optical depth to where things are seen with a contrast of 2 % (Koschmieder 1924).
inline constexpr double contrast_depth = 3.912;

/// Extinction by aerosols at 550 nm at the sea level: 3.912 / visibility less that of molecules, as
/// in Kneizys et al. 1988.
double aerosols_of_visibility_per_km(double visibility_km);

inline constexpr double lowest_visibility_km = 0.2, highest_visibility_km = 300;
/// LOWTRAN 7's of rural and maritime air.
inline constexpr double clear_visibility_km = 23;

/// The profile with LOWTRAN 7's aerosols at its levels and those of LOWTRAN 7: linear in 1 /
/// visibility between and beyond the visibilities tabulated (as LOWTRAN 7 has it), up to 10 km;
/// below 23 km the visibility concerns the lowest 2 km alone. Seasons: "spring-summer",
/// "fall-winter". Throws InputError.
AirProfile with_aerosols(const AirLibrary& library, AirProfile profile, double visibility_km,
                         const std::string& season);

inline constexpr double max_aerosol_depth = 5;

/// Vertical, at 550 nm, of all regions from the lowest level to the highest.
double aerosol_depth(const AirProfile& profile);

/// The profile with the aerosols of the boundary layer in a measure that makes all of them as deep.
/// Throws InputError where those above it are deeper, or where it has none.
AirProfile with_aerosol_depth(AirProfile profile, double depth);

}  // namespace photic::optics
