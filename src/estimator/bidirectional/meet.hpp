// Meetings of a ray of the laser's walk with one of a telescope's walk, which is translated
// sideways for it, or rotated about where it converts (strategy_sums.hpp gives the reason).
#pragma once

#include <array>
#include <cmath>

#include "core/flatten.hpp"
#include "estimator/bidirectional/connection_end.hpp"
#include "estimator/bidirectional/vertex.hpp"
#include "geometry/sightline.hpp"
#include "instrument/lens.hpp"
#include "surface/flat.hpp"

namespace photic::estimator {

/// Rays as the surface has reflected them: those that go up come from their mirror images above it.
template <class T>
Ray<T> reflected(const geometry::Slabs& sea, const Ray<T>& ray) {
  Ray<T> image = ray;
  image.position = geometry::mirror_image(ray.position);
  image.direction.z = -ray.direction.z;
  image.weight = ray.weight * surface::flat_surface<T>(sea, ray.line).reflectance(ray.direction.z);
  return image;
}

/// The value of(segment) of a ray's way to a level, `length` long, which the surface may have
/// reflected.
template <class T, class Of>
auto along(const geometry::Slabs& sea, const Ray<T>& ray, const medium::Level<T>& to,
           const T& length, Of of) {
  const geometry::Segment<T> straight{ray.line, geometry::level_of(sea, ray), to, length};
  const auto value = of(straight);
  const Mask<T> reflected = ray.is_reflected();
  if (!any(reflected)) return value;
  const T above = geometry::depth_of(ray.position);  // of the mirror image, negative
  const auto by_surface =
      geometry::by_surface(ray.line, sea.level(ray.layer, T(-above)), to, length,
                           geometry::Slant<T>::of_secant(T(length / (to.depth - above))));
  return select(reflected, of(by_surface), value);
}
template <class T>
geometry::OpticalDepths<T> depths_along(const geometry::Slabs& sea, const Ray<T>& ray,
                                        const medium::Level<T>& to, const T& length) {
  return along(sea, ray, to, length,
               [&](const auto& segment) { return geometry::optical_depths(sea, segment); });
}
template <class T>
PHOTIC_APART T path_along_in_air(const geometry::Slabs& sea, const Ray<T>& ray, medium::Level<T> to,
                                 T length) {
  return along(sea, ray, to, length,
               [&](const auto& segment) { return geometry::group_path(sea, segment); });
}
template <class T>
T path_along(const geometry::Slabs& sea, const Ray<T>& ray, const medium::Level<T>& to,
             const T& length) {
  if (sea.kind == medium::MediumKind::air) [[unlikely]]
    return path_along_in_air(sea, ray, to, length);
  return geometry::group_path(sea, geometry::Segment<T>{ray.line, {}, to, length});
}

/// A ray as a line over depth, its own or its image's in the surface.
template <class T>
struct DepthLine {
  T x{}, y{};  ///< at the surface's level [m]
  T x_per_depth{}, y_per_depth{};
  T path{}, path_per_depth{};  ///< of its walk [m], at the surface's level, and its growth
  T from{}, to{};              ///< the depths that it comes through [m]
  T rise{};                    ///< z of its direction
  T start{};                   ///< its walk's path where it begins [m]

  template <class F>
  constexpr void each_member(F f) {
    f(x), f(y), f(x_per_depth), f(y_per_depth), f(path), f(path_per_depth);
    f(from), f(to), f(rise), f(start);
  }
};

/// `deepest`: of the water [m].
template <class T>
DepthLine<T> depth_line(const geometry::Slabs& sea, const Ray<T>& ray, const T& deepest) {
  const T length_per_depth = T(-1) / ray.direction.z;
  const T own = geometry::depth_of(ray.position);
  const T above = -own * length_per_depth;  // length to the surface's level
  const T index = geometry::min_group_index<T>(sea, ray.line);
  const Mask<T> down = ray.direction.z < T(0);
  const T depth = select(own > T(0), own, T(0));
  return {ray.position.x + above * ray.direction.x,
          ray.position.y + above * ray.direction.y,
          length_per_depth * ray.direction.x,
          length_per_depth * ray.direction.y,
          ray.path + above * index,
          length_per_depth * index,
          select(down, depth, T(0)),
          select(down, deepest, depth),
          ray.direction.z,
          ray.path};
}

/// The line of the ray that a ray becomes which goes up and is reflected by the surface.
template <class T>
DepthLine<T> reflected(const DepthLine<T>& line, const T& deepest) {
  return {line.x, line.y,  -line.x_per_depth, -line.y_per_depth, line.path, -line.path_per_depth,
          T(0),   deepest, -line.rise,        line.start};
}

/// The depths that two rays have in common, and where their walks together are no longer than
/// `last_path` [m].
template <class T>
struct Span {
  Mask<T> exists;
  T from, to;  ///< depth [m]
};
template <class T>
Span<T> common_span(const DepthLine<T>& laser, const DepthLine<T>& back, const T& last_path) {
  const T upper = select(laser.from > back.from, laser.from, back.from);
  const T lower = select(laser.to < back.to, laser.to, back.to);
  const T per_depth = laser.path_per_depth + back.path_per_depth;
  const T last = (last_path - (laser.path + back.path)) / per_depth;
  const T from = select((per_depth < T(0)) & (last > upper), last, upper);
  const T to = select((per_depth > T(0)) & (last < lower), last, lower);
  return {Mask<T>(to > from), from, to};
}

/// The line on the lens of a telescope's walk that is translated to meet a ray at a depth.
template <class T>
struct LensLine {
  instrument::PlanePoint<T> at_surface{};  ///< for a meeting at the surface's level
  instrument::PlanePoint<T> per_depth{};   ///< and how that moves per metre of depth

