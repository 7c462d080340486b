// Entries in a ledger of weights.
#pragma once

#include "tally/state.hpp"

namespace photic::estimator {

/// Adds the weights of the lanes of a mask to an account of the ledger.
inline void book(double& account, bool mask, double weight) {
  if (mask) account += weight;
}
inline const tally::Ledger& total(const tally::Ledger& ledger) { return ledger; }

}  // namespace photic::estimator
