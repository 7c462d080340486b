// The absorption along flights in the layers on one side of the surface, or in those of a column
// of a row, for the source's light:
// what free paths are not drawn from (geometry/free_paths.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "estimator/tallies/flight.hpp"
#include "geometry/free_paths.hpp"

namespace photic::estimator {

/// The decay over an optical depth, exp(-depth), and its mean on the way there, (1 - exp(-depth)) /
/// depth. Most pieces of flights are short: their series are exact to 1e-9.
struct Decay {
  double there = 1, mean = 1;
};
inline Decay decay_over(double depth) {
  constexpr double short_depth = 0.02;
  if (std::abs(depth) > short_depth) {
    const double there = std::exp(-depth);
    return {there, (1 - there) / depth};
  }
  const double mean = 1 - depth / 2 * (1 - depth / 3 * (1 - depth / 4));
  return {1 - depth * mean, mean};
}

class ContinuousAbsorption {
 public:
  /// None: a vacuum.
  ContinuousAbsorption() : edges_{0, infinite}, per_m_{0}, integral_{0} {}
  explicit ContinuousAbsorption(const geometry::Slabs& slabs, std::int32_t column = 0) {
    const Index<double> line = 0;
    const auto first = gather_index<double>(slabs.row.first_layer, column);
    first_layer_ = static_cast<std::size_t>(first);
    for (auto k = first; k < gather_index<double>(slabs.row.first_layer, column + 1); ++k) {
      const auto [here, above] = gather_pair<double>(slabs.continuous_c, slabs.at(line, k));
      edges_.push_back(gather<double>(slabs.top, k));
      per_m_.push_back(here);
      integral_.push_back(above);
    }
    edges_.push_back(gather<double>(slabs.top, slabs.layers));
  }

  [[nodiscard]] std::size_t layers() const { return per_m_.size(); }
  /// Of the medium's, that of the first one here.
  [[nodiscard]] std::size_t first_layer() const { return first_layer_; }
  [[nodiscard]] double per_m(std::size_t layer) const { return per_m_[layer]; }
  [[nodiscard]] double begin_of(std::size_t layer) const { return edges_[layer]; }
  [[nodiscard]] double end_of(std::size_t layer) const { return edges_[layer + 1]; }
  /// The layer of a distance; on an edge the farther one, at the end the last.
  [[nodiscard]] std::size_t layer_of(double distance) const {
    const auto beyond = std::upper_bound(edges_.begin() + 1, edges_.end() - 1, distance);
    return static_cast<std::size_t>(beyond - edges_.begin()) - 1;
  }

  /// The same of a flight from there on, away from the surface or towards it.
  [[nodiscard]] std::ptrdiff_t layer_ahead(double distance, bool away) const {
    const std::size_t layer = layer_of(distance);
    const bool leaves = !away && layer > 0 && distance <= edges_[layer];
    return static_cast<std::ptrdiff_t>(layer) - (leaves ? 1 : 0);
  }
  /// The edge of a layer that such a flight comes to.
  [[nodiscard]] double edge_ahead(std::ptrdiff_t layer, bool away) const {
    return edges_[static_cast<std::size_t>(away ? layer + 1 : layer)];
  }

  /// The weight of a flight at a distance within it. It grows where free paths are drawn more often
  /// than light collides.
  [[nodiscard]] double weight_at(const Flight& flight, double distance) const {
    if (flight.to == flight.from) return flight.weight;
    const double farther =
        integral_to(distance, flight.layer) - integral_to(flight.from, flight.layer);
    return flight.weight * decay_over(farther * flight.length / (flight.to - flight.from)).there;
  }
  /// The same at its end.
  [[nodiscard]] double weight_at_end(const Flight& flight) const {
    if (flight.to != flight.from) return weight_at(flight, flight.to);
    return flight.weight * decay_over(per_m_[flight.layer] * flight.length).there;
  }
  /// The length of a piece of a flight within a layer times its mean weight, which it has at its
  /// start.
  [[nodiscard]] double track(std::size_t layer, double weight, double length) const {
    return weight * length * decay_over(per_m_[layer] * length).mean;
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  /// `likely`: a layer to look in first.
  [[nodiscard]] double integral_to(double distance, std::size_t likely) const {
    const bool there = distance >= edges_[likely] && distance < edges_[likely + 1];
    const std::size_t layer = there ? likely : layer_of(distance);
    return integral_[layer] + per_m_[layer] * (distance - edges_[layer]);
  }

  std::size_t first_layer_ = 0;
  std::vector<double> edges_, per_m_, integral_;
};

/// Calls f(layer, piece's length, length to its start) for the pieces of a flight in each layer, in
/// order.
template <class F>
void each_layer(const ContinuousAbsorption& absorption, const Flight& flight, F f) {
  std::size_t layer = std::min(flight.layer, absorption.layers() - 1);
  double begun = 0;
  for (;;) {
    const double edge = flight.leads_away() ? absorption.end_of(layer) : absorption.begin_of(layer);
    const bool ends =
        flight.to == flight.from || (flight.leads_away() ? flight.to <= edge : flight.to >= edge);
    const double end = ends ? flight.length : flight.length_to(edge);
    f(layer, end - begun, begun);
    const bool last = flight.leads_away() ? layer + 1 == absorption.layers() : layer == 0;
    if (ends || last) return;
    begun = end;
    layer = flight.leads_away() ? layer + 1 : layer - 1;
  }
}

}  // namespace photic::estimator
