// Jerlov's optical types of sea water.
#pragma once

#include <string>

#include "optics/library.hpp"

namespace photic::optics {

/// All absorption and scattering, water included.
struct JerlovWater {
  double a_per_m = 0, b_per_m = 0;
  std::string source;
};

/// Types IB, II, III, 1C, 3C, 5C: Williamson & Hollins 2022, Appl. Opt. 61, 9951, 420 to 700 nm.
/// Throws InputError for another type or wavelength.
JerlovWater jerlov_water(const Library& library, const std::string& type, double wavelength_nm);

}  // namespace photic::optics
