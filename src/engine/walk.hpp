// The walks of the bidirectional estimator, kept until they are connected.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "engine/world.hpp"
#include "transport/receive.hpp"
#include "transport/shift.hpp"

namespace photic::engine {

/// The vertices of one walk, and of a telescope's the rays in between.
template <class T>
struct Walk {
  transport::Beginning<T> begin;
  std::array<transport::Vertex<T>, most_vertices> vertex;
  int size = 0;

  instrument::PlanePoint<T> lens;                    ///< where a telescope's walk came through
  Vec3<T> outward;                                   ///< the direction in which it left there
  T shift_area{};                                    ///< of a telescope's walk [m^2]
  std::array<transport::Ray<T>, most_vertices> ray;  ///< ray m leaves vertex m, from 1; ray 0 the
                                                     ///< instrument
  int rays = 0;

  [[nodiscard]] const transport::Vertex<T>& last() const {
    return vertex[static_cast<std::size_t>(size - 1)];
  }
  void clear() { size = rays = 0; }
  void add(const transport::Vertex<T>& v) { vertex[static_cast<std::size_t>(size++)] = v; }
  void add(const transport::Ray<T>& r) { ray[static_cast<std::size_t>(rays++)] = r; }

  // In a path of `order` vertices, of which walks take `most` at most, not all strategies can be
  // used: vertex number `i` (from 0) and ray `m` with the densities of those that can.
  [[nodiscard]] transport::Vertex<T> vertex_in_path(int i, int order, int most) const {
    transport::Vertex<T> v = vertex[static_cast<std::size_t>(i)];
    if (order <= most) return v;
    if (order - i > most) v.open = T(0);
    v.closed = v.shifts = T(0);
    for (int k = std::max(1, order + 1 - most); k <= i; ++k) {
      v.closed += vertex[static_cast<std::size_t>(k)].before;
      v.shifts += vertex[static_cast<std::size_t>(k)].before_shifts;
    }
    return v;
  }
  [[nodiscard]] T closed_behind_ray(int m, int order, int most) const {
    const transport::Ray<T>& r = ray[static_cast<std::size_t>(m)];
    if (order <= most) return r.closed;
    T closed = order - m + 1 > most ? T(0) : r.before;
    for (int k = std::max(1, order + 1 - most); k < m; ++k)
      closed += vertex[static_cast<std::size_t>(k)].before;
    return closed;
  }
};

/// The walks of one set: all of the laser's, and one of a telescope's at a time.
template <class T>
struct WalkSet {
  explicit WalkSet(std::size_t walks) : from_laser(walks) {}
  std::vector<Walk<T>> from_laser;
  Walk<T> from_telescope;
};

}  // namespace photic::engine
