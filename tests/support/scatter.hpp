// A scattering whole, as the stages of an event do it one after the other.
#pragma once

#include "transport/scatter.hpp"

namespace photic::test {

template <class T, int capacity>
void scatter(const medium::MediumView& sea, transport::Photon<T>& photon, const Index<T>& phase,
             const Index<T>& lobe, const transport::Targets<T, capacity>& targets,
             const T& directed, const transport::ScatterUniforms<T>& u) {
  const Vec3<T> old = photon.direction;
  photon.direction = transport::turned(
      transport::deflect(sea, photon.layer, old, phase, lobe, targets, directed, u));
  photon.weight =
      photon.weight * transport::true_over_drawn(sea, photon.layer, old, photon.direction, phase,
                                                 lobe, targets, directed);
}

}  // namespace photic::test
