// The straight ways from a point in the water into a telescope: through the flat surface, directly, or
// mirrored in the surface from below (physics of docs/theory.md, "The local estimate").
#pragma once

#include <cmath>

#include "instrument/disc.hpp"
#include "instrument/telescope.hpp"
#include "medium/medium.hpp"
#include "optics/fresnel.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

/// One way from a point to a telescope.
template <class T>
struct Connection {
  Vec3<T> direction;   ///< in which light must leave the point
  T acceptance{};      ///< solid angle about it that ends on the detector, surface losses included [sr]
  T optical_depth{};   ///< of the way
  T path{};            ///< length times group index [m]
};

/// tan of the angle in air under which a point `depth` below a flat surface is seen from `height` above it and
/// `aside` to the side: the root of height t + depth t / sqrt(n^2 + (n^2-1) t^2) = aside. The left side is concave in
/// t and the paraxial start lies below the root, so Newton's steps rise towards it and never overshoot.
template <class T>
T crossing_tangent(const T& n, const T& depth, const T& height, const T& aside) {
  using std::abs;
  using std::sqrt;
  const T n2 = n * n;
  const T tolerance = T(8) * std::numeric_limits<Element<T>>::epsilon();
  T t = aside / (height + depth / n);
  for (int step = 0; step < 60; ++step) {
    const T q = T(1) / (n2 + (n2 - T(1)) * t * t);
    const T root = sqrt(q);
    const T excess = height * t + depth * t * root - aside;
    const T slope = height + depth * n2 * q * root;
    t = t - excess / slope;
    if (!any(abs(excess) > tolerance * aside)) break;
  }
  return t;
}

/// Solid angle in medium 1 (index n, path l1, cosine c1 to the vertical) per area across the ray in air (path l2,
/// cosine c2): both curvatures of the refracted wave front, not the paraxial one [1/m^2].
template <class T>
T refracted_solid_angle_per_area(const T& n, const T& l1, const T& c1, const T& l2, const T& c2) {
  const T across = l2 + l1 / n;
  const T ratio = c2 / c1;
  const T along = l2 + (l1 / n) * ratio * ratio;
  return ratio / (n * n * across * along);
}

/// From a photon's position through the surface to a telescope in the air, at the given line.
template <class T>
Connection<T> connect_through_surface(const medium::MediumView& sea, const instrument::Telescope<T>& telescope,
                                      const Photon<T>& at, const Index<T>& line) {
  using std::sqrt;
  const T n = gather<T>(sea.index, line);
  const T depth = -at.position.z;
  const T dx = telescope.position.x - at.position.x;
  const T dy = telescope.position.y - at.position.y;
  const T aside = sqrt(dx * dx + dy * dy);
  const T inverse_aside = select(aside > T(0), T(1) / select(aside > T(0), aside, T(1)), T(0));
  const T tangent = crossing_tangent(n, depth, telescope.position.z, aside);

  const T cos_air = T(1) / sqrt(T(1) + tangent * tangent);
  const T sin_air = tangent * cos_air;
  const T sin_water = sin_air / n;
  const T cos_water = sqrt(T(1) - sin_water * sin_water);
  const T ex = dx * inverse_aside;
  const T ey = dy * inverse_aside;
  const Vec3<T> arriving{ex * sin_air, ey * sin_air, cos_air};

  Connection<T> way;
  way.direction = {ex * sin_water, ey * sin_water, cos_water};
  const T in_water = depth / cos_water;
  const T in_air = telescope.position.z / cos_air;
  const T apparent = in_air + in_water / n;
  const T cos_off_axis = -dot(arriving, telescope.axis);
  const Mask<T> in_front = cos_off_axis > T(0);
  const T safe_cos = select(in_front, cos_off_axis, T(1));
  const T tan_off_axis = length(cross(arriving, telescope.axis)) / safe_cos;
  const T overlap = telescope.overlap(apparent * safe_cos, tan_off_axis);
  const T transmitted = T(1) - optics::refract(n, T(1), cos_water).reflectance;
  const T per_area = refracted_solid_angle_per_area(n, in_water, cos_water, in_air, cos_air);
  way.acceptance =
      select(in_front, per_area * telescope.area() * safe_cos * overlap * transmitted, T(0));
  way.optical_depth = sea.optical_depth<T>(line, at.layer, depth) / cos_water;
  way.path = in_air + in_water * gather<T>(sea.group_index, line);
  return way;
}

/// Solid angle of a telescope's open lens from a point in the same medium, `distance` away under the off-axis
/// cosine `cos_off_axis` > 0: near the lens the exact one of disc less obstruction, so that it stays below 2 pi.
template <class T>
T lens_solid_angle(const instrument::Telescope<T>& telescope, const T& distance, const T& cos_off_axis) {
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

/// From a photon's position to a telescope in the water, at the given line: directly, or by way of the
/// surface seen from below (`mirrored`), total reflection included.
template <class T>
Connection<T> connect_in_water(const medium::MediumView& sea, const instrument::Telescope<T>& telescope,
                               const Index<T>& telescope_layer, const Photon<T>& at, const Index<T>& line,
                               bool mirrored) {
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
  const Vec3<T> arriving{way.direction.x, way.direction.y, mirrored ? -way.direction.z : way.direction.z};
  const T cos_off_axis = -dot(arriving, telescope.axis);
  const Mask<T> in_front = apart & (cos_off_axis > T(0));
  const T safe_cos = select(in_front, cos_off_axis, T(1));
  const T tan_off_axis = length(cross(arriving, telescope.axis)) / safe_cos;
  const T overlap = telescope.overlap(distance * safe_cos, tan_off_axis);
  const Mask<T> seen = in_front & (overlap > T(0));

  const T tau_here = sea.optical_depth<T>(line, at.layer, depth);
  const T tau_there = sea.optical_depth<T>(line, telescope_layer, telescope_depth);
  const T steep = abs(way.direction.z);
  if (mirrored) {
    way.optical_depth = (tau_here + tau_there) / steep;
  } else {
    const Mask<T> same = at.layer == telescope_layer;
    const T within = gather<T>(sea.c, sea.at(line, at.layer)) * distance;
    way.optical_depth = select(same, within, abs(tau_here - tau_there) / select(same, T(1), steep));
  }
  way.path = distance * gather<T>(sea.group_index, line);
  const T reflected =
      mirrored ? optics::refract(gather<T>(sea.index, line), T(1), steep).reflectance : T(1);
  const T solid_angle = any(seen) ? lens_solid_angle(telescope, distance, safe_cos) : T(0);
  way.acceptance = select(seen, solid_angle * overlap * reflected, T(0));
  return way;
}

}  // namespace photic::transport
