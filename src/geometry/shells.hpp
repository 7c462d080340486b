// Light in spherical air: the spheres that a ray meets one after the other, in the plane that the
// ray and the planet's centre lie in. Heights keep their digits however large the planet is, since
// spheres differ by (H - h)(2R + h + H) and not by squares of radii; at a sphere the height is set
// to the sphere's (docs/theory.md, section 19).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/vec3.hpp"
#include "medium/shells.hpp"

namespace photic::geometry {

using medium::ShellsView;

/// A place in spherical air, in coordinates whose z is 0 at the top of the air.
struct PlaceInShells {
  Vec3<double> from_centre;  ///< [m]
  double height = 0;         ///< above the ground [m]
};
inline PlaceInShells place_in(const ShellsView& shells, const Vec3<double>& position) {
  const double z = position.z + shells.top_m();
  const Vec3<double> from_centre{position.x, position.y, z + shells.planet_m};
  const double aside = position.x * position.x + position.y * position.y;
  return {from_centre,
          (aside + z * (z + 2 * shells.planet_m)) / (length(from_centre) + shells.planet_m)};
}

/// The direction straight up at a place.
inline Vec3<double> local_vertical(const ShellsView& shells, const Vec3<double>& position) {
  return normalised(place_in(shells, position).from_centre);
}

/// A point of a ray: its height, and its distance along the ray's straight line from the point of
/// that line that is nearest to the centre, which is r times the cosine to the local vertical.
struct ShellRay {
  double height = 0;  ///< above the ground [m]
  double radius = 0;  ///< from the centre [m]
  double rise = 0;    ///< r cos [m]
  std::int32_t shell = 0;

  [[nodiscard]] double cosine() const { return rise / radius; }
  /// The distance of the straight line from the centre [m].
  [[nodiscard]] double nearest() const {
    return std::sqrt(std::max(0.0, (radius - rise) * (radius + rise)));
  }
};

/// By how much the square of the radius is larger at one height than at another [m2].
inline double square_above(const ShellsView& shells, double height, double lower) {
  return (height - lower) * (2 * shells.planet_m + lower + height);
}

/// The way of a ray to the next sphere.
struct Leg {
  double length = 0;
  std::size_t sphere = 0;
  double rise = 0;  ///< at its end
};
/// Down to the sphere below if the ray meets it, else up to the one above: by one number, the root
/// that is also the way.
inline Leg leg_ahead(const ShellsView& shells, const ShellRay& ray) {
  const auto above = static_cast<std::size_t>(ray.shell);
  const double square = ray.rise * ray.rise;
  if (ray.rise < 0) {
    const double step = square_above(shells, ray.height, shells.height[above + 1]);
    if (square >= step) {
      const double root = std::sqrt(square - step);
      return {step / (root - ray.rise), above + 1, -root};
    }
  }
  const double step = square_above(shells, shells.height[above], ray.height);
  const double root = std::sqrt(square + step);
  return {ray.rise > 0 ? step / (root + ray.rise) : root - ray.rise, above, root};
}

/// The end of a leg.
inline ShellRay end_of(const ShellsView& shells, const ShellRay& ray, const Leg& leg) {
  const double height = shells.height[leg.sphere];
  return {height, shells.planet_m + height, leg.rise, ray.shell};
}
/// The point of a ray so much farther, within its shell.
inline ShellRay farther(const ShellRay& ray, double length) {
  const double step = length * (2 * ray.rise + length);
  const double radius = std::sqrt(ray.radius * ray.radius + step);
  return {ray.height + step / (radius + ray.radius), radius, ray.rise + length, ray.shell};
}

/// Has a ray cross the sphere that it has come to, by Snell's law where shells bend light; it stays
/// in its shell in total reflection. Above shell 0 it has left the air.
inline void cross_sphere(const ShellsView& shells, ShellRay& ray, std::size_t sphere) {
  const bool up = sphere == static_cast<std::size_t>(ray.shell);
  if (shells.bend()) {
    const double bent = up ? shells.upwards[sphere] : shells.downwards[sphere];
    const double square =
        ray.rise * ray.rise + bent * (ray.radius - ray.rise) * (ray.radius + ray.rise);
    if (square < 0) {
      ray.rise = -ray.rise;
      return;
    }
    ray.rise = up ? std::sqrt(square) : -std::sqrt(square);
  }
  ray.shell += up ? -1 : 1;
}

/// The central angle from the start of a ray.
struct Turn {
  double cosine = 1, sine = 0;

