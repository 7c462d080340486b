// The scores of the lanes of packs, one after the other.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/lanes.hpp"
#include "tally/batch_tally.hpp"

namespace photic::lanes {

/// Scores in telescopes at one place, one in each lane; as tally::Score.
template <class T>
struct LaneScores {
  Index<T> telescope{};
  double path_to_origin = 0;  ///< the length that the paths leave out (estimator/world.hpp) [m]
  Index<T> light{}, order{};
  T depth{}, path{}, value{};
  tally::Technique technique = tally::Technique::none;
};

/// Their whole paths, in double.
template <class T>
auto whole_path(const LaneScores<T>& scores) {
  const auto wide = to_double(scores.path);
  return wide + std::decay_t<decltype(wide)>(scores.path_to_origin);
}

/// Calls act(lane, score, where it belongs) for the lanes of a mask.
template <class T, class Act>
void each_score(const tally::BatchTally& tally, const Mask<T>& mask, const LaneScores<T>& scores,
                Act act) {
  const auto wide_path = whole_path(scores), wide_depth = to_double(scores.depth);
  const auto bins = tally.bins(wide_path, wide_depth);
  const auto gates = each_lane(bins.gate), cells = each_lane(bins.depth);
  const auto telescopes = each_lane(scores.telescope);
  const auto lights = each_lane(scores.light), orders = each_lane(scores.order);
  const auto depths = each_lane(wide_depth), paths = each_lane(wide_path),
             values = each_lane(to_double(scores.value));
  for_each_lane(mask, [&](int lane) {
    const auto i = static_cast<std::size_t>(lane);
    act(i,
        tally::Score{static_cast<std::size_t>(telescopes[i]), lights[i], orders[i], depths[i],
                     paths[i], values[i], scores.technique},
        tally::Bins<std::int32_t>{gates[i], cells[i]});
  });
}

/// The queue of scores in one telescope, or in those with `nested` views: a tally takes many at
/// once, one by one, and packs do not wait for it.
template <class T>
class ScoreQueue {
 public:
  ScoreQueue(std::size_t telescope, double path_to_origin, bool nested = false)
      : telescope_(telescope), path_to_origin_(path_to_origin), nested_(nested) {}

  /// Adds the lanes of a mask; hands all to the tally when the queue is full.
  void push(const Mask<T>& mask, const LaneScores<T>& scores, tally::BatchTally& tally) {
    const auto path = whole_path(scores);
    const auto bins = tally.bins(path, to_double(scores.depth));
    if constexpr (lanes == 1) {
      if (mask)
        tally.score({static_cast<std::size_t>(scores.telescope), scores.light, scores.order,
                     scores.depth, path, scores.value, scores.technique},
                    bins);
    } else {
      const std::size_t at = waiting_;
      if (nested_) compress(mask, scores.telescope, &narrowest_[at]);
      compress(mask, scores.light, &light_[at]);
      compress(mask, scores.order, &order_[at]);
      compress(mask, scores.path, &path_[at]);
      compress(mask, scores.value, &value_[at]);
      compress(mask, bins.gate, &gate_[at]);
      compress(mask, bins.depth, &cell_[at]);
      const std::size_t more = count(mask);
      std::fill_n(&walked_[at], more, scores.technique);
      waiting_ = at + more;
      if (waiting_ > capacity) flush(tally);
    }
  }
  /// Hands over the scores that wait.
  void flush(tally::BatchTally& tally) {
    if (nested_)
      flush(tally, [this](std::size_t i) { return static_cast<std::size_t>(narrowest_[i]); });
    else
      flush(tally, [this](std::size_t) { return telescope_; });
  }
  [[nodiscard]] bool nested() const { return nested_; }

 private:
  template <class TelescopeOf>
  void flush(tally::BatchTally& tally, TelescopeOf telescope_of) {
    for (std::size_t i = 0; i < waiting_; ++i)
      tally.score({.telescope = telescope_of(i),
                   .light = light_[i],
                   .order = order_[i],
                   .path = path_to_origin_ + path_[i],
                   .value = value_[i],
                   .technique = walked_[i]},
                  {gate_[i], cell_[i]});
    waiting_ = 0;
  }

  /// Rounds are long, for each of them throws the photons out of the first cache.
  static constexpr std::size_t lanes = lanes_of<T>, capacity = 128 * lanes;
  template <class Number>
  using Column = std::array<Number, capacity + lanes>;

  std::size_t telescope_;
  double path_to_origin_;
  bool nested_;
  Column<std::int32_t> narrowest_{};  ///< telescope that sees a score; of nested views
  Column<std::int32_t> light_{}, order_{}, gate_{}, cell_{};
  Column<tally::Technique> walked_{};
  Column<Element<T>> path_{}, value_{};
  std::size_t waiting_ = 0;
};

}  // namespace photic::lanes
