// The local estimate by a rough surface: light goes from a point to one of the lens by way of a
// point of the mean surface, at which facets of one slope alone lead it on, or a whitecap
// (docs/theory.md, "The rough surface").
#pragma once

#include "core/random.hpp"
#include "surface/waves.hpp"
#include "transport/connect_ray.hpp"
#include "transport/facets_in_line.hpp"
#include "transport/surface_points.hpp"

namespace photic::transport {

/// The part in the water of a way from the surface straight to a point of the lens there.
template <class T>
geometry::Segment<T> from_surface_in_water(const medium::MediumView& sea,
                                           const geometry::Region<T>& region, const Index<T>& line,
                                           const FromSurface<T>& way) {
  const T depth = way.depth();
  const auto slant = geometry::Slant<T>::of_cosine(T(-way.direction.z));
  if (!sea.row.has_faces) [[likely]]
    return geometry::to_surface(line, sea.level(region.layer, depth), way.length, slant);
  const Vec3<T> lens = way.lens();
  const auto level = geometry::level_in(sea, sea.row.column_at(lens.x), region.layer, depth);
  return geometry::to_surface(line, level, way.length, slant,
                              geometry::Ray<T>{lens, T(-1) * way.direction});
}
/// Optical depth from the surface straight to a point of the lens.
template <class T>
T depth_to_lens(const geometry::Slabs& sea, const geometry::Region<T>& region, const Index<T>& line,
                const FromSurface<T>& way) {
  if (region.outside) {
    if (!region.column.exists()) [[likely]]
      return T(0);
    return gather<T>(region.column.optical_depth, line) * region.stretch(way.height()) /
           way.rising_cosine();
  }
  return geometry::optical_depths(sea, from_surface_in_water(sea, region, line, way)).all;
}
/// Its path as telescopes count it.
template <class T>
T path_to_telescope(const medium::MediumView& sea, const instrument::Telescope<T>& telescope,
                    const geometry::Region<T>& region, const Index<T>& line,
                    const instrument::PlanePoint<T>& lens, const Vec3<T>& at,
                    const FromSurface<T>& way) {
  if (region.outside)
    return longer_way(telescope, at, lens, way.length) +
           region.delay(line, way.rising_cosine(), region.stretch(way.height()));
  return path_within(sea, telescope, at, from_surface_in_water(sea, region, line, way), lens);
}

/// `meeting`: at the surface; known where environments have other surfaces.
template <class T>
struct SurfaceConnection : RayConnection<T> {
  T stretch{1};  ///< of the column to a telescope outside
  surface::FacetHit<T> meeting;
};
/// `direction` and `in_water` are those to the surface.
template <class T>
struct WavesConnection : SurfaceConnection<T> {
  FromSurface<T> onward;
};

/// A point of the surface by which light may go on, and what goes on there per solid angle over how
/// densely such points are drawn [m^2/sr].
template <class T>
struct WeighedPoint {
  Mask<T> exists{};
  Mask<T> white{};       ///< of waves of one direction: a whitecap leads by it, and no facet
  Vec3<T> at, arriving;  ///< `arriving`: direction to it
  T length{};            ///< so far [m]
  FromSurface<T> onward;
  T value{};
};
/// `at`: the point.
template <class T>
void go_by(const Vec3<T>& from, const instrument::Telescope<T>& telescope,
           const instrument::PlanePoint<T>& lens, const Vec3<T>& at, WeighedPoint<T>& point) {
  point.at = at;
  const Vec3<T> way = at - from;
  point.length = length(way);
  point.arriving = (T(1) / point.length) * way;
  point.onward = from_surface(telescope, lens, at);
}

/// By waves in two dimensions.
template <class T>
WeighedPoint<T> weighed_point(const surface::RoughSurface<T>& surface,
                              const instrument::Telescope<T>& telescope, bool back,
                              const Vec3<T>& from, const instrument::PlanePoint<T>& lens,
                              const NearLevel<T>& level, const SurfacePointUniforms<T>& u) {
  const auto& waves = surface.waves;
  const auto [share_seen, share_slopes, share_above] = point_shares(waves);
  const auto drawn = draw_point(waves, telescope, from, lens, level, u);
  WeighedPoint<T> point;
  go_by(from, telescope, lens, drawn.at, point);
  point.exists = drawn.exists & point.onward.seen;
  T density = T(share_seen) * density_seen(telescope, point.onward) +
              T(share_slopes) * density_by_slopes(level, waves, drawn.at);
  if (share_above > 0)
    density = density + T(share_above) * density_above(point.arriving, point.length);
  point.value =
      surface.density(Mask<T>(false), back, point.arriving, point.onward.direction) / density;
  return point;
}

/// By waves of one direction, or by whitecaps between them.
template <class T>
WeighedPoint<T> weighed_point_in_line(const surface::RoughSurface<T>& surface,
                                      const instrument::Telescope<T>& telescope, bool back,
                                      const Vec3<T>& from, const instrument::PlanePoint<T>& lens,
                                      const NearLevel<T>& level, const SurfacePointUniforms<T>& u) {
  using std::abs;
  const auto& waves = surface.waves;
  const auto axes = axes_of<T>(waves);
  const double share_white = share_of_whitecaps(waves);
  const auto [white, drawn, in_line] =
      draw_point_in_line(waves, telescope, from, lens, level, back ? T(1) : surface.n, u);
  WeighedPoint<T> point;
  go_by(from, telescope, lens, drawn.at, point);
  point.exists = drawn.exists & point.onward.seen;
  point.white = white;
  const auto by = surface.facets(Mask<T>(false), back, point.arriving, point.onward.direction);
  const T slope = waves.crosswind_deviation == 0 ? by.slope.upwind : by.slope.crosswind;
  const T across = waves.crosswind_deviation == 0 ? by.slope.crosswind : by.slope.upwind;
  // Where no facet leads on, the search for a point has none that is level across.
  const Mask<T> found = abs(across) < T(1e-3) * (T(axes.deviation) + abs(slope));
  const T of_facets = by.per_density * surface::gaussian_along(axes.deviation, slope) /
                      (T(1 - share_white) * in_line.per_metre * in_line.slope_across);
  point.value = select(found, of_facets, T(0));
  if (share_white == 0) return point;
  const T density = T(0.5 * share_white) * (density_seen(telescope, point.onward) +
                                            density_above(point.arriving, point.length));
  point.value =
      select(white, surface.by_whitecaps(Mask<T>(false), back, point.onward.direction) / density,
             point.value);
  return point;
}

/// From a photon's position in the water by the surface to a point of the lens, in the air or in
/// the water. `u`: of the point of the surface.
template <class T>
WavesConnection<T> connect_by_waves(const geometry::Slabs& sea,
                                    const instrument::Telescope<T>& telescope,
                                    const geometry::Region<T>& region, const Photon<T>& photon,
                                    const Index<T>& line, const instrument::PlanePoint<T>& lens,
                                    const SurfacePointUniforms<T>& u, const Mask<T>& wanted) {
  const auto surface = surface::rough_surface<T>(sea, line);
  const Vec3<T>& from = photon.position;
  const bool back = !region.outside;
  const auto level = near_level(sea, from, line, in_space(telescope, lens), region, wanted);
  const auto point = !sea.surface.leads_anywhere
                         ? weighed_point_in_line(surface, telescope, back, from, lens, level, u)
                         : weighed_point(surface, telescope, back, from, lens, level, u);
  WavesConnection<T> out;
  out.onward = point.onward;
  out.sight = point.onward.sight;
  out.direction = point.arriving;
  if (sea.surface.differs_in_environments) {
    out.meeting =
        surface::meeting_of(surface, Mask<T>(false), back, point.arriving, point.onward.direction);
    if (!sea.surface.leads_anywhere) out.meeting.by_whitecaps = select(point.white, T(1), T(0));
  }
  const Mask<T> detected = wanted & point.exists & (from.z < T(0));
  if (!any(detected)) return out;
  const T& l1 = point.length;
  const T& l2 = point.onward.length;
  out.acceptance = select(detected,
                          point.value * (point.arriving.z / (l1 * l1)) *
                              (telescope.area() * out.sight.cos_off_axis / (l2 * l2)),
                          T(0));
  const auto up = geometry::to_surface(line, geometry::level_of(sea, photon), l1,
                                       geometry::Slant<T>::of_cosine(out.direction.z),
                                       geometry::Ray<T>{photon.position, out.direction});
  out.in_water = up;
  out.optical_depth =
      geometry::optical_depths(sea, up).all + depth_to_lens(sea, region, line, point.onward);
  out.path = geometry::group_path(sea, up) +
             path_to_telescope(sea, telescope, region, line, lens, point.at, point.onward);
  return out;
}

/// Light that stands at the surface and is about to meet a facet or a whitecap: straight from there
/// to a point of the lens. With waves of one direction whitecaps alone do that.
template <class T>
SurfaceConnection<T> connect_from_surface(const geometry::Slabs& sea,
                                          const instrument::Telescope<T>& telescope,
                                          const geometry::Region<T>& region,
                                          const Photon<T>& photon, const Mask<T>& outside,
                                          const instrument::PlanePoint<T>& lens) {
  const auto surface = surface::rough_surface<T>(sea, photon.line);
  const auto way = from_surface(telescope, lens, photon.position);
  SurfaceConnection<T> out;
  out.sight = way.sight;
  if (!any(way.seen)) return out;
  const auto value = [&](bool reflected) {
    return !sea.surface.leads_anywhere
               ? surface.by_whitecaps(outside, reflected, way.direction)
               : surface.density(outside, reflected, photon.direction, way.direction);
  };
  const Mask<T> reflects = region.outside ? outside : !outside;
  T per_solid_angle(0);
  if (any(reflects)) per_solid_angle = select(reflects, value(true), per_solid_angle);
  if (!all(reflects)) per_solid_angle = select(reflects, per_solid_angle, value(false));
  if (sea.surface.differs_in_environments) {
    const auto meeting = [&](bool reflected) {
      return surface::meeting_of(surface, outside, reflected, photon.direction, way.direction);
    };
    const auto back = meeting(true), through = meeting(false);
    out.meeting.slope = {select(reflects, back.slope.upwind, through.slope.upwind),
                         select(reflects, back.slope.crosswind, through.slope.crosswind)};
    out.meeting.by_whitecaps = select(reflects, back.by_whitecaps, through.by_whitecaps);
    out.meeting.film = {photon.line, select(reflects, back.film.way, through.film.way),
                        select(reflects, back.film.cosine, through.film.cosine)};
    if (!sea.surface.leads_anywhere) out.meeting.by_whitecaps = T(1);
  }
  out.direction = way.direction;
  out.acceptance = select(
      way.seen,
      per_solid_angle * telescope.area() * way.sight.cos_off_axis / (way.length * way.length),
      T(0));
  out.optical_depth = depth_to_lens(sea, region, photon.line, way);
  out.stretch = region.stretch(way.height());
  if (!region.outside) out.in_water = from_surface_in_water(sea, region, photon.line, way);
  out.path = path_to_telescope(sea, telescope, region, photon.line, lens, photon.position, way);
  return out;
}

/// The same for facets of waves of one direction. Facets that lead to the lens have slopes between
/// two bounds: one of these, drawn by a uniform, leads to a point of it or misses it.
template <class T>
SurfaceConnection<T> connect_in_line(const geometry::Slabs& sea,
                                     const instrument::Telescope<T>& telescope,
                                     const geometry::Region<T>& region, const Photon<T>& photon,
                                     const Mask<T>& outside, const T& u) {
  using std::abs;
  const auto surface = surface::rough_surface<T>(sea, photon.line);
  const auto axes = axes_of<T>(sea.waves);
  const Mask<T> reflects = region.outside ? outside : !outside;
  const T n1 = select(outside, T(1), surface.n), n2 = select(outside, surface.n, T(1));
  const auto bounds = slopes_to_lens(axes, telescope, photon, select(reflects, T(1), n1 / n2));
  const T s = bounds.middle + bounds.half * (T(2) * u - T(1));
  const bool upwind = sea.waves.crosswind_deviation == 0;
  const auto facet = surface::facet_of(
      sea.waves, upwind ? surface::Slope<T>{s, T(0)} : surface::Slope<T>{T(0), s});
  const auto by_facet = surface::meet_facet(surface.face, n1, n2, photon.direction, facet);
  const T v = surface::visibility(photon.direction, facet);
  FromSurface<T> way;
  way.at = photon.position;
  way.direction = select(reflects, by_facet.reflected, by_facet.transmitted);
  const auto hit = come_to_lens(telescope, photon.position, way.direction);
  way.length = hit.distance;
  SurfaceConnection<T> out;
  out.sight = instrument::sight(telescope, hit.lens, way.direction);
  const Mask<T> seen = hit.open & out.sight.on_detector & (v > T(0));
  if (!any(seen)) return out;
  if (sea.surface.differs_in_environments)
    out.meeting = surface::meeting_with(surface, facet.slope, outside, Mask<T>(!reflects),
                                        photon.direction, way.direction);
  const T share = select(reflects, by_facet.reflectance, by_facet.transmittance);
  out.direction = way.direction;
  out.acceptance = select(seen,
                          (T(1) - surface.white.fraction) * v * share * T(2) * bounds.half *
                              surface::gaussian_along(axes.deviation, s),
                          T(0));
  out.optical_depth = depth_to_lens(sea, region, photon.line, way);
  out.stretch = region.stretch(way.height());
  if (!region.outside) out.in_water = from_surface_in_water(sea, region, photon.line, way);
  out.path = path_to_telescope(sea, telescope, region, photon.line, hit.lens, photon.position, way);
  return out;
}

}  // namespace photic::transport
