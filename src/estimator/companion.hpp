// A companion of light, besides its weight.
#pragma once

#include "transport/photon.hpp"

namespace photic::estimator {

/// An object that is shown the events of light, photons of a mask at a time: of histories, walks
/// and analog photons alike. Walks begin in the water; how they came there is not shown.
template <class T>
class Companion {
 public:
  using Photon = transport::Photon<T>;

  Companion() = default;
  Companion(const Companion&) = delete;
  Companion& operator=(const Companion&) = delete;
  virtual ~Companion() = default;

  /// They have flown so far in the medium [m], to where they are.
  virtual void flown(const Photon& after, const T& length, const Mask<T>& mask) = 0;
  /// They have collided; `after`: before weights pay for how directions were drawn.
  virtual void collided(const Photon& before, const Photon& after, const Mask<T>& mask) = 0;
  /// They stood at the surface; those that `stay` are in the water.
  virtual void crossed(const Photon& before, const Photon& after, const Mask<T>& mask,
                       const Mask<T>& stay) = 0;
};

}  // namespace photic::estimator
