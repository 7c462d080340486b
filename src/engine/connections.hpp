// The connections of telescopes' walks: with the laser, with the laser's walks, and of those with
// the telescope (docs/theory.md, "The bidirectional estimator").
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/flatten.hpp"
#include "engine/waiting_room.hpp"
#include "engine/walk.hpp"
#include "tally/batch_tally.hpp"
#include "transport/joint.hpp"
#include "transport/meet.hpp"
#include "transport/way.hpp"

namespace photic::engine {

/// What may be connected: vertex or ray i of a laser's walk and m of a telescope's.
template <class T>
struct Ends {
  Index<T> laser{}, i{}, back{}, m{};

  template <class F>
  void each_member(F f) {
    f(laser), f(i), f(back), f(m);
  }
  static constexpr std::size_t reals = 0, integers = 4;
};

/// Two rays that may be made to meet.
template <class T>
struct Pair {
  transport::Ray<T> out, back;
  Outset<T> outset;  ///< of the telescope's walk
  Ends<T> ends;
  transport::LensLine<T> lens;  ///< where it comes through, if it is shifted

  template <class F>
  void each_member(F f) {
    out.each_member(f);
    back.each_member(f);
    outset.each_member(f);
    ends.each_member(f);
    f(lens.at_surface.x), f(lens.at_surface.y), f(lens.per_depth.x), f(lens.per_depth.y);
  }
};

template <class T>
class Connections {
 public:
  Connections(const World<T>& world, const Receiver<T>& receiver,
              const transport::Samples<T>& samples, const Walks<T>& from_laser,
              const Walks<T>& from_telescope, tally::BatchTally& tally)
      : world_(world),
        sea_(world.sea),
        telescope_(world.telescopes[receiver.telescope]),
        receiver_(receiver),
        samples_(samples),
        laser_(from_laser),
        back_(from_telescope),
        tally_(tally) {}

  /// The laser's walk with the point of the lens of the telescope's that goes with it: the local
  /// estimate of a single ray.
  void to_telescope(std::size_t walk);
  /// The telescope's walk with the laser.
  void to_laser(std::size_t walk);
  /// Every vertex of the laser's walk with every vertex of the telescope's.
  void between(std::size_t walk);
  /// Every ray of the laser's walk with every ray of the telescope's, shifted so that they meet at
  /// depths that lie on a grid.
  void shifted(std::size_t laser, std::size_t back);
  /// Every ray of the laser's walk with every ray of the telescope's beyond where it converts,
  /// turned so that they meet.
  void turned(std::size_t laser, std::size_t back);
  /// What still waits for others to fill a pack.
  void close();

 private:
  using Vertex = transport::Vertex<T>;
  using Ray = transport::Ray<T>;
  using Joint = transport::Joint<T>;
  using Room = WaitingRoom<T, Ends<T>>;

  template <class Act>
  void each_pair(std::size_t laser, std::size_t back, std::int32_t first, Act act) const;

  // What is done with the ends of a mask once they fill a pack.
  void serve_to_telescope(const Ends<T>& ends, const Mask<T>& mask);
  void serve_to_laser(const Ends<T>& ends, const Mask<T>& mask);
  void serve_between(const Ends<T>& ends, const Mask<T>& mask);
  void serve_chords(const Ends<T>& ends, const Mask<T>& mask);
  void serve_crossings(const Ends<T>& ends, const Mask<T>& mask, std::size_t which);

  void by_way(const Ends<T>& ends, const Mask<T>& mask, const Vertex& v, const T& turned,
              const Outset<T>& outset, const transport::Way<T>& way, bool mirrored);
  void by_way_to_laser(const Ends<T>& ends, const Mask<T>& mask, const Vertex& w,
                       const transport::Way<T>& way, bool mirrored);
  void along(const Ends<T>& ends, const Mask<T>& mask, const Index<T>& line, const Joint& from,
             const Joint& to, const Vertex& v, const Vertex& w, const T& length,
             const Usable<T>& usable);
  void meet_at(const Pair<T>& pair, const Mask<T>& mask, const Ray& moved,
               const transport::Vertical<T>& axis, const T& depth, const T& gain);

