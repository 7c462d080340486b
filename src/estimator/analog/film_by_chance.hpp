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

/// Has photons of a mask come to a film from the air or from the water.
template <class T>
AfterFilm<T> film_by_chance(const medium::MediumView& sea, const RandomPlace<T>& place,
                            const Index<T>& spectral_bin, const Mask<T>& mask, bool in_air,
                            transport::Photon<T>& photon) {
  using std::abs;
  AfterFilm<T> out;
  InFilm<T> at;
  auto u = uniforms(place, film_step_blocks[0]);
  {
    const auto film = surface::film_on_water<T>(sea, photon.line);
    const T n1 = in_air ? T(1) : film.water;
    const T outside = abs(photon.direction.z);
    at.cosine = optics::cosine_in_film(film.film.index, n1, outside);
    at.s = u[0] < T(0.5);
    const auto r = optics::fresnel_reflectances(n1, film.film.index, outside, at.cosine);
    const Mask<T> reflected = mask & (u[1] < by_lot(r, at.s));
    (in_air ? out.up : out.down) = reflected;
    at.inside = mask & !reflected;
    at.depth = T(in_air ? 0 : 1);
    at.sinks = Mask<T>(in_air);
    at.along_x = n1 * photon.direction.x;
    at.along_y = n1 * photon.direction.y;
    photon.direction.z = select(reflected, T(0) - photon.direction.z, photon.direction.z);
  }
  for (std::uint32_t step = 1; step < max_film_steps && any(at.inside); ++step) {
    u = uniforms(place, film_step_blocks[2 * step]);
    const auto v = uniforms(place, film_step_blocks[2 * step + 1]);
    const auto film = surface::film_on_water<T>(sea, photon.line);
    // To a face, or to where it is absorbed.
    const T to_face = select(at.sinks, T(1) - at.depth, at.depth);
    const T free =
        minus_log(u[0]) * at.cosine /
        select(film.film.optical_thickness > T(0), film.film.optical_thickness, T(1e-30));
    const Mask<T> absorbed = at.inside & (free < to_face);
    at.depth = select(absorbed, at.depth + select(at.sinks, free, T(0) - free),
                      select(at.sinks, T(1), T(0)));
    // At the face.
    const T n2 = select(at.sinks, film.water, T(1));
    const T outside = optics::cosine_in_film(n2, film.film.index, at.cosine);
    const auto r = optics::fresnel_reflectances(film.film.index, n2, at.cosine, outside);
    const Mask<T> arrives = at.inside & !absorbed;
    const Mask<T> leaves = arrives & (u[1] >= by_lot(r, at.s));
    const Vec3<T> direction{at.along_x / n2, at.along_y / n2,
                            select(at.sinks, T(0) - outside, outside)};
    photon.direction = select(leaves, direction, photon.direction);
    out.up = out.up | (leaves & !at.sinks);
    out.down = out.down | (leaves & at.sinks);
    at.sinks = (at.sinks & !arrives) | (arrives & !at.sinks);
    at.inside = at.inside & !leaves;
    // The place of its absorption.
    if (!any(absorbed)) continue;
    Mask<T> shines(false);
    if (sea.surface.emits) {
      const Index<T> line = surface::film_line<T>(sea, spectral_bin);
      shines =
          absorbed & (photon.line == Index<T>(0)) & (u[2] < gather<T>(sea.film.emission, line));
      using std::sqrt;
      const auto [cosine, sine] = cos_sin_of_turns(v[0]);
      const T rise = T(2) * v[1] - T(1);
      const auto own = surface::film_on_water<T>(sea, line);
      const T level = own.film.index * sqrt(T(1) - rise * rise);
      photon.line = select(shines, line, photon.line);
      photon.order = photon.order + select(shines, Index<T>(1), Index<T>(0));
      at.along_x = select(shines, level * cosine, at.along_x);
      at.along_y = select(shines, level * sine, at.along_y);
      at.cosine = select(shines, abs(rise), at.cosine);
      at.sinks = (at.sinks & !shines) | (shines & (rise < T(0)));
      at.s = (at.s & !shines) | (shines & (v[2] < T(0.5)));
      out.emitted = out.emitted | shines;
    }
    at.inside = at.inside & (shines | !absorbed);
  }
  return out;
}

}  // namespace photic::estimator
