// A rough sea surface: facets at the mean level z = 0, whose slopes have a density, and whitecaps.
//
// Light meets a facet of slopes s with the density p(s) v, v being the facet's area as the light
// sees it over that of the level surface below it. Nothing is taken off for facets that hide one
// another at the first that light meets; this keeps reciprocity, and light that comes in flat gains
// Smith's function, which is 1e-7 at 60 degrees and 3 % at 80, at 5 m/s.
#pragma once

#include <cmath>

#include "core/constants.hpp"
#include "core/elementary.hpp"
#include "core/turn.hpp"
#include "core/vec3.hpp"
#include "medium/medium.hpp"
#include "medium/waves.hpp"
#include "surface/face.hpp"
#include "surface/film_crossing.hpp"
#include "surface/interface.hpp"
#include "surface/lambert.hpp"

namespace photic::surface {

using medium::WavesView;

/// The rise of a facet per metre towards where the wind comes from, and at right angles to that.
template <class T>
struct Slope {
  T upwind{}, crosswind{};
};

/// A facet as light meets it.
template <class T>
struct Facet {
  Slope<T> slope;
  Vec3<T> normal;  ///< upwards, a unit vector
};
template <class T>
Facet<T> facet_of(const WavesView& waves, const Slope<T>& slope) {
  using std::sqrt;
  const T x = T(waves.upwind_x), y = T(waves.upwind_y);
  const T z = T(1) / sqrt(T(1) + slope.upwind * slope.upwind + slope.crosswind * slope.crosswind);
  return {slope,
          {-z * (slope.upwind * x - slope.crosswind * y),
           -z * (slope.upwind * y + slope.crosswind * x), z}};
}
/// The slopes of a plane across a vector whose z is not 0.
template <class T>
Slope<T> slope_across(const WavesView& waves, const Vec3<T>& vector) {
  const T x = T(waves.upwind_x), y = T(waves.upwind_y);
  const T per_z = T(-1) / vector.z;
  return {per_z * (vector.x * x + vector.y * y), per_z * (vector.y * x - vector.x * y)};
}

/// Slopes of a Gaussian so many times as wide as the waves', from two uniforms.
template <class T>
Slope<T> sample_slope(const WavesView& waves, const T& u1, const T& u2) {
  using std::sqrt;
  const T radius = sqrt(T(2) * minus_log(u1));
  const auto [cosine, sine] = cos_sin_of_turns(u2);
  return {T(waves.upwind_deviation) * radius * cosine,
          T(waves.crosswind_deviation) * radius * sine};
}
/// The density of slopes over the Gaussian's; at least 0.
template <class T>
T series(const WavesView& waves, const Slope<T>& slope) {
  if (waves.one_dimensional) return T(1);
  const T up = slope.upwind * T(1 / waves.upwind_deviation);
  const T across = slope.crosswind * T(1 / waves.crosswind_deviation);
  const T value = waves.series(across, up);
  return T(waves.per_norm) * select(value > T(0), value, T(0));
}
/// The Gaussian's density, of two dimensions [1].
template <class T>
T gaussian(const WavesView& waves, const Slope<T>& slope) {
  const T up = slope.upwind * T(1 / waves.upwind_deviation);
  const T across = slope.crosswind * T(1 / waves.crosswind_deviation);
  return T(1 / (2 * pi * waves.upwind_deviation * waves.crosswind_deviation)) *
         exp_minus(T(0.5) * (up * up + across * across));
}
/// The Gaussian of one dimension: along the wind, or else across it [1].
template <class T>
T gaussian_along(double deviation, const T& slope) {
  const T x = slope * T(1 / deviation);
  return T(1 / (deviation * std::sqrt(2 * pi))) * exp_minus(T(0.5) * (x * x));
}
template <class T>
T slope_density(const WavesView& waves, const Slope<T>& slope) {
  return gaussian(waves, slope) * series(waves, slope);
}

/// A facet's area as light of a direction sees it, over that of the level below it; no light meets
/// facets where it is not above 0.
template <class T>
T visibility(const Vec3<T>& direction, const Facet<T>& facet) {
  return dot(direction, facet.normal) / (direction.z * facet.normal.z);
}

/// The components along the wind and across it of those along x and y.
template <class T>
Slope<T> by_wind(const WavesView& waves, const T& along_x, const T& along_y) {
  const T x = T(waves.upwind_x), y = T(waves.upwind_y);
  return {along_x * x + along_y * y, along_y * x - along_x * y};
}

/// Smith's function of a direction: by how much its light meets more facets than there are (Smith
/// 1967, IEEE Trans. Antennas Propag. 15, 668). `spread`: the deviation of slopes that way, times
/// the direction's level part; `cosine`: to the vertical. The complementary error function is
/// Abramowitz & Stegun's 7.1.26, to 1.5e-7.
template <class T>
T smith_of(const T& spread, const T& cosine) {
  using std::sqrt;
  const T twice = T(std::sqrt(2.0)) * spread;
  const Mask<T> level = twice > T(1e-3) * cosine;
  const T a = cosine / select(level, twice, T(1));
  const T t = T(1) / (T(1) + T(0.3275911) * a);
  const T erfc_over_exp =
      t *
      (T(0.254829592) +
       t * (T(-0.284496736) + t * (T(1.421413741) + t * (T(-1.453152027) + t * T(1.061405429)))));
  const T tiny = T(1e-30);
  const T value =
      T(0.5) * exp_minus(a * a) * (T(1 / 1.7724538509055160273) / (a + tiny) - erfc_over_exp);
  return select(level & (value > T(0)), value, T(0));
}
/// The deviation of slopes along a direction, times its level part, and its parts along the wind
/// and across it.
template <class T>
struct SpreadAlong {
  T up, aside, all;
};
template <class T>
SpreadAlong<T> spread_along(const WavesView& waves, const Vec3<T>& direction) {
  using std::sqrt;
  const auto [along, across] = by_wind(waves, direction.x, direction.y);
  const T up = T(waves.upwind_deviation) * along, aside = T(waves.crosswind_deviation) * across;
  return {up, aside, sqrt(up * up + aside * aside)};
}
template <class T>
T smith(const WavesView& waves, const Vec3<T>& direction) {
  using std::abs;
  return smith_of(spread_along(waves, direction).all, T(abs(direction.z)));
}

/// The mean visibility of the facets that light of a direction meets: 1 + Smith's function, and
/// what Cox & Munk's series adds to that of a Gaussian (docs/theory.md, eq. 109). A share of 6e-4
/// of the density at 15 m/s, where the series is below 0, is left out.
template <class T>
T mean_visibility(const WavesView& waves, const Vec3<T>& direction) {
  using std::abs;
  const auto [up, aside, spread] = spread_along(waves, direction);
  const T mean = T(1) + smith_of(spread, T(abs(direction.z)));
  if (waves.one_dimensional) return mean;
  // Slopes along the light's level direction, over their deviation: their third and fourth
  // cumulants, and the least one whose facets it cannot see.
  const Mask<T> steep = spread > T(1e-3) * abs(direction.z);
  const T per_spread = T(1) / select(steep, spread, T(1));
  const T sign = select(direction.z < T(0), T(-1), T(1));
  const T eta = sign * up * per_spread, xi = aside * per_spread;
  const T eta2 = eta * eta, xi2 = xi * xi;
  const auto& [c21, c03, c40, c22, c04] = waves.series;
  const T third = T(0) - eta * (T(c03) * eta2 + T(3 * c21) * xi2);
  const T fourth = T(c04) * (eta2 * eta2) + T(6 * c22) * (eta2 * xi2) + T(c40) * (xi2 * xi2);
  const T last = abs(direction.z) * per_spread;
  const T density = T(0.3989422804014327) * exp_minus(T(0.5) * (last * last));
  const T more = density * (third * T(1.0 / 6) +
                            fourth * T(1.0 / 24) * (last - T(1) / select(steep, last, T(1))));
  return mean + select(steep, more, T(0));
}

/// Two ways that light may go on from a facet, from medium 1 to 2, of index n1 and n2.
template <class T>
Split<T> meet_facet(const Face<T>& face, const T& n1, const T& n2, const Vec3<T>& direction,
                    const Facet<T>& facet) {
  const T along = dot(direction, facet.normal);
  const T cosine = select(along < T(0), -along, along);
  const T ratio = n1 / n2;
  const auto [cos_transmitted, reflectance, transmittance] = cross_face(face, n1, n2, cosine);
  const T signed_cosine = select(along < T(0), T(-cos_transmitted), cos_transmitted);
  return {direction - (T(2) * along) * facet.normal,
          ratio * direction + (signed_cosine - ratio * along) * facet.normal, reflectance,
          transmittance};
}

/// The facets that lead light of one direction on in another one.
template <class T>
struct Leading {
  Slope<T> slope{};  ///< theirs
  Vec3<T> along{};   ///< their normal, up or down, so long as n2 k2 - n1 k1
  /// The share of the light on a level area that goes there, per solid angle, over the density of
  /// slopes [1/sr]; 0 where no facet does it.
  T per_density{};
};
/// From direction k1 to k2, on the same side (Walter et al. 2007, Eurographics Symposium on
/// Rendering, eq. 20, times the cosine of k2 to the vertical).
template <class T>
Leading<T> reflecting(const WavesView& waves, const Face<T>& face, const T& n1, const T& n2,
                      const Vec3<T>& k1, const Vec3<T>& k2) {
  using std::abs;
  Leading<T> out;
  const Vec3<T>& h = out.along = k2 - k1;
  const Mask<T> faces = k1.z * h.z < T(0);
  out.slope = slope_across(waves, Vec3<T>{h.x, h.y, select(faces, h.z, T(1))});
  const Facet<T> facet = facet_of(waves, out.slope);
  const T cosine = abs(dot(k2, facet.normal));
  const T v = visibility(k1, facet);
  const T nz = facet.normal.z;
  const T value = v * cross_face(face, n1, n2, cosine).reflectance /
                  (T(4) * select(cosine > T(0), cosine, T(1)) * nz * nz * nz);
  out.per_density = select(faces & (v > T(0)) & (cosine > T(0)), value, T(0));
  return out;
}
/// Through them (eq. 21 there).
template <class T>
Leading<T> transmitting(const WavesView& waves, const Face<T>& face, const T& n1, const T& n2,
                        const Vec3<T>& k1, const Vec3<T>& k2) {
  using std::abs;
  Leading<T> out;
  const Vec3<T>& h = out.along = n2 * k2 - n1 * k1;
  const T square = dot(h, h);
  const Mask<T> has_slope = abs(h.z) > T(0);
  out.slope = slope_across(waves, Vec3<T>{h.x, h.y, select(has_slope, h.z, T(1))});
  const Facet<T> facet = facet_of(waves, out.slope);
  const T cos1 = dot(k1, facet.normal), cos2 = dot(k2, facet.normal);
  const T v = visibility(k1, facet);
  const Mask<T> passes = has_slope & (cos1 * cos2 > T(0)) & (v > T(0));
  const T nz = facet.normal.z;
  const T through = face.shares(n1, n2, T(abs(cos1)), T(abs(cos2))).transmittance;
  const T value = v * through * n2 * n2 * abs(cos2) / (select(passes, square, T(1)) * nz * nz * nz);
  out.per_density = select(passes, value, T(0));
  return out;
}

/// Whitecaps: they reflect light, and let pass the rest, evenly to all sides.
template <class T>
struct Whitecaps {
  T fraction{};                    ///< of the surface
  T from_above{1}, from_below{1};  ///< the share that they reflect
};
template <class T>
Whitecaps<T> whitecaps(const WavesView& waves, const Index<T>& line, const T& inverse_n) {
  if (waves.whitecap_fraction == 0) return {};
  const T above = gather<T>(waves.whitecap_reflectance, line);
  return {T(waves.whitecap_fraction), above, T(1) - (T(1) - above) * (inverse_n * inverse_n)};
}

/// The surface for light of a line.
template <class T>
struct RoughSurface {
  const WavesView& waves;
  T n;  ///< index of the water against the air's
  Whitecaps<T> white;
  Face<T> face{};
  Index<T> line{};