  [[nodiscard]] Turn by(const Turn& other) const {
    return {cosine * other.cosine - sine * other.sine, sine * other.cosine + cosine * other.sine};
  }
};
/// That of a straight piece to a radius.
inline Turn turn_of(const ShellRay& from, double length, double radius) {
  const double per_radii = 1 / (from.radius * radius);
  return {(from.radius * from.radius + length * from.rise) * per_radii,
          length * from.nearest() * per_radii};
}

/// The plane of a ray: unit vectors straight up where it starts, and horizontally ahead.
struct PlaneOfRay {
  Vec3<double> up, ahead;

  /// The local vertical after a turn, and the direction of a ray there.
  [[nodiscard]] Vec3<double> vertical(const Turn& turn) const {
    return turn.cosine * up + turn.sine * ahead;
  }
  [[nodiscard]] Vec3<double> direction(const Turn& turn, double cosine) const {
    const double sine = std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine)));
    const Vec3<double> horizontal = turn.cosine * ahead - turn.sine * up;
    return normalised(cosine * vertical(turn) + sine * horizontal);
  }
};
inline PlaneOfRay plane_of(const Vec3<double>& from_centre, const Vec3<double>& direction) {
  const Vec3<double> up = normalised(from_centre);
  Vec3<double> ahead = direction - dot(direction, up) * up;
  constexpr double vertical = 1e-12;  // any plane is as good then
  if (length(ahead) < vertical)
    ahead =
        std::abs(up.z) > 0.5 ? Vec3<double>{1, 0, -up.x / up.z} : cross(up, Vec3<double>{0, 0, 1});
  return {up, normalised(ahead)};
}

/// Axes of a frame whose z is straight up. Source: Duff et al., J. Comput. Graph. Tech. 6(1), 1
/// (2017).
struct LocalFrame {
  Vec3<double> x, y, z;

  explicit LocalFrame(const Vec3<double>& up) : z(up) {
    const double sign = std::copysign(1.0, up.z);
    const double a = -1 / (sign + up.z), b = up.x * up.y * a;
    x = {1 + sign * up.x * up.x * a, sign * b, -sign * up.x};
    y = {b, sign + up.y * up.y * a, -up.y};
  }
};
inline Vec3<double> in_local_frame(const Vec3<double>& up, const Vec3<double>& direction) {
  const LocalFrame frame(up);
  return {dot(frame.x, direction), dot(frame.y, direction), dot(frame.z, direction)};
}
inline Vec3<double> from_local_frame(const Vec3<double>& up, const Vec3<double>& local) {
  const LocalFrame frame(up);
  return normalised(local.x * frame.x + local.y * frame.y + local.z * frame.z);
}

/// The ray of light in a shell. Places on its spheres, but for what is rounded off, are on them.
inline ShellRay ray_in(const ShellsView& shells, const PlaceInShells& at,
                       const Vec3<double>& direction, std::int32_t shell) {
  constexpr double rounding = 1e-13;  // of the radius
  const auto above = static_cast<std::size_t>(shell);
  const double lower = shells.height[above + 1], upper = shells.height[above];
  const double nearly = rounding * shells.planet_m;
  const double height = at.height < lower + nearly   ? lower
                        : at.height > upper - nearly ? upper
                                                     : at.height;
  return {height, shells.planet_m + height, dot(at.from_centre, direction), shell};
}

}  // namespace photic::geometry
