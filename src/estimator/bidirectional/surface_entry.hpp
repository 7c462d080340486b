// The ways of walks into the water through waves (docs/theory.md, "Walks through waves"). An
// instrument's ray leads to a point of the surface. From there a walk goes on in a direction of a
// cone about that ray or, if walks may be free, about its instrument's axis, whatever the ray; its
// weight takes the share of light that the facets and whitecaps of the point send so. Light by way
// of several facets has walks of its own. Waves of one direction send a ray in none that is given:
// there all walks draw their facets. So do walks of instruments in the water that begin with light
// sent back by facets.
#pragma once

#include "core/flatten.hpp"
#include "core/turn.hpp"
#include "estimator/bidirectional/beam_spread.hpp"
#include "estimator/bidirectional/birth.hpp"
#include "estimator/crossing.hpp"
#include "estimator/entry_cone.hpp"
#include "estimator/variations/environments.hpp"
#include "estimator/world.hpp"
#include "geometry/sightline.hpp"
#include "instrument/laser.hpp"
#include "instrument/lens.hpp"
#include "surface/waves.hpp"
#include "transport/connect_waves.hpp"
#include "transport/cross.hpp"
#include "transport/emit.hpp"
#include "transport/surface_points.hpp"

namespace photic::estimator {

/// Returns whether an instrument's rays come into the water through waves.
template <class T>
bool enters_through_waves(const geometry::Slabs& sea, const geometry::Region<T>& region) {
  return !sea.surface.one_direction_each && region.outside;
}

/// The area over which a telescope draws rays of a direction, of the open lens as they come through
/// it on a horizontal plane: so far may they be translated sideways [m^2]. Through waves it draws
/// those alone that the detector sees; else its cone's, wherever they come through the lens.
template <class T>
T translation_area(const World<T>& world, const instrument::Telescope<T>& telescope,
                   const geometry::Region<T>& region, const Vec3<T>& direction) {
  const T area = instrument::translation_area(telescope, direction);
  return enters_through_waves(world.slabs, region)
             ? area * instrument::share_that_sees(telescope, direction)
             : area;
}

/// By a ray of the laser, from two uniforms.
template <class T>
SurfaceEntry<T> entry_of_laser(const instrument::Laser<T>& laser, const geometry::Region<T>& region,
                               const T& u_polar, const T& u_azimuth) {
  auto photon = transport::emit(laser, region.layer, u_polar, u_azimuth);
  SurfaceEntry<T> entry;
  entry.exists = transport::come_down(region, photon);
  entry.at = photon.position;
  entry.outside = photon.direction;
  entry.weight = photon.weight;
  entry.path = photon.path;
  return entry;
}
/// At a point of the surface, by the ray from the fictitious vertex, as if the air were clear.
/// `density`: of points that the laser's rays draw there [1/m^2].
template <class T>
SurfaceEntry<T> entry_of_laser(const instrument::Laser<T>& laser, const Vec3<T>& at, T& density) {
  using std::abs;
  const Vec3<T> way = at - fictitious_vertex(laser);
  const T distance = length(way);
  SurfaceEntry<T> entry;
  entry.at = at;
  entry.outside = (T(1) / distance) * way;
  const T x = one_minus_cos(entry.outside, laser.axis);
  entry.exists = laser.emits(x);
  entry.path = longer_from_disc(laser, at, distance, x);
  density = abs(entry.outside.z) / (distance * distance * T(2 * pi) * laser.even_within(x));
  return entry;
}

/// At a point of the surface, seen by a point of the lens, as if the air were clear. The weight is
/// that of all rays that the detector sees; `density`: of points that they draw there, alike for
/// all points of the detector [1/m^2].
template <class T>
SurfaceEntry<T> entry_of_telescope(const instrument::Telescope<T>& telescope,
                                   const instrument::PlanePoint<T>& lens, const Vec3<T>& at,
                                   instrument::Sight<T>& sight, T& density) {
  const auto way = transport::from_surface(telescope, lens, at);
  sight = way.sight;
  const T half_view = telescope.detector_radius / telescope.detector_distance;
  const T square = sight.cos_off_axis * sight.cos_off_axis;
  SurfaceEntry<T> entry;
  entry.exists = way.seen;
  entry.at = at;
  entry.outside = -way.direction;
  entry.weight = telescope.area() * (T(pi) * half_view * half_view * square * square);
  entry.path = longer_way(telescope, at, lens, way.length);
  density = transport::density_seen(telescope, way);
  return entry;
}

/// The slopes that lead from a point in the water to an instrument, or to its `lens`, near the way
/// by a level surface.
template <class T>
transport::NearLevel<T> level_to(const World<T>& world, std::int32_t instrument,
                                 const Index<T>& line, const Vec3<T>& from,
                                 const instrument::PlanePoint<T>& lens, const Mask<T>& wanted) {
  if (instrument == of_laser)
    return transport::near_level(world.slabs, from, line,
                                 fictitious_vertex(world.instruments.laser),
                                 world.instruments.laser_region, wanted);
  const auto number = static_cast<std::size_t>(instrument - 1);
  return transport::near_level(world.slabs, from, line,
                               in_space(world.instruments.telescopes[number], lens),
                               world.instruments.telescope_region[number], wanted);
}
/// The entry of an instrument's walk at a point of the surface.
template <class T>
SurfaceEntry<T> entry_at(const Instruments<T>& instruments, std::int32_t instrument,
                         const Vec3<T>& at, const instrument::PlanePoint<T>& lens, T& density) {
  if (instrument == of_laser) return entry_of_laser(instruments.laser, at, density);
  instrument::Sight<T> sight;
  return entry_of_telescope(instruments.telescopes[static_cast<std::size_t>(instrument - 1)], lens,
                            at, sight, density);
}
/// An entry behind the air between its instrument and the sea: its weight, and its path.
template <class T>
SurfaceEntry<T> behind_air(const geometry::Region<T>& region, const Index<T>& line,
                           SurfaceEntry<T> entry) {
  if (!region.column.exists()) [[likely]]
    return entry;
  const Mask<T> down = entry.outside.z < T(0);
  const T cosine = select(down, T(0) - entry.outside.z, T(1));
  entry.weight = entry.weight * region.through_column(line, cosine);
  entry.path = entry.path + region.delay(line, cosine);
  return entry;
}
/// The density of entries drawn by slopes, over that by an instrument's own rays.
template <class T>
T slopes_over_rays(const World<T>& world, std::int32_t instrument, const Index<T>& line,
                   const Vec3<T>& from, const SurfaceEntry<T>& entry,
                   const instrument::PlanePoint<T>& lens, const Mask<T>& wanted) {
  if (!world.walks.cone(instrument).enters_by_slopes) return T(0);
  const auto level = level_to(world, instrument, line, from, lens, wanted);
  T density(1);
  entry_at(world.instruments, instrument, entry.at, lens, density);
  return transport::density_by_slopes(level, world.slabs.waves, entry.at) / density;
}
/// Both kinds of entries are drawn once: rays and slopes, so densely. Free walks enter by slopes.
template <class T>
Spread<T> spread_by_entries(const T& slopes_over_rays, Spread<T> spread) {
  const T both = T(1) + slopes_over_rays;
  spread.solid_angle = spread.solid_angle * both;
  spread.freed = slopes_over_rays / both;
  return spread;
}

/// About which directions in the water are drawn at an entry.
template <class T>
Vec3<T> axis_in_water(const medium::MediumView& sea, const EntryCone<T>& cone,
                      const SurfaceEntry<T>& entry) {
  return cone.about_rays ? refracted_down(entry.outside, gather<T>(sea.index, Index<T>(0)))
                         : cone.axis;
}

/// The weight of a walk that goes on from an entry in a direction of the cone. `line`: of its
/// light.
template <class T>
T weight_along(const medium::MediumView& sea, const SurfaceEntry<T>& entry, bool from_telescope,
               const Index<T>& line, const Vec3<T>& direction, const T& solid_angle) {
  const auto surface = surface::rough_surface<T>(sea, line);
  const T passes = surface.density(Mask<T>(true), false, entry.outside, direction);
  const T weight = entry.weight * solid_angle * passes;
  return from_telescope ? weight / (surface.n * surface.n) : weight;
}

/// The straight edge from an entry to a point in the water.
template <class T>
struct EntryEdge {
  Mask<T> exists{};
  SurfaceEntry<T> by;
  Vec3<T> direction;  ///< away from the instrument
  T length{};         ///< [m]
  T area{};           ///< across it, of the cone, times how often such entries are drawn [m^2]
  T freed{};          ///< of Spread
  T weight{};         ///< of a walk that begins so

