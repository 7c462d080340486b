// The light that a film of oil emits where the laser's light comes to it (optics/film.hpp).
#pragma once

#include <cmath>

#include "core/vec3.hpp"
#include "medium/medium.hpp"
#include "optics/film.hpp"
#include "surface/face.hpp"

namespace photic::surface {

/// The line that light of a spectral_bin is emitted in by the film.
template <class T>
Index<T> film_line(const medium::MediumView& sea, const Index<T>& spectral_bin) {
  return gather_index<T>(sea.line_of_spectral_bin,
                         Index<T>(sea.film.band * medium::spectral_bins) + spectral_bin);
}

/// Returns whether light of a line has been emitted by the film: such a line is of no other
/// process, and light stays in it.
template <class T>
Mask<T> is_film_light(const medium::MediumView& sea, const Index<T>& line) {
  return gather<T>(sea.film.emission, line) > T(0);
}

template <class T>
optics::FilmOnWater<T> film_on_water(const medium::MediumView& sea, const Index<T>& line) {
  return {{gather<T>(sea.film.index, line), gather<T>(sea.film.optical_thickness, line)},
          gather<T>(sea.index, line)};
}

/// Light of the laser's line that comes to a film.
template <class T>
struct AtFilm {
  Mask<T> outside{};  ///< from above; the others from below
  Vec3<T> direction;  ///< in which it comes
  Vec3<T> normal;     ///< of the film, upwards
};
/// The share of it that is emitted in a line into a direction, up into the air or down into the
/// water, per solid angle there [1/sr].
template <class T>
T emitted_by_film(const medium::MediumView& sea, const AtFilm<T>& at, const Index<T>& line,
                  const Vec3<T>& direction, bool up) {
  using std::abs;
  const auto from = film_on_water<T>(sea, Index<T>(0)), to = film_on_water<T>(sea, line);
  const T cosine_in = abs(dot(at.direction, at.normal));
  const T along = dot(direction, at.normal);
  const T cosine_out = up ? along : T(0) - along;
  const auto value = [&](bool from_above) {
    return optics::film_emission(from, from_above, cosine_in, to, up, cosine_out);
  };
  T out(0);
  if (any(at.outside)) out = select(at.outside, value(true), out);
  if (!all(at.outside)) out = select(at.outside, out, value(false));
  return select(cosine_out > T(0), gather<T>(sea.film.emission, line) * out, T(0));
}

}  // namespace photic::surface
