// Entry cones under waves: as wide as facets send the rays of an instrument, most walks where most
// light goes, a few everywhere, for steep facets and whitecaps (docs/theory.md, "Walks through
// waves").
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/random.hpp"
#include "estimator/crossing.hpp"
#include "estimator/entry_cone.hpp"
#include "geometry/axis.hpp"
#include "instrument/laser.hpp"
#include "transport/surface_points.hpp"

namespace photic::estimator {
namespace {

/// The share of the light that comes down along a direction and goes into the water by way of
/// several facets. From a thousand rays, always the same ones.
double share_of_several(const medium::MediumView& sea, const Vec3<double>& outside) {
  constexpr int rays = 1024;
  const auto surface = surface::rough_surface<double>(sea, 0);
  const RandomKey key{0};
  double sum = 0;
  for (std::uint64_t n = 0; n < rays; ++n) {
    transport::Photon<double> photon;
    photon.direction = outside;
    const auto draw = [&](std::uint32_t block) { return uniforms<double>(key, n, 0, block); };
    const auto met = walk_by_facets(false, surface, photon, true, true, Facets::any, draw,
                                    [](bool, const surface::FacetHit<double>&) {});
    if (met.in_water && met.several) sum += std::min(photon.weight, 10.0);
  }
  return sum / rays;
}

/// Edges of the rings, in deviations of the directions that light takes.
constexpr std::array edges{0.6, 1.1, 1.6, 2.2, 3.0, 4.2, 6.0};
/// Directions are drawn from a Gaussian so much wider than that.
constexpr double wider = 1.1;
/// The share that is drawn evenly over all other directions; with whitecaps.
constexpr double share_aside = 0.02, share_with_whitecaps = 0.06;
/// The cone's rim leaves so much to the horizon [rad].
constexpr double above_horizon = 0.1;

/// `deviation`: of the angle to the axis, along each of two directions across it [rad]; `most`: the
/// widest half angle [rad].
void set_rings(double deviation, double most, double aside, EntryCone<double>& cone) {
  const auto within = [](double k) { return 1 - std::exp(-k * k / (2 * wider * wider)); };
  const double all = 1 - cone.by_facets;
  double x_before = 0, share_before = 0;
  cone.rings = 0;
  for (const double k : edges) {
    const double angle = std::min(k * deviation, most);
    const bool last = k == edges.back() || angle == most;
    const double x = one_minus_cos_of(angle);
    const double share = (all - aside) * (last ? 1 : within(k));
    cone.ring.at(cone.rings++) = {x, share, 2 * pi * (x - x_before) / (share - share_before)};
    x_before = x, share_before = share;
    if (last) break;
  }
  cone.free_within = x_before;
  cone.free_share = share_before;
  cone.ring.at(cone.rings++) = {2, all, 2 * pi * (2 - x_before) / aside};
}

/// Free walks come through the surface where slopes lead them, which is seldom farther aside than
/// so many deviations.
constexpr double farthest = 5 * transport::wider_slopes;

/// Entries are drawn by slopes where an instrument's own rays fill a spot of the surface that is
/// wider than what slopes do with light from so deep [m].
constexpr double by_slopes_from = 10;

/// The turning of light in the water by slopes and rays, at a ray with the cosine `steep` to the
/// vertical there: angle there per slope, and per angle in the air.
struct Turning {
  double per_slope, per_angle, slope;  ///< `slope`: the larger deviation of slopes
};
Turning turning_at(double steep, const medium::Medium& medium) {
  const auto waves = medium.view().waves;
  const double n = medium.line.front().refractive_index;
  const double per_angle = std::sqrt(std::max(0.0, 1 - n * n * (1 - steep * steep))) / (n * steep);
  return {1 - per_angle, per_angle, std::max(waves.upwind_deviation, waves.crosswind_deviation)};
}
/// Returns whether the rays of an instrument at such a height are wider than slopes make them.
/// `radius`: of the spot that its rays fill on the surface, across them [m].
bool are_wider_than_slopes(double height, double radius, const EntryCone<double>& flat,
                           const medium::Medium& medium) {
  if (height < 0 || !medium.view().surface.leads_anywhere) return false;
  const auto turning = turning_at(flat.steep, medium);
  return radius > by_slopes_from * turning.per_slope * turning.slope;
}
double spot_radius(const scene::Telescope& telescope) {
  return geometry::way_ahead(telescope.position_m, normalised(telescope.direction)) *
         std::tan(half_view(telescope));
}
/// 0 if its rays seem to come from no point above the surface.
double spot_radius(const scene::Source& source) {
  const auto laser = instrument::make_laser<double>(source);
  if (!can_be_met(laser)) return 0;
  return source.radius_of_all() + laser.ahead * std::tan(source.half_divergence_of_all());
}

/// Cosine to the vertical of an instrument's flattest ray in the water.
double flattest_steepness(const EntryCone<double>& flat, double half_angle,
                          const medium::Medium& medium) {
  const double n = medium.line.front().refractive_index;
  const double outside = std::acos(std::clamp(-flat.outside.z, -1.0, 1.0)) + half_angle;
  const double sine = std::sin(std::min(outside, pi / 2)) / n;
  return std::sqrt(1 - sine * sine);
}

/// The angles of an instrument's rays to its axis [rad].
struct Divergence {
  double deviation;  ///< along each of two directions across the axis
  double half_angle;
};
Divergence divergence_of(const scene::Telescope& telescope) {
  return {half_view(telescope) / 2, half_view(telescope)};
}
/// That of an even cone is half its half angle; that of a Gaussian half the angle of 1/e2.
Divergence divergence_of(const scene::Source& source) {
  return {source.half_divergence() / 2, source.half_divergence_of_all()};
}

/// `flat`: of the same instrument over a flat surface.
EntryCone<double> under_waves(const EntryCone<double>& flat, const Divergence& rays, bool by_slopes,
                              const medium::Medium& medium, double deepest, bool frees) {
  const auto sea = medium.view();
  EntryCone<double> cone = flat;
  cone.exact = true;
  cone.even_outside = false;
  if (!sea.surface.leads_anywhere) {
    cone.by_facets = 1;
    cone.spot = {};
    cone.by_depth = false;
    return cone;
  }
  cone.enters_by_slopes = by_slopes;
  cone.by_depth = frees && by_slopes;
  cone.about_rays = !cone.by_depth;
  const double steep =
      cone.about_rays ? flattest_steepness(flat, rays.half_angle, medium) : flat.steep;
  const auto [of_facets, of_rays, slope] = turning_at(steep, medium);
  const double deviation =
      std::hypot(of_facets * slope, cone.about_rays ? 0 : of_rays * rays.deviation);
  const double axis_angle = std::acos(steep);
  const double most = pi / 2 - above_horizon - axis_angle;
  const Vec3<double> down = cone.outside.z < 0 ? cone.outside : Vec3<double>{0, 0, -1};
  cone.by_facets = std::clamp(1.5 * share_of_several(sea, down), 0.005, 0.3);
  set_rings(deviation, most, sea.waves.whitecap_fraction > 0 ? share_with_whitecaps : share_aside,
            cone);
  Spot<double>& spot = cone.spot;
  if (!cone.by_depth) {  // no walk is free, and none becomes shorter
    spot = {};
    return cone;
  }
  spot.radius_per_depth += farthest * of_facets * slope / (cone.steep * cone.steep);
  spot.min_path_per_depth = std::numeric_limits<double>::infinity();
  double max_per_depth = 0;
  const double flattest = std::min(axis_angle + std::acos(1 - cone.free_within), 1.4);
  for (const auto& line : medium.line) {
    spot.min_path_per_depth = std::min(spot.min_path_per_depth, line.group_index);
    max_per_depth = std::max(max_per_depth, line.group_index / std::cos(flattest));
  }
  spot.max_shorter += deepest * (max_per_depth - spot.min_path_per_depth);
  return cone;
}

/// The share of walks that begin at the facets, of those of an instrument in the water whose rays
/// go up; and its least share of all walks, if any rays do.
constexpr double share_by_facets = 0.25, min_by_facets = 0.02;

/// The share of a cone that goes up.
double share_upwards(const Vec3<double>& axis, double half_angle) {
  if (std::asin(std::clamp(axis.z, -1.0, 1.0)) + half_angle <= 0) return 0;
  constexpr int rings = 64, azimuths = 64;
  const double widest = one_minus_cos_of(half_angle);
  int up = 0;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < azimuths; ++j) {
      const double azimuth = 2 * pi * (j + 0.5) / azimuths;
      const double x = widest * (i + 0.5) / rings;
      up += turned(axis, x, std::cos(azimuth), std::sin(azimuth)).z > 0;
    }
  return std::max(min_by_facets / share_by_facets, static_cast<double>(up) / (rings * azimuths));
}

}  // namespace

