// Rays that are made to meet: by shifting the telescope's walk, or by turning it (a part of
// connections.hpp).
#pragma once

#include "engine/connections.hpp"

namespace photic::engine {

/// Calls act(ends, mask, ray i, ray m) for all rays i of the laser's walk and m of the telescope's,
/// from `first` on, that may meet in time: as they are, and those that go up as the surface
/// reflects them.
template <class T>
template <class Act>
void Connections<T>::each_pair(std::size_t laser, std::size_t back, std::int32_t first,
                               Act act) const {
  each_index<T>(laser_.rays(laser), [&](const Index<T>& i, const Mask<T>& mask) {
    const Ray out = laser_.ray(Index<T>(laser), i);
    const Mask<T> rises = mask & (out.direction.z > T(0));
    const Ray image = any(rises) ? reflected(sea_, out) : out;
    for (std::int32_t m = first; m < back_.rays(back); ++m) {
      const Ray home = back_.ray_in_all_lanes(back, m);
      const Mask<T> in_time =
          mask & in_order(i + Index<T>(m + 1)) & (out.path + home.path < receiver_.last_path);
      if (!any(in_time)) break;
      const auto ends = ends_of<T>(laser, i, back, Index<T>(m));
      const bool home_rises = all(home.direction.z > T(0));
      const Ray home_image = home_rises ? reflected(sea_, home) : home;
      for (std::int32_t which = 0; which < (home_rises ? 4 : 2); ++which) {
        const Mask<T> some = which % 2 == 0 ? in_time : in_time & rises;
        if (any(some))
          act(RayEnds<T>{ends, Index<T>(which)}, some, which % 2 == 0 ? out : image,
              which < 2 ? home : home_image);
      }
    }
  });
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::shifted(std::size_t laser, std::size_t back) {
  const auto outset = back_.outset_in_all_lanes(back);
  if (!any(outset.shift_area > T(0))) return;
  each_pair(
      laser, back, 0, [&](const auto& ends, const auto& mask, const Ray& out, const Ray& home) {
        const Mask<T> may = mask & transport::turns_back(out, home);
        if (!any(may)) return;
        const auto chord = transport::chord(out, home, telescope_, outset.lens, world_.deepest);
        const Mask<T> meet = may & chord.exists;
        if (any(meet))
          chords_.admit(meet, ends,
                        [this](const auto& e, const auto& all) { serve_chords(e, all); });
      });
}

/// The rays again that each_pair had found.
template <class T>
Pair<T> Connections<T>::pair_of(const RayEnds<T>& ends) const {
  const auto axis = back_.axis(ends.back);
  Pair<T> pair{laser_.ray(ends.laser, ends.i),
               back_.ray(ends.back, ends.m),
               laser_.outset(ends.laser).spread,
               back_.outset(ends.back),
               select(axis.exists, Index<T>(1), Index<T>(0)),
               axis.x,
               axis.y,
               ends,
               {}};
  const Mask<T> home = ends.reflected >= Index<T>(2);
  const Mask<T> out = (ends.reflected == Index<T>(1)) | (ends.reflected == Index<T>(3));
  if (any(out)) assign<T>(out, reflected(sea_, pair.out), pair.out);
  if (any(home)) assign<T>(home, reflected(sea_, pair.back), pair.back);
  return pair;
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::serve_chords(const RayEnds<T>& ends, const Mask<T>& mask) {
  const auto& grid = samples_.grid;
  Pair<T> pairs = pair_of(ends);
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
    const Vec3<T> shift = in_plane(telescope_, lens) - in_plane(telescope_, pair.outset.lens);
    transport::Vertical<T> axis = pair.axis();
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
PHOTIC_FLATTEN void Connections<T>::serve_crossings(const RayEnds<T>& ends, const Mask<T>& mask,
                                                    std::size_t which) {
  const Pair<T> pair = pair_of(ends);
  const auto axis = pair.axis();
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
  const Ray& out = pair.out;
  const auto& outset = pair.outset;
  const auto& ends = pair.ends;
  const Index<T> layer = transport::layer_at(sea_, out.layer, depth);
  const Mask<T> emitting = mask & emits(moved.line, layer);
  if (!any(emitting)) return;
  const T reach = (-out.position.z - depth) / out.direction.z;
  const transport::Freedom<T> freedom{
      outset.shift_area,
      axis_or(moved.line > Index<T>(0), axis, out.position + reach * out.direction)};
  const auto in_path = usable(ends.i + ends.m + Index<T>(1));
  auto home = back_.side(pair.back, outset.spread, ends.back, ends.m, in_path,
                         {outset.shift_area, pair.axis()});
  home.ray = moved;
  const auto meeting =
      meet(sea_, laser_.side(out, pair.spread, ends.laser, ends.i, in_path, freedom), home, depth,
           layer, freedom, world_.reversal, samples_);
  if (world_.compares) [[unlikely]]
    complete_by_meeting(out, moved, depth, layer);
  score(pair.ends, Walked::both, emitting & (meeting.path < receiver_.last_path),
        gain * meeting.value, meeting.path,
        select(ends.m > Index<T>(0), last_depth(ends.back), depth), in_path.order);
}

}  // namespace photic::engine
