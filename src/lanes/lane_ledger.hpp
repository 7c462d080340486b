// A ledger of weights whose lanes are added up at the end.
#pragma once

#include "core/pack.hpp"
#include "tally/state.hpp"

namespace photic::lanes {

/// Sums of weights, in double, each lane for itself.
template <class T>
struct LaneSum {
  WidePack<double, lanes_of<T>> lanes;
  [[nodiscard]] double total() const {
    double sum = 0;
    for (const double lane : each_lane(lanes)) sum += lane;
    return sum;
  }
};

/// The ledger of a pool.
template <class T>
struct LaneLedger {
  LaneSum<T> absorbed, escaped, sea_bed, oil, cut_by_time, cut_by_order, cut_by_weight, roulette,
      lost;
  friend tally::Ledger total(const LaneLedger& sums) {
    return {sums.absorbed.total(),      sums.escaped.total(),     sums.sea_bed.total(),
            sums.oil.total(),           sums.cut_by_time.total(), sums.cut_by_order.total(),
            sums.cut_by_weight.total(), sums.roulette.total(),    sums.lost.total()};
  }
};

template <class T>
void book(LaneSum<T>& account, const Mask<T>& mask, const T& weight) {
  if (!any(mask)) return;
  account.lanes = account.lanes + to_double(select(mask, weight, T(0)));
}

}  // namespace photic::lanes
