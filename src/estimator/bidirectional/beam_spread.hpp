// The spread of a walk's light on the way from its instrument.
#pragma once

#include "geometry/crossing.hpp"
#include "medium/medium.hpp"

namespace photic::estimator {

/// The spread of a walk's light from its instrument: from a point, in directions that are drawn
/// with the density 1 / solid_angle.
template <class T>
struct Spread {
  bool through_surface = false;
  T before{};       ///< length from that point to where the ray in the water begins [m]
  T cos_air{1};     ///< of the ray in the air, to the vertical
  T solid_angle{};  ///< [sr]; 0: parallel rays, which no connection can meet
  T freed{1};       ///< share of connections to the instrument that free walks make as well; not
                    ///< kept

  template <class F>
  constexpr void each_member(F f) {
    f(before), f(cos_air), f(solid_angle);
  }
};

/// Area across the ray in the water per solid angle at the instrument's point [m^2/sr].
template <class T>
T area_per_solid_angle(const medium::MediumView& sea, const Spread<T>& spread, const Index<T>& line,
                       const T& length, const T& cos_water) {
  if (!spread.through_surface) {
    const T whole = spread.before + length;
    return whole * whole;
  }
  const T inverse_n = gather<T>(sea.inverse_index, line);
  const geometry::Widening<T> widening{cos_water / spread.cos_air, spread.cos_air / cos_water};
  return geometry::refracted_area_per_solid_angle(inverse_n, length, spread.before, widening);
}

}  // namespace photic::estimator
