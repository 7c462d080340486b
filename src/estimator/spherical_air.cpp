#include "estimator/spherical_air.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace photic::estimator {
namespace {

constexpr double metres_per_km = 1000;

/// Refraction is left out: the straight line is what the scene gives.
std::string continuation_text(const scene::Scene& scene) {
  const double radius = scene.atmosphere->planet_radius_m();
  const scene::Source& source = scene.source;
  const Vec3<double> from_centre = source.position_m + Vec3<double>{0, 0, radius};
  const double height = scene.height_of(source.position_m);
  const double rise = dot(from_centre, normalised(source.direction));
  const double square = rise * rise - height * (2 * radius + height);
  if (rise >= 0) return "straight ahead, the source's axis leads away from the planet";
  if (square < 0) {
    const double nearest = std::sqrt(radius * radius - square) - radius;
    return fmt::format(
        "straight ahead, the source's axis passes the planet at a height of {:.6g} km",
        nearest / metres_per_km);
  }
  const double cosine = std::min(1.0, std::sqrt(square) / radius);
  return fmt::format(
      "straight ahead, the source's axis meets the ground at a zenith angle of {:.6g} degrees",
      std::acos(cosine) / radian_per_degree);
}

}  // namespace

std::vector<std::string> reported_spherical_air(const scene::Scene& scene) {
  if (!scene.is_of_spherical_air()) return {};
  std::vector<std::string> out{
      fmt::format("shells about a planet with a radius of {:.6g} km, whose centre is that far "
                  "straight below the origin",
                  scene.atmosphere->planet_radius_km)};
  if (!scene.source.is_everywhere) out.push_back(continuation_text(scene));
  return out;
}

}  // namespace photic::estimator
