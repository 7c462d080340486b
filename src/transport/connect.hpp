// The straight ways from a point in the water into a telescope: through the flat surface, directly,
// or mirrored in the surface from below (physics of docs/theory.md, "The local estimate").
#pragma once

#include <cmath>

#include "instrument/disc.hpp"
#include "instrument/telescope.hpp"
#include "medium/medium.hpp"
#include "optics/fresnel.hpp"
#include "transport/flight.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

/// One way from a point to a telescope. Where no lane is seen by the detector only the first two
/// are filled in.
template <class T>
struct Connection {
  Vec3<T> direction;   ///< in which light must leave the point
  Mask<T> in_front{};  ///< of the lens: a direction worth sampling, in the field of view or not
  T acceptance{};  ///< solid angle about it that ends on the detector, surface losses included [sr]
  T optical_depth{};  ///< of the way
  T path{};           ///< length times group index [m]
};

/// tan of the angle in air under which a point `depth` below a flat surface is seen from `height`
/// above it and aside of it, to within a few per cent at any angle and t^5 at small ones: the root
/// of
///   height t + depth t / sqrt(n^2 + (n^2-1) t^2) = aside
/// to the third order in its paraxial value n aside / (n height + depth), which is never above the
/// root. `share` is depth / (n height + depth), `inverse_n` 1 / n.
template <class T>
T crossing_tangent_start(const T& inverse_n, const T& share, const T& paraxial) {
  const T cubic = T(0.5) * (T(1) - inverse_n * inverse_n) * share * paraxial * paraxial;
  return paraxial * (T(1) + select(cubic < T(0.1), cubic, T(0.1)));
}

/// The root itself by Newton's steps from there. The left side is concave in t: steps from above
/// the root lead below it, steps from below rise towards it and never overshoot. Errors square with
/// each step, so the last one needs to be no better than the root of the rounding.
template <class T>
T crossing_tangent(const T& n, const T& depth, const T& height, const T& aside, const T& start) {
  using std::abs;
  using std::sqrt;
  const T n2 = n * n;
  const T enough = T(std::sqrt(std::numeric_limits<Element<T>>::epsilon())) * aside;
  T t = start;
  Mask<T> open(true);  // a lane that is done rests, whatever the others still need
  for (int step = 0; step < 60; ++step) {
    const T q = T(1) / (n2 + (n2 - T(1)) * t * t);
    const T root = sqrt(q);
    const T excess = height * t + depth * t * root - aside;
    t = select(open, t - excess / (height + depth * n2 * q * root), t);
    open = open & (abs(excess) > enough);
    if (!any(open)) break;
  }
  return t;
}

/// Solid angle in medium 1 (index n, path l1, cosine c1 to the vertical) per area across the ray in
/// air (path l2, cosine c2): both curvatures of the refracted wave front, not the paraxial one
/// [1/m^2]. `inverse_n` is 1 / n.
template <class T>
T refracted_solid_angle_per_area(const T& inverse_n, const T& l1, const T& c1, const T& l2,
                                 const T& c2) {
  const T across = l2 + l1 * inverse_n;
  const T ratio = c2 / c1;
  const T along = l2 + l1 * inverse_n * ratio * ratio;
  return ratio * inverse_n * inverse_n / (across * along);
}

/// From a photon's position through the surface to a telescope in the air, at the given line. If
/// nothing `aims` at the telescope, directions are left out where its detector cannot see the
/// point.
template <class T>
Connection<T> connect_through_surface(const medium::MediumView& sea,
                                      const instrument::Telescope<T>& telescope,
                                      const Photon<T>& at, const Index<T>& line, bool aims) {
  using std::sqrt;
  Connection<T> way;
  const T n = gather<T>(sea.index, line);
  const T inverse_n = gather<T>(sea.inverse_index, line);
  const T depth = -at.position.z;
  const T dx = telescope.position.x - at.position.x;
  const T dy = telescope.position.y - at.position.y;
  const T height = telescope.position.z;

  // Most points lie far outside the field of view; the true angle is never below the paraxial one.
  const T per_height = T(1) / (n * height + depth);
  const T scale = n * per_height;
  const Mask<T> near_view = telescope.may_see_beyond(scale * dx, scale * dy);
  if (!(aims || any(near_view))) return way;
  const T aside = sqrt(dx * dx + dy * dy);
  const T inverse_aside = select(aside > T(0), T(1) / select(aside > T(0), aside, T(1)), T(0));
  const T ex = dx * inverse_aside;
  const T ey = dy * inverse_aside;
  const T start = crossing_tangent_start(inverse_n, depth * per_height, scale * aside);
  T tangent = start;
  if (any(near_view))
    tangent = select(near_view, crossing_tangent(n, depth, height, aside, start), start);

  const T secant_air = sqrt(T(1) + tangent * tangent);
  const T cos_air = T(1) / secant_air;
  const T sin_air = tangent * cos_air;
  const T sin_water = sin_air * inverse_n;
  const T cos_water = sqrt(T(1) - sin_water * sin_water);
  const Vec3<T> arriving{ex * sin_air, ey * sin_air, cos_air};

  way.direction = {ex * sin_water, ey * sin_water, cos_water};
  const T secant_water = T(1) / cos_water;
  const T in_water = depth * secant_water;
  const T in_air = height * secant_air;
  const T apparent = in_air + in_water * inverse_n;
  const T cos_off_axis = -dot(arriving, telescope.axis);
  way.in_front = cos_off_axis > T(0);
  if (!any(near_view)) return way;
  const T safe_cos = select(way.in_front, cos_off_axis, T(1));
  const T tan_off_axis = length(cross(arriving, telescope.axis)) / safe_cos;
  const T overlap = telescope.overlap(apparent * safe_cos, tan_off_axis);
  const Mask<T> seen = near_view & way.in_front & (overlap > T(0));
  if (!any(seen)) return way;
  const T transmitted = T(1) - optics::fresnel_reflectance(n, T(1), cos_water, cos_air);
  const T per_area =
      refracted_solid_angle_per_area(inverse_n, in_water, cos_water, in_air, cos_air);
  way.acceptance =
      select(seen, per_area * telescope.area() * safe_cos * overlap * transmitted, T(0));
  way.optical_depth = sea.optical_depth<T>(line, at.layer, depth) * secant_water;
  way.path = in_air + in_water * gather<T>(sea.group_index, line);
  return way;
}

