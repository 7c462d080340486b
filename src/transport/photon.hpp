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
  Index<T> layer{};    ///< in the water
  Index<T> order{};    ///< scatterings and conversions so far

  /// Calls f(member) for each.
  template <class F>
  constexpr void each_member(F f) {
    each_member_of(f, *this);
  }
  friend Photon select(const Mask<T>& mask, const Photon& yes, const Photon& no) {
    Photon out;
    each_member_of(
        [&mask](auto& member, const auto& a, const auto& b) { member = select(mask, a, b); }, out,
        yes, no);
    return out;
  }

 private:
  /// Calls f(the member of each photon) for each member.
  template <class F, class... Photons>
  static constexpr void each_member_of(F f, Photons&... p) {
    f(p.position.x...), f(p.position.y...), f(p.position.z...);
    f(p.direction.x...), f(p.direction.y...), f(p.direction.z...);
    f(p.weight...), f(p.analog_weight...), f(p.path...);
    f(p.line...), f(p.layer...), f(p.order...);
  }
};

}  // namespace photic::transport
