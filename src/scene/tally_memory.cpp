#include "scene/tally_memory.hpp"

namespace photic::scene {
namespace {

// Doubles: none of the products below can overflow.
//
// Of a number with its square: a sum, and the sum before an incomplete batch or on its way into the
// file; the number in two batches, or mean and error in the result.
constexpr double per_sum = 16.0 + 16.0 + 16.0;
/// Bytes of an order or a process, with its flags.
constexpr double per_part = per_sum + 5.0;
constexpr double per_sum_of_batch = 8.0;
/// Bytes of a cell by itself: sums, snapshots of them, flags, diagnostics.
constexpr double per_cell = 2 * 24.0 + 500.0;
constexpr double per_cell_of_batch = 24.0;
/// Bytes of a kind of its scores: counts by 128 octaves, of 8 bytes twice, and of 4 in two batches.
constexpr double per_kind = 2 * 1024.0 + 2 * 512.0;
constexpr double per_kind_of_batch = 512.0;
/// Bytes of a cell in other water: tally::EnvironmentSums as sums above, and four numbers of the
/// result.
constexpr double per_water = 2 * 168.0 + 2 * 56.0 + 32.0;
constexpr double per_water_of_batch = 56.0;

/// The number of kinds of scores, at most (tally::kinds_of_technique).
double kinds_in(const Scene& scene) {
  const auto estimator = scene.simulation.estimator;
  return estimator == Estimator::forward || estimator == Estimator::analog ? 1 : 3;
}

}  // namespace

TallyMemory tally_memory(const Scene& scene) {
  const auto number = [](auto count) { return static_cast<double>(count); };
  const double cells =
      number(scene.telescope.size() * scene.channel.size()) * number(scene.gates.count());
  const double depths = number(scene.gates.depth_cells);
  const double orders = number(scene.simulation.orders_kept) + 1;  // and 0
  const double processes =
      3.0 + (scene.bottom ? 1 : 0) + (scene.oil ? 1 : 0);  // elastic, raman, chlorophyll
  const double waters = number(scene.environment.size() + scene.sensitivity.size());
  return {.depths = cells * depths * per_sum,
          .orders = cells * orders * per_part,
          .other_waters = cells * waters * per_water,
          .rest = cells * (processes * per_part + per_cell + kinds_in(scene) * per_kind),
          .batch = cells *
                   ((depths + orders + processes) * per_sum_of_batch + waters * per_water_of_batch +
                    per_cell_of_batch + kinds_in(scene) * per_kind_of_batch)};
}

}  // namespace photic::scene
