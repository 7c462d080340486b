// Single rays through a telescope's thin lens: what the overlap of telescope.hpp is the mean of, at
// one range. A ray through the lens at p (a point of its plane) that moves aside by t per metre of
// its way along the axis falls on the detector's plane at p + x_d (t - p / f), from the lens'
// centre (docs/theory.md, "The telescope").
#pragma once

#include <cmath>

#include "core/turn.hpp"
#include "instrument/telescope.hpp"

namespace photic::instrument {

/// A point of the lens or the detector along the telescope's directions `across` and `up` [m].
template <class T>
struct PlanePoint {
  T x, y;

  friend PlanePoint operator+(const PlanePoint& a, const PlanePoint& b) {
    return {a.x + b.x, a.y + b.y};
  }
  friend PlanePoint operator*(const T& s, const PlanePoint& a) { return {s * a.x, s * a.y}; }
};

/// An even choice of a point of the ring between two radii, from two uniforms.
template <class T>
PlanePoint<T> ring_point(const T& inner, const T& outer, const T& u_radius, const T& u_azimuth) {
  using std::sqrt;
  const T radius = sqrt(inner * inner + u_radius * (outer * outer - inner * inner));
  const auto [cosine, sine] = cos_sin_of_turns(u_azimuth);
  return {radius * cosine, radius * sine};
}

/// An even choice of a point of the open lens.
template <class T>
PlanePoint<T> lens_point(const Telescope<T>& telescope, const T& u_radius, const T& u_azimuth) {
  return ring_point(telescope.obstruction_radius, telescope.lens_radius, u_radius, u_azimuth);
}

/// Returns whether a point of the lens' plane is open.
template <class T>
Mask<T> open_at(const Telescope<T>& telescope, const PlanePoint<T>& p) {
  const T squared = p.x * p.x + p.y * p.y;
  return (squared < telescope.lens_radius * telescope.lens_radius) &
         (squared >= telescope.obstruction_radius * telescope.obstruction_radius);
}

/// The vector that leads so far along a telescope's directions.
template <class T>
Vec3<T> in_plane(const Telescope<T>& telescope, const PlanePoint<T>& p) {
  return p.x * telescope.across + p.y * telescope.up;
}
/// The components of a vector along a telescope's directions.
template <class T>
PlanePoint<T> parts_in_plane(const Telescope<T>& telescope, const Vec3<T>& v) {
  return {dot(v, telescope.across), dot(v, telescope.up)};
}
/// The place of a point of the lens.
template <class T>
Vec3<T> in_space(const Telescope<T>& telescope, const PlanePoint<T>& p) {
  return telescope.position + in_plane(telescope, p);
}

/// The excess of a way in the air from a place to a point of the lens, of the given length, over
/// that from the origin to its centre [m].
template <class T>
T longer_way(const Telescope<T>& telescope, const Vec3<T>& from, const PlanePoint<T>& p,
             const T& length) {
  return longer_by(telescope.position, in_plane(telescope, p) - from, telescope.distance + length);
}

/// Telescope::may_see_beyond() for the way to one point of the lens. (x, y) leads to its centre.
template <class T>
Mask<T> may_see_by_ray(const Telescope<T>& telescope, const PlanePoint<T>& p, const T& x,
                       const T& y, const T& rise) {
  if (!telescope.upright) return telescope.may_see_beyond(x, y, rise);
  // See sight(): the way leads aside by no more than the detector's half view, but for what light
  // from a point that is not seen sharp is aside of the lens' centre.
  const T blurred = T(1) - rise * telescope.per_sharp_range;
  const T aside_x = x + blurred * (p.x * telescope.across.x + p.y * telescope.up.x);
  const T aside_y = y + blurred * (p.x * telescope.across.y + p.y * telescope.up.y);
  const T farthest = rise * telescope.reach.tangent_of_ray;
  return aside_x * aside_x + aside_y * aside_y <= farthest * farthest;
}

/// The detector's view through one point of the lens.
template <class T>
struct Sight {
  Mask<T> on_detector{};  ///< true if a ray is seen
  T cos_off_axis{1};      ///< of the ray outside, to the axis
  T image_squared{};      ///< (how far from the axis it falls, times that cosine)^2 [m^2]

