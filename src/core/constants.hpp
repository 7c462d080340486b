// Constants of nature and of arithmetic. SI.
#pragma once

#include <numbers>

namespace photic {

inline constexpr double pi = std::numbers::pi;

// Exact by definition of the SI (BIPM, The International System of Units, 9th ed., 2019).
inline constexpr double speed_of_light_m_s = 299792458.0;
inline constexpr double boltzmann_j_k = 1.380649e-23;
inline constexpr double avogadro_per_mol = 6.02214076e23;

inline constexpr double radian_per_degree = pi / 180.0;
inline constexpr double metre_per_km = 1e3;
inline constexpr double metre_per_nanosecond = speed_of_light_m_s * 1e-9;  ///< light in vacuum

}  // namespace photic
