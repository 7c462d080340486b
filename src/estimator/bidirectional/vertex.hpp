// A walk's notes on a vertex where it collides, and on the ray in which it goes on.
#pragma once

#include "core/constants.hpp"
#include "core/elementary.hpp"
#include "estimator/bidirectional/beam_spread.hpp"
#include "estimator/bidirectional/path_point.hpp"
#include "estimator/entry_cone.hpp"
#include "estimator/meeting_grid.hpp"
#include "medium/medium.hpp"
#include "surface/lambert.hpp"

namespace photic::estimator {

/// A density of meeting by translation times the cosine of one more direction. 0 where light goes
/// on up or down: walks are translated only to where it reverses. `density` has the sign of the
/// other direction's z.
template <class T>
T if_reversed(const T& density, const T& z) {
  const T product = T(0) - density * z;
  return select(product > T(0), product, T(0));
}

/// Such a density where light is converted: it goes to all sides, and walks meet there whichever
/// way it goes on. Has the sign of light that reverses. `z`: of the other direction.
template <class T>
T met_either_way(const T& density, const T& z) {
  using std::abs;
  const T size = abs(density);
  return select(z < T(0), size, T(0) - size);
}

/// Density of rotating walks to meet at a vertex that is left in a direction, but for the phase
/// function there and for what the edge beyond adds.
template <class T>
RotatedMeeting<T> rotation_at(const Vertex<T>& v, const Vec3<T>& direction) {
  return {v.rotated, rotation_jacobian(v.position, v.direction, direction)};
}

/// The departure of a walk from a vertex.
template <class T>
struct Departure {
  T p{1};               ///< density of the direction, the phase function's value [1/sr]
  T chance{1};          ///< h of its choices: of what the phase function does not draw
  T reverse_chance{1};  ///< the same of a telescope's walk through this vertex of a laser's walk
  T c_ratio{
      1};  ///< c' (that free paths are drawn from) of the line in which a laser's walk arrives
           ///< here, over that of this walk; 0: no laser's walk draws the path as far as here
};

/// Density of connecting the edge that came to a vertex, times the density p of the direction in
/// which it is left. On the bed the edge has a density of its own there: walks draw directions by
/// their cosine, on the one side or the other.
template <class T>
T arriving_edge(const geometry::Slabs& sea, const Vertex<T>& v, const T& p) {
  using std::abs;
  if (sea.bed_angles == 0) return v.arriving_edge;
  const T of_edge = T(pi) / abs(v.direction.z);
  return v.arriving_edge * select(surface::on_bed<T>(sea, v.layer), p * of_edge, T(1));
}

/// The ray in which the photon has departed from a vertex. `far`: that lies beyond the walk's
/// second; nearer edges are kept in FirstVertex.
template <class T>
Ray<T> next_ray(const geometry::Slabs& sea, const transport::Photon<T>& photon,
                const Vertex<T>& from, const Departure<T>& departure, const Mask<T>& far) {
  Ray<T> ray{walk_point(photon)};
  ray.vertex_chance = from.chance;
  ray.chance = from.chance * departure.chance;
  ray.reverse_chance = from.reverse_chance * departure.reverse_chance;
  ray.per_p = T(1) / departure.p;
  ray.last_edge =
      departure.c_ratio * arriving_edge(sea, from, departure.p) * ray.per_p / ray.reverse_chance;
  ray.behind = from.behind;
  ray.behind.edges = from.behind.edges + select(far, ray.last_edge, T(0));
  const Mask<T> known = departure.c_ratio > T(0);
  ray.translated = select(known, from.translated * ray.per_p, T(0));
  const Mask<T> converts = from.line > photon.line;
  if (any(converts))
    ray.translated =
        select(converts, met_either_way(ray.translated, photon.direction.z), ray.translated);
  ray.rotated = rotation_at(from, photon.direction);
  ray.rotated.density = select(known, ray.rotated.density * ray.per_p, T(0));
  return ray;
}

/// Density of connecting the edge along a ray to a point `length` away, times the phase function
/// there and exp(-tau) by the coefficient that free paths are drawn from. `first`: the ray leaves
/// the instrument, and its light has spread so.
template <class T>
T connecting_area(const geometry::Slabs& sea, const Ray<T>& ray, const Mask<T>& first,
                  const Spread<T>& spread, const T& length, const estimator::Samples<T>& samples) {
  using std::abs;
  const T area = samples.between * ray.vertex_chance * ray.per_p * (length * length);
  if (!any(first)) return area;
  const T from_instrument =
      samples.to_instrument * spread.solid_angle *
      area_per_solid_angle(sea, spread, ray.line, length, T(abs(ray.direction.z)));
  return select(first, from_instrument, area);
}

/// Facets of waves that have sent back a walk that came up to them on its leg.
template <class T>
struct SentBack {
  T chance{1}, reverse_chance{1};  ///< that walks choose them, as of a Vertex
  T walk_tau{};                    ///< of the leg up to there
};

/// The arrival of a walk at a vertex where it collides.
template <class T>
struct Arrival {
  Ray<T> ray;                           ///< by this one
  Leg<T> leg;                           ///< along it
  Mask<T> first{};                      ///< which leaves the instrument
  Mask<T> far{};                        ///< the vertex lies beyond the walk's second
  T reach{};                            ///< chance to come here by the leg, as the walk drew it
  const SentBack<T>* facets = nullptr;  ///< under waves
  Mask<T> rotates{true};                ///< of a telescope's walk, Walks::rotates()
};

/// That chance. `cone`: of the walk's instrument.
template <class T>
T reach_of(const geometry::Slabs& sea, const EntryCone<T>& cone, const Mask<T>& first,
           const transport::Photon<T>& photon, const Leg<T>& leg) {
  return cone.reach(first, leg.walk_tau, photon.direction.z,
                    sea.bed_angles > 0 ? surface::on_bed<T>(sea, photon.layer) : Mask<T>(false));
}

/// Takes a walk to a vertex by facets. Nothing is connected by them: every strategy draws its
/// meeting with them. So one whose walks meet at an end of the leg leaves out only the part on this
/// side of them.
template <class T>
void pass_facets(const Arrival<T>& by, Vertex<T>& v) {
  v.rotated = select(by.rotates, v.rotated, T(0));
  const Mask<T>& reflected = by.leg.reflected;
  if (!any(reflected)) return;
  const T reach_up = exp_minus(by.facets->walk_tau);
  v.chance = v.chance * select(reflected, by.facets->chance, T(1));
  v.reverse_chance = v.reverse_chance * select(reflected, by.facets->reverse_chance, T(1));
  const T here = select(reflected, by.facets->chance * reach_up, T(1));
  const T before = select(reflected, by.reach / reach_up, T(1));
  v.translated = v.translated * here;
  v.rotated = v.rotated * here;
  v.added.translated = v.added.translated * before;
  v.added.rotated = v.added.rotated * before;
  v.added_rotated.density = v.added_rotated.density * before;
}

/// The ray behind facets that send back one that goes up.
template <class T>
Ray<T> behind_facets(const Ray<T>& ray, const transport::Photon<T>& photon,
                     const SentBack<T>& facets) {
  Ray<T> behind = ray;
  static_cast<WalkPoint<T>&>(behind) = walk_point(photon);
  behind.chance = ray.chance * facets.chance;
  behind.reverse_chance = ray.reverse_chance * facets.reverse_chance;
  // The density of meeting where the ray up begins: without the cosine there, not that of the ray
  // behind.
  const T grows = facets.reverse_chance * exp_minus(T(0) - facets.walk_tau);
  behind.translated =
      if_reversed(ray.translated, ray.direction.z) * grows / (T(0) - photon.direction.z);
  behind.rotated.density = ray.rotated.density * grows;
  return behind;
}

/// The vertex where a photon collides. `axis`: that of the walk.
template <class T>
Vertex<T> vertex_on(const geometry::Slabs& sea, const Arrival<T>& by, const Spread<T>& spread,
                    const transport::Photon<T>& photon, const RotationAxis<T>& axis,
                    const estimator::Samples<T>& samples) {
  const auto& [ray, leg, first, far, reach, facets, rotates] = by;
  Vertex<T> v{walk_point(photon)};
  v.chance = ray.chance;
  v.reverse_chance = ray.reverse_chance;
  const T growth = T(1) / reach;
  const T straight = select(leg.reflected, T(0), growth);
  // A reflected first edge can be connected: to the instrument's mirror image.
  v.arriving_edge = connecting_area(sea, ray, first, spread, leg.length, samples) *
                    select(first, growth, straight);
  T drawn = ray.chance * growth * gather<T>(sea.walk_mean_path, sea.at(photon.line, photon.layer));
  v.translated = drawn * photon.direction.z;
  if (sea.bed_angles > 0) {
    const Mask<T> bed = surface::on_bed<T>(sea, photon.layer);
    // Translated rays come to one point of it, whatever their angles; rotated ones do not.
    v.translated = select(bed, T(-samples.grid.below_bed()) * drawn, v.translated);
    drawn = select(bed, T(0), drawn);
  }
  v.rotated = samples.rotated * T(2 * pi) * drawn;
  v.added_rotated = ray.rotated;
  const T growth_per_reverse = growth / ray.reverse_chance;
  v.added_rotated.density = ray.rotated.density * growth_per_reverse;
  v.added.edges = ray.last_edge;
  v.added.translated = if_reversed(ray.translated, growth_per_reverse * ray.leaving_z());
  v.added.rotated = v.added_rotated.about(axis);
  if (facets != nullptr) pass_facets(by, v);
  v.behind.edges = ray.behind.edges;
  v.behind.translated = ray.behind.translated + select(far, v.added.translated, T(0));
  v.behind.rotated = ray.behind.rotated + v.added.rotated;
  return v;
}

}  // namespace photic::estimator
