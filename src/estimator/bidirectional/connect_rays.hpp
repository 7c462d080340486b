// Rays that are made to meet: by translating the telescope's walk, or by rotating it (a part of
// connections.hpp).
#pragma once

#include "estimator/bidirectional/connections.hpp"

namespace photic::estimator {

/// Lists all rays of so many walks of the laser; tells how many there are.
template <class T>
std::int32_t Connections<T>::list_laser_rays(std::size_t first, std::size_t walks) {
  walk_of_.resize(walks * (most_vertices + 1) + lanes_of<T>);  // packs are read beyond the end
  ray_of_.resize(walk_of_.size());
  std::int32_t count = 0;
  for (std::size_t walk = first; walk < first + walks; ++walk) {
    for (std::int32_t i = 0; i < laser_.rays(walk); ++i, ++count) {
      walk_of_[static_cast<std::size_t>(count)] = static_cast<std::int32_t>(walk);
      ray_of_[static_cast<std::size_t>(count)] = i;
    }
  }
  return count;
}

/// Calls act(pairing, mask, line of ray i, line of ray m) for all rays i of so many of the laser's
/// walks and m of the telescope's that may meet in time: as they are, and those that go up as the
/// surface reflects them.
template <class T>
template <class Act>
void Connections<T>::each_pair(std::size_t first_laser, std::size_t walks, std::size_t back,
                               Act act) {
  lanes::each_index<T>(back_.rays(back), [&](const Index<T>& m, const Mask<T>&) {
    const auto first = static_cast<std::size_t>(each_lane(m)[0]);
    DepthLine line = depth_line_of(back_.ray(Index<T>(back), m));
    lines_.each(line, [first](const T& member, auto* column) { store(member, column + first); });
  });
  lanes::each_index<T>(
      list_laser_rays(first_laser, walks), [&](const Index<T>& k, const Mask<T>& mask) {
        const Index<T> laser = gather_index<T>(walk_of_.data(), k);
        const Index<T> i = gather_index<T>(ray_of_.data(), k);
        const auto out_line = depth_line_of(laser_.ray(laser, i));
        const auto image = reflected(out_line, world_.deepest);
        const Mask<T> rises = mask & (out_line.rise > T(0));
        for (std::int32_t m = 0; m < back_.rays(back); ++m) {
          DepthLine back_line;
          lines_.each(back_line, [m](T& member, const auto* column) { member = T(column[m]); });
          const Mask<T> in_time = mask & in_order(i + Index<T>(m + 1)) &
                                  (out_line.start + back_line.start < receiver_.longest);
          if (!any(in_time)) break;
          const Pairing<T> pairing{laser, i, Index<T>(back), Index<T>(m)};
          const bool back_rises = all(back_line.rise > T(0));
          const auto back_image = reflected(back_line, world_.deepest);
          for (std::int32_t which = 0; which < (back_rises ? 4 : 2); ++which) {
            const Mask<T> some = which % 2 == 0 ? in_time : in_time & rises;
            if (any(some))
              act(RayPairing<T>{pairing, Index<T>(which)}, some, which % 2 == 0 ? out_line : image,
                  which < 2 ? back_line : back_image);
          }
        }
      });
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::meetings(std::size_t first_laser, std::size_t walks,
                                             std::size_t back, Moves moves) {
  const auto birth = back_.birth_record_in_all_lanes(back);
  const bool translates = moves != Moves::rotations && any(birth.translation_area > T(0));
  const bool rotates =
      moves != Moves::translations && any(samples_.rotated > T(0)) && back_.pivot_vertex(back) >= 0;
  if (translates && comes_to_bed()) meetings_on_bed(first_laser, walks, back);
  if (!translates && !rotates) return;
  const auto axis = back_.axis(Index<T>(back));
  const Index<T> pivot(back_.pivot_vertex(back));
  const auto start = at_lens(birth, back_.line(Index<T>(back)));
  each_pair(first_laser, walks, back,
            [&](const auto& pairing, const auto& mask, const DepthLine& out_line,
                const DepthLine& back_line) {
              if (translates)
                translate(pairing, mask & reverses(out_line, back_line), out_line, back_line,
                          start);
              if (rotates) rotate(pairing, mask & (pairing.m > pivot), out_line, back_line, axis);
            });
}

/// Where a telescope's ray can meet a laser's so that its walk comes through the lens.
template <class T>
Chord<T> Connections<T>::chord_of(const DepthLine& out_line, const DepthLine& back_line,
                                  const Index<T>& m, const AtLens<T>& start) const {
  if (!telescope_.upright) return tilted_chord(out_line, back_line, m, start);
  return chord(out_line, back_line, telescope_, start.lens, receiver_.last_path);
}
/// Rays that meet where the telescope's walk comes through the lens, at depths that lie on a grid.
template <class T>
void Connections<T>::translate(const RayPairing<T>& pairing, const Mask<T>& mask,
                               const DepthLine& out_line, const DepthLine& back_line,
                               const AtLens<T>& start) {
  if (!any(mask)) return;
  const auto chord = chord_of(out_line, back_line, pairing.m, start);
  const Mask<T> meet = mask & chord.exists;
  if (any(meet))
    translated_.push(meet, pairing,
                     [this](const auto& e, const auto& all) { serve_translated(e, all); });
}

/// Rays that both come to the bed so that the telescope's walk comes through the lens if they meet
/// there.
template <class T>
PHOTIC_APART PHOTIC_FLATTEN void Connections<T>::meetings_on_bed(std::size_t first_laser,
                                                                 std::size_t walks,
                                                                 std::size_t back) {
  const auto birth = back_.birth_record_in_all_lanes(back);
  const auto start = at_lens(birth, back_.line(Index<T>(back)));
  const T bed = world_.deepest;
  const T radius = telescope_.lens_radius;
  each_pair(
      first_laser, walks, back,
      [&](const auto& pairing, const auto& mask, const DepthLine& out_line,
          const DepthLine& back_line) {
        const Mask<T> down = mask & (out_line.rise < T(0)) & (back_line.rise < T(0)) &
                             samples_.grid.meets_on_bed(bed, pairing.order(), birth.grid_offset);
        if (!any(down)) return;
        const auto lens = chord_of(out_line, back_line, pairing.m, start).lens.at(bed);
        const Mask<T> meet = down & (lens.x * lens.x + lens.y * lens.y < radius * radius);
        if (any(meet))
          met_on_bed_.push(meet, pairing,
                           [this](const auto& e, const auto& all) { serve_met_on_bed(e, all); });
      });
}

/// A telescope's walk that is translated sideways.
template <class T>
Moved<T> Connections<T>::translated(const RayPair<T>& pair, const Vec3<T>& translation) const {
  Moved<T> moved{pair.back, pair.axis()};
  moved.axis.x = moved.axis.x + translation.x;
  moved.axis.y = moved.axis.y + translation.y;
  return moved;
}

/// Rays that meet where both are as far from the axis of a rotation.
template <class T>
void Connections<T>::rotate(const RayPairing<T>& pairing, const Mask<T>& mask,
                            const DepthLine& out_line, const DepthLine& back_line,
                            const RotationAxis<T>& axis) {
  if (!any(mask)) return;
  const auto meetings =
      estimator::equidistant_depths(out_line, back_line, axis, receiver_.last_path);
  for (std::size_t n = 0; n < meetings.depth.size(); ++n) {
    const Mask<T> meet = mask & meetings.exists[n];
    if (any(meet))
      rotated_.push(meet, RotatedPairing<T>{pairing, meetings.depth[n]},
                    [this](const auto& e, const auto& all) { serve_rotated(e, all); });
  }
}

/// The rays again that each_pair had found.
template <class T>
RayPair<T> Connections<T>::pair_of(const RayPairing<T>& pairing) const {
  const auto axis = back_.axis(pairing.back);
  RayPair<T> pair{laser_.ray(pairing.laser, pairing.i),
                  back_.ray(pairing.back, pairing.m),
                  laser_.birth_record(pairing.laser).spread,
                  back_.birth_record(pairing.back),
                  select(axis.exists, Index<T>(1), Index<T>(0)),
                  axis.x,
                  axis.y,
                  pairing,
                  {}};
  const Mask<T> back_reflected = pairing.reflected >= Index<T>(2);
  const Mask<T> out_reflected =
      (pairing.reflected == Index<T>(1)) | (pairing.reflected == Index<T>(3));
  if (any(out_reflected)) lanes::assign<T>(out_reflected, reflected(sea_, pair.out), pair.out);
  if (any(back_reflected)) lanes::assign<T>(back_reflected, reflected(sea_, pair.back), pair.back);
  return pair;
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::serve_translated(const RayPairing<T>& pairing,
                                                     const Mask<T>& mask) {
  const auto& grid = samples_.grid;
  RayPair<T> pairs = pair_of(pairing);
  const auto chord = chord_of(depth_line_of(pairs.out), depth_line_of(pairs.back), pairing.m,
                              at_lens(pairs.birth, back_.line(pairing.back)));
  pairs.lens = chord.lens;
  const auto meet_on_grid = [&](const Index<T>& lane, const T& number, const Mask<T>& points) {
    const auto& pair = lanes::of_lanes<T>(pairs, lane);
    const T depth = grid.depth(number + pair.birth.grid_offset, pair.pairing.order());
    meet_translated(pair, points, depth, transport::layer_at(sea_, pair.out.layer, depth));
  };
  lanes::each_number(mask, grid.number(chord.from, pairing.order()) - pairs.birth.grid_offset,
                     grid.number(chord.to, pairing.order()) - pairs.birth.grid_offset,
                     meet_on_grid);
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::serve_met_on_bed(const RayPairing<T>& pairing,
                                                     const Mask<T>& mask) {
  RayPair<T> pair = pair_of(pairing);
  pair.lens = chord_of(depth_line_of(pair.out), depth_line_of(pair.back), pairing.m,
                       at_lens(pair.birth, back_.line(pairing.back)))
                  .lens;
  meet_translated(pair, mask, world_.deepest, Index<T>(sea_.layers));
}

/// Rays that meet at a depth, if the telescope's walk then comes through the lens and is seen.
template <class T>
void Connections<T>::meet_translated(const RayPair<T>& pair, const Mask<T>& mask, const T& depth,
                                     const Index<T>& place) {
  const auto lens = pair.lens.at(depth);
  const Mask<T> passes =
      mask & open_at(telescope_, lens) & sight(telescope_, lens, -pair.birth.outward).on_detector;
  if (!any(passes)) return;
  if (!telescope_.upright) return meet_tilted(pair, passes, lens, depth, place);
  const Vec3<T> translation = in_plane(telescope_, lens) - in_plane(telescope_, pair.birth.lens);
  meet_at<true>(pair, passes, translated(pair, translation), depth, place);
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::serve_rotated(const RotatedPairing<T>& pairing,
                                                  const Mask<T>& mask) {
  RayPair<T> pair = pair_of(pairing);
  const auto rotation = rotation_to_meet(pair.out, pair.back, pair.axis(), pairing.depth);
  const auto [gain, near_pivot] = rotate_pivot(pair, rotation);
  Moved<T> moved{pair.back, pair.axis(), gain, near_pivot};
  moved.ray.position = rotation.of_place(pair.back.position);
  moved.ray.direction = rotation.of_direction(pair.back.direction);
  const Index<T> layer = transport::layer_at(sea_, pair.out.layer, pairing.depth);
  if (!telescope_.upright) return meet_under_tilted(pair, mask, moved, pairing.depth, layer);
  meet_at<true>(pair, mask, moved, pairing.depth, layer);
}

/// A rotation changes the scattering angle at the pivot, and with it the phase function's value
/// there. Tells by which factor the sample gains, and what the densities behind the telescope's ray
/// gain in all: 0 where light is converted, since then all strategies draw this angle alike (eq.
/// 79).
template <class T>
std::array<T, 2> Connections<T>::rotate_pivot(RayPair<T>& pair, const Rotation<T>& rotation) const {
  const auto& pairing = pair.pairing;
  const Pivot<T> pivot = back_.pivot(pairing.back);
  const Vec3<T> rotated = rotation.of_direction(pivot.leaving);
  const Mask<T> bed = pivot.phase < Index<T>(0);
  const Index<T> layer = select(bed, Index<T>(sea_.layers), Index<T>(0));
  const T p = transport::scattered_density(sea_, layer, select(bed, Index<T>(0), pivot.phase),
                                           pivot.arriving, rotated);
  const T gain = pivot.per_p * p;
  if (any(receiver_.line > Index<T>(0))) return {gain, T(0)};
  // The density of the walk's direction as it was drawn over that as it is now: strategies that do
  // not draw it gain so much beside the others.
  const auto& inverse_conversion = world_.inverse_conversion;
  const T gained =
      inverse_conversion.scattered_over_phase(sea_, layer, pivot.leaving, T(1) / pivot.per_p) /
      (gain * inverse_conversion.scattered_over_phase(sea_, layer, rotated, p));
  const T of_ray = select(pairing.m == Index<T>(1), gained, T(1));
  pair.back.per_p = of_ray * pair.back.per_p;
  pair.back.translated = of_ray * pair.back.translated;
  const auto in_path = usable(pairing.order());
  const auto near = back_.near_first(pairing.back, pairing.m, in_path,
                                     translations_in(in_path.order, pair.birth.translation_area));
  return {gain, (gained - T(1)) * (near.lens_edge + near.translated + near.next_edge)};
}

template <class T>
template <bool upright>
void Connections<T>::meet_at(const RayPair<T>& pair, const Mask<T>& mask, const Moved<T>& moved,
                             const T& depth, const Index<T>& place) {
  const Ray& out = pair.out;
  const auto& birth = pair.birth;
  const auto& pairing = pair.pairing;
  const Mask<T> emitting = mask & emits(moved.ray.line, place);
  if (!any(emitting)) return;
  const T reach = (-out.position.z - depth) / out.direction.z;
  const auto in_path = usable(pairing.order());
  const T translations_last = translations_in(in_path.order, birth.translation_area);
  Freedom<T> freedom{translations_last, select(is_pivot(moved.ray.line, pairing.m),
                                               axis_at(out.position + reach * out.direction,
                                                       moved.ray.direction, out.direction),
                                               moved.axis)};
  const auto last = [&] {
    return select(pairing.m > Index<T>(0), last_depth(pairing.back), depth);
  };
  const bool aslant = !upright && is_aslant(telescope_);
  if (aslant) freedom = freedom_before(last(), freedom);
  const auto laser = laser_.side(out, pair.spread, pairing.laser, pairing.i, in_path, freedom);
  auto back = back_.side(pair.back, birth.spread, pairing.back, pairing.m, in_path,
                         {translations_last, pair.axis()});
  back.ray = moved.ray;
  back.behind = back.behind + moved.near_pivot;
  T gain = moved.gain;
  if (!upright) {
    const Longer<T> longer = lengthened(pair, moved.longer);
    gain = gain * longer.gain;
    back.ray.path = back.ray.path + longer.path;
    back.spread.before = back.spread.before + longer.length;
    back.behind = back.behind + longer.behind;
    back.meeting = back.meeting + longer.meeting;
  }
  if (aslant)
    freedom.translations = select(pairing.m > Index<T>(0), freedom.translations, translations_last);
  const auto meeting =
      meet(sea_, laser, back, depth, place, freedom, world_.inverse_conversion, samples_);
  if (world_.compares) [[unlikely]]
    complete_by_meeting(pair, moved, depth, place);
  score(pair.pairing, Walked::both, emitting & (meeting.path < receiver_.last_path),
        {gain * meeting.value, meeting.path, last(), in_path.order, pairing.i, pairing.m,
         surface::on_bed<T>(sea_, place)});
}

}  // namespace photic::estimator
