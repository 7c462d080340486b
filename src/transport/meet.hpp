// Meetings of a ray of the laser's walk with one of a telescope's walk, which is shifted sideways
// for it, or turned about where it converts (vertex.hpp tells why).
#pragma once

#include <array>
#include <cmath>

#include "instrument/lens.hpp"
#include "optics/fresnel.hpp"
#include "transport/depart.hpp"
#include "transport/joint.hpp"
#include "transport/vertex.hpp"
#include "transport/way.hpp"

namespace photic::transport {

/// Rays as the surface has reflected them: those that go up come from their mirror images above it.
template <class T>
Ray<T> reflected(const medium::MediumView& sea, const Ray<T>& ray) {
  Ray<T> image = ray;
  image.position.z = -ray.position.z;
  image.direction.z = -ray.direction.z;
  image.weight = ray.weight *
                 optics::refract(gather<T>(sea.index, ray.line), T(1), ray.direction.z).reflectance;
  return image;
}

/// Optical depths along a ray, `length` of it, to a depth in a layer.
template <class T>
OpticalDepths<T> depths_along(const medium::MediumView& sea, const Ray<T>& ray,
                              const Index<T>& layer, const T& depth, const T& length) {
  const T from = -ray.position.z;
  const OpticalDepths<T> straight{
      sea.slant_optical_depth<T>(ray.line, ray.layer, from, layer, depth, length),
      sea.walk_slant_optical_depth<T>(ray.line, ray.layer, from, layer, depth, length)};
  const Mask<T> reflected = ray.is_reflected();
  if (!any(reflected)) return straight;
  const auto by_surface = depths_by_surface(sea, ray.line, ray.layer, T(-from), layer, depth,
                                            T(length / (depth - from)));
  return {select(reflected, by_surface.all, straight.all),
          select(reflected, by_surface.walk, straight.walk)};
}

/// The depths that two rays have in common.
template <class T>
struct Span {
  Mask<T> exists;
  T from, to;  ///< depth [m]
};
/// `deepest`: of the water [m].
template <class T>
Span<T> common_span(const Ray<T>& laser, const Ray<T>& back, const T& deepest) {
  const auto from = [](const Ray<T>& ray) {
    return select((ray.direction.z < T(0)) & !ray.is_reflected(), T(-ray.position.z), T(0));
  };
  const auto to = [&](const Ray<T>& ray) {
    return select(ray.direction.z < T(0), deepest, T(-ray.position.z));
  };
  const T upper = select(from(laser) > from(back), from(laser), from(back));
  const T lower = select(to(laser) < to(back), to(laser), to(back));
  return {Mask<T>(lower > upper), upper, lower};
}

/// Where a telescope's walk comes through the lens if it is shifted to meet a ray at a depth.
template <class T>
struct LensLine {
  instrument::PlanePoint<T> at_surface{};  ///< for a meeting at the surface's level
  instrument::PlanePoint<T> per_depth{};   ///< and how that moves per metre of depth

