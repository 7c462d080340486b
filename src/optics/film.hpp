// A film between two media: what it makes of light, with multiple reflection, absorption and
// fluorescence (docs/theory.md, "The oil film").
//
// Light is added by its flux and not by its field: interference is left out. In films of 0.1 to 10
// um it makes the reflectance swing with the thickness, which varies by more than a period over a
// footprint; these are the means.
// Source: Born & Wolf, Principles of Optics, 7th ed., section 7.6.1, summed over fluxes.
#pragma once

#include <cmath>

#include "core/constants.hpp"
#include "core/elementary.hpp"
#include "core/lanes.hpp"
#include "optics/fresnel.hpp"

namespace photic::optics {

/// For light of one wavelength.
template <class T>
struct Film {
  T index{1};             ///< against air
  T optical_thickness{};  ///< straight through it: absorption times thickness
};

/// Shares of unpolarised light; the rest is absorbed.
template <class T>
struct FilmShares {
  T reflectance{}, transmittance{};
};

/// The cosine to the normal of light in a film that has one outside of it, in a medium of index n.
/// 0 where none passes.
template <class T>
T cosine_in_film(const T& film_index, const T& n, const T& cosine) {
  using std::sqrt;
  const T square = (film_index - n) * (film_index + n) + n * n * cosine * cosine;
  return sqrt(select(square > T(0), square, T(0))) / film_index;
}
/// The transmission of light that goes through once.
template <class T>
T optical_path(const Film<T>& film, const T& cosine) {
  const Mask<T> passes = cosine > T(1e-6);
  return select(passes, film.optical_thickness / select(passes, cosine, T(1)), T(1e6));
}

/// Light in medium 1 that meets a film in front of medium 2. The cosines to the normal are those in
/// these media, c2 = 0 in total reflection.
template <class T>
FilmShares<T> film_shares(const Film<T>& film, const T& n1, const T& n2, const T& c1, const T& c2) {
  const T c = cosine_in_film(film.index, n1, c1);
  const auto first = fresnel_reflectances(n1, film.index, c1, c);
  const auto second = fresnel_reflectances(film.index, n2, c, c2);
  const T once = exp_minus(optical_path(film, c));
  const auto shares = [&](const T& r1, const T& r2) {
    const T all = (T(1) - r1) / (T(1) - r1 * r2 * once * once);
    return FilmShares<T>{r1 + (T(1) - r1) * all * r2 * once * once, all * (T(1) - r2) * once};
  };
  const auto s = shares(first.s, second.s), p = shares(first.p, second.p);
  return {T(0.5) * (s.reflectance + p.reflectance), T(0.5) * (s.transmittance + p.transmittance)};
}

/// (1 - exp(-x)) / x for x >= 0, to rounding.
template <class T>
T mean_of_exponential(const T& x) {
  const Mask<T> small = x < T(1);
  const T h = select(small, T(0.5) * x, T(0)), h2 = h * h;  // 2 exp(-h) sinh(h) / x
  const T series =
      T(1) +
      h2 * T(1.0 / 6) *
          (T(1) +
           h2 * T(1.0 / 20) *
               (T(1) + h2 * T(1.0 / 42) *
                           (T(1) + h2 * T(1.0 / 72) *
                                       (T(1) + h2 * T(1.0 / 110) * (T(1) + h2 * T(1.0 / 156))))));
  const T large = (T(1) - exp_minus(x)) / select(small, T(1), x);
  return select(small, exp_minus(h) * series, large);
}

/// A film on water, for light of one wavelength.
template <class T>
struct FilmOnWater {
  Film<T> film;
  T water;  ///< index of the water against air
};

/// The shares of unpolarised light at one face of a film: the share of the light from outside that
/// begins its way through the film there, and the share that comes back from the other face. Light
/// emitted in the film gets out by this face in the same share, straight or by way of the other
/// one.
template <class T>
struct ThroughFace {
  T optical_path{};  ///< through the film once
  T direct{}, by_other_face{};
};
/// `above`: the face to the air, else that to the water; the cosine is that in the medium outside.
template <class T>
ThroughFace<T> through_face(const FilmOnWater<T>& at, bool above, const T& cosine) {
  const T n1 = above ? T(1) : at.water, n2 = above ? at.water : T(1);
  const T& n = at.film.index;
  const T c = cosine_in_film(n, n1, cosine);
  const auto face = fresnel_reflectances(n1, n, cosine, c);
  const auto other = fresnel_reflectances(n, n2, c, cosine_in_film(n2, n, c));
  ThroughFace<T> out;
  out.optical_path = optical_path(at.film, c);
  const T once = exp_minus(out.optical_path);
  const auto direct = [&](const T& r1, const T& r2) {
    return (T(1) - r1) / (T(1) - r1 * r2 * once * once);
  };
  const T s = direct(face.s, other.s), p = direct(face.p, other.p);
  out.direct = T(0.5) * (s + p);
  out.by_other_face = T(0.5) * (s * other.s + p * other.p);
  return out;
}

/// The share of the light that comes to a film that is absorbed and, each photon being emitted
/// again evenly to all sides, gets out by the `same` face or by the other one, per solid angle in
/// the film over 1 / (4 pi).
template <class T>
T absorbed_and_out(const ThroughFace<T>& in, const ThroughFace<T>& out, bool same) {
  using std::abs;
  const T a = in.optical_path, b = out.optical_path;
  // The means over the film of exponentials that fall the same way, and against each other.
  const T along = mean_of_exponential(T(a + b));
  const T least = select(a < b, a, b);
  const T against = exp_minus(least) * mean_of_exponential(T(abs(a - b)));
  const T once_a = exp_minus(a), once_b = exp_minus(b);
  const T straight =
      in.direct * out.direct + in.by_other_face * out.by_other_face * once_a * once_b;
  const T around = in.direct * out.by_other_face * once_b + in.by_other_face * out.direct * once_a;
  return a * (same ? straight * along + around * against : straight * against + around * along);
}

/// The share of light of `from` that comes to a film, is absorbed and, where each photon is emitted
/// again as light of `to`, gets out, per solid angle outside [1/sr]. Cosines to the normal are
/// those outside. Emitted light excites none.
template <class T>
T film_emission(const FilmOnWater<T>& from, bool from_above, const T& cosine_in,
                const FilmOnWater<T>& to, bool to_above, const T& cosine_out) {
  const auto in = through_face(from, from_above, cosine_in);
  const auto out = through_face(to, to_above, cosine_out);
  const T n = to_above ? T(1) : to.water;
  const T& film = to.film.index;
  const T c = cosine_in_film(film, n, cosine_out);
  const Mask<T> passes = (c > T(0)) & (cosine_out > T(0));
  const T solid_angle = n * n * cosine_out / (film * film * select(passes, c, T(1)));
  return select(
      passes, T(0.25 / pi) * solid_angle * absorbed_and_out(in, out, from_above == to_above), T(0));
}

}  // namespace photic::optics
