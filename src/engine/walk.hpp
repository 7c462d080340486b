// The walks of the bidirectional estimator, kept until they are connected.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "engine/world.hpp"
#include "transport/receive.hpp"
#include "transport/vertex.hpp"

namespace photic::engine {

/// Which strategies can be used for a path of `order` vertices by walks of at most `most`.
struct Usable {
  std::int32_t order, most;
  [[nodiscard]] bool all() const { return order <= most; }
  [[nodiscard]] bool connecting(std::int32_t edge) const {
    return edge <= most && order - edge <= most;
  }
  /// A walk that has all the vertices it may have does not set out from the last one.
  [[nodiscard]] bool meeting(std::int32_t vertex) const {
    return vertex <= most && order - vertex < most;
  }
};

/// The rays and vertices of one walk: ray m leads to vertex m, and ray 0 from the instrument.
template <class T>
struct Walk {
  transport::Beginning<T> begin;
  std::array<transport::Ray<T>, most_vertices> ray;
  std::array<transport::Vertex<T>, most_vertices> vertex;
  std::int32_t rays = 0, vertices = 0;
  bool from_telescope = false;
  instrument::PlanePoint<T> lens;  ///< where a telescope's walk came through
  Vec3<T> outward;                 ///< the direction in which it left there
  T shift_area{};                  ///< of a telescope's walk [m^2]

  void clear() { rays = vertices = 0; }
  void add(const transport::Ray<T>& r) { ray[static_cast<std::size_t>(rays++)] = r; }
  void add(const transport::Vertex<T>& v) { vertex[static_cast<std::size_t>(vertices++)] = v; }
  [[nodiscard]] const transport::Ray<T>& last_ray() const {
    return ray[static_cast<std::size_t>(rays - 1)];
  }
  [[nodiscard]] const transport::Vertex<T>& last_vertex() const {
    return vertex[static_cast<std::size_t>(vertices - 1)];
  }
  /// How the light of ray m spreads if it is the instrument's.
  [[nodiscard]] const transport::Spread<T>* spread(std::int32_t m) const {
    return m == 0 ? &begin.spread : nullptr;
  }

  /// Vertex i and the densities behind ray m in a path of which not all strategies can be used.
  [[nodiscard]] transport::Vertex<T> in_path(std::int32_t i, const Usable& usable) const {
    transport::Vertex<T> v = vertex[static_cast<std::size_t>(i)];
    if (usable.all()) return v;
    v.behind = {};
    for (std::int32_t k = 1; k <= i; ++k)
      add_last(vertex[static_cast<std::size_t>(k)], k, usable, v.behind);
    if (!usable.connecting(from_telescope ? usable.order - i : i)) v.open = T(0);
    return v;
  }
  /// Ray m, without meetings at the vertex it leaves where those cannot be used.
  [[nodiscard]] transport::Ray<T> ray_in_path(std::int32_t m, const Usable& usable) const {
    transport::Ray<T> r = ray[static_cast<std::size_t>(m)];
    if (!usable.meeting(passed(m, usable))) r.meeting = T(0);
    return r;
  }
  [[nodiscard]] transport::Densities<T> behind(std::int32_t m, const Usable& usable) const {
    const transport::Ray<T>& r = ray[static_cast<std::size_t>(m)];
    if (usable.all() || m == 0) return r.behind;
    transport::Densities<T> sum = in_path(m - 1, usable).behind;
    if (usable.connecting(passed(m, usable) - (from_telescope ? 0 : 1))) sum.edges += r.last.edges;
    return sum;
  }

 private:
  /// The path's number of the vertex that ray m leaves.
  [[nodiscard]] std::int32_t passed(std::int32_t m, const Usable& usable) const {
    return from_telescope ? usable.order + 1 - m : m;
  }
  void add_last(const transport::Vertex<T>& v, std::int32_t m, const Usable& usable,
                transport::Densities<T>& sum) const {
    const std::int32_t x = passed(m, usable);
    if (usable.connecting(x - (from_telescope ? 0 : 1))) sum.edges += v.last.edges;
    if (usable.meeting(x)) sum.meetings += v.last.meetings;
  }
};

/// The walks of one set: all of the laser's, and one of a telescope's at a time.
template <class T>
struct WalkSet {
  explicit WalkSet(std::size_t walks) : from_laser(walks) { from_telescope.from_telescope = true; }
  std::vector<Walk<T>> from_laser;
  Walk<T> from_telescope;
};

}  // namespace photic::engine