  instrument::PlanePoint<T> at(const T& depth) const {
    return {at_surface.x + depth * per_depth.x, at_surface.y + depth * per_depth.y};
  }
};

/// Whether light turns back, up or down, where two rays meet: else no walk is shifted for it.
template <class T>
Mask<T> turns_back(const Ray<T>& laser, const Ray<T>& back) {
  return laser.direction.z * back.direction.z > T(0);
}

/// The depths between which two rays can meet so that the telescope's walk comes through the lens.
template <class T>
struct Chord {
  Mask<T> exists;
  T from, to;  ///< depth [m]
  LensLine<T> lens;
};

/// `lens`: where the walk came through the lens; `deepest`: of the water [m].
template <class T>
Chord<T> chord(const Ray<T>& laser, const Ray<T>& back, const instrument::Telescope<T>& telescope,
               const instrument::PlanePoint<T>& lens, const T& deepest) {
  using std::sqrt;
  const T a = T(1) / laser.direction.z;
  const T b = T(1) / back.direction.z;
  const Vec3<T> slope = b * back.direction - a * laser.direction;  // per metre of depth
  const Vec3<T> at_surface = (laser.position - (laser.position.z * a) * laser.direction) -
                             (back.position - (back.position.z * b) * back.direction);
  Chord<T> c;
  const instrument::PlanePoint<T> at{lens.x + dot(at_surface, telescope.across),
                                     lens.y + dot(at_surface, telescope.up)};
  const instrument::PlanePoint<T> per_depth{dot(slope, telescope.across), dot(slope, telescope.up)};
  c.lens = {at, per_depth};
  const T squared = per_depth.x * per_depth.x + per_depth.y * per_depth.y;
  const Mask<T> moves = squared > T(1e-18);
  const T per_square = T(1) / select(moves, squared, T(1));
  const T middle = -(at.x * per_depth.x + at.y * per_depth.y) * per_square;
  const T x = at.x * per_depth.y - at.y * per_depth.x;
  const T radius = telescope.lens_radius;
  const T half = (radius * radius * squared - x * x) * per_square * per_square;
  const Mask<T> inside = at.x * at.x + at.y * at.y < radius * radius;
  const T reach = select(moves, sqrt(select(half > T(0), half, T(0))), deepest);
  c.from = select(moves, middle, T(0)) - reach;
  c.to = select(moves, middle, T(0)) + reach;

  const Span<T> span = common_span(laser, back, deepest);
  c.from = select(c.from > span.from, c.from, span.from);
  c.to = select(c.to < span.to, c.to, span.to);
  c.exists = span.exists & select(moves, half > T(0), inside) & (c.to > c.from);
  return c;
}

/// The depths, at most two, at which a telescope's ray meets a laser's if it is turned about a
/// vertical: where both are as far from it.
template <class T>
struct Crossings {
  std::array<Mask<T>, 2> exists;
  std::array<T, 2> depth;  ///< [m]
};

template <class T>
Crossings<T> crossings(const Ray<T>& laser, const Ray<T>& back, const Vertical<T>& axis,
                       const T& deepest) {
  using std::copysign;
  using std::sqrt;
  const Span<T> span = common_span(laser, back, deepest);
  const T a = T(-1) / laser.direction.z;
  const T b = T(-1) / back.direction.z;
  const T out = (span.from + laser.position.z) * a;
  const T home = (span.from + back.position.z) * b;
  // From the axis, at the depth where the span begins; and per metre of depth.
  const instrument::PlanePoint<T> at{laser.position.x + out * laser.direction.x - axis.x,
                                     laser.position.y + out * laser.direction.y - axis.y};
  const instrument::PlanePoint<T> bt{back.position.x + home * back.direction.x - axis.x,
                                     back.position.y + home * back.direction.y - axis.y};
  const instrument::PlanePoint<T> am{a * laser.direction.x, a * laser.direction.y};
  const instrument::PlanePoint<T> bm{b * back.direction.x, b * back.direction.y};
  const T square = am.x * am.x + am.y * am.y - (bm.x * bm.x + bm.y * bm.y);
  const T half = at.x * am.x + at.y * am.y - (bt.x * bm.x + bt.y * bm.y);
  const T constant = (at.x - bt.x) * (at.x + bt.x) + (at.y - bt.y) * (at.y + bt.y);
  const T discriminant = half * half - square * constant;
  const Mask<T> real = axis.exists & span.exists & (discriminant > T(0));
  const T root = sqrt(select(real, discriminant, T(0)));
  const T q = -(half + copysign(root, half));
  const T length = span.to - span.from;
  Crossings<T> c;
  const std::array<T, 2> beyond{q / square, constant / q};
  for (std::size_t i = 0; i < 2; ++i) {
    c.depth[i] = span.from + beyond[i];
    c.exists[i] = real & (beyond[i] > T(0)) & (beyond[i] < length);
  }
  return c;
}

/// A turn about a vertical.
template <class T>
struct Rotation {
  Vertical<T> axis;
  T cosine, sine;

