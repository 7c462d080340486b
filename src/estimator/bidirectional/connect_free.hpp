// Meetings of free walks (a part of connections.hpp; theory.md, "Free walks"): all of a walk beyond
// its instrument's ray is put where its ray meets the other walk's, and its first vertex is then
// connected with the instrument.
#pragma once

#include "estimator/bidirectional/connections.hpp"
#include "estimator/bidirectional/surface_entry.hpp"

namespace photic::estimator {

/// The circle within which the first vertices of an instrument's free walks have to come to be seen
/// or lit.
template <class T>
struct FreeStart {
  T x{}, y{};       ///< the first vertex, from the circle's centre [m]
  T radius{};       ///< [m]
  T longer_path{};  ///< the walk's way there is longer than the shortest by so much at most [m]
};
/// `position`, `path`: of the first vertex as it was drawn; `lens`: from the instrument's middle to
/// where its rays begin.
template <class T>
FreeStart<T> free_start(const EntryCone<T>& cone, const Vec3<T>& position, const T& path,
                        const T& way_down, const Vec3<T>& lens) {
  const Spot<T>& spot = cone.spot;
  const T steep = T(0) - cone.outside.z;
  const T per_height = select(steep > T(0), T(1) / select(steep > T(0), steep, T(1)), T(0));
  const T lift = cone.begins_outside ? lens.z * per_height : T(0);
  return {position.x - (spot.x + lens.x + lift * cone.outside.x + way_down * spot.x_per_depth),
          position.y - (spot.y + lens.y + lift * cone.outside.y + way_down * spot.y_per_depth),
          spot.radius + way_down * spot.radius_per_depth,
          path - (spot.min_path + way_down * spot.min_path_per_depth)};
}
/// The depth that a first way to a point goes through: from the surface, or from the place in the
/// water that light spreads from, perhaps by way of the surface.
template <class T>
T way_down_of(bool outside, const Vec3<T>& from, const Vec3<T>& to, const Mask<T>& by_surface) {
  using std::abs;
  const T depth = geometry::depth_of(to);
  if (outside) return depth;
  const T begins = geometry::depth_of(from);
  return select(by_surface, depth + begins, T(abs(depth - begins)));
}

/// Returns whether walks may be free: under waves those that begin in a part of the cone.
template <class T>
Mask<T> Connections<T>::may_be_free(const Walks<T>& walks, std::int32_t instrument,
                                    const Index<T>& walk) const {
  if (sea_.surface.one_direction_each) return Mask<T>(true);
  return (walks.birth_record(walk).spread.solid_angle > T(0)) &
         world_.walks.cone(instrument).frees(walks.vertex(walk, Index<T>(0)).direction);
}

template <class T>
Mask<T> Connections<T>::comes_by_surface(const Vertex& first, const T& leaves_z) const {
  return leaves_z * first.direction.z < T(0);
}

/// A telescope's walk as its free meetings see it.
template <class T>
FreeStart<T> Connections<T>::free_telescope_start(std::size_t back) const {
  const auto birth = back_.birth_record_in_all_lanes(back);
  const Vertex first = back_.vertex_in_all_lanes(back, 0);
  const Vec3<T> lens = in_plane(telescope_, birth.lens);
  return free_start(world_.walks.cone(instrument()), first.position, first.path,
                    way_down_of(receiver_.region.outside, telescope_.position, first.position,
                                comes_by_surface(first, birth.outward.z)),
                    lens);
}
template <class T>
FreeStart<T> Connections<T>::free_laser_start(const Index<T>& laser) const {
  const Vertex first = laser_.vertex(laser, Index<T>(0));
  return free_start(world_.walks.laser_cone, first.position, first.path,
                    way_down_of(world_.instruments.laser_region.outside,
                                fictitious_vertex(world_.instruments.laser), first.position,
                                comes_by_surface(first, world_.instruments.laser.axis.z)),
                    {T(0), T(0), T(0)});
}

/// The depths of a grid where rays `meet`, and the bed, at which they do so that a first vertex
/// comes into the circle. `to`: from it to there as it moves with depth, `sign` of the offset of
/// the rays.
template <class T>
template <class Push>
void Connections<T>::free_meetings(const RayPairing<T>& pairing, const Mask<T>& mask,
                                   const Mask<T>& meet, const DepthLine& out_line,
                                   const DepthLine& back_line, const FreeStart<T>& start,
                                   const T& sign, const MeetingGrid<T>& grid, const T& offset,
                                   Push push) {
  if (!any(mask)) return;
  const auto [at_surface, per_depth] = horizontal_offset(back_line, out_line);
  const LensLine<T> line{{start.x + sign * at_surface.x, start.y + sign * at_surface.y},
                         {sign * per_depth.x, sign * per_depth.y}};
  const auto chord =
      within_rim(line, start.radius,
                 common_span(out_line, back_line, T(receiver_.last_path + start.longer_path)));
  const Index<T> order = pairing.order();
  const auto each_point = [&](const Mask<T>& some, const T& from, const T& to,
                              const Index<T>& bed) {
    if (!any(some)) return;
    const T last = grid.number(to, order) - offset;
    const T before = grid.number(from, order) - offset;
    T number = to_real<T>(floor_index(before));
    number = select(number < before, number + T(1), number);
    for (Mask<T> more = some & (number < last); any(more); more = some & (number < last)) {
      const T depth = select(bed == Index<T>(1), from, grid.depth(number + offset, order));
      push(more, FreePairing<T>{{pairing, depth}, bed});
      number = number + T(1);
    }
  };
  each_point(mask & chord.exists & meet, chord.from, chord.to, Index<T>(0));
  if (!comes_to_bed()) return;
  const T bed = world_.walks.deepest;
  const auto there = line.at(bed);
  each_point(mask & (out_line.rise < T(0)) & (back_line.rise < T(0)) &
                 (there.x * there.x + there.y * there.y < start.radius * start.radius),
             bed, bed + samples_.grid.below_bed(), Index<T>(1));
}

/// Level, from the telescope's ray to the laser's where they are at a depth.
template <class T>
Vec3<T> Connections<T>::apart(const RayPair<T>& pair, const T& depth) const {
  const auto at = [&](const Ray& ray) {
    return ray.position + ray.length_to(depth) * ray.direction;
  };
  const Vec3<T> there = at(pair.out) - at(pair.back);
  return {there.x, there.y, T(0)};
}
template <class T>
void Connections<T>::meet_free(const FreePairing<T>& pairing, const Mask<T>& mask,
                               const Met<T>& met) {
  const Mask<T> bed = pairing.bed == Index<T>(1);
  meet_at(pairing, mask, met, pairing.depth,
          select(bed, Index<T>(sea_.layers), sea_.layer_at(met.out->layer, pairing.depth)));
}
/// c / c' of a collision at a first vertex, which is in the weight of a walk that has come there.
template <class T>
T Connections<T>::collision_gain(const Vertex& first) const {
  return select(on_bed(first.layer), T(1),
                gather<T>(sea_.collision_gain, sea_.at(first.line, sea_.layer_of<T>(first.layer))));
}

template <class T>
PHOTIC_APART PHOTIC_FLATTEN void Connections<T>::serve_free_telescope(FreePairing<T> pairing,
                                                                      Mask<T> mask) {
  tally_.operations.free_meetings += count(mask);
  const RayPair<T> pair = pair_of(pairing);
  const Vertex first = back_.vertex(pairing.back, Index<T>(0));
  const Vec3<T> moved = apart(pair, pairing.depth);
  if (!sea_.surface.one_direction_each) {
    const auto entry = entry_to(world_, instrument(), first.line, first.position + moved,
                                back_.entry(pairing.back), pair.birth.lens, true, mask);
    return free_telescope_by(pairing, pair, first, moved, sightline_along(entry, receiver_.region),
                             edge_to_telescope(mask, entry, first.line,
                                               geometry::level_of(sea_, first), pair.birth.lens));
  }
  const Vec3<T> at_lens = in_space(telescope_, pair.birth.lens);
  const Mask<T> by_surface = comes_by_surface(first, pair.birth.outward.z);
  for (const auto route : geometry::routes_to(receiver_.region.outside)) {
    const Mask<T> by = route == geometry::Route::direct ? mask & !by_surface : mask & by_surface;
    if (!any(by)) continue;
    const Vec3<T> at = first.position + moved;
    const auto way =
        geometry::sightline(sea_, at, first.line, at_lens, receiver_.region, route, by);
    free_telescope_by(pairing, pair, first, moved, way,
                      edge_to_telescope(by, at, first.layer, pair.birth.lens, first.line, way));
  }
}

/// The first vertex is seen by a new way to the lens.
template <class T>
void Connections<T>::free_telescope_by(const FreePairing<T>& pairing, const RayPair<T>& pair,
                                       const Vertex& first, const Vec3<T>& moved,
                                       const geometry::Sightline<T>& way,
                                       const EdgeToTelescope<T>& edge) {
  using std::abs;
  if (!any(edge.seen)) return;
  const Ray leaving = back_.ray(pairing.back, Index<T>(1));
  const Vec3<T> arriving = -way.direction;
  const Mask<T> bed = on_bed(first.layer), converts = first.line > leaving.line;
  const T p = density_of(
      contribution(sea_, interaction_at<T>(sea_, converts, first.line, first.layer, arriving),
                   leaving.direction));
  const T per_p = T(1) / (p * leaving.per_p);
  const auto drawn = [&](const T& value) {
    return world_.walks.inverse_conversion.scattered_over_phase(sea_, first.layer,
                                                                leaving.direction, value);
  };
  const T chance =
      select(converts, per_p,
             select(first.line == Index<T>(0), T(drawn(p) / drawn(T(1) / leaving.per_p)), T(1)));
  const auto& cone = world_.walks.cone(instrument());
  const auto tau = geometry::optical_depths(sea_, edge.in_water);
  auto met = this->met(pair);
  met.telescope = edge.telescope;
  Ray back = pair.back;
  change_first(pairing.m == Index<T>(1), per_p, chance, back, met.back_near, met.back_free);
  met.rest = chance;
  put_first(T(edge.area / abs(arriving.z)), edge.freed, met.back_near, met.back_free);
  met.translation_area = translation_area(world_, telescope_, receiver_.region, way.arriving);
  back.weight = back.weight / first.weight * collision_gain(first) * edge.weight *
                (exp_minus(tau.all) / cone.reach(Mask<T>(true), tau.walk, arriving.z, bed));
  back.path = back.path - first.path + edge.path;
  back.position = back.position + moved;
  met.back = &back;
  if (all(receiver_.line == Index<T>(0))) {  // the pivot is the first vertex
    const Mask<T> rotates = world_.walks.uses.rotated_scattered
                                ? leads_aside(arriving, leaving.direction)
                                : Mask<T>(false);
    met.own_axis = {rotates, first.position.x, first.position.y};
    met.rotates_anew = true;
    met.axis = met.own_axis;
  }
  translate(met, moved);
  const NewLeg<T> leg{first, leaving, arriving, way, edge.in_water};
  met.free = Free::telescope;
  met.leg = &leg;
  meet_free(pairing, edge.seen, met);
}

/// A first vertex has come where its instrument's cone has another footprint.
template <class T>
void Connections<T>::put_first(const T& footprint, const T& freed, NearFirst<T>& near,
                               FreeArea<T>& free) {
  near.instrument_edge = near.instrument_edge * (footprint / free.footprint);
  free.footprint = footprint;
  free.freed = freed;
}

template <class T>
PHOTIC_APART PHOTIC_FLATTEN void Connections<T>::serve_free_laser(FreePairing<T> pairing,
                                                                  Mask<T> mask) {
  tally_.operations.free_meetings += count(mask);
  const RayPair<T> pair = pair_of(pairing);
  const Vertex first = laser_.vertex(pairing.laser, Index<T>(0));
  const Vec3<T> moved = -apart(pair, pairing.depth);
  const Vec3<T> at = first.position + moved;
  // Walks on a bed whose albedo depends on the angle are never free: see averaged_over_drawn().
  const Mask<T> may = sea_.bed_angles > 1 ? mask & !on_bed(first.layer) : mask;
  if (!sea_.surface.one_direction_each) {
    const auto entry =
        entry_to(world_, of_laser, Index<T>(0), at, laser_.entry(pairing.laser), {}, true, may);
    const auto way = sightline_along(entry, world_.instruments.laser_region);
    return free_laser_by(pairing, pair, first, moved, way,
                         way_to_laser(may, at, first.layer, way, entry));
  }
  const Mask<T> by_surface = comes_by_surface(first, world_.instruments.laser.axis.z);
  for (const auto route : geometry::routes_to(world_.instruments.laser_region.outside)) {
    const Mask<T> by = route == geometry::Route::direct ? may & !by_surface : may & by_surface;
    if (!any(by)) continue;
    const auto way =
        geometry::sightline(sea_, at, Index<T>(0), fictitious_vertex(world_.instruments.laser),
                            world_.instruments.laser_region, route, by);
    free_laser_by(pairing, pair, first, moved, way, way_to_laser(by, at, first.layer, way));
  }
}

/// The first vertex is lit by a new way from the laser.
template <class T>
void Connections<T>::free_laser_by(const FreePairing<T>& pairing, const RayPair<T>& pair,
                                   const Vertex& first, const Vec3<T>& moved,
                                   const geometry::Sightline<T>& way,
                                   const WayToLaser<T>& to_laser) {
  using std::abs;
  if (!any(to_laser.lit)) return;
  const Ray leaving = laser_.ray(pairing.laser, Index<T>(1));
  const Vec3<T> arriving = -way.direction;
  const T p = density_of(contribution(
      sea_, scattering_at<T>(sea_, first.line, first.layer, arriving), leaving.direction));
  const T per_p = T(1) / (p * leaving.per_p);
  const T steeper = abs(arriving.z / first.direction.z);
  auto met = this->met(pair);
  Ray out = pair.out;
  change_first(pairing.i == Index<T>(1), per_p, T(1), out, met.out_near, met.out_free);
  put_first(T(to_laser.area / abs(arriving.z)), to_laser.freed, met.out_near, met.out_free);
  const auto jacobian = rotation_jacobian(first.position, arriving, leaving.direction);
  const RotatedMeeting<T> rotated{laser_.rotated_first(pairing.laser).density * per_p / steeper,
                                  jacobian};
  met.out_rotated = &rotated;
  const Mask<T> only = pairing.i == Index<T>(1);
  out.rotated.density = out.rotated.density * select(only, T(1) / steeper, T(1));
  lanes::assign<T>(only, jacobian, out.rotated.jacobian);
  out.weight = out.weight / first.weight * collision_gain(first) * to_laser.weight *
               (exp_minus(to_laser.tau) / to_laser.reach);
  out.path = out.path - first.path + to_laser.path;
  out.position = out.position + moved;
  met.out = &out;
  met.out_moved = moved;
  const NewLeg<T> leg{first, leaving, arriving, way, to_laser.in_water};
  met.free = Free::laser;
  met.leg = &leg;
  meet_free(pairing, to_laser.lit, met);
}

}  // namespace photic::estimator
