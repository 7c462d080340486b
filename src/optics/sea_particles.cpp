#include "optics/sea_particles.hpp"

#include "optics/spheres.hpp"

namespace photic::optics {

Spheres spheres_in_water(const SeaParticles& particles, double wavelength_nm,
                         double refractive_index) {
  constexpr double metres_per_nm = 1e-9, metres_per_um = 1e-6;
  const Junge sizes{particles.junge_slope, particles.min_radius_um * metres_per_um,
                    particles.max_radius_um * metres_per_um};
  return {wavelength_nm * metres_per_nm / refractive_index, particles.relative_index,
          particles.absorption_index, sizes};
}

}  // namespace photic::optics
