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
struct LaneLedger : tally::Accounts<LaneSum<T>> {
  friend tally::Ledger total(const LaneLedger& sums) {
    tally::Ledger out;
    tally::Ledger::each(
        [](const char*, double& all, const LaneSum<T>& lanes) { all = lanes.total(); }, out, sums);
    return out;
  }
};

template <class T>
void book(LaneSum<T>& account, const Mask<T>& mask, const T& weight) {
  if (!any(mask)) return;
  account.lanes = account.lanes + to_double(select(mask, weight, T(0)));
}

}  // namespace photic::lanes
