#include "tally/batch_tally.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "core/error.hpp"

namespace photic::tally {
namespace {

void add(double& sum, double more) { sum += more; }
void add(CellScores& scores, const CellScores& more) { scores.add(more); }
void add(EnvironmentScores& scores, const EnvironmentScores& more) { scores.add(more); }
void add(OctavesOfBatch& counts, const OctavesOfBatch& more) {
  if (more != OctavesOfBatch{}) std::ranges::transform(counts, more, counts.begin(), std::plus());
}

bool is_by(const Grid& grid, Quantity quantity) {
  return grid.axes.size() == 1 && grid.axes.front().quantity == quantity;
}

}  // namespace

void CellScores::add(const CellScores& others) {
  largest = std::max(largest, others.largest);
  cut_order += others.cut_order;
  scores += others.scores;
}

void EnvironmentScores::add(const EnvironmentScores& others) {
  for (const auto member :
       {&EnvironmentScores::echo, &EnvironmentScores::difference, &EnvironmentScores::squares,
        &EnvironmentScores::fourths, &EnvironmentScores::squares_of_differences,
        &EnvironmentScores::fourths_of_differences})
    std::ranges::transform(this->*member, others.*member, (this->*member).begin(), std::plus());
  std::ranges::transform(largest, others.largest, largest.begin(),
                         [](double a, double b) { return std::max(a, b); });
}

BatchTally::BatchTally(const Shape& shape, const Gates& gates)
    : rests(shape.rows()),
      cells(shape.cells()),
      environment_groups((shape.environments + EnvironmentScores::size - 1) /
                         EnvironmentScores::size),
      environment(shape.cells() * environment_groups),
      touched_cells(shape.rows()),
      tallies(cells_of(shape.tallies)),
      shape_(&shape),
      gates_(&gates),
      cells_of_telescope_(shape.channels * shape.gates),
      last_order_(shape.max_order > 0 ? shape.max_order
                                      : std::numeric_limits<std::int32_t>::max()) {
  for (auto& kind : octaves) kind.resize(shape.cells());
  for (const Grid& grid : shape.grids) {
    for (const Axis& axis : grid.axes) know(axis);
    if (grid.profile) {
      expect(is_by(grid, Quantity::depth) && profile.size == 0, "the one profile is by depth");
      profile = {grid.size(), ZeroedVector<double>(shape.cells() * grid.size()),
                 std::vector<std::vector<std::uint32_t>>(shape.rows())};
      continue;
    }
    if (grids.size() > 1) add_further(grid, parts_size);
    grids.push_back({grid.size(), std::exchange(parts_size, parts_size + grid.size())});
  }
  expect(grids.size() > 1 && is_by(shape.grids[0], Quantity::order) &&
             is_by(shape.grids[1], Quantity::process),
         "the first grids are by order and by process");
  parts.resize(shape.cells() * parts_size);
  const std::size_t lines = shape.channels_of_line.size();
  for (std::size_t each = 0; each < shape.process_of_light.size(); ++each) {
    const std::size_t line = each % lines;
    const Decay* decay = shape.decay_of_line.empty() ? nullptr : &shape.decay_of_line[line];
    Light& light = light_.emplace_back();
    light.process = static_cast<std::size_t>(shape.process_of_light[each]);
    light.by_process = grids[1].offset + light.process;
    for (const auto& [channel, share] : shape.channels_of_line[line])
      light.counting.push_back({shape.cell(0, static_cast<std::size_t>(channel), 0), share});
    if (decay != nullptr && !decay->at_once()) light.decay = decay;
  }
  for (std::size_t t = 0; t < shape.wider.size(); ++t) {
    if (std::ranges::find(shape.wider, t) != shape.wider.end()) continue;
    for (std::size_t from = t; shape.wider[from]; from = *shape.wider[from])
      passes_.push_back({from, *shape.wider[from]});
  }
}

void BatchTally::add_further(const Grid& grid, std::size_t offset) {
  Further out{offset};
  std::size_t stride = grid.size();
  for (const Axis& axis : grid.axes) {
    stride /= axis.size();
    expect(axis.quantity != Quantity::depth, "parts are not by depth");
    const bool by_order = axis.quantity == Quantity::order;
    expect(axis.size() == grids[by_order ? 0 : 1].size, "axes of one quantity are the same");
    (by_order ? out.per_order : out.per_process) = stride;
  }
  further_.push_back(out);
}

void BatchTally::know(const Axis& axis) {
  if (axis.quantity == Quantity::order) last_order_bin_ = axis.size() - 1;
  if (axis.quantity != Quantity::depth) return;
  depths_ = static_cast<std::int32_t>(axis.size());
  depth_min_ = axis.edges.front();
  per_depth_step_ = static_cast<double>(depths_) / (axis.edges.back() - depth_min_);
}

bool BatchTally::wants(std::size_t telescope, std::int32_t line) const {
  const auto& counting = shape_->channels_of_line[static_cast<std::size_t>(line)];
  const bool own = std::ranges::any_of(counting, [&](const Counting& c) {
    return !rests[telescope * shape_->channels + static_cast<std::size_t>(c.channel)];
  });
  return own || std::ranges::any_of(passes_, [&](const Pass& pass) {
           return pass.to == telescope && wants(pass.from, line);
         });
}

void BatchTally::pass_to_wider() {
  for (const Pass& pass : passes_)
    for (std::size_t channel = 0; channel < shape_->channels; ++channel) {
      const std::size_t from = shape_->cell(pass.from, channel, 0);
      const std::size_t to = shape_->cell(pass.to, channel, 0);
      for (const std::uint32_t cell : touched_cells[shape_->row_of(from)])
        add_cell(cell, cell - from + to);
    }
}

void BatchTally::add_cell(std::size_t from, std::size_t to) {
  if (!cells[to].touched())
    touched_cells[shape_->row_of(to)].push_back(static_cast<std::uint32_t>(to));
  each_array([&](auto& array, std::size_t size) {
    for (std::size_t k = 0; k < size; ++k) tally::add(array[to * size + k], array[from * size + k]);
  });
  for (std::size_t k = 0; k < profile.size; ++k) {
    const double more = profile.sums[from * profile.size + k];
    if (more != 0) add_to_profile(to, to * profile.size + k, more);
  }
}

void BatchTally::clear() {
  each_array([&](auto& array, std::size_t size) {
    const std::remove_reference_t<decltype(array[0])> zero{};
    for (const auto& row : touched_cells)
      for (const std::uint32_t cell : row)
        for (std::size_t k = cell * size; k < (cell + 1) * size; ++k)
          if (array[k] != zero) array[k] = zero;
  });
  for (auto& row : profile.touched) {
    for (const std::uint32_t k : row) profile.sums[k] = 0;
    row.clear();
  }
  for (auto& row : touched_cells) row.clear();
  tallies.clear();
  ledger = {};
  operations = {};
  photons = collisions = scores = too_many_events = not_finite = 0;
}

}  // namespace photic::tally