  instrument::PlanePoint<T> at(const T& depth) const {
    return {at_surface.x + depth * per_depth.x, at_surface.y + depth * per_depth.y};
  }
};

/// Returns whether light reverses, between up and down, where two rays meet: else no walk is
/// translated for it, unless it is converted there.
template <class T>
Mask<T> reverses(const Ray<T>& laser, const Ray<T>& back) {
  return laser.direction.z * back.direction.z > T(0);
}
template <class T>
Mask<T> reverses(const DepthLine<T>& laser, const DepthLine<T>& back) {
  return laser.rise * back.rise > T(0);
}

/// The depths between which two rays can meet so that the telescope's walk comes through the lens.
template <class T>
struct Chord {
  Mask<T> exists;
  T from, to;  ///< depth [m]
  LensLine<T> lens;
};

/// A telescope's walk at its lens.
template <class T>
struct AtLens {
  instrument::PlanePoint<T> lens;  ///< its point on the lens
  Vec3<T> outward;                 ///< in this direction
  T index{1};                      ///< group index of what is before the lens
};

/// The part of a span in which a line over depth lies within the lens' rim.
template <class T>
Chord<T> within_rim(const LensLine<T>& line, const T& radius, const Span<T>& span) {
  using std::sqrt;
  const auto& [at, per_depth] = line;
  Chord<T> c;
  c.lens = line;
  const T squared = per_depth.x * per_depth.x + per_depth.y * per_depth.y;
  const Mask<T> moves = squared > T(1e-18);
  const T per_square = T(1) / select(moves, squared, T(1));
  const T middle = -(at.x * per_depth.x + at.y * per_depth.y) * per_square;
  const T x = at.x * per_depth.y - at.y * per_depth.x;
  const T half = (radius * radius * squared - x * x) * per_square * per_square;
  const Mask<T> inside = at.x * at.x + at.y * at.y < radius * radius;
  const T reach = select(moves, sqrt(select(half > T(0), half, T(0))), span.to);
  c.from = select(moves, middle, T(0)) - reach;
  c.to = select(moves, middle, T(0)) + reach;

  c.from = select(c.from > span.from, c.from, span.from);
  c.to = select(c.to < span.to, c.to, span.to);
  c.exists = span.exists & select(moves, half > T(0), inside) & (c.to > c.from);
  return c;
}

/// From a telescope's ray to a laser's, at the surface's level and per metre of depth.
template <class T>
std::array<Vec3<T>, 2> horizontal_offset(const DepthLine<T>& back, const DepthLine<T>& laser) {
  return {
      Vec3<T>{laser.x - back.x, laser.y - back.y, T(0)},
      Vec3<T>{laser.x_per_depth - back.x_per_depth, laser.y_per_depth - back.y_per_depth, T(0)}};
}

/// Under a lens that lies level. `lens`: where the walk came through it; `last_path`: of both walks
/// together [m].
template <class T>
Chord<T> chord(const DepthLine<T>& laser, const DepthLine<T>& back,
               const instrument::Telescope<T>& telescope, const instrument::PlanePoint<T>& lens,
               const T& last_path) {
  const auto [at_surface, per_depth] = horizontal_offset(back, laser);
  return within_rim<T>(
      {lens + parts_in_plane(telescope, at_surface), parts_in_plane(telescope, per_depth)},
      telescope.lens_radius, common_span(laser, back, last_path));
}
/// Under any lens.
template <class T>
Chord<T> chord(const DepthLine<T>& laser, DepthLine<T> back,
               const instrument::Telescope<T>& telescope, const AtLens<T>& start,
               const T& last_path) {
  const auto [at_surface, per_depth] = horizontal_offset(back, laser);
  const auto there = lens_translation(telescope, start.outward, at_surface);
  const auto slope = lens_translation(telescope, start.outward, per_depth);
  back.path = back.path + start.index * there.longer;
  back.path_per_depth = back.path_per_depth + start.index * slope.longer;
  return within_rim<T>({start.lens + there.aside, slope.aside}, telescope.lens_radius,
                       common_span(laser, back, last_path));
}

/// The depths, at most two, at which a telescope's ray meets a laser's if it is rotated about an
/// axis: where both are as far from it.
template <class T>
struct EquidistantDepths {
  std::array<Mask<T>, 2> exists;
  std::array<T, 2> depth;  ///< [m]
};

template <class T>
EquidistantDepths<T> equidistant_depths(const DepthLine<T>& laser, const DepthLine<T>& back,
                                        const RotationAxis<T>& axis, const T& last_path) {
  using std::copysign;
  using std::sqrt;
  const Span<T> span = common_span(laser, back, last_path);
  // From the axis, at the depth where the span begins; and per metre of depth.
  const auto from_axis = [&](const DepthLine<T>& line) -> instrument::PlanePoint<T> {
    return {line.x + span.from * line.x_per_depth - axis.x,
            line.y + span.from * line.y_per_depth - axis.y};
  };
  const auto at = from_axis(laser), bt = from_axis(back);
  const instrument::PlanePoint<T> am{laser.x_per_depth, laser.y_per_depth};
  const instrument::PlanePoint<T> bm{back.x_per_depth, back.y_per_depth};
  const T square = am.x * am.x + am.y * am.y - (bm.x * bm.x + bm.y * bm.y);
  const T half = at.x * am.x + at.y * am.y - (bt.x * bm.x + bt.y * bm.y);
  const T constant = (at.x - bt.x) * (at.x + bt.x) + (at.y - bt.y) * (at.y + bt.y);
  const T discriminant = half * half - square * constant;
  const Mask<T> real = axis.exists & span.exists & (discriminant > T(0));
  const T root = sqrt(select(real, discriminant, T(0)));
  const T q = -(half + copysign(root, half));
  const T length = span.to - span.from;
  EquidistantDepths<T> c;
  const std::array<T, 2> beyond{q / square, constant / q};
  for (std::size_t i = 0; i < 2; ++i) {
    c.depth[i] = span.from + beyond[i];
    c.exists[i] = real & (beyond[i] > T(0)) & (beyond[i] < length);
  }
  return c;
}

/// A rotation about a vertical axis.
template <class T>
struct Rotation {
  RotationAxis<T> axis;
  T cosine, sine;

