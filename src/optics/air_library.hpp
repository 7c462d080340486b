// The published tables that the optics of air are made of: apart from those of the sea, so that
// scenes without air do not read them.
#pragma once

#include <map>
#include <string>

#include "optics/aerosol_profiles.hpp"
#include "optics/aerosols.hpp"
#include "optics/atmosphere.hpp"
#include "optics/library.hpp"
#include "optics/opac.hpp"

namespace photic::optics {

/// Throws EnvironmentError for a file that is missing or damaged.
class AirLibrary {
 public:
  explicit AirLibrary(const std::string& folder);

  /// The six of Anderson et al. 1986 (AFGL), without aerosols: us-standard, tropical,
  /// midlatitude-summer, midlatitude-winter, subarctic-summer, subarctic-winter. Throws InputError
  /// for another name.
  [[nodiscard]] const AirProfile& atmosphere(const std::string& name) const;

  const Spectrum ozone_c0, ozone_c1, ozone_c2;  ///< Molina & Molina 1986: 1e-20 cm2, per K, per K2
  const Spectrum ozone_293k;                    ///< Serdyuchenko et al. 2014: cm2
  const AerosolProfiles aerosol_profiles;
  const std::map<std::string, AerosolModel> aerosols;
  const Opac opac;

  const SampledSpheresCache spheres;  ///< no table: what Mie theory gives, computed once

 private:
  std::map<std::string, AirProfile> atmospheres_;
};

}  // namespace photic::optics
