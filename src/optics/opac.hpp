// The aerosol components of OPAC (Hess, Koepke & Schult 1998, Bull. Am. Meteorol. Soc. 79, 831),
// through Mie theory.
#pragma once

#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "optics/aerosols.hpp"
#include "optics/sampled_spheres.hpp"

namespace photic::optics {

class Opac {
 public:
  Opac(const DataTable& indices, const DataTable& sizes);

  /// The spheres of a component at a relative humidity: "waso-80" is water-soluble at 80 %,
  /// "soot-0" soot. The index of the air around them is taken as 1. The largest spheres of the
  /// distribution, with 1e-9 of the cross-sectional area, are left out: less than 1e-5 of
  /// extinction. Throws InputError for another name or a wavelength outside the data.
  [[nodiscard]] Spheres spheres(const std::string& component, double wavelength_nm) const;

  /// Throws InputError as spheres() does, and Stopped. Takes up to some seconds, once for each
  /// wavelength.
  [[nodiscard]] AerosolOptics at(const SampledSpheresCache& cache, const std::string& component,
                                 double wavelength_nm, Phases phases = Phases::wanted,
                                 const std::stop_token& stop = {}) const;

 private:
  struct Component {
    std::vector<double> wavelength_nm, n, k;
    LogNormal sizes;
  };

  std::map<std::string, Component> components_;
  std::string source_;
};

}  // namespace photic::optics
