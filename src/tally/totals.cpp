#include "tally/totals.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <utility>

#include "core/error.hpp"

namespace photic::tally {
namespace {

/// The one of two ways to the same sum that loses no digits: an environment like the scene has the
/// scene's echo to the last bit, one without light has none.
double environment_echo(double echo, double difference, double scored) {
  return std::abs(difference) < echo / 2 ? echo + difference : scored;
}

bool groups_fit(const TotalsState& state, const Shape& shape) {
  const std::size_t groups = shape.keeps_groups ? groups_of(state.batches) : 0;
  return state.groups.photons.sums.size() == groups * shape.rows() &&
         state.groups.echo.sums.size() == groups * shape.cells() &&
         state.groups.environment.sums.size() == groups * shape.cells() * shape.waters();
}

bool fits(const TotalsState& state, const Shape& shape) {
  const std::size_t cells = shape.cells(), snapshots = snapshots_at(state.batches);
  return state.row.size() == shape.rows() && state.echo.size() == cells &&
         std::ranges::equal(state.grids, shape.grids, {}, &ZeroedVector<Sums>::size,
                            [&](const Grid& grid) { return cells * grid.size(); }) &&
         state.cut_order.size() == cells && state.largest.size() == cells &&
         state.octaves.size() == cells * shape.techniques &&
         state.environment.size() == cells * shape.environments && groups_fit(state, shape) &&
         state.tallies.size() == cells_of(shape.tallies) &&
         state.tally_octaves.size() == cells_of(shape.tallies) &&
         state.snapshot_photons.size() == snapshots * shape.rows() &&
         state.snapshot_batches.size() == snapshots * shape.rows() &&
         state.snapshot_echo.size() == snapshots * cells;
}

}  // namespace

Totals::Totals(const Shape& shape, TotalsState state) : shape_(&shape), state_(std::move(state)) {
  expect(fits(state_, shape), "totals go on from a state of their own shape");
}

void Totals::merge_cell(const BatchTally& batch, std::size_t cell) {
  const auto n = static_cast<double>(batch.photons);
  double echo = 0;
  const double* part = &batch.parts[cell * batch.parts_size];
  for (std::size_t g = 0; g < shape_->grids.size(); ++g) {
    if (shape_->grids[g].profile) continue;
    const std::size_t size = shape_->grids[g].size();
    for (std::size_t k = cell * size; k < (cell + 1) * size; ++k, ++part) {
      if (g == 0) echo += *part;
      if (*part > 0) state_.grids[g][k].add(*part, n);
    }
  }
  state_.echo[cell].add(echo, n);
  if (const auto group = this->group())
    state_.groups.echo.sums[*group * shape_->cells() + cell] += echo;
  const CellScores& scores = batch.cells[cell];
  state_.cut_order[cell] += scores.cut_order;
  state_.largest[cell] = std::max(state_.largest[cell], scores.largest);
  std::uint64_t rest = scores.scores;
  for (auto k = static_cast<std::size_t>(score_octave(scores.largest)); rest > 0; --k) {
    for (std::size_t kind = 0; kind < kinds_of_technique; ++kind) {
      const std::size_t row = std::min(kind, shape_->techniques - 1);
      const std::uint32_t count = batch.octaves[kind][cell][k];
      state_.octaves[cell * shape_->techniques + row][k] += count;
      rest -= count;
    }
  }
  if (shape_->environments > 0) merge_environments(batch, cell, echo);
}

void Totals::merge_row(const BatchTally& batch, std::size_t row) {
  const auto n = static_cast<double>(batch.photons);
  for (const std::uint32_t cell : batch.touched_cells[row]) merge_cell(batch, cell);
  for (std::size_t g = 0; g < shape_->grids.size(); ++g) {
    if (!shape_->grids[g].profile) continue;
    for (const std::uint32_t k : batch.profile.touched[row])
      state_.grids[g][k].add(batch.profile.sums[k], n);
  }
  if (const auto group = this->group())
    state_.groups.photons.sums[*group * shape_->rows() + row] += batch.photons;
  state_.row[row].photons += batch.photons;
  ++state_.row[row].batches;
}

void Totals::merge_tallies(const BatchTally& batch) {
  const auto n = static_cast<double>(batch.photons);
  double balance = 0;
  std::size_t cell = 0;
  for (const TallyGrid& grid : shape_->tallies)
    for (std::size_t k = 0; k < grid.size(); ++k, ++cell) {
      const double score = grid.is_balance ? balance : batch.tallies.sums[cell];
      if (score == 0) continue;
      if (grid.in_balance) balance += score;
      TallySums& sums = state_.tallies[cell];
      sums.scored.add(score, n);
      sums.largest = std::max(sums.largest, batch.tallies.largest[cell]);
      if (!grid.is_balance)
        std::ranges::transform(state_.tally_octaves[cell], batch.tallies.octaves[cell],
                               state_.tally_octaves[cell].begin(), std::plus());
    }
}

std::optional<std::size_t> Totals::group() const {
  if (!shape_->keeps_groups) return std::nullopt;
  return static_cast<std::size_t>(state_.batches / batches_of_group(state_.batches));
}

void Totals::merge(const BatchTally& batch) {
  const auto n = static_cast<double>(batch.photons);
  if (const auto group = this->group())
    each_group_sums([&](auto& sums, std::size_t cells) { sums.open(*group, cells); });
  for (std::size_t row = 0; row < state_.row.size(); ++row)
    if (!batch.rests[row]) merge_row(batch, row);

  merge_tallies(batch);

  state_.photons += batch.photons;
  ++state_.batches;
  state_.collisions += batch.collisions;
  state_.scores += batch.scores;
  state_.operations += batch.operations;
  state_.too_many_events += batch.too_many_events;
  state_.not_finite += batch.not_finite;
  state_.ledger_excess.add(batch.ledger.sum() - n, n);
  state_.ledger += batch.ledger;

  if (std::has_single_bit(state_.batches)) {
    if (state_.batches >= full_groups)
      each_group_sums([](auto& sums, std::size_t cells) { sums.pair_up(cells); });
    for (const Row& row : state_.row) {
      state_.snapshot_photons.push_back(static_cast<double>(row.photons));
      state_.snapshot_batches.push_back(static_cast<double>(row.batches));
    }
    for (const TailSums& s : state_.echo) state_.snapshot_echo.push_back(s.low);
  }
}

void Totals::merge_environments(const BatchTally& batch, std::size_t cell, double echo) {
  const auto n = static_cast<double>(batch.photons);
  double* by_group = nullptr;
  if (const auto group = this->group(); group && shape_->waters() > 0)
    by_group =
        &state_.groups.environment.sums[(*group * shape_->cells() + cell) * shape_->waters()];
  for (std::size_t e = 0; e < shape_->environments; ++e) {
    const std::size_t group = cell * batch.environment_groups + e / EnvironmentScores::size;
    const std::size_t k = e % EnvironmentScores::size;
    const EnvironmentScores& scored = batch.environment[group];
    EnvironmentSums& sums = state_.environment[cell * shape_->environments + e];
    const double there = environment_echo(echo, scored.difference[k], scored.echo[k]);
    sums.echo.add(there, n);
    if (by_group != nullptr && e < shape_->waters()) by_group[e] += there;
    sums.difference.add(scored.difference[k], n);
    sums.largest = std::max(sums.largest, scored.largest[k]);
    sums.of_scores = sums.of_scores + Powers{scored.squares[k], scored.fourths[k]};
    sums.of_differences = sums.of_differences + Powers{scored.squares_of_differences[k],
                                                       scored.fourths_of_differences[k]};
  }
}

Counted Totals::counted(std::size_t cell) const {
  const Row& row = state_.row[shape_->row_of(cell)];
  return {static_cast<double>(row.photons), static_cast<double>(row.batches)};
}

}  // namespace photic::tally
