// The walks of the bidirectional estimator, kept until they are connected.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "engine/world.hpp"
#include "transport/meet.hpp"
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
  std::array<std::int32_t, most_vertices> turned;  ///< vertices with a last turn, of a laser's walk
  std::int32_t turns = 0;
  bool from_telescope = false;
  instrument::PlanePoint<T> lens;  ///< where a telescope's walk came through
  Vec3<T> outward;                 ///< the direction in which it left there
  T shift_area{};                  ///< of a telescope's walk [m^2]
  transport::Vertical<T> axis;     ///< of a telescope's walk, where it has converted
  std::int32_t converted = 0;      ///< the vertex where it has

  void clear() {
    rays = vertices = turns = 0;
    axis = {};
  }
  void add(const transport::Ray<T>& r) { ray[static_cast<std::size_t>(rays++)] = r; }
  void add(const transport::Vertex<T>& v) {
    if (!from_telescope && v.last_turn.density > T(0))
      turned[static_cast<std::size_t>(turns++)] = vertices;
    vertex[static_cast<std::size_t>(vertices++)] = v;
  }
  /// A telescope's walk turns a conversion back at its last vertex.
  void converts() {
    converted = vertices - 1;
    axis = {true, last_vertex().position.x, last_vertex().position.y};
  }
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

  /// Vertex i as it is in a path of which perhaps not all strategies can be used; kept in `room` if
  /// they cannot.
  [[nodiscard]] const transport::Vertex<T>& in_path(std::int32_t i, const Usable& usable,
                                                    transport::Vertex<T>& room) const {
    const transport::Vertex<T>& v = vertex[static_cast<std::size_t>(i)];
    if (usable.all()) return v;
    room = v;
    room.behind = {};
    for (std::int32_t k = 1; k <= i; ++k)
      add_last(vertex[static_cast<std::size_t>(k)], k, usable, room.behind);
    if (!usable.connecting(from_telescope ? usable.order - i : i)) room.open = T(0);
    return room;
  }
  /// The densities of turning a telescope's walk about an axis so that it meets this walk of the
  /// laser at a vertex before vertex i.
  [[nodiscard]] T turned_before(std::int32_t i, const Usable& usable,
                                const transport::Vertical<T>& other) const {
    T sum(0);
    if (!other.exists) return sum;
    for (std::int32_t n = 0; n < turns && turned[static_cast<std::size_t>(n)] <= i; ++n) {
      const std::int32_t k = turned[static_cast<std::size_t>(n)];
      if (usable.meeting(k)) sum += vertex[static_cast<std::size_t>(k)].last_turn.about(other);
    }
    return sum;
  }
  /// Ray m as one side of a meeting. `freedom`: of the telescope's walk, as this walk sees it.
  [[nodiscard]] transport::Side<T> side(std::int32_t m, const Usable& usable,
                                        const transport::Freedom<T>& freedom) const {
    const transport::Ray<T>& r = ray[static_cast<std::size_t>(m)];
    transport::Side<T> side{r, spread(m)};
    side.behind = behind(m, usable).all(freedom.shift_area);
    if (!from_telescope) side.behind += turned_before(m - 1, usable, freedom.axis);
    if (usable.meeting(passed(m, usable)))
      side.last = freedom.shift_area * transport::turning(r.meeting, r.direction.z) +
                  r.turn.about(freedom.axis);
    return side;
  }

 private:
  [[nodiscard]] transport::Densities<T> behind(std::int32_t m, const Usable& usable) const {
    const transport::Ray<T>& r = ray[static_cast<std::size_t>(m)];
    if (usable.all() || m == 0) return r.behind;
    transport::Vertex<T> room;
    transport::Densities<T> sum = in_path(m - 1, usable, room).behind;
    if (usable.connecting(passed(m, usable) - (from_telescope ? 0 : 1))) sum.edges += r.last.edges;
    return sum;
  }
  /// The path's number of the vertex that ray m leaves.
  [[nodiscard]] std::int32_t passed(std::int32_t m, const Usable& usable) const {
    return from_telescope ? usable.order + 1 - m : m;
  }
  void add_last(const transport::Vertex<T>& v, std::int32_t m, const Usable& usable,
                transport::Densities<T>& sum) const {
    const std::int32_t x = passed(m, usable);
    if (usable.connecting(x - (from_telescope ? 0 : 1))) sum.edges += v.last.edges;
    if (!usable.meeting(x)) return;
    sum.meetings += v.last.meetings;
    sum.turned += v.last.turned;
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
