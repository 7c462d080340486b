// Meetings under tilted lenses: a translation makes the way from the lens longer or shorter (a part
// of connections.hpp; eq. 80). They are apart from meetings under upright lenses, whose loops stay
// short.
#pragma once

#include "estimator/bidirectional/connections.hpp"
#include "estimator/bidirectional/surface_entry.hpp"

namespace photic::estimator {

template <class T>
PHOTIC_APART Chord<T> Connections<T>::tilted_chord(DepthLine out_line, DepthLine back_line,
                                                   Index<T> m, AtLens<T> start) const {
  return chord(out_line, translatable(back_line, m), telescope_, start, receiver_.last_path);
}

/// Returns whether a telescope's translated ray goes through a depth; later rays only in walks that
/// all points of the lens can begin.
template <class T>
Mask<T> Connections<T>::can_meet(const RayPair<T>& pair, const Ray& moved, const T& depth) const {
  if (!is_aslant(telescope_)) return Mask<T>(true);
  const Mask<T> ahead = (geometry::depth_of(moved.position) - depth) * moved.direction.z > T(0);
  return ahead & ((pair.pairing.m == Index<T>(0)) |
                  all_points_reach(telescope_, last_depth(pair.pairing.back)));
}

template <class T>
FirstLeg<T> Connections<T>::first_leg(const BirthRecord<T>& birth, const Index<T>& back) const {
  using std::abs;
  const Vertex v = back_.vertex(back, Index<T>(0));
  T from(0);
  if (telescope_.inside) {
    const T lens = in_space(telescope_, birth.lens).z;
    from = select(birth.outward.z * v.direction.z < T(0), T(-lens), lens);  // or its image
  }
  const T steep = abs(v.direction.z);
  return {abs(v.position.z - from) / steep, steep};
}

/// The same where it comes through waves: the entry moves with the lens, and all that changes is
/// how densely its rays draw it.
template <class T>
PHOTIC_APART void Connections<T>::lengthen_to_entry(const RayPairing<T>& pairing,
                                                    const Mask<T>& first, Met<T>& met) const {
  if (all(first)) return;
  const Index<T> line = back_.line(pairing.back);
  const auto entry = back_.entry(pairing.back);
  const Vec3<T> v = back_.vertex(pairing.back, Index<T>(0)).position;
  const auto ratio = [&](const Vec3<T>& from, const SurfaceEntry<T>& by,
                         const instrument::PlanePoint<T>& lens) {
    return slopes_over_rays(world_, instrument(), line, from, by, lens, Mask<T>(!first));
  };
  const T before = ratio(v, entry, back_.birth_record(pairing.back).lens);
  const auto moved = entry_of(pairing.back, met);
  const T after = ratio(v + (moved.at - entry.at), moved, met.lens);
  const T wider = (T(1) + after) / (T(1) + before);
  met.back_free.footprint = met.back_free.footprint * wider;
  met.back_free.freed = after / (T(1) + after);
  met.back_near.instrument_edge = met.back_near.instrument_edge * wider;
}

/// Lengthens or shortens the way from a tilted lens. That changes the time of the light; in the
/// water also its weight, and the chance that walks go so far; and the densities of connecting this
/// edge and of meeting at its end, which later rays carry on. Walks that begin at facets come there
/// anyhow, and their edge is not connected.
template <class T>
PHOTIC_APART void Connections<T>::lengthen(const RayPairing<T>& pairing,
                                           const BirthRecord<T>& birth, T length, Ray& back,
                                           Met<T>& met) const {
  const Index<T> line = back_.line(pairing.back);
  const Index<T> here = sea_.at(line, receiver_.region.layer);
  const Mask<T> first = pairing.m == Index<T>(0);
  T growth(1);  // of the walks' draws along it
  if (telescope_.inside) {
    const Mask<T> straight = back_.facets(pairing.back) == Index<T>(0);
    length = select(first & straight, T(0), length);  // such first rays have been moved
    met.gain = exp_minus(length * gather<T>(sea_.c.first, here));
    growth = select(straight, exp_minus(-length / gather<T>(sea_.walk_mean_path, here)), T(1));
  }
  met.longer = length;
  back.path = back.path + length * at_lens(birth, line).index;
  if (enters_through_waves(world_.slabs, receiver_.region))
    return lengthen_to_entry(pairing, first, met);
  met.back_spread.before = met.back_spread.before + length;
  if (all(first)) return;
  const FirstLeg<T> way = first_leg(birth, pairing.back);
  const auto area = [&](const T& more) {
    auto spread = birth.spread;
    spread.through_surface = !telescope_.inside;
    spread.before = spread.before + more;
    return area_per_solid_angle(sea_, spread, line, way.length, way.steep);
  };
  const T wider = area(length) / area(T(0));
  met.back_free.footprint = met.back_free.footprint * wider;
  met.back_near.instrument_edge = met.back_near.instrument_edge * wider * growth;
  met.back_near.translated = met.back_near.translated * growth;
  back.translated = back.translated * select(pairing.m == Index<T>(1), growth, T(1));
}

/// Rays that meet at a depth, where the telescope's walk comes through a point of a tilted lens.
template <class T>
PHOTIC_APART PHOTIC_FLATTEN void Connections<T>::meet_tilted(const RayPair<T>& pair, Mask<T> mask,
                                                             instrument::PlanePoint<T> lens,
                                                             Index<T> telescope, T depth,
                                                             Index<T> place) {
  const Vec3<T>& outward = pair.birth.outward;
  const auto aside = lens + T(-1) * pair.birth.lens;
  const T longer = longer_by_translation(telescope_, outward, aside);
  auto met = this->met(pair);
  met.telescope = telescope;
  translate(met, in_plane(telescope_, aside) + longer * outward);
  if (!sea_.surface.one_direction_each) met.lens = lens;
  Ray back = pair.back;
  if (telescope_.inside) {  // there a first ray begins at the lens, or at facets
    const Mask<T> at_lens = (pair.pairing.m + back_.facets(pair.pairing.back)) == Index<T>(0);
    const T begins = select(at_lens, longer, T(0));
    back.position = pair.back.position - begins * pair.back.direction;
  }
  const Mask<T> meets = mask & can_meet(pair, back, depth);
  lengthen(pair.pairing, pair.birth, longer, back, met);
  met.back = &back;
  meet_at(pair.pairing, meets, met, depth, place);
}

}  // namespace photic::estimator