  [[nodiscard]] Usable<T> usable(const Index<T>& order) const {
    return {order, world_.most_vertices};
  }
  /// Whether light of the laser's line can leave a layer as light of a line.
  [[nodiscard]] Mask<T> emits(const Index<T>& line, const Index<T>& layer) const {
    return (line == Index<T>(0)) | (gather<T>(sea_.conversion, sea_.at(line, layer)) > T(0));
  }
  /// Whether paths of an order can still be scored.
  [[nodiscard]] Mask<T> in_order(const Index<T>& order) const {
    return order <= Index<T>(world_.last_order > 0 ? world_.last_order
                                                   : std::numeric_limits<std::int32_t>::max());
  }
  /// Where the light of a telescope's walk was last scattered.
  [[nodiscard]] T last_depth(const Index<T>& back) const {
    return -back_.vertex(back, Index<T>(0)).position.z;
  }
  /// How a telescope's walk may be turned in paths that convert at a place.
  [[nodiscard]] transport::Vertical<T> vertical_at(const Vec3<T>& place) const {
    return {receiver_.line > Index<T>(0), place.x, place.y};
  }
  /// `axis`, or where the path converts at `place` the vertical there.
  [[nodiscard]] transport::Vertical<T> axis_or(const Mask<T>& converts,
                                               const transport::Vertical<T>& axis,
                                               const Vec3<T>& place) const {
    const auto other = vertical_at(place);
    return {select(converts, other.exists, axis.exists), select(converts, other.x, axis.x),
            select(converts, other.y, axis.y)};
  }
  /// `last`: the depth at which light was last scattered.
  void score(const Mask<T>& mask, const T& value, const T& path, const T& last,
             const Index<T>& order) {
    const auto values = each_lane(value), paths = each_lane(path), depths = each_lane(last);
    const auto orders = each_lane(order);
    const std::int32_t line = each_lane(receiver_.line)[0];
    for_each_lane(mask, [&](int lane) {
      const auto k = static_cast<std::size_t>(lane);
      tally_.score({receiver_.telescope, line, orders[k], depths[k], paths[k], values[k]});
    });
  }

