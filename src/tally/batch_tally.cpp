#include "tally/batch_tally.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace photic::tally {
namespace {

/// Adds the `size` sums of a cell to those of another one.
void add_sums(ZeroedVector<double>& sums, std::size_t from, std::size_t to, std::size_t size) {
  for (std::size_t k = 0; k < size; ++k) sums[to * size + k] += sums[from * size + k];
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
      by_order(shape.cells() * shape.orders),
      by_process(shape.cells() * shape.processes),
      by_depth(shape.cells() * shape.depths),
      cells(shape.cells()),
      environment_groups((shape.environments + EnvironmentScores::size - 1) /
                         EnvironmentScores::size),
      environment(shape.cells() * environment_groups),
      shape_(&shape),
      gates_(&gates),
      orders_(shape.orders),
      processes_(shape.processes),
      depths_(shape.depths),
      cells_of_telescope_(shape.channels * shape.gates),
      last_order_(shape.max_order > 0 ? shape.max_order
                                      : std::numeric_limits<std::int32_t>::max()) {
  for (auto& kind : octaves) kind.resize(shape.cells());
  const std::size_t lines = shape.channels_of_line.size();
  for (std::size_t each = 0; each < shape.process_of_light.size(); ++each) {
    const std::size_t line = each % lines;
    const Decay* decay = shape.decay_of_line.empty() ? nullptr : &shape.decay_of_line[line];
    Light& light = light_.emplace_back();
    light.process = static_cast<std::size_t>(shape.process_of_light[each]);
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
  for (const Pass& pass : passes_) {
    const std::size_t first = pass.from * cells_of_telescope_;
    for (std::size_t i = 0, known = touched_cells.size(); i < known; ++i) {
      const std::size_t of_telescope = touched_cells[i] - first;  // wraps around below the first
      if (of_telescope < cells_of_telescope_)
        add_cell(touched_cells[i], pass.to * cells_of_telescope_ + of_telescope);
    }
  }
}

void BatchTally::add_cell(std::size_t from, std::size_t to) {
  if (!cells[to].touched()) touched_cells.push_back(static_cast<std::uint32_t>(to));
  cells[to].add(cells[from]);
  for (auto& kind : octaves) {
    if (kind[from] != OctavesOfBatch{})
      std::ranges::transform(kind[to], kind[from], kind[to].begin(), std::plus());
  }
  add_sums(by_order, from, to, orders_);
  add_sums(by_process, from, to, processes_);
  for (std::size_t g = 0; g < environment_groups; ++g)
    environment[to * environment_groups + g].add(environment[from * environment_groups + g]);
  for (std::size_t d = 0; d < depths_; ++d) {
    const double more = by_depth[from * depths_ + d];
    if (more == 0) continue;
    const std::size_t k = to * depths_ + d;
    if (by_depth[k] == 0) touched_depths.push_back(static_cast<std::uint32_t>(k));
    by_depth[k] += more;
  }
}

void BatchTally::clear() {
  for (const std::uint32_t cell : touched_cells) {
    std::fill_n(by_order.begin() + static_cast<std::ptrdiff_t>(cell * shape_->orders),
                shape_->orders, 0.0);
    std::fill_n(by_process.begin() + static_cast<std::ptrdiff_t>(cell * shape_->processes),
                shape_->processes, 0.0);
    cells[cell] = {};
    for (auto& kind : octaves)
      if (kind[cell] != OctavesOfBatch{}) kind[cell] = {};
    std::fill_n(environment.begin() + static_cast<std::ptrdiff_t>(cell * environment_groups),
                environment_groups, EnvironmentScores{});
  }
  for (const std::uint32_t k : touched_depths) by_depth[k] = 0;
  touched_cells.clear();
  touched_depths.clear();
  ledger = {};
  photons = collisions = scores = too_many_events = not_finite = 0;
}

}  // namespace photic::tally
