// Hand-made batches of scores.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "support/random.hpp"
#include "tally/totals.hpp"
#include "unit/tally/lines.hpp"

namespace photic::tally {

/// The k-th of so many scores that exceed x with a chance as x^-index, from 1 up: their quantiles.
inline double falling_off(int k, int scores, double index) {
  return std::pow(scores / (k + 0.5), 1 / index);
}

/// Two telescopes; channel 0 counts line 0, channel 1 line 1, channel 2 lines 1 and 2; four gates
/// of 5 m; orders 0, 1, 2 and above.
struct Tallies {
  explicit Tallies(std::int32_t max_order = 0, std::size_t environments = 0,
                   std::size_t techniques = 1)
      : Tallies(make_shape(max_order, environments, techniques)) {}
  explicit Tallies(Shape of)
      : shape(std::move(of)), gates(scene(), lines()), batch(shape, gates), totals(shape) {}
  Tallies(const Tallies&) = delete;  // batch and totals point to the shape
  Tallies& operator=(const Tallies&) = delete;

  static scene::Scene scene() {
    auto scene = test::ship_scene();
    scene.gates.depth_m = {0, 20, 5};
    return scene;
  }

  static Shape make_shape(std::int32_t max_order, std::size_t environments,
                          std::size_t techniques) {
    Shape shape;
    shape.techniques = techniques;
    shape.environments = environments;
    shape.telescopes = 2;
    shape.channels = 3;
    shape.grids = echo_grids(4, {"elastic", "raman", "chlorophyll"}, {0, 5, 10, 15, 20});
    shape.gates = 4;
    shape.channels_of_line = {{Counting{0}}, {Counting{1}, Counting{2}}, {Counting{2}}};
    shape.process_of_light = {0, 1, 2};
    shape.max_order = max_order;
    return shape;
  }

  /// A path in the middle of a gate.
  [[nodiscard]] double path_in(std::int32_t gate) const {
    return (gates.edge_path(gate) + gates.edge_path(gate + 1)) / 2;
  }

  /// Light 0, of order 1 in a gate of telescope 0.
  void score(std::int32_t gate, double value, std::int32_t order = 1, std::int32_t light = 0,
             std::size_t telescope = 0) {
    batch.score({telescope, light, order, 5.0 * gate + 2.5, path_in(gate), value});
  }
  /// The same, of a path that is made of such walks.
  void score(std::int32_t gate, double value, Technique technique) {
    batch.score({0, 0, 1, 5.0 * gate + 2.5, path_in(gate), value, technique});
  }

  /// What the batch scored on a grid, [cell][cell of the grid].
  [[nodiscard]] std::vector<double> sums(const std::string& name) const {
    if (name == "echo_by_depth") return {batch.profile.sums.begin(), batch.profile.sums.end()};
    const GridPlaces& grid = batch.grids[name == "echo_by_order" ? 0 : 1];
    std::vector<double> out;
    for (std::size_t cell = 0; cell < shape.cells(); ++cell)
      for (std::size_t k = 0; k < grid.size; ++k)
        out.push_back(batch.parts[cell * batch.parts_size + grid.offset + k]);
    return out;
  }
  void end_batch(std::uint64_t photons) {
    batch.photons = photons;
    totals.merge(batch);
    batch.clear();
  }

  [[nodiscard]] Result result() const {
    Result out;
    totals.fill(out);
    return out;
  }

  Shape shape;
  Gates gates;
  BatchTally batch;
  Totals totals;
};

}  // namespace photic::tally
