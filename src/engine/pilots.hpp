// What short runs tell of the estimators that they were made with.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tally/result.hpp"

namespace photic::engine {

struct Pilot {
  double cost = 0;  ///< in operations; above 0
  /// Relative, of the mean, [telescope][channel][gate]; none where nothing was scored.
  std::vector<std::optional<double>> squared_error{};
  std::size_t rows_seen = 0;  ///< channels of telescopes that anything was scored in
};

Pilot pilot_of(const tally::Result& result, double cost);

/// Gates that light reaches: those that any of them saw.
std::vector<bool> gates_seen(const std::vector<Pilot>& pilots);

/// Mean over the gates that count of the logarithm of the squared error times the cost.
double badness(const Pilot& pilot, const std::vector<bool>& counts);

/// Which saw light in most channels of telescopes, and of several such the one of least badness;
/// none if none saw any.
std::optional<std::size_t> best_of(const std::vector<Pilot>& pilots);

}  // namespace photic::engine