  Vec3<T> of_direction(const Vec3<T>& d) const {
    return {cosine * d.x - sine * d.y, sine * d.x + cosine * d.y, d.z};
  }
  Vec3<T> of_place(const Vec3<T>& p) const {
    const Vec3<T> foot{axis.x, axis.y, T(0)};
    return foot + of_direction(p - foot);
  }
};

/// The turn that brings a telescope's ray to a laser's at a depth where both are as far from the
/// vertical.
template <class T>
Rotation<T> turn_to_meet(const Ray<T>& laser, const Ray<T>& back, const Vertical<T>& axis,
                         const T& depth) {
  using std::sqrt;
  const T out = (-laser.position.z - depth) / laser.direction.z;
  const T home = (-back.position.z - depth) / back.direction.z;
  const T ax = laser.position.x + out * laser.direction.x - axis.x;
  const T ay = laser.position.y + out * laser.direction.y - axis.y;
  const T bx = back.position.x + home * back.direction.x - axis.x;
  const T by = back.position.y + home * back.direction.y - axis.y;
  const T square = sqrt(ax * ax + ay * ay) * sqrt(bx * bx + by * by);
  const Mask<T> aside = square > T(0);  // else any turn does
  const T per = T(1) / select(aside, square, T(1));
  return {axis, select(aside, per * (ax * bx + ay * by), T(1)), per * (bx * ay - by * ax)};
}

/// What a meeting contributes, and where.
template <class T>
struct Meeting {
  T value{};
  T path{};  ///< [m]
};

/// One side of a meeting.
template <class T>
struct Side {
  Ray<T> ray;
  Mask<T> first{};  ///< it leaves the instrument, as light that spreads so
  Spread<T> spread;
  T behind{};  ///< densities behind the ray
  T last{};    ///< of meeting where the ray begins, but for what is beyond it

  /// n h / g of connecting the edge along the ray, times P and the walked exp(-tau): what the
  /// surface reflects can only be connected to an instrument, by its mirror image.
  T connecting(const medium::MediumView& sea, const T& length, const Samples<T>& samples) const {
    const T area = connecting_area(sea, ray, first, spread, length, samples);
    return select(ray.is_reflected() & !first, T(0), area);
  }
};

/// A laser's ray and a telescope's that meet at a depth in a layer.
template <class T>
Meeting<T> meet(const medium::MediumView& sea, const Side<T>& laser_side, const Side<T>& side,
                const T& depth, const Index<T>& layer, const Freedom<T>& freedom,
                const Reversal<T>& reversal, const Samples<T>& samples) {
  const Ray<T>& laser = laser_side.ray;
  const Ray<T>& back = side.ray;
  const Index<T> line = back.line;
  const Index<T> here = sea.at(line, layer);
  const Mask<T> converts = line > Index<T>(0);
  const T out = (-laser.position.z - depth) / laser.direction.z;
  const T home = (-back.position.z - depth) / back.direction.z;
  const auto tau_out = depths_along(sea, laser, layer, depth, out);
  const auto tau_home = depths_along(sea, back, layer, depth, home);
  const T walked_out = exp_minus(tau_out.walk);
  const T walked_home = exp_minus(tau_home.walk);
  const T walk_mean_path = gather<T>(sea.walk_mean_path, here);
  const T coefficient = select(converts, gather<T>(sea.conversion, here) * gather<T>(sea.c, layer),
                               gather<T>(sea.albedo, here) * gather<T>(sea.c, here)) *
                        walk_mean_path;
  const Index<T> phase = select(converts, gather_index<T>(sea.conversion_phase, line),
                                gather_index<T>(sea.elastic_phase, here));
  const T p = sea.phases.template value<T>(one_minus_cos(laser.direction, -back.direction), phase);

  // Strategies, each with n h / g times p and the walked exp(-tau) of both rays.
  const T steep = select(turns_back(laser, back), T(laser.direction.z * back.direction.z), T(0));
  const T swept = sweep(laser.position + out * laser.direction, laser.direction, back.direction)
                      .about(freedom.axis);
  const T here_met =
      (samples.meeting(depth) * freedom.shift_area * steep + samples.turned * T(2 * pi) * swept) *
      back.chance * walk_mean_path;
  const T ratio = walk_c_ratio<T>(sea, line, layer);
  const T connected = back.chance * laser_side.connecting(sea, out, samples) * walked_home +
                      ratio * side.connecting(sea, home, samples) * walked_out;
  const T goes_on = back.chance * reversal.goes_on(sea, line, layer, converts, -laser.direction, p);
  const T met_next = goes_on * laser_side.last * walked_home + side.last * walked_out;
  const T met_behind = walked_out * walked_home * (goes_on * laser_side.behind + side.behind);
  Meeting<T> meeting;
  meeting.value = laser.weight * back.weight * coefficient * p *
                  exp_minus(tau_out.all + tau_home.all) /
                  (here_met + connected + p * (met_next + met_behind));
  meeting.path = laser.path + back.path + out * gather<T>(sea.group_index, Index<T>(0)) +
                 home * gather<T>(sea.group_index, line);
  return meeting;
}

}  // namespace photic::transport
