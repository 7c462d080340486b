// The connections of a telescope's walk: with the laser, with the laser's walks, and of those with
// the telescope (docs/theory.md, "The bidirectional estimator").
#pragma once

#include <cmath>

#include "core/flatten.hpp"
#include "engine/walk.hpp"
#include "tally/batch_tally.hpp"
#include "transport/joint.hpp"
#include "transport/meet.hpp"
#include "transport/way.hpp"

namespace photic::engine {

template <class T>
class Connections {
 public:
  Connections(const World<T>& world, const Receiver<T>& receiver,
              const transport::Samples<T>& samples, const Walk<T>& telescope_walk,
              tally::BatchTally& tally)
      : world_(world),
        sea_(world.sea),
        telescope_(world.telescopes[receiver.telescope]),
        receiver_(receiver),
        samples_(samples),
        back_(telescope_walk),
        tally_(tally) {}

  /// The laser's walk with the walk's point of the lens: the local estimate of a single ray.
  void to_telescope(const Walk<T>& laser) const;
  /// The telescope's walk with the laser.
  void to_laser() const;
  /// Every vertex of the laser's walk with every vertex of the telescope's.
  void between(const Walk<T>& laser) const;
  /// Every ray of the laser's walk with every ray of the telescope's, shifted so that they meet at
  /// depths that lie on a grid from `offset` (0 to 1 of its step) on.
  void shifted(const Walk<T>& laser, T offset) const;
  /// Every ray of the laser's walk with every ray of the telescope's beyond where it converts,
  /// turned so that they meet.
  void turned(const Walk<T>& laser) const;

 private:
  using Vertex = transport::Vertex<T>;
  using Joint = transport::Joint<T>;

  void to_telescope(const Vertex& v, T turned, std::int32_t order, const transport::Way<T>& way,
                    bool mirrored) const;
  void to_laser(const Vertex& v, std::int32_t order, const transport::Way<T>& way,
                bool mirrored) const;
  void between(const Walk<T>& laser, std::int32_t i, std::int32_t m) const;
  void along(Index<T> line, const Joint& from, const Joint& to, const Vertex& v, const Vertex& w,
             T length, const Usable& usable, std::int32_t edge) const;
  void shifted(const Walk<T>& laser, std::int32_t i, std::int32_t m, const Usable& usable,
               const transport::Chord<T>& chord, T offset) const;
  template <class Act>
  void each_pair(const Walk<T>& laser, std::int32_t first, Act act) const;
  void meet_at(const Walk<T>& laser, std::int32_t i, std::int32_t m, const Usable& usable,
               const transport::Ray<T>& back, const transport::Vertical<T>& axis, T depth,
               T gain) const;

  /// Whether light of the laser's line can leave a layer as light of a line.
  [[nodiscard]] bool emits(Index<T> line, Index<T> layer) const {
    return line == 0 || sea_.conversion[sea_.at(line, layer)] > 0;
  }
  [[nodiscard]] bool beyond_last(std::int32_t order) const {
    return world_.last_order > 0 && order > world_.last_order;
  }
  /// Where the light of the telescope's walk was last scattered.
  [[nodiscard]] T last_depth() const { return -back_.vertex.front().position.z; }
  /// How the telescope's walk may be turned in paths that convert at a place.
  [[nodiscard]] transport::Vertical<T> vertical_at(const Vec3<T>& place) const {
    return {receiver_.line > 0, place.x, place.y};
  }
  /// How it may be moved in paths that come to its vertex w in the laser's line, if only by being
  /// converted there.
  [[nodiscard]] transport::Freedom<T> freedom_at(const Vertex& w) const {
    return {back_.shift_area, w.line == 0 ? back_.axis : vertical_at(w.position)};
  }
  /// `last`: the depth at which light was last scattered.
  void score(T value, T path, T last, std::int32_t order) const {
    tally::Score s;
    s.telescope = receiver_.telescope;
    s.line = receiver_.line;
    s.order = order;
    s.depth = last;
    s.path = path;
    s.value = value;
    tally_.score(s);
  }

