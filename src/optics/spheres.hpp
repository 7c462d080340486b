// The optics of many spheres of one material: Mie theory integrated over their sizes.
#pragma once

#include <memory>
#include <stop_token>

#include "core/kept.hpp"
#include "optics/legendre.hpp"
#include "optics/phase_table.hpp"
#include "optics/size_distribution.hpp"

namespace photic::optics {

struct Spheres {
  double wavelength_m = 0;      ///< of the light in the medium around: in vacuum over its index
  double index = 0;             ///< n of m = n - ik, relative to the medium
  double absorption_index = 0;  ///< k
  SizeDistribution sizes;
  friend auto operator<=>(const Spheres&, const Spheres&) = default;
};

/// Means over all spheres.
struct SpheresOptics {
  Spheres of;
  double extinction_m2 = 0, scattering_m2 = 0, absorption_m2 = 0;  ///< cross-sections of one
  double mean_cosine = 0;                                          ///< g of what is scattered
  double volume_m3 = 0;                                            ///< of one
  LegendreSeries phase;  ///< p [1/sr], 1 over the sphere; exact between its nodes, too
  double error = 0;      ///< estimated relative error of the worst of cross-sections and p
  int radii = 0;         ///< for how many Mie theory was evaluated
};

/// Means over all spheres without their phase function, which takes nearly all the time.
struct SphereSections {
  double scattering_m2 = 0, absorption_m2 = 0;  ///< cross-sections of one
  double volume_m3 = 0;                         ///< of one
};

/// The integration over sizes goes on until its estimated error is below this; the true one is
/// smaller still. Resonances of large spheres that hardly absorb keep the estimate above.
inline constexpr double spheres_tolerance = 1e-4;

/// Takes as long as the cube of the largest size parameter: a tenth of a second at 100, some ten at
/// 1000, where it ends with what it has reached. Throws ContractViolation for what Mie theory
/// cannot do or for a distribution that is none, and Stopped.
SpheresOptics optics_of_spheres(const Spheres& spheres, const std::stop_token& stop = {});

/// As optics_of_spheres.
SphereSections sections_of_spheres(const Spheres& spheres, const std::stop_token& stop = {});

/// The phase function for a PhaseTable. Throws InputError if it has detail too fine for one, as
/// that of large spheres near 180 degrees may be.
PhaseShape phase_of_spheres(std::shared_ptr<const SpheresOptics> optics);

/// Keeps each kind of spheres, and what their phase function is at the nodes of a table.
class SpheresCache {
 public:
  std::shared_ptr<const SpheresOptics> operator()(const Spheres& spheres,
                                                  const std::stop_token& stop = {}) const;
  SphereSections sections(const Spheres& spheres, const std::stop_token& stop = {}) const;
  /// Throws as phase_of_spheres does.
  std::shared_ptr<const PhaseShape> phase(const Spheres& spheres,
                                          const std::stop_token& stop = {}) const;

 private:
  Kept<Spheres, std::shared_ptr<const SpheresOptics>> known_;
  Kept<Spheres, SphereSections> sections_;
  Kept<Spheres, std::shared_ptr<const PhaseShape>> phase_;
};

}  // namespace photic::optics