void begin_some_at_facets(double half_angle, EntryCone<double>& cone) {
  cone.by_facets = share_by_facets * share_upwards(cone.axis, half_angle);
  for (std::size_t k = 0; k < cone.rings; ++k) {
    cone.ring.at(k).up_to *= cone.others();
    cone.ring.at(k).solid_angle /= cone.others();
  }
}

bool enters_by_slopes(const scene::Telescope& telescope, const medium::Medium& medium) {
  return are_wider_than_slopes(telescope.position_m.z, spot_radius(telescope),
                               entry_cone(telescope, medium, 0), medium);
}
bool enters_by_slopes(const scene::Source& source, const medium::Medium& medium) {
  return are_wider_than_slopes(source.position_m.z, spot_radius(source),
                               entry_cone(source, medium, 0), medium);
}

EntryCone<double> cone_under_waves(const scene::Telescope& telescope, const medium::Medium& medium,
                                   double deepest, bool frees) {
  return under_waves(entry_cone(telescope, medium, deepest), divergence_of(telescope),
                     enters_by_slopes(telescope, medium), medium, deepest, frees);
}
EntryCone<double> cone_under_waves(const scene::Source& source, const medium::Medium& medium,
                                   double deepest, bool frees) {
  return under_waves(entry_cone(source, medium, deepest), divergence_of(source),
                     enters_by_slopes(source, medium), medium, deepest, frees);
}

}  // namespace photic::estimator
