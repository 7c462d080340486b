#include "scene/tally_memory.hpp"

#include <algorithm>

#include "scene/checks.hpp"

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
/// Bytes of a cell of a tally beside echoes: tally::TallySums twice, sums of two batches, mean,
/// error and flags; and octaves as above.
constexpr double per_tally_cell = 2 * 72.0 + 2 * 16.0 + 24.0 + per_kind;
constexpr double per_tally_cell_of_batch = 16.0 + per_kind_of_batch;

/// Groups of batches, at most (tally::full_groups), and bytes of a cell or a cell in other water in
/// each: sums, sums before an incomplete batch or on their way into the file, and means.
constexpr double max_groups = 128, per_group_mean = 4.0, per_group = 2 * 8.0 + per_group_mean;

/// Constituents of a layer, and layers of air that a profile becomes, at most.
constexpr double max_constituents = 8, max_air_layers = 200;
/// Quantities of the irradiances, and of the boundaries but for absorption and angles.
constexpr double irradiances = 4, single_boundaries = 6;

/// Of echoes.
double cells_of(const Scene& scene) {
  return static_cast<double>(scene.telescope.size() * scene.channel.size()) *
         static_cast<double>(scene.gates.count());
}

double cells_of_tally(const Tally& tally, const Scene& scene) {
  const auto number = [](const auto& values) { return static_cast<double>(values.size()); };
  const double levels = number(tally.depth_m) + number(tally.height_m);
  const auto cells = [&](double edges) { return std::max(0.0, edges - 1); };
  switch (tally.kind) {
    case TallyKind::irradiance:
      return irradiances * levels * std::max(1.0, cells(number(tally.zone_deg)));
    case TallyKind::radiance:
      return levels * number(tally.direction_deg);
    case TallyKind::fluence:
      return cells(levels) * cells(number(tally.radius_m) + number(tally.x_m));
    case TallyKind::boundaries:
      return cells(number(tally.zenith_deg)) + single_boundaries +
             max_constituents *
                 (number(layers_of(scene.sea)) + (scene.atmosphere ? max_air_layers : 0.0));
  }
  return 0;
}

/// The number of kinds of scores, at most (tally::kinds_of_technique).
double kinds_in(const Scene& scene) {
  const auto estimator = scene.simulation.estimator;
  return estimator == Estimator::forward || estimator == Estimator::analog ? 1 : 3;
}

}  // namespace

double cells_of_tallies(const Scene& scene) {
  double cells = 0;
  for (const Tally& tally : scene.tally) cells += cells_of_tally(tally, scene);
  return cells;
}

double group_echoes(const Scene& scene) {
  const auto environments = static_cast<double>(scene.environment.size());
  return cells_of(scene) * (1 + environments) * max_groups * per_group_mean;
}

bool keeps_groups(const Scene& scene) {
  return scene.simulation.keep_groups && group_echoes(scene) <= max_group_echoes;
}

TallyMemory tally_memory(const Scene& scene) {
  const auto number = [](auto count) { return static_cast<double>(count); };
  const double cells = cells_of(scene);
  const double depths = number(scene.gates.depth_cells);
  const double orders = number(scene.simulation.orders_kept) + 1;  // and 0
  const double processes =
      3.0 + (has_bed(scene) ? 1 : 0) + (scene.oil ? 1 : 0);  // elastic, raman, chlorophyll
  const double waters = number(scene.environment.size() + scene.sensitivity.size());
  return {.depths = cells * depths * per_sum,
          .orders = cells * orders * per_part,
          .other_waters = cells * waters * per_water,
          .rest = cells * (processes * per_part + per_cell + kinds_in(scene) * per_kind),
          .groups = keeps_groups(scene) ? group_echoes(scene) / per_group_mean * per_group : 0,
          .tallies = cells_of_tallies(scene) * per_tally_cell,
          .batch = cells * ((depths + orders + processes) * per_sum_of_batch +
                            waters * per_water_of_batch + per_cell_of_batch +
                            kinds_in(scene) * per_kind_of_batch) +
                   cells_of_tallies(scene) * per_tally_cell_of_batch};
}

}  // namespace photic::scene