  /// The facets that lead light on. `outside`: light that comes from there, and goes down; the rest
  /// rises from the water. `reflected`: true if k2 leads back there.
  [[nodiscard]] Leading<T> facets(const Mask<T>& outside, bool reflected, const Vec3<T>& k1,
                                  const Vec3<T>& k2) const {
    const T n1 = select(outside, T(1), n), n2 = select(outside, n, T(1));
    auto out = reflected ? reflecting(waves, face, n1, n2, k1, k2)
                         : transmitting(waves, face, n1, n2, k1, k2);
    out.per_density = out.per_density * (T(1) - white.fraction);
    return out;
  }
  /// The share of the light on a level area that whitecaps send in a direction [1/sr].
  [[nodiscard]] T by_whitecaps(const Mask<T>& outside, bool reflected, const Vec3<T>& k2) const {
    using std::abs;
    const T back = select(outside, white.from_above, white.from_below);
    return white.fraction * (reflected ? back : T(1) - back) * abs(k2.z) * T(1 / pi);
  }
  /// The same of facets and whitecaps together, of waves in two dimensions.
  [[nodiscard]] T density(const Mask<T>& outside, bool reflected, const Vec3<T>& k1,
                          const Vec3<T>& k2) const {
    const auto by = facets(outside, reflected, k1, k2);
    const T value = by.per_density * slope_density(waves, by.slope);
    return waves.whitecap_fraction == 0 ? value : value + by_whitecaps(outside, reflected, k2);
  }
};
/// Light that has met the surface once.
template <class T>
struct FacetHit {
  Slope<T> slope{};      ///< of the facet
  T by_whitecaps{};      ///< share of the light that whitecaps have sent, 0 to 1
  Vec3<T> between{};     ///< in which direction it goes on to another facet; 0: it does not
  FilmCrossing<T> film;  ///< on the facet
};
/// Light of a direction that has come to a facet's film, from the air or from the water, and gone
/// on in another one.
template <class T>
FilmCrossing<T> film_crossing(const Index<T>& line, const Mask<T>& outside, const Mask<T>& passes,
                              const Vec3<T>& k1, const Vec3<T>& k2, const Vec3<T>& normal) {
  using std::abs;
  const auto way = [](std::int32_t which) { return Index<T>(which); };
  const Vec3<T> in_water = select(passes & outside, k2, k1);
  return {line,
          select(passes, way(medium::through_film),
                 select(outside, way(medium::back_into_air), way(medium::back_into_water))),
          T(abs(dot(in_water, normal)))};
}
/// The meeting of light from direction k1 to k2 with a facet.
template <class T>
FacetHit<T> meeting_with(const RoughSurface<T>& surface, const Slope<T>& slope,
                         const Mask<T>& outside, const Mask<T>& passes, const Vec3<T>& k1,
                         const Vec3<T>& k2) {
  FacetHit<T> out{slope, T(0), {}, {}};
  if (surface.face.oily)
    out.film =
        film_crossing(surface.line, outside, passes, k1, k2, facet_of(surface.waves, slope).normal);
  return out;
}
/// The meeting with a facet of a normal, of light that its film emits.
template <class T>
FacetHit<T> meeting_by_emission(const WavesView& waves, const Vec3<T>& normal) {
  return {slope_across(waves, normal), T(0), {}, {}};
}
/// The meeting with the surface, as density() weighs facets and whitecaps; of waves of one
/// direction with their facets alone.
template <class T>
FacetHit<T> meeting_of(const RoughSurface<T>& surface, const Mask<T>& outside, bool reflected,
                       const Vec3<T>& k1, const Vec3<T>& k2) {
  const auto by = surface.facets(outside, reflected, k1, k2);
  auto out = meeting_with(surface, by.slope, outside, Mask<T>(!reflected), k1, k2);
  if (surface.waves.one_dimensional || surface.waves.whitecap_fraction == 0) return out;
  const T white = surface.by_whitecaps(outside, reflected, k2);
  const T all = white + by.per_density * slope_density(surface.waves, by.slope);
  out.by_whitecaps = white / select(all > T(0), all, T(1));
  return out;
}

template <class T>
RoughSurface<T> rough_surface(const medium::MediumView& sea, const Index<T>& line) {
  return {sea.waves, gather<T>(sea.index, line),
          whitecaps<T>(sea.waves, line, gather<T>(sea.inverse_index, line)), face_of<T>(sea, line),
          line};
}

}  // namespace photic::surface
