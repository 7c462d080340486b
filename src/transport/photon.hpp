// The state of a photon on its walk.
#pragma once

#include "core/vec3.hpp"

namespace photic::transport {

template <class T>
struct Photon {
  Vec3<T> position;    ///< [m]; z up, the sea level is 0
  Vec3<T> direction;   ///< unit vector of propagation
  T weight{1};         ///< photons it stands for, per photon emitted
  T analog_weight{1};  ///< the weight of a plain walk (albedo^k): what Russian roulette looks at
  T path{};            ///< sum of length times group index since the laser's disc [m]
  Index<T> line{};     ///< wavelength, a line of the medium
  Index<T> layer{};    ///< where it is in the water
  Index<T> order{};    ///< scatterings and conversions so far
};

}  // namespace photic::transport
