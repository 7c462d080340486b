// Rays that are made to meet: by translating the telescope's walk, or by rotating it (a part of
// connections.hpp).
#pragma once

#include "estimator/bidirectional/connections.hpp"

namespace photic::estimator {

/// Lists all rays of so many walks of the laser; returns their number.
template <class T>
std::int32_t Connections<T>::list_laser_rays(std::size_t first, std::size_t walks) {
  walk_of_.resize(walks * (max_vertices + 1) + lanes_of<T>);  // packs are read beyond the end
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
/// surface reflects them, or as facets of waves have sent them back.
template <class T>
template <class Act>
void Connections<T>::each_pair(std::size_t first_laser, std::size_t walks, std::size_t back,
                               Act act) {
  const bool facets = !sea_.surface.one_direction_each;
  lanes::each_index<T>(back_.rays(back), [&](const Index<T>& m, const Mask<T>&) {
    const auto first = static_cast<std::size_t>(each_lane(m)[0]);
    DepthLine line = depth_line_of(back_.ray(Index<T>(back), m));
    lines_.each(line, [first](const T& member, auto* column) { store(member, column + first); });
  });
  lanes::each_index<T>(list_laser_rays(first_laser, walks), [&](const Index<T>& k,
                                                                const Mask<T>& mask) {
    const Index<T> laser = gather_index<T>(walk_of_.data(), k);
    const Index<T> i = gather_index<T>(ray_of_.data(), k);
    const auto out_line = depth_line_of(laser_.ray(laser, i));
    const auto image = facets ? depth_line_of(laser_.behind_facets(laser, i))
                              : reflected(out_line, world_.walks.deepest);
    const Mask<T> returns =
        mask & (facets ? laser_.is_sent_back(laser, i) : Mask<T>(out_line.rise > T(0)));
    for (std::int32_t m = 0; m < back_.rays(back); ++m) {
      DepthLine back_line;
      lines_.each(back_line, [m](T& member, const auto* column) { member = T(column[m]); });
      const Mask<T> in_time = mask & in_order(i + Index<T>(m + 1)) &
                              (out_line.start + back_line.start < receiver_.longest);
      if (!any(in_time)) break;
      const Pairing<T> pairing{laser, i, Index<T>(back), Index<T>(m)};
      const bool back_returns = facets ? back_.is_sent_back(back, m) : all(back_line.rise > T(0));
      const auto back_image = facets && back_returns
                                  ? depth_line_of(back_.behind_facets_in_all_lanes(back, m))
                                  : reflected(back_line, world_.walks.deepest);
      for (std::int32_t which = 0; which < (back_returns ? 4 : 2); ++which) {
        const Mask<T> some = which % 2 == 0 ? in_time : in_time & returns;
        if (!any(some)) continue;
        tally_.operations.ray_pairs += count(some);
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
  const bool own = back_.is_own(back);
  const bool translates = world_.walks.uses.translated && includes(moves, Moves::translations) &&
                          any(birth.translation_area > T(0));
  const bool rotates = own && includes(moves, Moves::rotations) && any(samples_.rotated > T(0)) &&
                       back_.pivot_vertex(back) >= 0;
  const bool of_telescope = includes(moves, Moves::free_telescope) && frees(instrument()) &&
                            any(samples_.free_telescope.most > T(0)) && back_.vertices(back) > 0 &&
                            any(may_be_free(back_, instrument(), Index<T>(back)));
  const bool of_laser = own && includes(moves, Moves::free_laser) &&
                        frees(photic::estimator::of_laser) && any(samples_.free_laser.most > T(0));
  if (translates && comes_to_bed()) meetings_on_bed(first_laser, walks, back);
  if (!translates && !rotates && !of_telescope && !of_laser) return;
  const auto telescope_start = of_telescope ? free_telescope_start(back) : FreeStart<T>{};
  const auto axis = back_.axis(Index<T>(back));
  const Index<T> pivot(back_.pivot_vertex(back));
  const auto start = at_lens(birth, back_.line(Index<T>(back)));
  each_pair(
      first_laser, walks, back,
      [&](const auto& pairing, const auto& all, const DepthLine& out_line,
          const DepthLine& back_line) {
        const Mask<T> mask = all & is_lit(pairing.laser);
        const Mask<T> meets = reverses(out_line, back_line) | converts(back, pairing.m);
        if (translates) translate(pairing, mask & meets, out_line, back_line, start);
        if (rotates)
          rotate(pairing, mask & (pairing.m > pivot), out_line, back_line,
                 rotated_with(axis, pairing, pairing.reflects_telescope()));
        if (of_telescope)
          free_meetings(pairing, mask & (pairing.m > Index<T>(0)), meets, out_line, back_line,
                        telescope_start, T(1), samples_.free_telescope, birth.grid_offset,
                        [this](const Mask<T>& meet, const FreePairing<T>& at) {
                          free_telescope_.push(meet, at, [this](const auto& e, const auto& m) {
                            serve_free_telescope(e, m);
                          });
                        });
        if (!of_laser) return;
        const Mask<T> later = all & (pairing.i > Index<T>(0)) &
                              may_be_free(laser_, photic::estimator::of_laser, pairing.laser);
        if (any(later))
          free_meetings(pairing, later, meets, out_line, back_line, free_laser_start(pairing.laser),
                        T(-1), samples_.free_laser, birth.grid_offset,
                        [this](const Mask<T>& meet, const FreePairing<T>& at) {
                          free_laser_.push(meet, at, [this](const auto& e, const auto& m) {
                            serve_free_laser(e, m);
                          });
                        });
      });
}

/// The chord where a telescope's ray can meet a laser's so that its walk comes through the lens.
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
  const T bed = world_.walks.deepest;
  const T radius = telescope_.lens_radius;
  each_pair(first_laser, walks, back,
            [&](const auto& pairing, const auto& mask, const DepthLine& out_line,
                const DepthLine& back_line) {
              const Mask<T> down =
                  mask & is_lit(pairing.laser) & (out_line.rise < T(0)) & (back_line.rise < T(0)) &
                  samples_.grid.meets_on_bed(bed, pairing.order(), birth.grid_offset);
              if (!any(down)) return;
              const auto lens = chord_of(out_line, back_line, pairing.m, start).lens.at(bed);
              const Mask<T> meet = down & (lens.x * lens.x + lens.y * lens.y < radius * radius);
              if (any(meet))
                met_on_bed_.push(meet, pairing, [this](const auto& e, const auto& all) {
                  serve_met_on_bed(e, all);
                });
            });
}

/// Two rays before a walk is moved.
template <class T>
Met<T> Connections<T>::met(const RayPair<T>& pair) const {
  Met<T> met;
  met.out = &pair.out;
  met.back = &pair.back;
  met.out_spread = pair.spread;
  met.back_spread = pair.birth.spread;
  met.out_spread.through_surface = laser_.through_surface();  // lanes do not keep it
  met.back_spread.through_surface = back_.through_surface();
  met.out_near = laser_.near_first(pair.pairing.laser);
  met.back_near = back_.near_first(pair.pairing.back);
  if (samples_.frees()) {
    met.out_free = laser_.free_area(pair.pairing.laser);
    met.back_free = back_.free_area(pair.pairing.back);
  }
  met.translation_area = pair.birth.translation_area;
  met.axis = met.own_axis = pair.axis();
  met.telescope = seen_by(pair.pairing.back);
  if (!sea_.surface.one_direction_each) {
    met.lens = pair.birth.lens;
    met.moved = {T(0), T(0)};
  }
  return met;
}
/// The telescope's walk is moved sideways. Its ray keeps its place: the rays' levels are all that
/// counts.
template <class T>
void Connections<T>::translate(Met<T>& met, const Vec3<T>& translation) const {
  met.axis.x = met.axis.x + translation.x;
  met.axis.y = met.axis.y + translation.y;
  if (!sea_.surface.one_direction_each) met.moved = {translation.x, translation.y};
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
      rotated_.push(meet, PlacedPairing<T>{pairing, meetings.depth[n]},
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
  const auto reflect = [&](const Mask<T>& mask, const Walks<T>& walks, const Index<T>& walk,
                           const Index<T>& m, Ray& ray) {
    if (!any(mask)) return;
    lanes::assign<T>(mask, walks.has_facets() ? walks.behind_facets(walk, m) : reflected(sea_, ray),
                     ray);
  };
  reflect(pairing.reflects_laser(), laser_, pairing.laser, pairing.i, pair.out);
  reflect(pairing.reflects_telescope(), back_, pairing.back, pairing.m, pair.back);
  return pair;
}

template <class T>
PHOTIC_APART PHOTIC_FLATTEN void Connections<T>::serve_translated(const RayPairing<T>& pairing,
                                                                  const Mask<T>& mask) {
  const auto& grid = samples_.grid;
  RayPair<T> pairs = pair_of(pairing);
  const auto chord = chord_of(depth_line_of(pairs.out), depth_line_of(pairs.back), pairing.m,
                              at_lens(pairs.birth, back_.line(pairing.back)));
  pairs.lens = chord.lens;
  const auto meet_on_grid = [&](const Index<T>& lane, const T& number, const Mask<T>& points) {
    const auto& pair = lanes::of_lanes<T>(pairs, lane);
    const T depth = grid.depth(number + pair.birth.grid_offset, pair.pairing.order());
    meet_translated(pair, points, depth, sea_.layer_at(pair.out.layer, depth));
  };
  lanes::each_number(mask, grid.number(chord.from, pairing.order()) - pairs.birth.grid_offset,
                     grid.number(chord.to, pairing.order()) - pairs.birth.grid_offset,
                     meet_on_grid);
}

template <class T>
PHOTIC_APART PHOTIC_FLATTEN void Connections<T>::serve_met_on_bed(const RayPairing<T>& pairing,
                                                                  const Mask<T>& mask) {
  RayPair<T> pair = pair_of(pairing);
  pair.lens = chord_of(depth_line_of(pair.out), depth_line_of(pair.back), pairing.m,
                       at_lens(pair.birth, back_.line(pairing.back)))
                  .lens;
  meet_translated(pair, mask, world_.walks.deepest, Index<T>(sea_.layers));
}

/// Rays that meet at a depth, if the telescope's walk then comes through the lens and is seen.
template <class T>
void Connections<T>::meet_translated(const RayPair<T>& pair, const Mask<T>& mask, const T& depth,
                                     const Index<T>& place) {
  const auto lens = pair.lens.at(depth);
  const auto sight = instrument::sight(telescope_, lens, -pair.birth.outward);
  const Mask<T> passes = mask & open_at(telescope_, lens) & sight.on_detector;
  if (!any(passes)) return;
  if (!telescope_.upright) return meet_tilted(pair, passes, lens, seen_by(sight), depth, place);
  auto met = this->met(pair);
  met.telescope = seen_by(sight);
  translate(met, in_plane(telescope_, lens) - in_plane(telescope_, pair.birth.lens));
  if (!sea_.surface.one_direction_each) met.lens = lens;
  meet_at(pair.pairing, passes, met, depth, place);
}

template <class T>
PHOTIC_APART PHOTIC_FLATTEN void Connections<T>::serve_rotated(const PlacedPairing<T>& pairing,
                                                               const Mask<T>& mask) {
  const RayPair<T> pair = pair_of(pairing);
  const auto rotation = rotation_to_meet(pair.out, pair.back, pair.axis(), pairing.depth);
  auto met = this->met(pair);
  Ray back = pair.back;
  rotate_pivot(pairing, rotation, back, met);
  back.position = rotation.of_place(pair.back.position);
  back.direction = rotation.of_direction(pair.back.direction);
  met.back = &back;
  meet_at(pairing, mask, met, pairing.depth, sea_.layer_at(pair.out.layer, pairing.depth));
}

/// Changes the densities near the first vertex of a telescope's walk, of two vertices or more, that
/// comes there otherwise: of the direction in which it leaves it (1 over that, `per_p`), and of the
/// choice of the way (`chance`), both over their former values. `only`: the ray begins there.
template <class T>
void Connections<T>::change_first(const Mask<T>& only, const T& per_p, const T& chance, Ray& ray,
                                  NearFirst<T>& near, FreeArea<T>& free) {
  const T of_ray = select(only, per_p, chance);
  ray.chance = ray.chance * chance;
  ray.vertex_chance = ray.vertex_chance * select(only, T(1), chance);
  ray.per_p = ray.per_p * select(only, per_p, T(1));
  ray.translated = ray.translated * of_ray;
  ray.rotated.density = ray.rotated.density * of_ray;
  free.averaged = free.averaged * per_p / chance;
  near.instrument_edge = near.instrument_edge * per_p;
  near.next_edge = near.next_edge * per_p;
  near.translated = near.translated * per_p;
}

/// Rotates the pivot. A rotation changes the scattering angle at the pivot, and with it the phase
/// function's value there. Where light is converted all strategies draw this angle alike (eq. 79).
template <class T>
void Connections<T>::rotate_pivot(const RayPairing<T>& pairing, const Rotation<T>& rotation,
                                  Ray& back, Met<T>& met) const {
  const Pivot<T> pivot = back_.pivot(pairing.back);
  const Vec3<T> rotated = rotation.of_direction(pivot.leaving);
  const Mask<T> bed = pivot.phase < Index<T>(0);
  const Index<T> layer = select(bed, Index<T>(sea_.layers), Index<T>(0));
  const T of_pivot = contribution(
      sea_, Interaction<T>{layer, select(bed, Index<T>(0), pivot.phase), pivot.arriving}, rotated);
  const T p = density_of(of_pivot), p_before = T(1) / pivot.per_p;
  met.gain = pivot.per_p * of_pivot;
  if (any(receiver_.line > Index<T>(0))) return;
  const auto chance = [&](const Vec3<T>& direction, const T& value) {
    return world_.walks.inverse_conversion.scattered_over_phase(sea_, layer, direction, value);
  };
  const T gained = chance(rotated, p) / chance(pivot.leaving, p_before);
  met.gain = met.gain * gained;
  met.rest = gained;
  change_first(pairing.m == Index<T>(1), T(p_before / p), gained, back, met.back_near,
               met.back_free);
  if (!frees(instrument())) return;
  // The mean over directions in which it could have come is that of another angle.
  const Index<T> line(0);
  const Vertex first = back_.vertex(pairing.back, Index<T>(0));
  met.back_free.averaged = averaged_over_drawn(world_, instrument(), line, first.layer,
                                               Mask<T>(true), first.direction.z, rotated, p);
}

}  // namespace photic::estimator
