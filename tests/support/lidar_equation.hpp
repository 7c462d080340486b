// The first-order echo by numerical integration of the lidar equation, independent of the transport
// code: rays are refracted by Fermat's principle, solid angles come from finite differences of
// traced rays or from an integral over the lens, overlaps from an integral over the blurred image,
// Fresnel's equations in their angle form.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/vec3.hpp"
#include "scene/scene.hpp"

namespace photic::test {

/// One layer as the equation sees it: from `top` down, attenuation on the way out and on the way
/// back, and the coefficient [1/m] of what turns the light.
struct EquationLayer {
  double top_m, c_out_per_m, c_back_per_m, turning_per_m;
};

struct EquationWater {
  double n_out, n_back;          ///< refractive indices at the laser's and the emitted wavelength
  double group_out, group_back;  ///< group indices
  std::vector<EquationLayer> layers;
  std::function<double(double)> phase;  ///< per steradian, of the cosine of the scattering angle
};

/// Expected photons per photon emitted in every gate of one telescope; gate edges in metres of
/// group path.
std::vector<double> first_order_echo(const scene::Source& source, const scene::Telescope& telescope,
                                     const EquationWater& water,
                                     const std::vector<double>& gate_edges_m);

/// The share of the image of a point at range z (along the axis), off-axis angle psi, that lies on
/// the detector.
double overlap_by_integration(const scene::Telescope& telescope, double z, double tan_psi);

}  // namespace photic::test
