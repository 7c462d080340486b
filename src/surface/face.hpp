// The face between air and water: bare, or under a film of oil (optics/film.hpp).
#pragma once

#include "core/flatten.hpp"
#include "medium/medium.hpp"
#include "optics/film.hpp"
#include "optics/fresnel.hpp"

namespace photic::surface {

/// For unpolarised light of one line.
template <class T>
struct Face {
  bool oily = false;
  optics::Film<T> film;  ///< if it is

  /// Shares of light in medium 1 that comes to it, for the cosines to its normal in both media: c2
  /// is 0 in total reflection.
  [[nodiscard]] optics::FilmShares<T> shares(const T& n1, const T& n2, const T& c1,
                                             const T& c2) const {
    if (oily) [[unlikely]]
      return of_film(film, n1, n2, c1, c2);
    const T reflectance = optics::fresnel_reflectance(n1, n2, c1, c2);
    return {reflectance, T(1) - reflectance};
  }

 private:
  PHOTIC_APART static optics::FilmShares<T> of_film(optics::Film<T> film, T n1, T n2, T c1, T c2) {
    return optics::film_shares(film, n1, n2, c1, c2);
  }
};
template <class T>
Face<T> face_of(const medium::MediumView& sea, const Index<T>& line) {
  if (!sea.surface.absorbs) return {};
  return {true, {gather<T>(sea.film.index, line), gather<T>(sea.film.optical_thickness, line)}};
}

/// Light in medium 1 that comes to a face.
template <class T>
struct Crossing {
  T cos_transmitted{};  ///< to the normal; 0 in total reflection
  T reflectance{}, transmittance{};
};
/// Under a cosine to the normal, 0 to 1.
template <class T>
Crossing<T> cross_face(const Face<T>& face, const T& n1, const T& n2, const T& cosine) {
  const auto [c2, bare] = optics::refract(n1, n2, cosine);
  if (!face.oily) return {c2, bare, T(1) - bare};
  const auto [reflectance, transmittance] = face.shares(n1, n2, cosine, c2);
  return {c2, reflectance, transmittance};
}

}  // namespace photic::surface
