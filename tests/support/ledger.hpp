// All of a ledger's accounts.
#pragma once

#include "tally/state.hpp"

namespace photic::test {

/// 1 in expectation, of shares of the photons emitted.
inline double sum_of(const tally::Ledger& l) {
  return l.absorbed + l.escaped + l.sea_bed + l.oil + l.cut_by_time + l.cut_by_order +
         l.cut_by_weight + l.roulette + l.lost;
}

}  // namespace photic::test
