// The flat surface between air and water: Snell's law and Fresnel's equations (surface/face.hpp).
#pragma once

#include "medium/medium.hpp"
#include "surface/face.hpp"
#include "surface/interface.hpp"

namespace photic::surface {

/// The surface z = 0 for unpolarised light of one line.
template <class T>
struct Flat {
  T n, inverse_n;  ///< index of the water against the air's, and 1 over it
  Face<T> face;

  /// The split of light that rises to it, in a direction whose z is >= 0.
  [[nodiscard]] Split<T> from_below(const Vec3<T>& direction) const {
    const auto [cos_air, reflectance, transmittance] = cross_face(face, n, T(1), direction.z);
    return {{direction.x, direction.y, -direction.z},
            {n * direction.x, n * direction.y, cos_air},
            reflectance,
            transmittance};
  }
  /// The split of light that comes down to it, in a direction whose z is <= 0.
  [[nodiscard]] Split<T> from_above(const Vec3<T>& direction) const {
    const auto [cos_water, reflectance, transmittance] = cross_face(face, T(1), n, T(-direction.z));
    return {{direction.x, direction.y, -direction.z},
            {direction.x * inverse_n, direction.y * inverse_n, -cos_water},
            reflectance,
            transmittance};
  }

  /// The share of light rising in the water that it reflects; `cosine`: to the vertical, 0 to 1.
  [[nodiscard]] T reflectance(const T& cosine) const {
    return cross_face(face, n, T(1), cosine).reflectance;
  }
  /// The share that goes through, either way, for the cosines to the vertical on both sides.
  [[nodiscard]] T transmittance(const T& cos_water, const T& cos_air) const {
    return face.shares(n, T(1), cos_water, cos_air).transmittance;
  }
};

/// For light of a line.
template <class T>
Flat<T> flat_surface(const medium::MediumView& sea, const Index<T>& line) {
  return {gather<T>(sea.index, line), gather<T>(sea.inverse_index, line), face_of<T>(sea, line)};
}

}  // namespace photic::surface
