// Particles in sea water as spheres with a Junge distribution of sizes, for Mie theory.
#pragma once

namespace photic::optics {

struct Spheres;

struct SeaParticles {
  double relative_index = 0;    ///< n of m = n - ik, relative to water
  double absorption_index = 0;  ///< k
  double junge_slope = 0;       ///< particles per radius go as radius^-slope
  double min_radius_um = 0, max_radius_um = 0;
  friend bool operator==(const SeaParticles&, const SeaParticles&) = default;
};

/// PREMAR-2F's (Barbini et al. 2000), with the indices of Pak, Zaneveld & Beardsley 1971, J.
/// Geophys. Res. 76, 5065. Its Junge exponent c = 4 (Reuter 1980, Oceanol. Acta 3, 317) is of
/// radius^-(c+1).
inline constexpr SeaParticles paper_phytoplankton{1.05, 0.01, 5, 0.01, 1};
inline constexpr SeaParticles paper_minerals{1.15, 0.001, 5, 0.1, 10};

/// In light of a wavelength in air and in water of an index.
Spheres spheres_in_water(const SeaParticles& particles, double wavelength_nm,
                         double refractive_index);

}  // namespace photic::optics
