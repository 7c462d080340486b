// A collision of an analog photon: nothing is weighed, all is decided.
#pragma once

#include "medium/medium.hpp"
#include "transport/photon.hpp"
#include "transport/scatter.hpp"

namespace photic::estimator {

/// Scatters the photons of a mask where they stand, or converts or absorbs them. Returns which go
/// on.
template <class T>
Mask<T> collide_by_chance(const medium::MediumView& sea, transport::Photon<T>& photon,
                          const Index<T>& spectral_bin, const Mask<T>& colliding, const T& u,
                          const T& u_polar, const T& u_azimuth) {
  const Index<T> here = sea.at(photon.line, photon.layer);
  Index<T> phase = gather_index<T>(sea.elastic_phase, here);
  T rest = u - transport::scattered_share(sea, photon.line, photon.layer, T(-photon.direction.z));
  Mask<T> goes_on = rest < T(0);
  const Index<T> count = select(photon.line == Index<T>(0),
                                gather_index<T>(sea.convertible_count, photon.layer), Index<T>(0));
  Index<T> i(0);
  for (Mask<T> left = colliding & (i < count); any(left); left = colliding & (i < count)) {
    const Index<T> line =
        sea.emitted_line<T>(photon.layer, select(left, i, Index<T>(0)), spectral_bin);
    const T share = gather<T>(sea.conversion, sea.at(line, photon.layer));
    const Mask<T> converted = left & !goes_on & (rest < share);
    photon.line = select(converted, line, photon.line);
    phase = select(converted, gather_index<T>(sea.conversion_phase, line), phase);
    goes_on = goes_on | converted;
    rest = rest - share;
    i = i + Index<T>(1);
  }
  photon.order = photon.order + Index<T>(1);
  const transport::Targets<T, 1> none{};
  photon.direction =
      transport::turned(transport::deflect(sea, photon.layer, photon.direction, phase, phase, none,
                                           T(0), {u_polar, u_azimuth, T(0), T(0)}));
  transport::leave_ground(sea, photon);
  photon.layer = sea.layer_of<T>(photon.layer);
  return colliding & goes_on;
}

}  // namespace photic::estimator