  /// Returns whether a ray from ahead falls on a detector of a radius, at the same place.
  Mask<T> falls_within(const T& detector_radius) const {
    const T radius = detector_radius * cos_off_axis;
    return image_squared < radius * radius;
  }
};

/// Rays of a tilted lens that are flatter, by their cosine to the vertical, are not translated:
/// their ways would become longer by many of its radii.
inline constexpr double flattest_translated = 0.2;

/// The area of the open lens as rays of a direction come through it on a horizontal plane: so far
/// may they be translated sideways [m^2]. `direction`: either way; 0 of rays that are too flat for
/// that under a tilted lens.
template <class T>
T translation_area(const Telescope<T>& telescope, const Vec3<T>& direction) {
  using std::abs;
  if (telescope.upright) return telescope.area();
  const T steep = abs(direction.z);
  const Mask<T> translates = steep >= T(flattest_translated);
  return select(
      translates,
      telescope.area() * abs(dot(direction, telescope.axis)) / select(translates, steep, T(1)),
      T(0));
}

/// The share of the open lens through which rays of a direction, either way, fall on the detector:
/// in focus all of it or nothing, and then 1 is returned, as for a ray that is seen. Else it is
/// that of light from infinitely far away, Telescope::overlap(). It is at least 1e-6, since the ray
/// that asks is seen, whatever rounding makes of it.
template <class T>
T share_that_sees(const Telescope<T>& telescope, const Vec3<T>& direction) {
  using std::abs;
  using std::sqrt;
  const T defocus = abs(telescope.detector_distance * telescope.per_sharp_range);
  if (!any(defocus > telescope.min_defocus)) return T(1);
  const auto aside = parts_in_plane(telescope, direction);
  const T tangent =
      sqrt(aside.x * aside.x + aside.y * aside.y) / abs(dot(direction, telescope.axis));
  const T share = telescope.overlap(T(0), tangent);
  return select(share > T(1e-6), share, T(1e-6));
}

/// The shift of a ray's point on the lens if all of its light's way beyond is translated sideways;
/// and the excess of its way from there, along the ray.
template <class T>
struct LensTranslation {
  PlanePoint<T> aside{};  ///< [m]
  T longer{};             ///< [m]; 0 of an upright lens
};
/// `outward`: the ray's direction; `translation`: level.
template <class T>
LensTranslation<T> lens_translation(const Telescope<T>& telescope, const Vec3<T>& outward,
                                    const Vec3<T>& translation) {
  const T longer = dot(translation, telescope.axis) / dot(outward, telescope.axis);
  return {parts_in_plane(telescope, translation - longer * outward), longer};
}
/// The excess of a ray's way if its point on the lens is shifted so far [m].
template <class T>
T longer_by_translation(const Telescope<T>& telescope, const Vec3<T>& outward,
                        const PlanePoint<T>& aside) {
  return T(0) - in_plane(telescope, aside).z / outward.z;
}
/// No translation makes a way longer or shorter by more than this [m].
inline double max_longer(const scene::Telescope& telescope) {
  return 2 / flattest_translated * lens_rise(telescope);
}

/// Returns whether points of the lens are at several depths in the water.
template <class T>
bool is_aslant(const Telescope<T>& telescope) {
  return telescope.inside && !telescope.upright;
}
/// Returns whether walks from all points of the lens come to a depth, so that those that collide
/// there first may be translated.
template <class T>
Mask<T> all_points_reach(const Telescope<T>& telescope, const T& depth) {
  using std::abs;
  if (!is_aslant(telescope)) return Mask<T>(true);
  return abs(depth + telescope.position.z) >= telescope.lens_rise;
}

/// Light that arrives at a point of the lens in a direction.
template <class T>
Sight<T> sight(const Telescope<T>& telescope, const PlanePoint<T>& p, const Vec3<T>& arriving) {
  Sight<T> seen;
  const T towards = -dot(arriving, telescope.axis);
  const Mask<T> in_front = towards > T(0);
  seen.cos_off_axis = select(in_front, towards, T(1));
  // Its place on the detector, times that cosine.
  const T from_lens =
      T(0) - telescope.detector_distance * telescope.per_sharp_range * seen.cos_off_axis;
  const T x = p.x * from_lens + telescope.detector_distance * dot(arriving, telescope.across);
  const T y = p.y * from_lens + telescope.detector_distance * dot(arriving, telescope.up);
  seen.image_squared = x * x + y * y;
  seen.on_detector = in_front & seen.falls_within(telescope.detector_radius);
  return seen;
}

/// The direction of a ray from the lens that leads aside so far per length along the axis.
template <class T>
Vec3<T> outward(const Telescope<T>& telescope, const PlanePoint<T>& slope) {
  return normalised(telescope.axis + in_plane(telescope, slope));
}
/// The sight of light that comes in by such a ray, through a point of the lens; as if along the
/// axis.
template <class T>
Sight<T> sight_along(const Telescope<T>& telescope, const PlanePoint<T>& p,
                     const PlanePoint<T>& slope) {
  const PlanePoint<T> image = telescope.detector_distance * (slope + telescope.per_sharp_range * p);
  Sight<T> seen;
  seen.image_squared = image.x * image.x + image.y * image.y;
  seen.on_detector = seen.falls_within(telescope.detector_radius);
  return seen;
}

}  // namespace photic::instrument
