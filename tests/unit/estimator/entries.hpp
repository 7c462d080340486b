// What the edges of instruments above waves give to a path, by direct sums: how densely an
// instrument's own rays and slopes draw the point of the surface by which they go, how much light
// comes by it, and through how much of the lens the detector sees.
#pragma once

#include <array>
#include <cmath>
#include <complex>

#include "unit/estimator/paths.hpp"
#include "unit/instrument/share_of_lens.hpp"

namespace photic::estimator {

/// An instrument's edge of a path.
struct WayByEntry {
  V direction;            ///< in the water, to the vertex
  double length_air = 0;  ///< [m]
  double value = 1;       ///< of the path: what comes so, over how densely own rays draw the entry
                          ///< and walks the direction
  double area = 0;        ///< across the edge, of walks' directions, times how often entries are
                          ///< drawn that the edge is connected by [m^2]
  double freed = 1;       ///< share of that which free walks have, too
  double translation_area;  ///< of a telescope [m^2]
};

using Level = std::array<std::complex<double>, 2>;

/// The slopes of the facets that lead light from a point in water of index n by a point of the mean
/// surface to one in the air.
inline Level slopes_by(const V& from, double n, const V& to, const Level& at) {
  const auto unit = [](std::complex<double> x, std::complex<double> y, double z) {
    const std::complex<double> per_length = 1.0 / std::sqrt(x * x + y * y + z * z);
    return std::array{x * per_length, y * per_length, z * per_length};
  };
  const auto up = unit(at[0] - from.x, at[1] - from.y, -from.z);
  const auto on = unit(to.x - at[0], to.y - at[1], to.z);
  const std::complex<double> rise = on[2] - n * up[2];
  return {(n * up[0] - on[0]) / rise, (n * up[1] - on[1]) / rise};
}
/// How these change from point to point: [slope][coordinate], by a step aside into the imaginary.
inline std::array<std::array<double, 2>, 2> slopes_per_metre(const V& from, double n, const V& to,
                                                             const V& at) {
  constexpr double step = 1e-30;
  std::array<std::array<double, 2>, 2> out;
  for (std::size_t k = 0; k < 2; ++k) {
    Level aside{at.x, at.y};
    aside.at(k) += std::complex<double>(0, step);
    const Level slopes = slopes_by(from, n, to, aside);
    for (std::size_t i = 0; i < 2; ++i) out.at(i).at(k) = slopes.at(i).imag() / step;
  }
  return out;
}
/// The point by which level facets lead, by Newton's method.
inline V level_point(const V& from, double n, const V& to) {
  V at = from + (-from.z / (to.z - from.z)) * (to - from);
  for (int round = 0; round < 8; ++round) {
    const auto m = slopes_per_metre(from, n, to, at);
    const Level s = slopes_by(from, n, to, {at.x, at.y});
    const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    at.x -= (m[1][1] * s[0].real() - m[0][1] * s[1].real()) / determinant;
    at.y -= (m[0][0] * s[1].real() - m[1][0] * s[0].real()) / determinant;
  }
  return at;
}
/// How densely slopes 1.4 times as steep as the waves' draw a point, which changes the slope evenly
/// from the level one on (theory.md, eq. 90) [1/m^2].
inline double drawn_by_slopes(const World<double>& world, const V& from, double n, const V& to,
                              const V& at) {
  const auto& waves = world.slabs.waves;
  const V level = level_point(from, n, to);
  const auto m = slopes_per_metre(from, n, to, level);
  const V off = at - level;
  const double x = (m[0][0] * off.x + m[0][1] * off.y) / 1.4;
  const double y = (m[1][0] * off.x + m[1][1] * off.y) / 1.4;
  const double up = (x * waves.upwind_x + y * waves.upwind_y) / waves.upwind_deviation;
  const double across = (y * waves.upwind_x - x * waves.upwind_y) / waves.crosswind_deviation;
  return std::exp(-(up * up + across * across) / 2) /
         (2 * pi * waves.upwind_deviation * waves.crosswind_deviation) *
         std::abs(m[0][0] * m[1][1] - m[0][1] * m[1][0]) / (1.4 * 1.4);
}

/// How much of light that goes one way another one's facets send there, per solid angle.
inline double sent_on(const World<double>& world, std::int32_t line, bool down, const V& from,
                      const V& to) {
  return surface::rough_surface<double>(world.slabs, line).density(down, false, from, to);
}

/// With what is the same of both instruments. `outside`: direction of the ray away from the
/// instrument, whose light seems to come from `place`; `by_rays`: density of its own rays at the
/// entry.
inline void add_connections(const World<double>& world, std::int32_t instrument, std::int32_t line,
                            const V& outside, const V& place, const Entry& entry, const V& vertex,
                            double by_rays, WayByEntry& way) {
  const auto& cone = world.walks.cone(instrument);
  if (entry.drawn_weight > 0) {
    way.value = entry.drawn_weight;
    return;
  }
  const double n_axis = world.slabs.index[0], n = world.slabs.index[line];
  const V refracted{outside.x / n_axis, outside.y / n_axis,
                    -geometry::cosine_in_water(outside.z, n_axis)};
  const double solid_angle =
      cone.solid_angle_at(one_minus_cos(way.direction, cone.about_rays ? refracted : cone.axis));
  const double ratio =
      cone.enters_by_slopes ? drawn_by_slopes(world, vertex, n, place, entry.at) / by_rays : 0;
  const V edge = vertex - entry.at;
  way.value *= solid_angle;
  way.area = (1 + ratio) * solid_angle * dot(edge, edge);
  way.freed = ratio / (1 + ratio);
}

/// Of the laser's light the share comes by a level area that its own rays are drawn with.
inline WayByEntry way_of_laser(const World<double>& world, const Path& path) {
  const auto& laser = world.instruments.laser;
  const Entry& entry = *path.laser_entry;
  const V from_vertex = entry.at - fictitious_vertex(laser);
  const V outside = normalised(from_vertex);
  WayByEntry way;
  way.direction = normalised(path.x(1) - entry.at);
  way.length_air = length(from_vertex) - laser.vertex_distance / dot(outside, laser.axis);
  way.value = sent_on(world, 0, true, outside, way.direction);
  const double by_rays = -outside.z / dot(from_vertex, from_vertex) /
                         (2 * pi * laser.even_within(one_minus_cos(outside, laser.axis)));
  add_connections(world, of_laser, 0, outside, fictitious_vertex(laser), entry, path.x(1), by_rays,
                  way);
  return way;
}

/// What leaves the water at an entry for a point of the lens is reported as by the local estimate
/// (theory.md, eq. 89).
inline WayByEntry way_of_telescope(const World<double>& world, const Path& path) {
  const auto& telescope = world.instruments.telescopes[0];
  const Entry& entry = *path.telescope_entry;
  const V lens = in_space(telescope, path.lens), on = lens - entry.at, seen = normalised(on);
  const double square = dot(on, on), cosine = -dot(seen, telescope.axis);
  const double per_half_view = telescope.detector_distance / telescope.detector_radius;
  WayByEntry way;
  way.direction = normalised(path.x(path.order()) - entry.at);
  way.length_air = length(on);
  const double by_rays =
      per_half_view * per_half_view / pi * seen.z / (cosine * cosine * cosine * square);
  way.value = sent_on(world, path.line, false, -way.direction, seen) * -way.direction.z *
              telescope.area() * cosine / square / by_rays;
  const V slope = (1 / cosine) * seen;
  way.translation_area =
      instrument::translation_area(telescope, seen) *
      instrument::share_of_lens(telescope,
                                std::hypot(dot(slope, telescope.across), dot(slope, telescope.up)));
  add_connections(world, of_telescope(0), path.line, -seen, lens, entry, path.x(path.order()),
                  by_rays, way);
  return way;
}

}  // namespace photic::estimator