/// Solid angle of a telescope's open lens from a point in the same medium, `distance` away under
/// the off-axis cosine `cos_off_axis` > 0: near the lens the exact one of disc less obstruction, so
/// that it stays below 2 pi.
template <class T>
T lens_solid_angle(const instrument::Telescope<T>& telescope, const T& distance,
                   const T& cos_off_axis) {
  using std::sqrt;
  const Mask<T> far = distance > T(instrument::far_radii) * telescope.lens_radius;
  const T from_afar = telescope.area() * cos_off_axis / (distance * distance);
  if (all(far)) return from_afar;
  const T height = distance * cos_off_axis;
  const T sine_squared = select(cos_off_axis < T(1), T(1) - cos_off_axis * cos_off_axis, T(0));
  const T aside = distance * sqrt(sine_squared);
  const T exact = instrument::disc_solid_angle(telescope.lens_radius, height, aside) -
                  instrument::disc_solid_angle(telescope.obstruction_radius, height, aside);
  return select(far, from_afar, exact);
}

/// From a photon's position to a telescope in the water, at the given line: directly, or by way of
/// the surface seen from below (`mirrored`), total reflection included.
template <class T>
Connection<T> connect_in_water(const medium::MediumView& sea,
                               const instrument::Telescope<T>& telescope,
                               const Index<T>& telescope_layer, const Photon<T>& at,
                               const Index<T>& line, bool mirrored) {
  using std::abs;
  using std::sqrt;
  const T depth = -at.position.z;
  const T telescope_depth = -telescope.position.z;
  const Vec3<T> target{telescope.position.x, telescope.position.y,
                       mirrored ? telescope_depth : telescope.position.z};
  const Vec3<T> way_there = target - at.position;
  const T squared = dot(way_there, way_there);
  const Mask<T> apart = squared > T(0);
  const T distance = sqrt(select(apart, squared, T(1)));

  Connection<T> way;
  way.direction = (T(1) / distance) * way_there;
  const Vec3<T> arriving{way.direction.x, way.direction.y,
                         mirrored ? -way.direction.z : way.direction.z};
  const T cos_off_axis = -dot(arriving, telescope.axis);
  way.in_front = apart & (cos_off_axis > T(0));
  const T safe_cos = select(way.in_front, cos_off_axis, T(1));
  const T tan_off_axis = length(cross(arriving, telescope.axis)) / safe_cos;
  const T overlap = telescope.overlap(distance * safe_cos, tan_off_axis);
  const Mask<T> seen = way.in_front & (overlap > T(0));
  if (!any(seen)) return way;

  const T steep = abs(way.direction.z);
  if (mirrored) {
    way.optical_depth = (sea.optical_depth<T>(line, at.layer, depth) +
                         sea.optical_depth<T>(line, telescope_layer, telescope_depth)) /
                        steep;
  } else {
    way.optical_depth = sea.slant_optical_depth<T>(line, at.layer, depth, telescope_layer,
                                                   telescope_depth, distance);
  }
  way.path = distance * gather<T>(sea.group_index, line);
  const T reflected =
      mirrored ? optics::refract(gather<T>(sea.index, line), T(1), steep).reflectance : T(1);
  way.acceptance =
      select(seen, lens_solid_angle(telescope, distance, safe_cos) * overlap * reflected, T(0));
  return way;
}

}  // namespace photic::transport