  /// The edge as light of a line goes along it from a level to the surface.
  [[nodiscard]] geometry::Segment<T> in_water(const Index<T>& line,
                                              const medium::Level<T>& from) const {
    return geometry::to_surface(line, from, length, geometry::Slant<T>::of_secant(secant()));
  }
  [[nodiscard]] T secant() const { return T(1) / select(exists, T(0) - direction.z, T(1)); }
};
/// By an instrument's `own` ray, or by slopes.
template <class T>
EntryEdge<T> entry_to(const World<T>& world, std::int32_t instrument, const Index<T>& line,
                      const Vec3<T>& to, const SurfaceEntry<T>& own,
                      const instrument::PlanePoint<T>& lens, bool by_slopes,
                      const Mask<T>& wanted) {
  const auto& cone = world.walks.cone(instrument);
  EntryEdge<T> edge;
  if (by_slopes && !cone.enters_by_slopes) return edge;
  T ratio(0);
  edge.by = own;
  if (cone.enters_by_slopes) {
    const auto level = level_to(world, instrument, line, to, lens, wanted);
    const auto& waves = world.slabs.waves;
    const Vec3<T> at =
        by_slopes ? transport::point_by_slopes(level, waves, own.u_slope, own.u_azimuth) : own.at;
    T density(1);
    const auto entry = entry_at(world.instruments, instrument, at, lens, density);
    if (by_slopes) edge.by = behind_air(world.instruments.region(instrument), line, entry);
    ratio = transport::density_by_slopes(level, waves, at) / density;
  }
  const Vec3<T> there = to - edge.by.at;
  edge.length = length(there);
  edge.exists = wanted & edge.by.exists & (there.z < T(0));
  edge.direction = (T(1) / select(edge.exists, edge.length, T(1))) * there;
  Spread<T> spread;
  spread.solid_angle =
      cone.solid_angle_at(one_minus_cos(edge.direction, axis_in_water(world.slabs, cone, edge.by)));
  edge.weight = weight_along(world.slabs, edge.by, instrument != of_laser, line, edge.direction,
                             spread.solid_angle);
  spread = spread_by_entries(ratio, spread);
  edge.area = spread.solid_angle * (edge.length * edge.length);
  edge.freed = spread.freed;
  edge.exists = edge.exists & (edge.weight > T(0));
  return edge;
}
/// An edge as light goes along it to the instrument, or would if it went back.
template <class T>
geometry::Sightline<T> sightline_along(const EntryEdge<T>& edge, const geometry::Region<T>& to) {
  geometry::Sightline<T> way;
  way.exists = edge.exists;
  way.direction = -edge.direction;
  way.arriving = -edge.by.outside;
  way.length_water = edge.length;
  way.crossing = edge.by.at;
  way.secant_water = edge.secant();
  way.to = to;
  return way;
}

/// The meeting with the surface of light that goes along such a way, or would if it went back.
template <class T>
surface::FacetHit<T> meeting_along(const medium::MediumView& sea, const Index<T>& line,
                                   const geometry::Sightline<T>& way) {
  return surface::meeting_of(surface::rough_surface<T>(sea, line), Mask<T>(true), false,
                             Vec3<T>(-way.arriving), Vec3<T>(-way.direction));
}

/// Facets send light so far aside of where they send most of it that floats hold no number for how
/// little it is. Walks that may be free take it for this density [1/sr]: their own entry counts for
/// nothing still.
inline constexpr double min_passing = 1e-12;

/// A walk that begins at an entry, by two uniforms; draw(block) draws more, and met(mask, meeting)
/// is called for its meeting with the surface.
template <class T, class Draw, class Met>
Birth<T> birth_through_waves(const medium::MediumView& sea, const geometry::Region<T>& region,
                             const EntryCone<T>& cone, const SurfaceEntry<T>& entry,
                             bool from_telescope, const Index<T>& line, const T& u_polar,
                             const T& u_azimuth, Draw draw, Met met_surface) {
  Birth<T> birth;
  birth.entry = entry;
  auto& photon = birth.photon;
  photon.position = entry.at;
  photon.path = entry.path;
  photon.line = line;
  photon.layer = region.layer;
  const Mask<T> drawn_facets = entry.exists & (u_polar >= cone.others());
  const bool by_any = !sea.surface.leads_anywhere;  // else by several: one can be found
  if (!by_any) {
    const Vec3<T> axis = axis_in_water(sea, cone, entry);
    const Vec3<T> direction = direction_about(axis, cone, u_polar, u_azimuth);
    const T solid_angle = cone.solid_angle_at(one_minus_cos(direction, axis));
    photon.direction = direction;
    photon.weight = weight_along(sea, entry, from_telescope, line, direction, solid_angle);
    if (cone.by_depth) {  // else nothing would be left for a free walk to put another entry's for
      const T least = T(min_passing) * entry.weight * solid_angle;
      photon.weight = select(photon.weight > least, photon.weight, least);
    }
    birth.spread.solid_angle = solid_angle;
    birth.exists = entry.exists & (direction.z < T(0));
    if (sea.surface.differs_in_environments)
      met_surface(Mask<T>(!drawn_facets),
                  surface::meeting_of(surface::rough_surface<T>(sea, line), Mask<T>(true), false,
                                      entry.outside, direction));
  }
  if (any(drawn_facets)) {
    auto by = photon;
    by.direction = entry.outside;
    by.weight = entry.weight / cone.by_facets;
    const auto surface = surface::rough_surface<T>(sea, line);
    const auto which = by_any ? Facets::any : Facets::several;
    const auto met =
        walk_by_facets(from_telescope, surface, by, drawn_facets, true, which, draw, met_surface);
    photon = select(drawn_facets, by, photon);
    birth.spread.solid_angle = select(drawn_facets, T(0), birth.spread.solid_angle);
    birth.exists =
        (birth.exists & !drawn_facets) | (met.in_water & (met.several | Mask<T>(by_any)));
  }
  birth.own = birth.exists;
  return birth;
}

/// The share of the laser's light that a film of oil absorbs on its way into the water: of a ray
/// by two uniforms; draw(block) draws more.
template <class T, class Draw>
PHOTIC_APART T absorbed_on_way_in(const World<T>& world, T u_polar, T u_azimuth, Draw draw) {
  auto photon = transport::emit(world.instruments.laser, world.instruments.laser_region.layer,
                                u_polar, u_azimuth);
  if (!world.instruments.laser_region.outside) return T(0);
  const Mask<T> comes = transport::come_down(world.instruments.laser_region, photon);
  if (world.slabs.surface.one_direction_each)
    return select(comes, transport::refract_down(world.slabs, photon).into_film, T(0));
  const auto surface = surface::rough_surface<T>(world.slabs, photon.line);
  return walk_by_facets(false, surface, photon, comes, true, Facets::any, draw,
                        [](const auto&...) {})
      .into_film;
}

/// Weight of the laser's light that facets do not send down in the water.
template <class T>
struct NotSentDown {
  T weight{}, into_film{};  ///< `into_film`: of that, what a film of oil absorbs
};
/// Has the walks of an instrument in the water that `u_class`, a uniform, chooses begin at the
/// surface instead: they have come there without colliding, and facets send them down again.
/// Returns the weight that facets do not send down; flown(mask, segment) is called for the way up.
template <class T, class Draw, class Met, class Flown>
NotSentDown<T> begin_at_facets(const geometry::Slabs& sea, const EntryCone<T>& cone,
                               const T& u_class, bool from_telescope, Birth<T>& birth, Draw draw,
                               Met met_surface, Flown flown) {
  const Mask<T> chosen = u_class >= cone.others();
  if (!any(chosen)) return {};
  auto by = birth.photon;
  const auto up = transport::come_up(sea, by);
  const Mask<T> rises = chosen & birth.exists & up.rises;
  flown(rises, up.way);
  by.weight = by.weight * (cone.others() / cone.by_facets);
  const T comes = by.weight;
  const Mask<T> stand = rises & (comes > T(0));
  const auto surface = surface::rough_surface<T>(sea, by.line);
  const auto met = walk_by_facets(from_telescope, surface, by, stand, false, Facets::that_return,
                                  draw, met_surface);
  birth.photon = select(stand, by, birth.photon);
  birth.spread.solid_angle = select(chosen, T(0), birth.spread.solid_angle);
  birth.facets = select(chosen, select(met.several, Index<T>(2), Index<T>(1)), Index<T>(0));
  birth.exists = (met.in_water & chosen) | (birth.exists & !chosen);
  birth.own = birth.own & birth.exists;
  return {select(stand, comes - select(birth.exists, by.weight, T(0)), T(0)), met.into_film};
}

}  // namespace photic::estimator
