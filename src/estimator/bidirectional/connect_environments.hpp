// Connections in environments: what the paths that they complete are there (a part of
// connections.hpp).
#pragma once

#include "estimator/bidirectional/connections.hpp"
#include "estimator/bidirectional/leg_terms.hpp"
#include "estimator/bidirectional/surface_entry.hpp"

namespace photic::estimator {

template <class T>
PHOTIC_APART void Connections<T>::complete_to_telescope(const Pairing<T>& pairing, const Vertex& v,
                                                        const geometry::Sightline<T>& way,
                                                        const geometry::Segment<T>& in_water) {
  const Index<T> line = back_.line(pairing.back);
  completion_.clear();
  add_leg(sea_, laser_.ray(pairing.laser, pairing.i), v, completion_.ways);
  completion_.pass_flat(sea_, in_water, way.direction);
  completion_.collide(sea_, {v.line, v.layer, line > Index<T>(0), line,
                             one_minus_cos(v.direction, way.direction), T(-v.direction.z)});
  complete_entry(line, way);
}
/// By a way to an instrument: the surface, and the air above it.
template <class T>
void Connections<T>::complete_entry(const Index<T>& line, const geometry::Sightline<T>& way) {
  if (!way.to.outside) return;
  if (sea_.surface.differs_in_environments)
    completion_.surface.meet(sea_, meeting_along(sea_, line, way));
  add_column(way.to, line, way.arriving.z, way.stretch, completion_.ways);
}
/// By a facet to a telescope in the water.
template <class T>
PHOTIC_APART void Connections<T>::complete_by_facet(const Pairing<T>& pairing, const Vertex& v,
                                                    const transport::WavesConnection<T>& way) {
  const Index<T> line = back_.line(pairing.back);
  completion_.clear();
  add_leg(sea_, laser_.ray(pairing.laser, pairing.i), v, completion_.ways);
  completion_.pass(sea_, way.in_water);
  completion_.pass(sea_,
                   transport::from_surface_in_water(sea_, receiver_.region, line, way.onward));
  completion_.collide(sea_, {v.line, v.layer, line > Index<T>(0), line,
                             one_minus_cos(v.direction, way.direction), T(-v.direction.z)});
  if (sea_.surface.differs_in_environments) completion_.surface.meet(sea_, way.meeting);
}

template <class T>
PHOTIC_APART void Connections<T>::complete_to_laser(const Pairing<T>& pairing, const Vertex& w,
                                                    const geometry::Sightline<T>& way,
                                                    const geometry::Segment<T>& in_water) {
  completion_.clear();
  add_leg(sea_, back_.ray(pairing.back, pairing.m), w, completion_.ways);
  completion_.pass_flat(sea_, in_water, way.direction);
  completion_.collide(sea_, {w.line, w.layer, w.line > Index<T>(0), w.line,
                             one_minus_cos(w.direction, way.direction), way.direction.z});
  complete_entry(Index<T>(0), way);
}

/// By an edge.
template <class T>
PHOTIC_APART void Connections<T>::complete_between(const Pairing<T>& pairing, const Vertex& v,
                                                   const Vertex& w,
                                                   const geometry::Segment<T>& edge) {
  const Index<T>& line = edge.line;
  const Vec3<T> direction = (T(1) / edge.length) * (w.position - v.position);
  completion_.clear();
  add_leg(sea_, laser_.ray(pairing.laser, pairing.i), v, completion_.ways);
  add_leg(sea_, back_.ray(pairing.back, pairing.m), w, completion_.ways);
  completion_.pass(sea_, edge);
  completion_.collide(sea_, {v.line, v.layer, line > v.line, line,
                             one_minus_cos(v.direction, direction), T(-v.direction.z)});
  completion_.collide(sea_, {w.line, w.layer, w.line > line, w.line,
                             one_minus_cos(w.direction, -direction), T(-direction.z)});
}

/// By a meeting of a laser's ray and a telescope's.
template <class T>
PHOTIC_APART void Connections<T>::complete_by_meeting(const RayPairing<T>& pairing,
                                                      const Met<T>& met, const T& depth,
                                                      const Index<T>& layer) {
  const Ray &out = *met.out, &back = *met.back;
  const bool facets = !sea_.surface.one_direction_each;
  const auto pass = [&](const Ray& ray, const Walks<T>& walks, const Index<T>& walk,
                        const Index<T>& m, const Mask<T>& sent_back) {
    const Mask<T> reflected = ray.is_reflected();
    WalkPoint<T> left = ray;
    left.position = select(reflected, geometry::mirror_image(ray.position), ray.position);
    left.direction.z = ray.leaving_z();
    if (facets && any(sent_back)) {
      const Ray up = walks.ray(walk, m);
      left.position = select(sent_back, up.position, left.position);
      left.direction = select(sent_back, up.direction, left.direction);
      left.layer = select(sent_back, up.layer, left.layer);
    }
    WalkPoint<T> arrived = ray;
    arrived.position = ray.position + ray.length_to(depth) * ray.direction;
    arrived.layer = layer;
    add_leg(sea_, left, arrived, completion_.ways);
  };
  completion_.clear();
  completion_.meets = true;
  if (facets) completion_.sent_back = pairing.reflected;
  pass(out, laser_, pairing.laser, pairing.i, pairing.reflects_laser());
  pass(back, back_, pairing.back, pairing.m, pairing.reflects_telescope());
  if (is_aslant(telescope_)) {
    const Index<T>& at = receiver_.region.layer;
    const auto level = sea_.level(at, T(0));
    completion_.pass(sea_, {back_.line(pairing.back), level, level, met.longer});
  }
  completion_.collide(sea_, {out.line, layer, back.line > Index<T>(0), back.line,
                             one_minus_cos(out.direction, -back.direction), T(-out.direction.z)});
  if (met.free == Free::none) return;
  const auto& [first, leaving, arriving, way, in_water] = *met.leg;
  completion_.pass_flat(sea_, in_water, way.direction);
  completion_.collide(sea_, {first.line, first.layer, Mask<T>(!(first.line == leaving.line)),
                             first.line, one_minus_cos(arriving, leaving.direction),
                             met.free == Free::telescope ? leaving.direction.z : T(-arriving.z)});
  complete_entry(first.line, way);
}

/// Scores with the ratios of the completed paths.
template <class T>
PHOTIC_APART PHOTIC_FLATTEN void Connections<T>::score_in_environments(Pairing<T> pairing,
                                                                       Technique technique,
                                                                       Mask<T> mask,
                                                                       FoundPath<T> path) {
  const auto laser = each_lane(pairing.laser), out = each_lane(pairing.i);
  const auto telescope = each_lane(pairing.back), back = each_lane(pairing.m);
  const auto sent_back = each_lane(completion_.sent_back);
  lanes::each_score(tally_, mask, scores_of(pairing, technique, path),
                    [&](std::size_t lane, const tally::Score& score, const auto& at) {
                      const auto whole_leg = [&](std::int32_t of_walk) {
                        return !completion_.meets || (sent_back[lane] & of_walk) != 0;
                      };
                      const auto of_walks = [&](std::int32_t e) {
                        const auto of_laser = [&] {
                          return laser_.ratio(sea_, laser[lane], out[lane],
                                              path.free == Free::laser, whole_leg(1), e);
                        };
                        const auto of_telescope = [&] {
                          return back_.ratio(sea_, telescope[lane], back[lane],
                                             path.free == Free::telescope, whole_leg(2), e);
                        };
                        if (technique == Technique::laser) return of_laser();
                        if (technique == Technique::telescope) return of_telescope();
                        return joined(sea_.environments, e, of_laser(), of_telescope());
                      };
                      tally_.not_finite +=
                          complete<T>(sea_, completion_, lane, of_walks, ratios_.data());
                      tally_.score(score, at, ratios_.data());
                    });
}

}  // namespace photic::estimator
