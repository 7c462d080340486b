// The parts of what the bidirectional estimator handles, one by one: to put four scalars into four
// lanes and to compare each lane with its scalar.
#pragma once

#include "estimator/bidirectional/connection_end.hpp"
#include "estimator/bidirectional/meet.hpp"
#include "transport/connect_ray.hpp"
#include "unit/transport/packs.hpp"

namespace photic::transport {

template <class P, template <class> class S>
inline constexpr bool is_packed = std::same_as<std::remove_const_t<P>, S<Lanes4>>;

// fields(packed, one, f) calls f(lanes, scalar, name) for every part.
template <class P, class S, class F>
  requires is_packed<P, Vec3>
void fields(P& a, S& b, F f) {
  f(a.x, b.x, "x");
  f(a.y, b.y, "y");
  f(a.z, b.z, "z");
}
template <class P, class S, class F>
  requires is_packed<P, instrument::PlanePoint>
void fields(P& a, S& b, F f) {
  f(a.x, b.x, "x");
  f(a.y, b.y, "y");
}
template <class P, class S, class F>
  requires is_packed<P, instrument::Sight>
void fields(P& a, S& b, F f) {
  f(a.on_detector, b.on_detector, "on detector");
  f(a.cos_off_axis, b.cos_off_axis, "cosine");
}
template <class P, class S, class F>
  requires is_packed<P, Photon>
void fields(P& a, S& b, F f) {
  fields(a.position, b.position, f);
  fields(a.direction, b.direction, f);
  f(a.weight, b.weight, "weight");
  f(a.analog_weight, b.analog_weight, "analog weight");
  f(a.path, b.path, "path");
  f(a.line, b.line, "line");
  f(a.layer, b.layer, "layer");
  f(a.order, b.order, "order");
}
template <class P, class S, class F>
  requires is_packed<P, geometry::Sightline>
void fields(P& a, S& b, F f) {
  f(a.exists, b.exists, "exists");
  fields(a.direction, b.direction, f);
  fields(a.arriving, b.arriving, f);
  f(a.length_water, b.length_water, "length in water");
  f(a.length_air, b.length_air, "length in air");
  fields(a.crossing, b.crossing, f);
  f(a.secant_water, b.secant_water, "secant in water");
  f(a.area_per_solid_angle, b.area_per_solid_angle, "area per solid angle");
  f(a.index_squared, b.index_squared, "index squared");
  f(a.throughput, b.throughput, "throughput");
}
template <class P, class S, class F>
  requires is_packed<P, geometry::OpticalDepths>
void fields(P& a, S& b, F f) {
  f(a.all, b.all, "optical depth");
  f(a.walk, b.walk, "walked optical depth");
}
template <class P, class S, class F>
  requires is_packed<P, estimator::Densities>
void fields(P& a, S& b, F f) {
  f(a.edges, b.edges, "edges");
  f(a.translated, b.translated, "translated");
  f(a.rotated, b.rotated, "rotated");
}
template <class P, class S, class F>
  requires is_packed<P, estimator::RotationAxis>
void fields(P& a, S& b, F f) {
  f(a.exists, b.exists, "axis exists");
  f(a.x, b.x, "axis x");
  f(a.y, b.y, "axis y");
}
template <class P, class S, class F>
  requires is_packed<P, estimator::Freedom>
void fields(P& a, S& b, F f) {
  f(a.translations, b.translations, "translations");
  fields(a.axis, b.axis, f);
}
template <class P, class S, class F>
  requires is_packed<P, estimator::RotatedMeeting>
void fields(P& a, S& b, F f) {
  f(a.density, b.density, "rotated density");
  f(a.jacobian.x, b.jacobian.x, "place x");
  f(a.jacobian.y, b.jacobian.y, "place y");
  f(a.jacobian.cross_x, b.jacobian.cross_x, "cross x");
  f(a.jacobian.cross_y, b.jacobian.cross_y, "cross y");
}
/// Of four that all go through the surface, or none.
template <class P, class S, class F>
  requires is_packed<P, estimator::Spread>
void fields(P& a, S& b, F f) {
  f(a.before, b.before, "before");
  f(a.cos_air, b.cos_air, "cosine in air");
  f(a.solid_angle, b.solid_angle, "solid angle");
}
/// What rays and vertices have in common.
template <class P, class S, class F>
void walk_point_fields(P& a, S& b, F f) {
  fields(a.position, b.position, f);
  fields(a.direction, b.direction, f);
  f(a.weight, b.weight, "weight");
  f(a.path, b.path, "path");
  f(a.line, b.line, "line");
  f(a.layer, b.layer, "layer");
}
template <class P, class S, class F>
  requires is_packed<P, estimator::Ray>
void fields(P& a, S& b, F f) {
  walk_point_fields(a, b, f);
  f(a.vertex_chance, b.vertex_chance, "vertex chance");
  f(a.chance, b.chance, "chance");
  f(a.reverse_chance, b.reverse_chance, "reverse chance");
  f(a.per_p, b.per_p, "per p");
  f(a.last_edge, b.last_edge, "last edge");
  fields(a.behind, b.behind, f);
  f(a.translated, b.translated, "translated");
  fields(a.rotated, b.rotated, f);
}
template <class P, class S, class F>
  requires is_packed<P, estimator::Vertex>
void fields(P& a, S& b, F f) {
  walk_point_fields(a, b, f);
  f(a.chance, b.chance, "chance");
  f(a.reverse_chance, b.reverse_chance, "reverse chance");
  f(a.arriving_edge, b.arriving_edge, "arriving edge");
  f(a.translated, b.translated, "translated");
  f(a.rotated, b.rotated, "rotated");
  fields(a.added_rotated, b.added_rotated, f);
  fields(a.added, b.added, f);
  fields(a.behind, b.behind, f);
}
template <class P, class S, class F>
  requires is_packed<P, estimator::Leg>
void fields(P& a, S& b, F f) {
  f(a.length, b.length, "length");
  f(a.walk_tau, b.walk_tau, "walked optical depth");
  f(a.reflected, b.reflected, "reflected");
}
template <class P, class S, class F>
  requires is_packed<P, estimator::Departure>
void fields(P& a, S& b, F f) {
  f(a.p, b.p, "p");
  f(a.chance, b.chance, "chance");
  f(a.reverse_chance, b.reverse_chance, "reverse chance");
  f(a.c_ratio, b.c_ratio, "c ratio");
}
template <class P, class S, class F>
  requires is_packed<P, estimator::EndDensities>
void fields(P& a, S& b, F f) {
  f(a.p, b.p, "p");
  f(a.arriving_edge, b.arriving_edge, "arriving edge");
  f(a.behind, b.behind, "behind");
}
template <class P, class S, class F>
  requires is_packed<P, estimator::ConnectionEnd>
void fields(P& a, S& b, F f) {
  fields(a.densities, b.densities, f);
  f(a.contribution, b.contribution, "contribution");
  f(a.weight, b.weight, "weight");
  f(a.chance, b.chance, "chance");
  f(a.goes_on, b.goes_on, "goes on");
  f(a.meeting, b.meeting, "meeting");
}
template <class P, class S, class F>
  requires is_packed<P, estimator::InverseConversion>
void fields(P& a, S& b, F f) {
  f(a.probability, b.probability, "probability");
  f(a.directed, b.directed, "directed");
  fields(a.beam, b.beam, f);
  f(a.lobe, b.lobe, "lobe");
  f(a.scattered, b.scattered, "scattered");
}
template <class P, class S, class F>
  requires is_packed<P, estimator::MeetingGrid>
void fields(P& a, S& b, F f) {
  f(a.most, b.most, "most points");
}
template <class P, class S, class F>
  requires is_packed<P, estimator::Samples>
void fields(P& a, S& b, F f) {
  f(a.to_instrument, b.to_instrument, "to instrument");
  f(a.between, b.between, "between");
  f(a.pairs, b.pairs, "pairs");
  f(a.rotated, b.rotated, "rotated");
  fields(a.grid, b.grid, f);
}
template <class P, class S, class F>
  requires is_packed<P, estimator::DepthLine>
void fields(P& a, S& b, F f) {
  f(a.x, b.x, "x");
  f(a.y, b.y, "y");
  f(a.x_per_depth, b.x_per_depth, "x per depth");
  f(a.y_per_depth, b.y_per_depth, "y per depth");
  f(a.path, b.path, "path");
  f(a.path_per_depth, b.path_per_depth, "path per depth");
  f(a.from, b.from, "from");
  f(a.to, b.to, "to");
  f(a.rise, b.rise, "rise");
  f(a.start, b.start, "start");
}
template <class P, class S, class F>
  requires is_packed<P, estimator::Chord>
void fields(P& a, S& b, F f) {
  f(a.exists, b.exists, "exists");
  f(a.from, b.from, "from");
  f(a.to, b.to, "to");
  fields(a.lens.at_surface, b.lens.at_surface, f);
  fields(a.lens.per_depth, b.lens.per_depth, f);
}
template <class P, class S, class F>
  requires is_packed<P, estimator::AtLens>
void fields(P& a, S& b, F f) {
  fields(a.lens, b.lens, f);
  fields(a.outward, b.outward, f);
  f(a.index, b.index, "index");
}
template <class P, class S, class F>
  requires is_packed<P, estimator::Rotation>
void fields(P& a, S& b, F f) {
  fields(a.axis, b.axis, f);
  f(a.cosine, b.cosine, "cosine");
  f(a.sine, b.sine, "sine");
}
template <class P, class S, class F>
  requires is_packed<P, estimator::Arrival>
void fields(P& a, S& b, F f) {
  fields(a.ray, b.ray, f);
  fields(a.leg, b.leg, f);
  f(a.first, b.first, "first");
  f(a.far, b.far, "far");
  f(a.reach, b.reach, "reach");
}
template <class P, class S, class F>
  requires is_packed<P, estimator::EntryRay>
void fields(P& a, S& b, F f) {
  fields(a.direction, b.direction, f);
  fields(a.outside, b.outside, f);
  fields(a.off_axis, b.off_axis, f);
  f(a.solid_angle, b.solid_angle, "solid angle");
  f(a.exists, b.exists, "exists");
}

template <template <class> class S>
S<Lanes4> pack_fields(const Four<S<double>>& values) {
  S<Lanes4> out{};
  for (std::size_t i = 0; i < lanes; ++i)
    fields(out, values[i], [i](auto& lane, const auto& one, const char*) { lane.set(i, one); });
  return out;
}
/// The same in all lanes.
template <template <class> class S>
S<Lanes4> in_all_lanes(const S<double>& one) {
  return pack_fields<S>({one, one, one, one});
}
template <template <class> class S>
void expect_same_fields(const S<Lanes4>& packed, std::size_t i, const S<double>& scalar) {
  fields(packed, scalar, [i](const auto& lane, const auto& one, const char* what) {
    expect_same(lane[i], one, what);
  });
}

}  // namespace photic::transport
