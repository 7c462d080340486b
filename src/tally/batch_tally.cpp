#include "tally/batch_tally.hpp"

#include <algorithm>
#include <cmath>

namespace photic::tally {

BatchTally::BatchTally(const Shape& shape, const Gates& gates)
    : rests(shape.rows()),
      by_order(shape.cells() * shape.orders),
      by_process(shape.cells() * shape.processes),
      by_depth(shape.cells() * shape.depths),
      cut_order(shape.cells()),
      largest(shape.cells()),
      octaves(shape.cells()),
      environment_groups((shape.environments + EnvironmentScores::size - 1) /
                         EnvironmentScores::size),
      environment(shape.cells() * environment_groups),
      shape_(&shape),
      gates_(&gates) {}

inline std::span<const GateShare> BatchTally::gates_of(const Score& s) {
  if (!shape_->decay_of_line.empty()) {
    const Decay& decay = shape_->decay_of_line[static_cast<std::size_t>(s.line)];
    if (!decay.at_once()) {
      decay.spread(s.path, *gates_, shares_);
      return shares_;
    }
  }
  const std::int32_t gate = gates_->find(s.path);
  if (gate < 0) return {};
  whole_.gate = gate;
  return {&whole_, 1};
}

bool BatchTally::wants(std::size_t telescope, std::int32_t line) const {
  const auto& counting = shape_->channels_of_line[static_cast<std::size_t>(line)];
  return std::ranges::any_of(counting, [&](const Counting& c) {
    return !rests[telescope * shape_->channels + static_cast<std::size_t>(c.channel)];
  });
}

std::span<const GateShare> BatchTally::add(const Score& s) {
  ++scores;
  if (!(s.value > 0)) {
    if (std::isnan(s.value)) ++not_finite;
    return {};
  }
  const auto gates = gates_of(s);
  if (gates.empty()) return {};
  const bool beyond = shape_->max_order > 0 && s.order > shape_->max_order;
  const auto order = std::min(static_cast<std::size_t>(s.order), shape_->orders) - 1;
  const auto process =
      static_cast<std::size_t>(shape_->process_of_line[static_cast<std::size_t>(s.line)]);
  const double depth_cell = (s.depth - shape_->depth_min) * shape_->per_depth_step;
  const bool has_depth = depth_cell >= 0 && depth_cell < static_cast<double>(shape_->depths);

  for (const auto& [gate, part] : gates) {
    for (const auto& [channel, share] :
         shape_->channels_of_line[static_cast<std::size_t>(s.line)]) {
      const double value = s.value * part * share;
      if (!(value > 0)) continue;  // a share of nothing: the cell would be touched twice
      const std::size_t cell = shape_->cell(s.telescope, static_cast<std::size_t>(channel),
                                            static_cast<std::size_t>(gate));
      if (largest[cell] == 0 && cut_order[cell] == 0)
        touched_cells.push_back(static_cast<std::uint32_t>(cell));
      if (beyond) {
        cut_order[cell] += value;
        continue;
      }
      by_order[cell * shape_->orders + order] += value;
      by_process[cell * shape_->processes + process] += value;
      largest[cell] = std::max(largest[cell], value);
      ++octaves[cell][static_cast<std::size_t>(score_octave(value))];
      if (has_depth) {
        const std::size_t k = cell * shape_->depths + static_cast<std::size_t>(depth_cell);
        if (by_depth[k] == 0) touched_depths.push_back(static_cast<std::uint32_t>(k));
        by_depth[k] += value;
      }
    }
  }
  return beyond ? std::span<const GateShare>() : gates;
}

void BatchTally::clear() {
  for (const std::uint32_t cell : touched_cells) {
    std::fill_n(by_order.begin() + static_cast<std::ptrdiff_t>(cell * shape_->orders),
                shape_->orders, 0.0);
    std::fill_n(by_process.begin() + static_cast<std::ptrdiff_t>(cell * shape_->processes),
                shape_->processes, 0.0);
    cut_order[cell] = 0;
    largest[cell] = 0;
    octaves[cell].fill(0);
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
