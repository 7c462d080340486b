// The time at which light leaves an emitter that excited light has come to: not at once, but by and
// by.
#pragma once

#include <cstdint>
#include <vector>

#include "tally/gates.hpp"

namespace photic::tally {

/// A gate, and the share of a score that falls into it.
struct GateShare {
  std::int32_t gate = 0;
  double share = 1;
};

/// An exponential decay as the gates see it: of light that would come at a time t0 if it were
/// emitted at once, exp(-(t - t0)/tau)/tau dt comes at t (docs/theory.md, "Lifetimes").
class Decay {
 public:
  Decay() = default;  ///< at once
  /// `lifetime_ns` is tau, not negative. 0, or what has no finite inverse: at once.
  Decay(double lifetime_ns, const Gates& gates);

  [[nodiscard]] bool at_once() const { return stays_.empty(); }

  /// The shares of the gates of light whose group path [m] would be `path` if it were emitted at
  /// once. They sum to 1 less what comes after the last gate and before the first one; what is
  /// below 1e-17 at a gate's beginning is left out.
  void spread(double path, const Gates& gates, std::vector<GateShare>& out) const;

 private:
  double per_metre_ = 0;  ///< 1 / (c tau)
  double first_path_ = 0, last_path_ = 0;
  std::vector<double> stays_, leaves_;  ///< from the beginning of a gate to its end; they sum to 1
};

}  // namespace photic::tally
