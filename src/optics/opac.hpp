// The aerosol components of OPAC (Hess, Koepke & Schult 1998, Bull. Am. Meteorol. Soc. 79, 831),
// through Mie theory.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "optics/aerosols.hpp"
#include "optics/spheres.hpp"

namespace photic::optics {

class Opac {
 public:
  Opac(const DataTable& indices, const DataTable& sizes);

  /// The spheres of a component at a relative humidity: "waso-80" is water-soluble at 80 %,
  /// "soot-0" soot. The index of the air around them is taken as 1. Of the distribution the largest
  /// spheres, with 1e-9 of the cross-sectional area, are left out. Throws InputError for another
  /// name or a wavelength outside the data.
  [[nodiscard]] Spheres spheres(const std::string& component, double wavelength_nm) const;

  /// Throws InputError, also if the spheres are too large (see below).
  [[nodiscard]] AerosolOptics at(const SpheresCache& cache, const std::string& component,
                                 double wavelength_nm) const;

 private:
  struct Component {
    std::vector<double> wavelength_nm, n, k;
    LogNormal sizes;
  };

  std::map<std::string, Component> components_;
  std::string source_;
};

/// Size parameters above this are refused: Mie theory integrated over sizes takes as long as the
/// cube of it. At 420 it takes 2 to 9 s for spheres that absorb, 25 s for sea salt.
inline constexpr double largest_opac_size = 425;

}  // namespace photic::optics
