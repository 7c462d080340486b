#include "estimator/entry_cone.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "estimator/ahead.hpp"
#include "geometry/axis.hpp"
#include "instrument/laser.hpp"
#include "instrument/telescope.hpp"

namespace photic::estimator {
namespace {

/// An instrument: where its light spreads from, and by how much its rays may be off its axis [rad].
struct Rays {
  Vec3<double> position, axis;
  double half_angle;
  std::size_t lines;  ///< so many of the medium's
  bool outside;       ///< the instrument, wherever its light spreads from

  [[nodiscard]] bool vertical() const { return axis.x == 0 && axis.y == 0; }
};

/// Below the horizon by no less than this: flatter rays count as this one.
constexpr double horizon = 1e-4;

/// Calls f(outside, in water, line) for rays that lie evenly about the axis out to its farthest.
/// Rays in the air that do not look down have the horizon's direction.
template <class F>
void each_ray(const Rays& rays, const medium::Medium& medium, F f) {
  const int azimuths = rays.vertical() ? 1 : 256;
  constexpr int radii = 32;
  for (int i = 0; i <= radii; ++i) {
    const double x = one_minus_cos_of(rays.half_angle * i / radii);
    for (int j = 0; j < azimuths; ++j) {
      const double azimuth = 2 * pi * j / azimuths;
      auto outside = turned(rays.axis, x, std::cos(azimuth), std::sin(azimuth));
      if (rays.outside && outside.z > -horizon) {
        outside.z = 0;
        const double level = length(outside);
        if (level == 0) continue;
        outside = normalised(Vec3<double>{outside.x / level, outside.y / level, -horizon});
      }
      for (std::size_t l = 0; l < rays.lines; ++l) {
        const double n = medium.line[l].refractive_index;
        f(outside,
          rays.outside
              ? Vec3<double>{outside.x / n, outside.y / n, -geometry::cosine_in_water(outside.z, n)}
              : outside,
          l);
      }
    }
  }
}

/// The factor for points between two azimuths, which are farther by no more than (pi / 256)^2 / 2
/// of all.
constexpr double between = 1 + 1e-4;

/// `path`: of a ray to the surface, or where it begins to spread in the water, as walks count it.
Spot<double> spot_of(const Rays& rays, const medium::Medium& medium, const Vec3<double>& in_water,
                     double deepest, const std::function<double(const Vec3<double>&)>& path) {
  Spot<double> spot;
  const double height = rays.outside ? rays.position.z : 0;
  const Vec3<double> axis = rays.axis.z < 0 || !rays.outside ? rays.axis : Vec3<double>{0, 0, -1};
  spot.x = rays.position.x + height * axis.x / -axis.z;
  spot.y = rays.position.y + height * axis.y / -axis.z;
  spot.x_per_depth = in_water.x / -in_water.z;
  spot.y_per_depth = in_water.y / -in_water.z;
  double most = 0, max_per_depth = 0;
  spot.min_path = spot.min_path_per_depth = std::numeric_limits<double>::infinity();
  each_ray(rays, medium, [&](const Vec3<double>& outside, const Vec3<double>& u, std::size_t l) {
    const double aside = std::hypot(outside.x / -outside.z - axis.x / -axis.z,
                                    outside.y / -outside.z - axis.y / -axis.z);
    spot.radius = std::max(spot.radius, height * aside);
    spot.radius_per_depth = std::max(
        spot.radius_per_depth,
        std::hypot(u.x / u.z - in_water.x / in_water.z, u.y / u.z - in_water.y / in_water.z));
    const double at_surface = path(outside);
    const double per_depth = medium.line[l].group_index / std::abs(u.z);
    spot.min_path = std::min(spot.min_path, at_surface);
    spot.min_path_per_depth = std::min(spot.min_path_per_depth, per_depth);
    most = std::max(most, at_surface);
    max_per_depth = std::max(max_per_depth, per_depth);
  });
  spot.radius *= between;
  spot.radius_per_depth *= between;
  const double way_down =  // in the water perhaps by the surface
      deepest + (rays.outside ? 0 : std::abs(rays.position.z));
  spot.max_shorter = most - spot.min_path + way_down * (max_per_depth - spot.min_path_per_depth);
  return spot;
}

/// Even in a cone, and shares in narrower ones. `inner`: 1 - cos of the half angle, and share.
void set_rings(double one_minus_cos, std::vector<std::pair<double, double>> inner,
               EntryCone<double>& cone) {
  if (one_minus_cos == 0) return;
  std::ranges::sort(inner);
  double left = 1, per_solid_angle = 0;
  for (const auto& [x, share] : inner) left -= share, per_solid_angle += share / (2 * pi * x);
  inner.emplace_back(one_minus_cos, left);
  per_solid_angle += left / (2 * pi * one_minus_cos);
  double within = 0, x_within = 0;
  cone.rings = 0;
  for (const auto& [x, share] : inner) {
    within += 2 * pi * (x - x_within) * per_solid_angle;
    cone.ring.at(cone.rings++) = {x, within, 1 / per_solid_angle};
    per_solid_angle -= share / (2 * pi * x);
    x_within = x;
  }
}

/// 1 - cos of the half angle of a cone in the water about an axis that holds all rays.
double widest_in_water(const Rays& rays, const medium::Medium& medium, const Vec3<double>& axis) {
  if (!rays.outside) return one_minus_cos_of(rays.half_angle);
  double widest = 0;
  each_ray(rays, medium, [&](const Vec3<double>&, const Vec3<double>& u, std::size_t) {
    widest = std::max(widest, one_minus_cos(u, axis));
  });
  return rays.vertical() ? widest : widest * between;
}

EntryCone<double> cone_of(const Rays& rays, const medium::Medium& medium) {
  EntryCone<double> cone;
  cone.begins_outside = rays.outside;
  cone.outside = rays.axis;
  if (!cone.begins_outside) {
    cone.axis = rays.axis;
    cone.steep = std::abs(rays.axis.z);
    // Some points of a tilted instrument are deeper than others; and flat rays come far by little
    // depth.
    constexpr double flattest = 0.2;
    cone.by_depth = rays.half_angle > 0 && rays.vertical() && std::cos(rays.half_angle) >= flattest;
    cone.exact = true;
    return cone;
  }
  const double n = medium.line.front().refractive_index;
  const bool looks_down = rays.axis.z < 0;
  cone.axis = looks_down ? Vec3<double>{rays.axis.x / n, rays.axis.y / n,
                                        -geometry::cosine_in_water(rays.axis.z, n)}
                         : Vec3<double>{0, 0, -1};
  if (!looks_down) cone.beside_x = -rays.axis.x, cone.beside_y = -rays.axis.y;
  cone.steep = -cone.axis.z;
  cone.by_depth = rays.half_angle > 0;
  cone.exact =
      rays.vertical() && looks_down && rays.lines == 1 && rays.half_angle < pi / 2 - horizon;
  return cone;
}

/// With the rings that are drawn in the water or, of own rays, outside.
void set_rings(const Rays& rays, const std::vector<InnerCone>& inner, const medium::Medium& medium,
               EntryCone<double>& cone) {
  const auto widest = [&](double half_angle) {
    Rays within = rays;
    within.half_angle = half_angle;
    return cone.even_outside ? one_minus_cos_of(half_angle)
                             : widest_in_water(within, medium, cone.axis);
  };
  const double whole = widest(rays.half_angle);
  std::vector<std::pair<double, double>> narrower;
  for (const auto& [half_angle, share] : inner) {
    const double x = widest(half_angle);
    if (x < whole) narrower.emplace_back(x, share);
  }
  set_rings(whole, narrower, cone);
}

/// All rays that some point of the lens may see.
Rays rays_of(const scene::Telescope& telescope, const medium::Medium& medium) {
  return {telescope.position_m, normalised(telescope.direction), half_view(telescope),
          medium.line.size(), !geometry::stands_in_water(telescope.position_m)};
}
Rays rays_of(const scene::Source& source) {
  return {source.position_m, normalised(source.direction), source.half_divergence_of_all(), 1,
          !geometry::stands_in_water(source.position_m)};
}

/// The narrower cones in which a share of the laser's walks begins: together they follow a
/// Gaussian, but for a share that is even to the rim, so that its wings have walks, too.
std::vector<InnerCone> beam_cones(const scene::Source& source) {
  std::vector<InnerCone> inner;
  if (source.profile == scene::SourceProfile::disc) return inner;
  constexpr double even_share = 0.1;
  constexpr std::array rims{0.5, 0.75, 1.0, 1.25, 1.6, 2.0, 2.5, scene::gaussian_cut};
  const auto decay = [](double rim) { return 2 * rim * rim; };
  // Of the ring within a rim, by decay.
  const auto density = [&](std::size_t k) {
    const double from = k == 0 ? 0 : decay(rims.at(k - 1)), to = decay(rims.at(k));
    return (std::exp(-from) - std::exp(-to)) / (to - from);
  };
  for (std::size_t k = 0; k + 1 < rims.size(); ++k)
    inner.push_back({rims.at(k) * source.half_divergence(),
                     (1 - even_share) * decay(rims.at(k)) * (density(k) - density(k + 1))});
  return inner;
}

/// The way to where paths of an instrument above air begin; 0 for all others.
template <class Instrument>
geometry::Ahead above_air(const medium::Medium& medium, const Instrument& instrument) {
  return medium.kind == medium::MediumKind::water ? geometry::Ahead{}
                                                  : ahead_in(medium, instrument);
}

EntryCone<double> own_rays(const Rays& rays, const medium::Medium& medium,
                           const std::vector<InnerCone>& inner) {
  auto cone = cone_of(rays, medium);
  cone.even_outside = true;
  cone.by_depth = false;
  cone.exact = true;
  set_rings(rays, inner, medium, cone);
  if (!medium.view().surface.one_direction_each && !cone.begins_outside)
    begin_some_at_facets(rays.half_angle, cone);
  return cone;
}

}  // namespace

double half_view(const scene::Telescope& telescope) {
  const auto t = instrument::make_telescope<double>(telescope);
  return std::atan(t.detector_radius / t.detector_distance +
                   t.lens_radius * std::abs(t.per_sharp_range));
}

EntryCone<double> cone_of_own_rays(const scene::Telescope& telescope, const medium::Medium& medium,
                                   const std::vector<InnerCone>& inner) {
  auto cone = own_rays(rays_of(telescope, medium), medium, inner);
  cone.exact = instrument::per_sharp_range(telescope) == 0;
  return cone;
}
EntryCone<double> cone_of_own_rays(const scene::Source& source, const medium::Medium& medium) {
  return own_rays(rays_of(source), medium, beam_cones(source));
}

EntryCone<double> entry_cone(const scene::Telescope& telescope, const medium::Medium& medium,
                             double deepest, const std::vector<InnerCone>& inner) {
  const auto t = instrument::make_telescope<double>(telescope);
  const Rays rays = rays_of(telescope, medium);
  auto cone = cone_of(rays, medium);
  set_rings(rays, inner, medium, cone);
  cone.exact = cone.exact && t.per_sharp_range == 0;
  const double left_out = above_air(medium, telescope).to_sea > 0 ? t.distance : 0;
  cone.spot = spot_of(rays, medium, cone.axis, deepest, [&](const Vec3<double>& outside) {
    return rays.outside ? rays.position.z / -outside.z - t.distance : -left_out;
  });
  // From points of a tilted lens that are lower, or farther aside of the axis.
  const double rise = instrument::lens_rise(telescope);
  if (rays.outside && rise > 0) {
    cone.spot.radius *= 1 + rise / rays.position.z;
    const double shorter = rise / std::max(0.05, -t.axis.z);
    cone.spot.min_path -= 2 * shorter;
    cone.spot.max_shorter += 4 * shorter;
  }
  return cone;
}

EntryCone<double> entry_cone(const scene::Source& source, const medium::Medium& medium,
                             double deepest) {
  const auto laser = instrument::make_laser<double>(source);
  const Rays rays = rays_of(source);
  auto cone = cone_of(rays, medium);
  set_rings(rays, beam_cones(source), medium, cone);
  Rays from_vertex = rays;
  from_vertex.position = fictitious_vertex(laser);
  if (rays.outside && geometry::stands_in_water(from_vertex.position))
    from_vertex.position = rays.position;  // not used
  const geometry::Ahead left_out = above_air(medium, source);
  cone.spot = spot_of(from_vertex, medium, cone.axis, deepest, [&](const Vec3<double>& outside) {
    const double secant = 1 / dot(outside, laser.axis);
    if (!rays.outside) return -(laser.vertex_distance * secant + left_out.length + left_out.to_sea);
    // The excess of the way from the disc on over the axis' own to its start.
    return from_vertex.position.z / -outside.z - laser.vertex_distance * secant - laser.ahead;
  });
  return cone;
}

}  // namespace photic::estimator
