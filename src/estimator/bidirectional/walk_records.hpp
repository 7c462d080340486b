// Records of a walk as a whole: its birth, and the axis about which it may be rotated.
#pragma once

#include "estimator/bidirectional/birth.hpp"
#include "estimator/bidirectional/vertex.hpp"
#include "instrument/lens.hpp"
#include "medium/medium.hpp"
#include "surface/lambert.hpp"

namespace photic::estimator {

/// The birth of a walk at its instrument; the lens, outwards and the rest for a telescope's walk.
template <class T>
struct BirthRecord {
  Spread<T> spread;
  instrument::PlanePoint<T> lens{};
  Vec3<T> outward{};
  T translation_area{};   ///< [m^2]
  T grid_offset{};        ///< of the depths of its meetings, 0 to 1 of a step
  Index<T> connected{1};  ///< with the vertices of a laser's walk: 1 or 0
  Mask<T> own{true};      ///< its ray is one of its instrument's own: not all rays of cones are
  Index<T> telescope{};   ///< the narrowest of nested views that sees its ray
  Index<T> line{};        ///< of the light that comes back
  Index<T> facets{};      ///< under waves, that sent it down where its instrument is in the water:
                          ///< none, one, or 2 for several
  template <class F>
  constexpr void each_member(F f) {
    spread.each_member(f);
    f(lens.x), f(lens.y), f(outward.x), f(outward.y), f(outward.z);
    f(translation_area), f(grid_offset);
  }
};

/// The vertex about which a telescope's walk may be rotated, and how the walk came and left.
template <class T>
struct Pivot {
  T x{}, y{};  ///< [m]
  Vec3<T> arriving{}, leaving{};
  T per_p{};         ///< 1 over the phase function's value [sr]
  Index<T> phase{};  ///< its table; -1 on the bed
  template <class F>
  constexpr void each_member(F f) {
    f(x), f(y), f(arriving.x), f(arriving.y), f(arriving.z);
    f(leaving.x), f(leaving.y), f(leaving.z), f(per_p), f(phase);
  }
};

/// `ray`: leaves the vertex, where light is converted if it comes in another line than the laser's.
template <class T>
Pivot<T> pivot_at(const medium::MediumView& sea, const Vertex<T>& vertex, const Ray<T>& ray) {
  const Index<T> elastic = gather_index<T>(sea.elastic_phase, sea.at(vertex.line, vertex.layer));
  return {vertex.position.x,
          vertex.position.y,
          vertex.direction,
          ray.direction,
          ray.per_p,
          select(vertex.line > Index<T>(0), gather_index<T>(sea.conversion_phase, vertex.line),
                 select(surface::on_bed<T>(sea, vertex.layer), Index<T>(-1), elastic))};
}

}  // namespace photic::estimator
