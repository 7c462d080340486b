// The results of short runs, by estimator.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "run/rule.hpp"
#include "tally/result.hpp"

namespace photic::run {

struct Pilot {
  double cost = 0;  ///< in operations; above 0
  /// Relative, of the mean, [telescope][channel][gate]; none where nothing was scored.
  std::vector<std::optional<double>> squared_error{};
  std::size_t rows_seen = 0;  ///< channels of telescopes that anything was scored in
};

Pilot pilot_of(const tally::Result& result, double cost);

/// Gates that pilots, which simulated alike, are compared by: those that light reaches, since any
/// of them saw it; of these the ones that the best of them knows to this squared error, if there
/// are any. In others luck decides: all estimators' scores are rare there.
std::vector<bool> gates_compared(const std::vector<Pilot>& pilots, double known_to);

/// Logarithm of the work (rule.hpp) in the gates that are compared; at least one is.
double badness(const Pilot& pilot, const std::vector<bool>& compared, Aim aim);

/// The pilot that saw light in most channels of telescopes, and of several such the one of least
/// badness; none if none saw any.
std::optional<std::size_t> best_of(const std::vector<Pilot>& pilots,
                                   const std::vector<bool>& compared, Aim aim);

}  // namespace photic::run
