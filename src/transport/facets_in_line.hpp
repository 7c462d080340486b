// Waves of one direction: all facets are level across it, and so light goes on from a point in the
// water to one of a lens by points of a curve alone. A point of that is drawn by how far it lies
// along the waves' direction, from the density of slopes or evenly where the detector sees.
#pragma once

#include "core/random.hpp"
#include "transport/surface_points.hpp"

namespace photic::transport {

/// Along which facets are steep, and across it.
template <class T>
struct WavesAxes {
  Vec3<T> along, across;  ///< level unit vectors
  double deviation;       ///< of slopes
};
template <class T>
WavesAxes<T> axes_of(const surface::WavesView& waves) {
  const Vec3<T> upwind{T(waves.upwind_x), T(waves.upwind_y), T(0)};
  const Vec3<T> crosswind{T(-waves.upwind_y), T(waves.upwind_x), T(0)};
  if (waves.crosswind_deviation == 0) return {upwind, crosswind, waves.upwind_deviation};
  return {crosswind, upwind, waves.crosswind_deviation};
}

/// The span of the surface, along a level direction, where the rays come from that a detector sees
/// through a point of the lens.
template <class T>
struct SeenSpan {
  Mask<T> exists{};
  T from{}, to{};  ///< [m]
};
template <class T>
SeenSpan<T> seen_span(const instrument::Telescope<T>& telescope,
                      const instrument::PlanePoint<T>& lens, const Vec3<T>& along) {
  using std::sqrt;
  // Rays are axis + s.x across + s.y up with s in a disc: their place on the surface is a quotient
  // of linear functions of s, whose extremes are on the rim.
  const auto middle = (T(0) - telescope.per_sharp_range) * lens;
  const T radius = telescope.detector_radius / telescope.detector_distance;
  const Vec3<T> ray = telescope.axis + in_plane(telescope, middle);
  const auto [bx, by] = parts_in_plane(telescope, along);
  const T dx = telescope.across.z, dy = telescope.up.z;
  const T r2 = radius * radius;
  const T level = dot(ray, along);
  const T a = ray.z * ray.z - r2 * (dx * dx + dy * dy);
  const T b = level * ray.z - r2 * (bx * dx + by * dy);
  const T c = level * level - r2 * (bx * bx + by * by);
  const T discriminant = b * b - a * c;
  const Mask<T> leads = telescope.inside ? ray.z > T(0) : ray.z < T(0);
  SeenSpan<T> out;
  out.exists = leads & (a > T(0)) & (discriminant > T(0));
  const T root = sqrt(select(out.exists, discriminant, T(0)));
  const T per_a = T(1) / select(out.exists, a, T(1));
  const Vec3<T> from = in_space(telescope, lens);
  const T middle_at = dot(from, along) - from.z * b * per_a;
  const T half = T(1.01) * root * per_a * (telescope.inside ? T(0) - from.z : from.z);
  out.from = middle_at - half;
  out.to = middle_at + half;
  return out;
}

/// A point by which facets lead light on, and how densely such points are drawn.
template <class T>
struct PointInLine {
  Vec3<T> at;
  T per_metre{};     ///< density of points along the waves' direction [1/m]
  T slope_across{};  ///< by how much facets that lead by a point would have to be steeper across
                     ///< the waves, per metre across [1/m]
};
/// `n1`, `n2`: indices before and behind the surface. `u1`, `u2`: uniforms.
template <class T>
PointInLine<T> point_in_line(const WavesAxes<T>& axes, const NearLevel<T>& level,
                             const instrument::Telescope<T>& telescope,
                             const instrument::PlanePoint<T>& lens, const Vec3<T>& from,
                             const T& n1, const T& n2, const T& u_choice, const T& u1,
                             const T& u2) {
  using std::abs;
  using std::sqrt;
  const auto [cosine, sine] = cos_sin_of_turns(u2);
  const T drawn = T(wider_slopes * axes.deviation) * sqrt(T(2) * minus_log(u1)) * cosine;
  const Vec3<T> per_slope = level.off(axes.along.x, axes.along.y);
  const T spread = T(wider_slopes * axes.deviation) * abs(dot(per_slope, axes.along));
  const auto span = seen_span(telescope, lens, axes.along);
  const T share_even = select(span.exists, T(0.5), T(0));
  const T length = select(span.exists, span.to - span.from, T(1));
  const T middle = dot(level.at, axes.along);
  const Mask<T> evenly = u_choice < share_even;
  const T along =
      select(evenly, span.from + u1 * length, middle + drawn * dot(per_slope, axes.along));
  T across = dot(level.at, axes.across) + select(evenly, T(0), drawn * dot(per_slope, axes.across));

  PointInLine<T> out;
  const Vec3<T> to = in_space(telescope, lens);
  for (int step = 0; step < 8; ++step) {  // towards where facets are level across
    out.at = along * axes.along + across * axes.across;
    const Vec3<T> first = out.at - from, second = to - out.at;
    const T l1 = photic::length(first), l2 = photic::length(second);
    const T k1 = dot(first, axes.across) / l1, k2 = dot(second, axes.across) / l2;
    const T change = n2 * (T(1) - k2 * k2) / l2 + n1 * (T(1) - k1 * k1) / l1;
    across = across + (n2 * k2 - n1 * k1) / change;
    out.slope_across = change / abs(n2 * second.z / l2 - n1 * first.z / l1);
  }
  const T off = (along - middle) / spread;
  const Mask<T> inside = (along >= span.from) & (along <= span.to);
  const T by_slopes = T(1 / std::sqrt(2 * pi)) * exp_minus(T(0.5) * (off * off)) / spread;
  out.per_metre = (T(1) - share_even) * by_slopes + select(inside, share_even / length, T(0));
  return out;
}

/// The share of whitecaps in the points by which waves of one direction are crossed, if there are
/// any.
inline double share_of_whitecaps(const surface::WavesView& waves) {
  return waves.whitecap_fraction > 0 ? 0.25 : 0;
}
template <class T>
struct DrawnInLine {
  Mask<T> white{};  ///< it is one of a whitecap
  SurfacePoint<T> point;
  PointInLine<T> facets;  ///< the one that facets would lead by
};
/// `n1`: as in point_in_line(); behind the surface is what lenses are in or the light comes from.
template <class T>
DrawnInLine<T> draw_point_in_line(const surface::WavesView& waves,
                                  const instrument::Telescope<T>& telescope, const Vec3<T>& from,
                                  const instrument::PlanePoint<T>& lens, const NearLevel<T>& level,
                                  const T& n1, const SurfacePointUniforms<T>& u) {
  const T share_white = T(share_of_whitecaps(waves));
  const Mask<T> white = u.choice < share_white;
  const T rest = left_of_choice(u.choice, share_white);
  const auto in_line = point_in_line(axes_of<T>(waves), level, telescope, lens, from, n1, T(1),
                                     rest, u.radius, u.azimuth);
  if (!any(white)) return {white, {Mask<T>(true), in_line.at}, in_line};
  const auto seen = point_seen(telescope, lens, u.radius, u.azimuth);
  const Mask<T> by_detector = rest < T(0.5);
  const Vec3<T> of_whitecap = select(by_detector, seen.at, point_above(from, u.radius, u.azimuth));
  const Mask<T> exists = seen.exists | (!(white & by_detector));
  return {white, {exists, select(white, of_whitecap, in_line.at)}, in_line};
}

/// The point where a ray comes through the plane of a lens.
template <class T>
struct ComesToLens {
  Mask<T> open{};  ///< within the lens, from ahead
  instrument::PlanePoint<T> lens;
  T distance{};  ///< [m]
};
template <class T>
ComesToLens<T> come_to_lens(const instrument::Telescope<T>& telescope, const Vec3<T>& from,
                            const Vec3<T>& direction) {
  const T towards = -dot(direction, telescope.axis);
  const Vec3<T> from_lens = from - telescope.position;
  ComesToLens<T> out;
  out.distance = dot(from_lens, telescope.axis) / select(towards > T(0), towards, T(1));
  const Vec3<T> met = from_lens + out.distance * direction;
  out.lens = parts_in_plane(telescope, met);
  out.open = (towards > T(0)) & (out.distance > T(0)) & open_at(telescope, out.lens);
  return out;
}

/// Slopes by which facets may lead light to a lens: middle - half to middle + half hold all of
/// them, but for those steeper than six standard deviations.
template <class T>
struct SlopesToLens {
  T middle{}, half{};
};
/// `n`: index of the medium that light comes from, over that of the one in which it goes on.
template <class T>
SlopesToLens<T> slopes_to_lens(const WavesAxes<T>& axes, const instrument::Telescope<T>& telescope,
                               const Photon<T>& photon, const T& n) {
  using std::abs;
  const Vec3<T> way = telescope.position - photon.position;
  const T distance = photic::length(way);
  const Vec3<T> h = (T(1) / distance) * way - n * photon.direction;
  // No point of the lens is seen in a direction that differs by more than its radius over the least
  // distance.
  const T nearest = distance - telescope.lens_radius;
  const T off = telescope.lens_radius / select(nearest > T(0), nearest, T(1));
  const Mask<T> bounded = (nearest > T(0)) & (abs(h.z) > T(2) * off);
  const T all = T(6 * axes.deviation);
  const T middle = -dot(h, axes.along) / select(bounded, h.z, T(1));
  const T half = off * (T(1) + abs(middle)) / (select(bounded, abs(h.z), T(1)) - off);
  const Mask<T> narrow = bounded & (half < all);
  return {select(narrow, middle, T(0)), select(narrow, half, all)};
}

}  // namespace photic::transport
