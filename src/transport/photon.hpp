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
  T path{};            ///< sum of length times group index since its start: for a laser's light,
                       ///< that of the axis less (instrument/laser.hpp) [m]
  Index<T> line{};     ///< wavelength, a line of the medium
  Index<T> layer{};    ///< where it is in the water
  Index<T> order{};    ///< scatterings and conversions so far

  friend Photon select(const Mask<T>& mask, const Photon& yes, const Photon& no) {
    return {select<T>(mask, yes.position, no.position),
            select<T>(mask, yes.direction, no.direction),
            select(mask, yes.weight, no.weight),
            select(mask, yes.analog_weight, no.analog_weight),
            select(mask, yes.path, no.path),
            select(mask, yes.line, no.line),
            select(mask, yes.layer, no.layer),
            select(mask, yes.order, no.order)};
  }
};

}  // namespace photic::transport
