#include "tally/batch_tally.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace photic::tally {

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
}

bool BatchTally::wants(std::size_t telescope, std::int32_t line) const {
  const auto& counting = shape_->channels_of_line[static_cast<std::size_t>(line)];
  return std::ranges::any_of(counting, [&](const Counting& c) {
    return !rests[telescope * shape_->channels + static_cast<std::size_t>(c.channel)];
  });
}

void BatchTally::clear() {
  for (const std::uint32_t cell : touched_cells) {
    std::fill_n(by_order.begin() + static_cast<std::ptrdiff_t>(cell * shape_->orders),
                shape_->orders, 0.0);
    std::fill_n(by_process.begin() + static_cast<std::ptrdiff_t>(cell * shape_->processes),
                shape_->processes, 0.0);
    cells[cell] = {};
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
