// The scores of the lanes of a pack, one after the other.
#pragma once

#include <cstddef>

#include "core/lanes.hpp"
#include "tally/batch_tally.hpp"

namespace photic::engine {

/// Scores in one telescope, one in each lane; as tally::Score.
template <class T>
struct LaneScores {
  std::size_t telescope = 0;
  Index<T> line{}, order{};
  T depth{}, path{}, value{};
};

/// Calls act(lane, score, where it belongs) for the lanes of a mask.
template <class T, class Act>
void each_score(const tally::BatchTally& tally, const Mask<T>& mask, const LaneScores<T>& scores,
                Act act) {
  const auto wide_path = to_double(scores.path), wide_depth = to_double(scores.depth);
  const auto places = tally.places(wide_path, wide_depth);
  const auto gates = each_lane(places.gate), cells = each_lane(places.depth);
  const auto lines = each_lane(scores.line), orders = each_lane(scores.order);
  const auto depths = each_lane(wide_depth), paths = each_lane(wide_path),
             values = each_lane(to_double(scores.value));
  for_each_lane(mask, [&](int lane) {
    const auto i = static_cast<std::size_t>(lane);
    act(i, tally::Score{scores.telescope, lines[i], orders[i], depths[i], paths[i], values[i]},
        tally::Places<std::int32_t>{gates[i], cells[i]});
  });
}

}  // namespace photic::engine