  Vec3<T> of_direction(const Vec3<T>& d) const {
    return {cosine * d.x - sine * d.y, sine * d.x + cosine * d.y, d.z};
  }
  Vec3<T> of_place(const Vec3<T>& p) const {
    const Vec3<T> foot{axis.x, axis.y, T(0)};
    return foot + of_direction(p - foot);
  }
};

/// The rotation that brings a telescope's ray to a laser's at a depth where both are as far from
/// the axis.
template <class T>
Rotation<T> rotation_to_meet(const Ray<T>& laser, const Ray<T>& back, const RotationAxis<T>& axis,
                             const T& depth) {
  using std::sqrt;
  const T length_out = laser.length_to(depth);
  const T length_back = back.length_to(depth);
  const T ax = laser.position.x + length_out * laser.direction.x - axis.x;
  const T ay = laser.position.y + length_out * laser.direction.y - axis.y;
  const T bx = back.position.x + length_back * back.direction.x - axis.x;
  const T by = back.position.y + length_back * back.direction.y - axis.y;
  const T square = sqrt(ax * ax + ay * ay) * sqrt(bx * bx + by * by);
  const Mask<T> aside = square > T(0);  // else any rotation does
  const T per = T(1) / select(aside, square, T(1));
  return {axis, select(aside, per * (ax * bx + ay * by), T(1)), per * (bx * ay - by * ax)};
}

/// One side of a meeting.
template <class T>
struct Side {
  Ray<T> ray;
  Mask<T> first{};  ///< it leaves the instrument, as light that spreads so
  Spread<T> spread;
  T behind{};              ///< sum of the densities behind the ray
  T meeting{};             ///< density of meeting where the ray begins, but for what its edge adds
  Mask<T> straight{true};  ///< the surface has not reflected it

  /// Density of connecting the edge along the ray, times the phase function and exp(-tau) of the
  /// walk's coefficient. Light that the surface reflects can only be connected to an instrument, by
  /// its mirror image.
  T connecting(const geometry::Slabs& sea, const T& length,
               const estimator::Samples<T>& samples) const {
    const T area = connecting_area(sea, ray, first, spread, length, samples);
    return select(straight | first, area, T(0));
  }
};

}  // namespace photic::estimator