  const World<T>& world_;
  const medium::MediumView& sea_;
  const instrument::Telescope<T>& telescope_;
  const Receiver<T>& receiver_;
  const transport::Samples<T>& samples_;
  const Walk<T>& back_;
  tally::BatchTally& tally_;
};

template <class T>
void Connections<T>::to_telescope(const Walk<T>& laser) const {
  const Index<T> line = receiver_.line;
  const Vec3<T> at = in_space(telescope_, back_.lens);
  for (std::int32_t i = 0; i < laser.vertices; ++i) {
    const Usable usable{i + 1, world_.most_vertices};
    Vertex room;
    const Vertex& v = laser.in_path(i, usable, room);
    if (!emits(line, v.layer)) continue;
    const T turned = laser.turned_before(i, usable, vertical_at(v.position));
    if (telescope_.submerged) {
      for (const bool mirrored : {false, true})
        to_telescope(v, turned, i + 1,
                     transport::way_in_water(sea_, v.position, line, at, mirrored), mirrored);
      continue;
    }
    const Vec3<T> there = telescope_.position - v.position;
    const T rise = telescope_.position.z - v.position.z * T(sea_.inverse_index[line]);
    if (telescope_.may_see_beyond(there.x, there.y, rise))
      to_telescope(v, turned, i + 1,
                   transport::way_through_surface(sea_, v.position, line, at, true), false);
  }
}

template <class T>
void Connections<T>::to_telescope(const Vertex& v, T turned, std::int32_t order,
                                  const transport::Way<T>& way, bool mirrored) const {
  const Index<T> line = receiver_.line;
  const auto seen = sight(telescope_, back_.lens, way.arriving);
  const T path = v.path + way.length_air + way.length_water * T(sea_.group_index[line]);
  if (!way.exists || !seen.on_detector || !(path < world_.last_path)) return;
  const T depth = -v.position.z;
  const auto tau = telescope_.submerged
                       ? depths_in_water(sea_, way, line, v.layer, depth, receiver_.layer,
                                         way.length_water, mirrored)
                       : depths_through_surface(sea_, way, line, v.layer, depth);
  const T solid_angle = detector_solid_angle(telescope_, seen.cos_off_axis);
  const T etendue = telescope_.area() * seen.cos_off_axis * solid_angle / way.index_squared;
  const transport::Freedom<T> freedom{instrument::shift_area(telescope_, seen.cos_off_axis),
                                      vertical_at(v.position)};
  const T behind = v.behind.all(freedom.shift_area) + turned;
  const Joint from = line == 0
                         ? scattering_from_laser(sea_, v, behind, way.direction, T(1), freedom)
                         : conversion_from_laser(sea_, v, behind, way.direction, line,
                                                 world_.reversal, T(1), T(1), freedom);
  const T area =
      samples_.to_instrument * from.share * solid_angle / (way.per_area * way.index_squared) +
      (mirrored ? T(0) : from.meeting);
  score(from.weight * way.passed * etendue *
            transport::balance(area, tau.all, tau.walk, from.end, transport::End<T>{}),
        path, depth, order);
}

template <class T>
void Connections<T>::to_laser() const {
  const auto& laser = world_.laser;
  const Vec3<T> vertex = transport::fictitious_vertex(laser);
  if (!(transport::connectable_solid_angle(laser, vertex) > T(0))) return;
  for (std::int32_t m = 0; m < back_.vertices; ++m) {
    Vertex room;
    const Vertex& w = back_.in_path(m, {m + 1, world_.most_vertices}, room);
    if (!emits(w.line, w.layer)) continue;
    if (!laser.submerged) {
      to_laser(w, m + 1,
               transport::way_through_surface(sea_, w.position, Index<T>(0), vertex, true), false);
      continue;
    }
    for (const bool mirrored : {false, true})
      to_laser(w, m + 1, transport::way_in_water(sea_, w.position, Index<T>(0), vertex, mirrored),
               mirrored);
  }
}

template <class T>
void Connections<T>::to_laser(const Vertex& w, std::int32_t order, const transport::Way<T>& way,
                              bool mirrored) const {
  const auto& laser = world_.laser;
  const Vec3<T> leaving = -way.arriving;
  const bool in_cone = one_minus_cos(leaving, laser.axis) < laser.one_minus_cos_divergence;
  if (!way.exists || !in_cone) return;
  // The way from the disc on; the fictitious vertex lies behind it.
  const T hidden = laser.vertex_distance / dot(leaving, laser.axis);
  const T air = laser.submerged ? T(0) : way.length_air - hidden;
  const T water = laser.submerged ? way.length_water - hidden : way.length_water;
  const T path = w.path + air + water * T(sea_.group_index[0]);
  if (!(water > T(0)) || !(path < world_.last_path)) return;
  const T depth = -w.position.z;
  const auto tau = laser.submerged ? depths_in_water(sea_, way, Index<T>(0), w.layer, depth,
                                                     world_.laser_layer, water, mirrored)
                                   : depths_through_surface(sea_, way, Index<T>(0), w.layer, depth);
  const Joint to = arrival_from_laser(sea_, w, way.direction, world_.reversal, freedom_at(w));
  const T solid_angle =
      transport::connectable_solid_angle(laser, transport::fictitious_vertex(laser));
  const T area =
      samples_.to_instrument * to.share * solid_angle / (way.per_area * way.index_squared) +
      (mirrored ? T(0) : to.meeting);
  score(to.weight * way.passed *
            transport::balance(area, tau.all, tau.walk, transport::End<T>{}, to.end),
        path, last_depth(), order);
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::between(const Walk<T>& laser) const {
  for (std::int32_t i = 0; i < laser.vertices; ++i) {
    for (std::int32_t m = 0; m < back_.vertices; ++m) {
      if (beyond_last(i + m + 2)) break;
      if (!(laser.vertex[i].path + back_.vertex[m].path < world_.last_path)) break;
      between(laser, i, m);
    }
  }
}

template <class T>
void Connections<T>::between(const Walk<T>& laser, std::int32_t i, std::int32_t m) const {
  const Usable usable{i + m + 2, world_.most_vertices};
  Vertex v_room, w_room;
  const Vertex& v = laser.in_path(i, usable, v_room);
  const Vertex& w = back_.in_path(m, usable, w_room);
  const Vec3<T> there = w.position - v.position;
  const T length = std::sqrt(dot(there, there));
  const Vec3<T> direction = (T(1) / length) * there;
  if (emits(w.line, w.layer)) {
    const transport::Freedom<T> freedom = freedom_at(w);
    const T behind =
        v.behind.all(freedom.shift_area) + laser.turned_before(i, usable, freedom.axis);
    const Joint to = arrival_from_laser(sea_, w, -direction, world_.reversal, freedom);
    along(0, scattering_from_laser(sea_, v, behind, direction, to.goes_on, freedom), to, v, w,
          length, usable, i + 1);
  }
  if (w.line != 0 && emits(w.line, v.layer)) {
    const transport::Freedom<T> freedom{back_.shift_area, vertical_at(v.position)};
    const T behind =
        v.behind.all(freedom.shift_area) + laser.turned_before(i, usable, freedom.axis);
    const T goes_on = T(1) - world_.reversal.chance(sea_, w.line, w.layer);
    along(w.line,
          conversion_from_laser(sea_, v, behind, direction, w.line, world_.reversal, w.chance,
                                w.chance * goes_on, freedom),
          scattering_of_converted(sea_, w, -direction), v, w, length, usable, i + 1);
  }
}

template <class T>
void Connections<T>::along(Index<T> line, const Joint& from, const Joint& to, const Vertex& v,
                           const Vertex& w, T length, const Usable& usable,
                           std::int32_t edge) const {
  const T path = v.path + w.path + length * T(sea_.group_index[line]);
  if (!(path < world_.last_path)) return;
  const T depth = -v.position.z;
  const T end = -w.position.z;
  const T tau = sea_.slant_optical_depth<T>(line, v.layer, depth, w.layer, end, length);
  const T walk_tau = sea_.walk_slant_optical_depth<T>(line, v.layer, depth, w.layer, end, length);
  T meeting(0);
  if (usable.meeting(edge)) meeting += from.meeting * to.end.p;
  if (usable.meeting(edge + 1)) meeting += to.meeting * from.end.p;
  const T area = samples_.between * from.share * to.share * length * length + meeting;
  score(from.weight * to.weight * balance(area, tau, walk_tau, from.end, to.end), path,
        last_depth(), usable.order);
}

/// Calls act(i, m, usable) for all rays i of the laser's walk and m of the telescope's, from
/// `first` on, that may meet in time.
template <class T>
template <class Act>
void Connections<T>::each_pair(const Walk<T>& laser, std::int32_t first, Act act) const {
  for (std::int32_t m = first; m < back_.rays; ++m) {
    const transport::Ray<T>& back = back_.ray[m];
    for (std::int32_t i = 0; i < laser.rays; ++i) {
      const transport::Ray<T>& out = laser.ray[i];
      const Usable usable{i + m + 1, world_.most_vertices};
      if (beyond_last(usable.order) || !(out.path + back.path < world_.last_path)) break;
      if (out.direction.z * back.direction.z > T(0)) act(i, m, usable);
    }
  }
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::shifted(const Walk<T>& laser, T offset) const {
  if (!(back_.shift_area > T(0))) return;
  each_pair(laser, 0, [&](std::int32_t i, std::int32_t m, const Usable& usable) {
    const auto chord =
        transport::chord(laser.ray[i], back_.ray[m], telescope_, back_.lens, world_.deepest);
    if (chord.exists) shifted(laser, i, m, usable, chord, offset);
  });
}

template <class T>
void Connections<T>::shifted(const Walk<T>& laser, std::int32_t i, std::int32_t m,
                             const Usable& usable, const transport::Chord<T>& chord,
                             T offset) const {
  const auto& grid = samples_.grid;
  const T last = grid.number(chord.to) - offset;
  for (T j = std::ceil(grid.number(chord.from) - offset); j < last; j += T(1)) {
    const T depth = grid.depth(j + offset);
    const instrument::PlanePoint<T> lens{chord.lens.x + depth * chord.per_depth.x,
                                         chord.lens.y + depth * chord.per_depth.y};
    if (!open_at(telescope_, lens) || !sight(telescope_, lens, -back_.outward).on_detector)
      continue;
    const Vec3<T> shift = in_space(telescope_, lens) - in_space(telescope_, back_.lens);
    transport::Vertical<T> axis = back_.axis;
    axis.x += shift.x;
    axis.y += shift.y;
    meet_at(laser, i, m, usable, back_.ray[m], axis, depth, T(1));
  }
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::turned(const Walk<T>& laser) const {
  if (!(samples_.turned > T(0)) || !back_.axis.exists) return;
  const transport::Vertex<T>& converting = back_.vertex[back_.converted];
  const transport::Ray<T>& left = back_.ray[back_.converted + 1];
  const Index<T> phase = sea_.conversion_phase[receiver_.line];
  each_pair(laser, back_.converted + 1, [&](std::int32_t i, std::int32_t m, const Usable& usable) {
    const transport::Ray<T>& back = back_.ray[m];
    const auto crossings = transport::crossings(laser.ray[i], back, back_.axis, world_.deepest);
    for (std::size_t n = 0; n < crossings.depth.size(); ++n) {
      if (!crossings.exists[n]) continue;
      const T depth = crossings.depth[n];
      const auto turn = transport::turn_to_meet(laser.ray[i], back, back_.axis, depth);
      transport::Ray<T> moved = back;
      moved.position = turn.of_place(back.position);
      moved.direction = turn.of_direction(back.direction);
      // The angle of the conversion has changed, and with it all densities of the walk alike.
      const T gain =
          left.per_p * phase_value(sea_, converting, turn.of_direction(left.direction), phase);
      meet_at(laser, i, m, usable, moved, back_.axis, depth, gain);
    }
  });
}

/// `back`: the telescope's ray m, `axis`: its walk's, as they have been moved.
template <class T>
void Connections<T>::meet_at(const Walk<T>& laser, std::int32_t i, std::int32_t m,
                             const Usable& usable, const transport::Ray<T>& back,
                             const transport::Vertical<T>& axis, T depth, T gain) const {
  const transport::Ray<T>& out = laser.ray[i];
  const Index<T> layer = transport::layer_at(sea_, out.layer, depth);
  if (!emits(back.line, layer)) return;
  const T reach = (-depth - out.position.z) / out.direction.z;
  const transport::Freedom<T> freedom{
      back_.shift_area, back.line == 0 ? axis : vertical_at(out.position + reach * out.direction)};
  transport::Side<T> home = back_.side(m, usable, {back_.shift_area, back_.axis});
  const auto meeting =
      meet(sea_, laser.side(i, usable, freedom), {back, home.spread, home.behind, home.last}, depth,
           layer, freedom, world_.reversal, samples_);
  if (meeting.path < world_.last_path)
    score(gain * meeting.value, meeting.path, m > 0 ? last_depth() : depth, usable.order);
}

}  // namespace photic::engine