  const World<T>& world_;
  const medium::MediumView& sea_;
  const instrument::Telescope<T>& telescope_;
  const Receiver<T>& receiver_;
  const transport::Samples<T>& samples_;
  const Walks<T>& laser_;
  const Walks<T>& back_;
  tally::BatchTally& tally_;
  Room to_telescope_, to_laser_, between_, chords_;
  std::array<Room, 2> crossings_;
};

/// Calls act(Index, mask) for the whole numbers below `count`, so many at a time as there are
/// lanes.
template <class T, class Act>
void each_index(std::int32_t count, Act act) {
  for (std::int32_t base = 0; base < count; base += lanes_of<T>) {
    const Index<T> i = Index<T>(base) + lane_numbers<T>();
    act(i, i < Index<T>(count));
  }
}

template <class T>
Ends<T> ends_of(std::size_t laser, const Index<T>& i, std::size_t back, const Index<T>& m) {
  return {Index<T>(laser), i, Index<T>(back), m};
}

template <class T>
void Connections<T>::to_telescope(std::size_t walk) {
  each_index<T>(laser_.vertices(walk), [&](const Index<T>& i, const Mask<T>& mask) {
    to_telescope_.admit(mask, ends_of<T>(walk, i, walk, Index<T>(0)),
                        [this](const auto& e, const auto& all) { serve_to_telescope(e, all); });
  });
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::serve_to_telescope(const Ends<T>& ends, const Mask<T>& mask) {
  const Index<T>& line = receiver_.line;
  const auto outset = back_.outset(ends.back);
  const Vec3<T> at = in_space(telescope_, outset.lens);
  const auto in_path = usable(ends.i + Index<T>(1));
  const Vertex v = laser_.in_path(ends.laser, ends.i, in_path);
  const Mask<T> wanted = mask & emits(line, v.layer);
  if (telescope_.submerged) {
    const T turned = laser_.turned_before(ends.laser, ends.i, in_path, vertical_at(v.position));
    for (const bool mirrored : {false, true})
      by_way(ends, wanted, v, turned, outset,
             transport::way_in_water(sea_, v.position, line, at, mirrored), mirrored);
    return;
  }
  const Vec3<T> there = telescope_.position - v.position;
  const T rise = telescope_.position.z - v.position.z * gather<T>(sea_.inverse_index, line);
  const Mask<T> near_view = wanted & telescope_.may_see_beyond(there.x, there.y, rise);
  if (!any(near_view)) return;
  const T turned = laser_.turned_before(ends.laser, ends.i, in_path, vertical_at(v.position));
  by_way(ends, near_view, v, turned, outset,
         transport::way_through_surface(sea_, v.position, line, at, near_view), false);
}

template <class T>
void Connections<T>::by_way(const Ends<T>& ends, const Mask<T>& mask, const Vertex& v,
                            const T& turned, const Outset<T>& outset, const transport::Way<T>& way,
                            bool mirrored) {
  const Index<T>& line = receiver_.line;
  const auto sight = instrument::sight(telescope_, outset.lens, way.arriving);
  const T path = v.path + way.length_air + way.length_water * gather<T>(sea_.group_index, line);
  const Mask<T> seen = mask & way.exists & sight.on_detector & (path < world_.last_path);
  if (!any(seen)) return;
  const T depth = -v.position.z;
  const auto tau = telescope_.submerged
                       ? depths_in_water(sea_, way, line, v.layer, depth, receiver_.layer,
                                         way.length_water, mirrored)
                       : depths_through_surface(sea_, way, line, v.layer, depth);
  const T solid_angle = detector_solid_angle(telescope_, sight.cos_off_axis);
  const T etendue = telescope_.area() * sight.cos_off_axis * solid_angle / way.index_squared;
  const transport::Freedom<T> freedom{instrument::shift_area(telescope_, sight.cos_off_axis),
                                      vertical_at(v.position)};
  const T behind = v.behind.all(freedom.shift_area) + turned;
  const Joint from = all(line == Index<T>(0))
                         ? scattering_from_laser(sea_, v, behind, way.direction, T(1), freedom)
                         : conversion_from_laser(sea_, v, behind, way.direction, line,
                                                 world_.reversal, T(1), T(1), freedom);
  const T area =
      samples_.to_instrument * from.share * solid_angle / (way.per_area * way.index_squared) +
      (mirrored ? T(0) : from.meeting);
  score(seen,
        from.weight * way.passed * etendue *
            transport::balance(area, tau.all, tau.walk, from.end, transport::End<T>{}),
        path, depth, ends.i + Index<T>(1));
}

template <class T>
void Connections<T>::to_laser(std::size_t walk) {
  each_index<T>(back_.vertices(walk), [&](const Index<T>& m, const Mask<T>& mask) {
    to_laser_.admit(mask, ends_of<T>(walk, Index<T>(0), walk, m),
                    [this](const auto& e, const auto& all) { serve_to_laser(e, all); });
  });
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::serve_to_laser(const Ends<T>& ends, const Mask<T>& mask) {
  const auto& laser = world_.laser;
  const Vec3<T> vertex = transport::fictitious_vertex(laser);
  if (!any(transport::connectable_solid_angle(laser, vertex) > T(0))) return;
  const Vertex w = back_.in_path(ends.back, ends.m, usable(ends.m + Index<T>(1)));
  const Mask<T> wanted = mask & emits(w.line, w.layer);
  const Index<T> line(0);
  if (!laser.submerged) {
    by_way_to_laser(ends, wanted, w,
                    transport::way_through_surface(sea_, w.position, line, vertex, wanted), false);
    return;
  }
  for (const bool mirrored : {false, true})
    by_way_to_laser(ends, wanted, w,
                    transport::way_in_water(sea_, w.position, line, vertex, mirrored), mirrored);
}

template <class T>
void Connections<T>::by_way_to_laser(const Ends<T>& ends, const Mask<T>& mask, const Vertex& w,
                                     const transport::Way<T>& way, bool mirrored) {
  const auto& laser = world_.laser;
  const Vec3<T> leaving = -way.arriving;
  const Mask<T> in_cone = one_minus_cos(leaving, laser.axis) < laser.one_minus_cos_divergence;
  Mask<T> lit = mask & way.exists & in_cone;
  if (!any(lit)) return;
  // The way from the disc on; the fictitious vertex lies behind it.
  const T hidden = laser.vertex_distance / dot(leaving, laser.axis);
  const T air = laser.submerged ? T(0) : way.length_air - hidden;
  const T water = laser.submerged ? way.length_water - hidden : way.length_water;
  const Index<T> line(0);
  const T path = w.path + air + water * gather<T>(sea_.group_index, line);
  lit = lit & (water > T(0)) & (path < world_.last_path);
  if (!any(lit)) return;
  const T depth = -w.position.z;
  const auto tau = laser.submerged ? depths_in_water(sea_, way, line, w.layer, depth,
                                                     world_.laser_layer, water, mirrored)
                                   : depths_through_surface(sea_, way, line, w.layer, depth);
  const transport::Freedom<T> freedom{
      back_.outset(ends.back).shift_area,
      axis_or(w.line > Index<T>(0), back_.axis(ends.back), w.position)};
  const Joint to = arrival_from_laser(sea_, w, way.direction, world_.reversal, freedom);
  const T solid_angle =
      transport::connectable_solid_angle(laser, transport::fictitious_vertex(laser));
  const T area =
      samples_.to_instrument * to.share * solid_angle / (way.per_area * way.index_squared) +
      (mirrored ? T(0) : to.meeting);
  score(lit,
        to.weight * way.passed *
            transport::balance(area, tau.all, tau.walk, transport::End<T>{}, to.end),
        path, last_depth(ends.back), ends.m + Index<T>(1));
}

template <class T>
void Connections<T>::between(std::size_t walk) {
  each_index<T>(laser_.vertices(walk), [&](const Index<T>& i, const Mask<T>& mask) {
    const T path = laser_.vertex(Index<T>(walk), i).path;
    for (std::int32_t m = 0; m < back_.vertices(walk); ++m) {
      const Mask<T> may = mask & in_order(i + Index<T>(m + 2)) &
                          (path + back_.vertex_in_all_lanes(walk, m).path < world_.last_path);
      if (!any(may)) break;
      between_.admit(may, ends_of<T>(walk, i, walk, Index<T>(m)),
                     [this](const auto& e, const auto& all) { serve_between(e, all); });
    }
  });
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::serve_between(const Ends<T>& ends, const Mask<T>& mask) {
  const auto in_path = usable(ends.i + ends.m + Index<T>(2));
  const Vertex v = laser_.in_path(ends.laser, ends.i, in_path);
  const Vertex w = back_.in_path(ends.back, ends.m, in_path);
  const Vec3<T> there = w.position - v.position;
  const T length = photic::length(there);
  const Vec3<T> direction = (T(1) / length) * there;
  const T shift_area = back_.outset(ends.back).shift_area;
  const Mask<T> inelastic = w.line > Index<T>(0);
  const Mask<T> arrives = mask & emits(w.line, w.layer);
  if (any(arrives)) {
    const transport::Freedom<T> freedom{shift_area,
                                        axis_or(inelastic, back_.axis(ends.back), w.position)};
    const T behind =
        v.behind.all(shift_area) + laser_.turned_before(ends.laser, ends.i, in_path, freedom.axis);
    const Joint to = arrival_from_laser(sea_, w, -direction, world_.reversal, freedom);
    along(ends, arrives, Index<T>(0),
          scattering_from_laser(sea_, v, behind, direction, to.goes_on, freedom), to, v, w, length,
          in_path);
  }
  const Mask<T> converts = mask & inelastic & emits(w.line, v.layer);
  if (any(converts)) {
    const transport::Freedom<T> freedom{shift_area, vertical_at(v.position)};
    const T behind =
        v.behind.all(shift_area) + laser_.turned_before(ends.laser, ends.i, in_path, freedom.axis);
    const T goes_on = T(1) - world_.reversal.chance(sea_, w.line, w.layer);
    along(ends, converts, w.line,
          conversion_from_laser(sea_, v, behind, direction, w.line, world_.reversal, w.chance,
                                w.chance * goes_on, freedom),
          scattering_of_converted(sea_, w, -direction), v, w, length, in_path);
  }
}

template <class T>
void Connections<T>::along(const Ends<T>& ends, const Mask<T>& mask, const Index<T>& line,
                           const Joint& from, const Joint& to, const Vertex& v, const Vertex& w,
                           const T& length, const Usable<T>& usable) {
  const T path = v.path + w.path + length * gather<T>(sea_.group_index, line);
  const Mask<T> in_time = mask & (path < world_.last_path);
  if (!any(in_time)) return;
  const T depth = -v.position.z;
  const T end = -w.position.z;
  const T tau = sea_.slant_optical_depth<T>(line, v.layer, depth, w.layer, end, length);
  const T walk_tau = sea_.walk_slant_optical_depth<T>(line, v.layer, depth, w.layer, end, length);
  const Index<T> edge = ends.i + Index<T>(1);
  const T meeting = select(usable.meeting(edge), from.meeting * to.end.p, T(0)) +
                    select(usable.meeting(edge + Index<T>(1)), to.meeting * from.end.p, T(0));
  const T area = samples_.between * from.share * to.share * length * length + meeting;
  score(in_time, from.weight * to.weight * balance(area, tau, walk_tau, from.end, to.end), path,
        last_depth(ends.back), usable.order);
}

/// Calls act(ends, mask, ray i, ray m) for all rays i of the laser's walk and m of the telescope's,
/// from `first` on, that may meet in time.
template <class T>
template <class Act>
void Connections<T>::each_pair(std::size_t laser, std::size_t back, std::int32_t first,
                               Act act) const {
  each_index<T>(laser_.rays(laser), [&](const Index<T>& i, const Mask<T>& mask) {
    const Ray out = laser_.ray(Index<T>(laser), i);
    for (std::int32_t m = first; m < back_.rays(back); ++m) {
      const Ray home = back_.ray_in_all_lanes(back, m);
      const Mask<T> in_time =
          mask & in_order(i + Index<T>(m + 1)) & (out.path + home.path < world_.last_path);
      if (!any(in_time)) break;
      const Mask<T> may = in_time & (out.direction.z * home.direction.z > T(0));
      if (any(may)) act(ends_of<T>(laser, i, back, Index<T>(m)), may, out, home);
    }
  });
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::shifted(std::size_t laser, std::size_t back) {
  const auto outset = back_.outset_in_all_lanes(back);
  if (!any(outset.shift_area > T(0))) return;
  each_pair(
      laser, back, 0, [&](const auto& ends, const auto& mask, const Ray& out, const Ray& home) {
        const auto chord = transport::chord(out, home, telescope_, outset.lens, world_.deepest);
        const Mask<T> meet = mask & chord.exists;
        if (any(meet))
          chords_.admit(meet, ends,
                        [this](const auto& e, const auto& all) { serve_chords(e, all); });
      });
}

/// Calls act(which lane, number, mask) for all whole numbers from `first` to below `last` of the
/// lanes of a mask, so many at a time as there are lanes.
template <class T, class Act>
void each_number(const Mask<T>& mask, const T& first, const T& last, Act act) {
  constexpr std::size_t lanes = lanes_of<T>;
  std::array<std::int32_t, lanes> lane{};
  std::array<Element<T>, lanes> number{};
  std::size_t found = 0;
  const auto firsts = each_lane(first), lasts = each_lane(last);
  const auto pass_on = [&] {
    Index<T> from(0);
    T n(0);
    const Mask<T> all = mask_of_bits<T>(found == 32 ? ~0U : (1U << found) - 1);
    expand(all, lane.data(), from);
    expand(all, number.data(), n);
    act(from, n, all);
    found = 0;
  };
  for_each_lane(mask, [&](int k) {
    const auto i = static_cast<std::size_t>(k);
    for (auto n = std::ceil(firsts[i]); n < lasts[i]; n += 1) {
      lane[found] = k;
      number[found] = n;
      if (++found == lanes) pass_on();
    }
  });
  if (found > 0) pass_on();
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::serve_chords(const Ends<T>& ends, const Mask<T>& mask) {
  const auto& grid = samples_.grid;
  Pair<T> pairs{laser_.ray(ends.laser, ends.i),
                back_.ray(ends.back, ends.m),
                back_.outset(ends.back),
                ends,
                {}};
  const auto chord =
      transport::chord(pairs.out, pairs.back, telescope_, pairs.outset.lens, world_.deepest);
  pairs.lens = chord.lens;
  const auto meet_on_grid = [&](const Index<T>& lane, const T& number, const Mask<T>& points) {
    const auto& pair = of_lanes<T>(pairs, lane);
    const T depth = grid.depth(number + pair.outset.grid_offset);
    const auto lens = pair.lens.at(depth);
    const Mask<T> passes = points & open_at(telescope_, lens) &
                           sight(telescope_, lens, -pair.outset.outward).on_detector;
    if (!any(passes)) return;
    const Vec3<T> shift = in_space(telescope_, lens) - in_space(telescope_, pair.outset.lens);
    transport::Vertical<T> axis = back_.axis(pair.ends.back);
    axis.x = axis.x + shift.x;
    axis.y = axis.y + shift.y;
    meet_at(pair, passes, pair.back, axis, depth, T(1));
  };
  each_number(mask, grid.number(chord.from) - pairs.outset.grid_offset,
              grid.number(chord.to) - pairs.outset.grid_offset, meet_on_grid);
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::turned(std::size_t laser, std::size_t back) {
  if (!any(samples_.turned > T(0)) || back_.converted(back) < 0) return;
  const auto axis = back_.axis(Index<T>(back));
  const std::int32_t first = back_.converted(back) + 1;
  each_pair(laser, back, first,
            [&](const auto& ends, const auto& mask, const Ray& out, const Ray& home) {
              const auto crossings = transport::crossings(out, home, axis, world_.deepest);
              for (std::size_t n = 0; n < crossings_.size(); ++n) {
                const Mask<T> meet = mask & crossings.exists[n];
                if (!any(meet)) continue;
                crossings_[n].admit(meet, ends, [this, n](const auto& e, const auto& all) {
                  serve_crossings(e, all, n);
                });
              }
            });
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::serve_crossings(const Ends<T>& ends, const Mask<T>& mask,
                                                    std::size_t which) {
  const Pair<T> pair{laser_.ray(ends.laser, ends.i),
                     back_.ray(ends.back, ends.m),
                     back_.outset(ends.back),
                     ends,
                     {}};
  const auto axis = back_.axis(ends.back);
  const T depth = transport::crossings(pair.out, pair.back, axis, world_.deepest).depth[which];
  const auto turn = transport::turn_to_meet(pair.out, pair.back, axis, depth);
  Ray moved = pair.back;
  moved.position = turn.of_place(pair.back.position);
  moved.direction = turn.of_direction(pair.back.direction);
  // The angle of the conversion has changed, and with it all densities of the walk alike.
  const Index<T> conversion = back_.conversion(ends.back);
  const Ray left = back_.ray(ends.back, conversion + Index<T>(1));
  const T gain = left.per_p * phase_value(sea_, back_.vertex(ends.back, conversion),
                                          turn.of_direction(left.direction),
                                          gather_index<T>(sea_.conversion_phase, receiver_.line));
  meet_at(pair, mask, moved, axis, depth, gain);
}

/// `moved`: the telescope's ray, `axis`: its walk's, as they have been moved.
template <class T>
void Connections<T>::meet_at(const Pair<T>& pair, const Mask<T>& mask, const Ray& moved,
                             const transport::Vertical<T>& axis, const T& depth, const T& gain) {
  const auto& [out, back, outset, ends, lens] = pair;
  const Index<T> layer = transport::layer_at(sea_, out.layer, depth);
  const Mask<T> emitting = mask & emits(back.line, layer);
  if (!any(emitting)) return;
  const T reach = (-depth - out.position.z) / out.direction.z;
  const transport::Freedom<T> freedom{
      outset.shift_area,
      axis_or(back.line > Index<T>(0), axis, out.position + reach * out.direction)};
  const auto in_path = usable(ends.i + ends.m + Index<T>(1));
  auto home =
      back_.side(back, ends.back, ends.m, in_path, {outset.shift_area, back_.axis(ends.back)});
  home.ray = moved;
  const auto meeting = meet(sea_, laser_.side(out, ends.laser, ends.i, in_path, freedom), home,
                            depth, layer, freedom, world_.reversal, samples_);
  score(emitting & (meeting.path < world_.last_path), gain * meeting.value, meeting.path,
        select(ends.m > Index<T>(0), last_depth(ends.back), depth), in_path.order);
}

template <class T>
void Connections<T>::close() {
  to_telescope_.close([this](const auto& e, const auto& mask) { serve_to_telescope(e, mask); });
  to_laser_.close([this](const auto& e, const auto& mask) { serve_to_laser(e, mask); });
  between_.close([this](const auto& e, const auto& mask) { serve_between(e, mask); });
  chords_.close([this](const auto& e, const auto& mask) { serve_chords(e, mask); });
  for (std::size_t n = 0; n < crossings_.size(); ++n)
    crossings_[n].close([&](const auto& e, const auto& mask) { serve_crossings(e, mask, n); });
}

}  // namespace photic::engine
