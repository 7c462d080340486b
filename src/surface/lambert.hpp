// The sea bed: light that it reflects leaves it evenly, as Lambert's law has it (the paper's
// "isotropic reflection for the normal component"). It absorbs the rest.
//
// Its albedo may depend on the zenith angle of the light that comes to it. So it is not reciprocal:
// the angle on the laser's side counts, whichever way a walk goes.
#pragma once

#include <cmath>

#include "core/constants.hpp"
#include "core/vec3.hpp"
#include "medium/medium.hpp"

namespace photic::surface {

/// Returns which of these places are on a bed that reflects.
template <class T>
Mask<T> on_bed(const medium::MediumView& sea, const Index<T>& layer) {
  return layer >= Index<T>(sea.layers);
}

/// An albedo that depends on the angle stands at even steps of sqrt(1 - cos), of 0 to 90 degrees.
/// The place of an angle among those of the table: between two of them, so far from the first.
template <class T>
struct BedAngle {
  Index<T> first{};
  T rest{};
};
/// `cosine`: to the vertical, 0 to 1.
template <class T>
BedAngle<T> bed_angle(const medium::MediumView& sea, const T& cosine) {
  using std::sqrt;
  if (sea.bed_angles < 2) return {};
  const Index<T> last(sea.bed_angles - 2);
  const T x = T(1) - cosine;
  const T place = T(static_cast<double>(sea.bed_angles - 1)) * sqrt(select(x > T(0), x, T(0)));
  const Index<T> first = floor_index(place);
  const Index<T> inside = select(first < last, first, last);
  return {inside, place - to_real<T>(inside)};
}

/// The share of light of a line that it reflects, coming under a cosine to the vertical; in the
/// column of a place.
template <class T>
T bed_albedo(const medium::MediumView& sea, const Index<T>& line, const Index<T>& place,
             const T& cosine) {
  const Index<T> row = sea.template bed_row<T>(line, place);
  if (sea.bed_angles < 2) return gather<T>(sea.bed_albedo, row);
  const auto [first, rest] = bed_angle(sea, cosine);
  const T below = gather<T>(sea.bed_albedo, row + first);
  return below + rest * (gather<T>(sea.bed_albedo, row + first + Index<T>(1)) - below);
}

/// Density of directions that leave a horizontal plane evenly, and 1 - cos to the vertical of one
/// from a uniform [1/sr].
template <class T>
T lambert_density(const Vec3<T>& direction) {
  return select(direction.z > T(0), direction.z, T(0)) * T(1 / pi);
}
template <class T>
T lambert_one_minus_cos(const T& u) {
  using std::sqrt;
  return T(1) - sqrt(T(1) - u);
}

}  // namespace photic::surface
