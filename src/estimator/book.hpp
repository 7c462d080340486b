// Entries in a ledger of weights.
#pragma once

namespace photic::estimator {

/// Adds the weights of the lanes of a mask to an account of the ledger.
inline void book(double& account, bool mask, double weight) {
  if (mask) account += weight;
}

}  // namespace photic::estimator
