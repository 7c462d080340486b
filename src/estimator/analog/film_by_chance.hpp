// An analog photon in a flat film of oil: refracted, reflected to and fro, absorbed where chance
// has it, and perhaps emitted anew. The closed forms of optics/film.hpp happen here step by step,
// in one of two polarisations drawn by lot.
#pragma once

#include <cstdint>

#include "core/random.hpp"
#include "core/turn.hpp"
#include "estimator/random_blocks.hpp"
#include "surface/oil.hpp"
#include "transport/photon.hpp"

namespace photic::estimator {

/// The fate of photons.
template <class T>
struct AfterFilm {
  Mask<T> up{},
      down{};  ///< photons that leave it into the air, and into the water; the others are absorbed
  Mask<T> emitted{};  ///< those of them that were absorbed in it before
};

/// In the film.
template <class T>
struct InFilm {
  Mask<T> inside{};
  T depth{};               ///< 0 at the air, 1 at the water
  Mask<T> sinks{};         ///< true if it goes down
  T cosine{};              ///< to the vertical
  T along_x{}, along_y{};  ///< level part of the direction, times the index
  Mask<T> s{};             ///< polarised across the plane of incidence; the others in it
};

template <class T>
T by_lot(const optics::ByPolarisation<T>& r, const Mask<T>& s) {
  return select(s, r.s, r.p);
}

/// Has photons of a mask come to a film from the outside or from the inside: they are reflected, or
/// are in it.
template <class T>
InFilm<T> enter_film(const medium::MediumView& sea, const std::array<T, 4>& u, const Mask<T>& mask,
                     bool from_outside, transport::Photon<T>& photon, AfterFilm<T>& out) {
  using std::abs;
  InFilm<T> at;
  const auto film = surface::film_on_water<T>(sea, photon.line);
  const T n1 = from_outside ? T(1) : film.water;
  const T outside = abs(photon.direction.z);
  at.cosine = optics::cosine_in_film(film.film.index, n1, outside);
  at.s = u[0] < T(0.5);
  const auto r = optics::fresnel_reflectances(n1, film.film.index, outside, at.cosine);
  const Mask<T> reflected = mask & (u[1] < by_lot(r, at.s));
  (from_outside ? out.up : out.down) = reflected;
  at.inside = mask & !reflected;
  at.depth = T(from_outside ? 0 : 1);
  at.sinks = Mask<T>(from_outside);
  at.along_x = n1 * photon.direction.x;
  at.along_y = n1 * photon.direction.y;
  photon.direction.z = select(reflected, T(0) - photon.direction.z, photon.direction.z);
  return at;
}

/// Takes photons in a film to a face, or to where they are absorbed. Returns which are.
template <class T>
Mask<T> cross_film(const optics::FilmOnWater<T>& film, const T& u, InFilm<T>& at) {
  const T to_face = select(at.sinks, T(1) - at.depth, at.depth);
  const T free = minus_log(u) * at.cosine /
                 select(film.film.optical_thickness > T(0), film.film.optical_thickness, T(1e-30));
  const Mask<T> absorbed = at.inside & (free < to_face);
  at.depth = select(absorbed, at.depth + select(at.sinks, free, T(0) - free),
                    select(at.sinks, T(1), T(0)));
  return absorbed;
}

/// Has photons of a mask leave a film by the face that they have come to, or turn back there.
template <class T>
void leave_film(const optics::FilmOnWater<T>& film, const T& u, const Mask<T>& arrives,
                InFilm<T>& at, transport::Photon<T>& photon, AfterFilm<T>& out) {
  const T n2 = select(at.sinks, film.water, T(1));
  const T outside = optics::cosine_in_film(n2, film.film.index, at.cosine);
  const auto r = optics::fresnel_reflectances(film.film.index, n2, at.cosine, outside);
  const Mask<T> leaves = arrives & (u >= by_lot(r, at.s));
  const Vec3<T> direction{at.along_x / n2, at.along_y / n2,
                          select(at.sinks, T(0) - outside, outside)};
  photon.direction = select(leaves, direction, photon.direction);
  out.up = out.up | (leaves & !at.sinks);
  out.down = out.down | (leaves & at.sinks);
  at.sinks = (at.sinks & !arrives) | (arrives & !at.sinks);
  at.inside = at.inside & !leaves;
}

/// Has a film emit light for absorbed photons of the laser's line, to all sides alike. Returns for
/// which. `lot`: which of them; `u`: the directions and polarisations.
template <class T>
Mask<T> emit_in_film(const medium::MediumView& sea, const Index<T>& spectral_bin,
                     const Mask<T>& absorbed, const T& lot, const std::array<T, 4>& u,
                     InFilm<T>& at, transport::Photon<T>& photon) {
  using std::abs;
  using std::sqrt;
  const Index<T> line = surface::film_line<T>(sea, spectral_bin);
  const Mask<T> shines =
      absorbed & (photon.line == Index<T>(0)) & (lot < gather<T>(sea.film.emission, line));
  const auto [cosine, sine] = cos_sin_of_turns(u[0]);
  const T rise = T(2) * u[1] - T(1);
  const auto own = surface::film_on_water<T>(sea, line);
  const T level = own.film.index * sqrt(T(1) - rise * rise);
  photon.line = select(shines, line, photon.line);
  photon.order = photon.order + select(shines, Index<T>(1), Index<T>(0));
  at.along_x = select(shines, level * cosine, at.along_x);
  at.along_y = select(shines, level * sine, at.along_y);
  at.cosine = select(shines, abs(rise), at.cosine);
  at.sinks = (at.sinks & !shines) | (shines & (rise < T(0)));
  at.s = (at.s & !shines) | (shines & (u[2] < T(0.5)));
  return shines;
}

/// Has photons of a mask come to a film from the outside or from the inside, and follows them until
/// they leave it or are absorbed. `facet`: its number in the event.
template <class T>
AfterFilm<T> film_by_chance(const medium::MediumView& sea, const RandomPlace<T>& place,
                            const Index<T>& spectral_bin, const Mask<T>& mask, bool from_outside,
                            transport::Photon<T>& photon, std::uint32_t facet = 0) {
  AfterFilm<T> out;
  const std::uint32_t first = 2 * max_film_steps * facet;
  InFilm<T> at =
      enter_film(sea, uniforms(place, film_step_blocks[first]), mask, from_outside, photon, out);
  for (std::uint32_t step = 1; step < max_film_steps && any(at.inside); ++step) {
    const auto u = uniforms(place, film_step_blocks[first + 2 * step]);
    const auto film = surface::film_on_water<T>(sea, photon.line);
    const Mask<T> absorbed = cross_film(film, u[0], at);
    leave_film(film, u[1], at.inside & !absorbed, at, photon, out);
    if (!any(absorbed)) continue;
    Mask<T> shines(false);
    if (sea.surface.emits)
      shines = emit_in_film(sea, spectral_bin, absorbed, u[2],
                            uniforms(place, film_step_blocks[first + 2 * step + 1]), at, photon);
    out.emitted = out.emitted | shines;
    at.inside = at.inside & (shines | !absorbed);
  }
  return out;
}

}  // namespace photic::estimator
