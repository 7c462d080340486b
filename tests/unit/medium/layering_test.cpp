// The layer of a coordinate.
#include "medium/layering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "support/random.hpp"

namespace photic::medium {
namespace {

using test::Random;

/// Two rows of edges of so many layers, from `thinnest` to 1 thick.
std::vector<double> two_rows(Random& random, std::int32_t layers, double thinnest) {
  std::vector<double> edges;
  for (int row = 0; row < 2; ++row) {
    edges.push_back(0);
    for (std::int32_t i = 0; i < layers; ++i)
      edges.push_back(edges.back() + random.scale(thinnest, 1));
  }
  return edges;
}

/// Of rows that have so many layers each.
Layering layering_of(const TwinTable& edges, std::int32_t layers) {
  const auto row = static_cast<std::size_t>(layers) + 1;
  std::vector<double> ends;
  for (std::size_t end = row; end <= edges.numbers().size(); end += row)
    ends.push_back(edges.numbers()[end - 1]);
  return {edges.numbers(), layers, ends};
}

/// In the middle of layers, beside edges and on them, and beyond all.
template <class T>
void expect_layers(Random& random, const LayeringView& view, std::int32_t row) {
  const T* edge = nullptr;
  if constexpr (std::is_same_v<T, float>) {
    edge = view.edge.rounded + row * (view.layers + 1);
  } else {
    edge = view.edge.exact + row * (view.layers + 1);
  }
  constexpr T beyond = std::numeric_limits<T>::infinity();
  const auto found = [&](std::int32_t from, T x) { return view.layer_of<T>(row, from, x); };
  for (std::int32_t i = 0; i < view.layers; ++i) {
    const std::int32_t from = random.below(view.layers);
    const T inside = edge[i] + static_cast<T>(random.uniform()) * (edge[i + 1] - edge[i]);
    if (inside > edge[i] && inside < edge[i + 1]) {
      ASSERT_EQ(found(from, inside), i) << view.layers << " layers from " << from;
    }
    if (i == 0) continue;
    ASSERT_EQ(found(from, std::nextafter(edge[i], -beyond)), i - 1);
    ASSERT_EQ(found(from, std::nextafter(edge[i], beyond)), i);
    ASSERT_EQ(found(i - 1, edge[i]), i - 1);
    ASSERT_EQ(found(i, edge[i]), i);
    ASSERT_EQ(found(from, edge[i]), from == i ? i : i - 1)
        << view.layers << " layers from " << from;
  }
  const std::int32_t from = view.layers / 2;
  const std::int32_t last = view.layers - 1;
  for (const T x : {T(-1), T(0), std::numeric_limits<T>::quiet_NaN(), -beyond})
    ASSERT_EQ(found(from, x), 0) << x;
  for (const T x : {T(1e9), beyond, edge[view.layers]}) ASSERT_EQ(found(from, x), last) << x;
}

// However many layers there are and however unlike, in whichever row their edges stand. Seen red:
// with too few steps, or edges in a step; with the lower layer on an edge, or `from` on each; with
// a layer below the last; with one row for all; without the bounds of what is no coordinate.
TEST(Layering, FindsEachOfManyLayers) {
  Random random(67);
  std::int32_t most = 0;
  for (const double thinnest : {0.5, 1e-3, 1e-5}) {
    for (std::int32_t layers = 2; layers <= 140; ++layers) {
      const TwinTable edges(two_rows(random, layers, thinnest));
      const Layering layering = layering_of(edges, layers);
      const LayeringView view = layering.view(edges.view());
      for (const std::int32_t row : {0, 1}) {
        expect_layers<double>(random, view, row);
        expect_layers<float>(random, view, row);
      }
      most = std::max(most, view.max_edges);
    }
  }
  EXPECT_GE(most, 16);  // so that all steps of the search are taken
}

// A float may be rounded across the end of a cell, where an edge may be as well. Seen red: without
// regard to that, at either end.
TEST(Layering, AllowsForRoundingAtTheEndsOfCells) {
  Random random(68);
  for (int i = 0; i < 10000; ++i) {
    const double cell = random.scale(1e-3, 1);
    const auto beside = [&](int n) { return n * cell * (1 + random.between(-1e-7, 1e-7)); };
    const TwinTable edges(std::vector{0.0, 10.5 * cell, beside(11), 63 * cell, 64 * cell});
    const Layering layering = layering_of(edges, 4);
    const LayeringView view = layering.view(edges.view());
    ASSERT_EQ(view.cells, 64);
    expect_layers<float>(random, view, 0);
  }
}

// Layers that are alike differ by one edge each.
TEST(Layering, HasFewEdgesInACell) {
  for (const std::int32_t layers : {2, 50, 200}) {
    std::vector<double> edges;
    for (std::int32_t i = 0; i <= layers; ++i) edges.push_back(0.7 * i);
    EXPECT_EQ(layering_of(TwinTable(edges), layers).view({}).max_edges, 1) << layers;
  }
}

TEST(Layering, HasAnOnlyLayerWithoutEnd) {
  const TwinTable edges(std::vector{0.0, std::numeric_limits<double>::infinity()});
  const Layering layering = layering_of(edges, 1);
  EXPECT_EQ(layering.view(edges.view()).layer_of<double>(0, 0, 1e9), 0);
}

// Clear layers have no optical depth: all edges are one, and what lies on it stays in its layer or
// is in the upper one.
TEST(Layering, ToleratesLayersOfNoDepth) {
  const TwinTable edges(std::vector{0.0, 0.0, 0.0, 1.0});
  const Layering layering = layering_of(edges, 3);
  const LayeringView view = layering.view(edges.view());
  EXPECT_EQ(view.layer_of<double>(0, 0, 0.5), 2);
  EXPECT_EQ(view.layer_of<double>(0, 0, 0.0), 0);
}

}  // namespace
}  // namespace photic::medium
