// Light on its way from an instrument in the air into the water.
#pragma once

#include "transport/cross.hpp"

namespace photic::test {

/// Takes photons through the flat surface. Returns those that get there; the others are left as
/// they are.
template <class T>
Mask<T> enter_water(const medium::MediumView& sea, const geometry::Region<T>& from,
                    transport::Photon<T>& photon) {
  const Mask<T> comes = transport::come_down(from, photon);
  transport::Photon<T> down = photon;
  transport::refract_down(sea, down);
  photon = select(comes, down, photon);
  return comes;
}

}  // namespace photic::test
