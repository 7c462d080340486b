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

/// A short run of a heavy-tailed estimator looks better than it is: its error is made of few large
/// scores, and larger ones have not come yet. Between estimators no single score is taken to carry
/// more than this share of the squared error (docs/decisions/0038). Settings of one estimator have
/// tails alike, and fewer or more samples in a photon: their errors are taken as they are
/// (docs/decisions/0052).
inline constexpr double share_between_estimators = 0.05, share_between_settings = 1;

/// `largest_share`: the largest that a single score is taken to have of the squared error.
Pilot pilot_of(const tally::Result& result, double cost, double largest_share);

/// Gates that pilots, which simulated alike, are compared by: those that light reaches, since any
/// of them saw it; of these the ones that the best of them knows to this squared error, if there
/// are any. In others luck decides: all estimators' scores are rare there.
std::vector<bool> gates_compared(const std::vector<Pilot>& pilots, double known_to);

/// Logarithm of the work (rule.hpp) in the gates that are compared; at least one is.
double badness(const Pilot& pilot, const std::vector<bool>& compared, Aim aim);

/// The work of the worst gate that is compared: what a run to a target waits for.
double work_of_worst(const Pilot& pilot, const std::vector<bool>& compared);

/// Of the pilots that saw light in most channels of telescopes the one of least work, or a cheaper
/// one whose work is more by no larger a factor than its cost is less, nor by much: of pilots alike
/// those of many independent samples are the ones to trust. None if none saw any light.
std::optional<std::size_t> best_of(const std::vector<Pilot>& pilots,
                                   const std::vector<bool>& compared, Aim aim);

}  // namespace photic::run
