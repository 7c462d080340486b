#include "engine/pilots.hpp"

#include <algorithm>
#include <cmath>

namespace photic::engine {
namespace {

/// A short run of a heavy-tailed estimator looks better than it is. Where a single score carries
/// more than this share of a gate, the squared error is taken to be larger by as much as it does.
constexpr double largest_known_score = 2e-3;
/// And where nothing was scored, as where one score is all: who saw that one is no worse.
constexpr double unknown_squared_error = 1 / largest_known_score;
/// No error is known to be smaller: they are differences of rounded sums.
constexpr double least_squared_error = 1e-16;

bool is_better(const Pilot& a, const Pilot& b, const std::vector<bool>& counts) {
  if (a.rows_seen != b.rows_seen) return a.rows_seen > b.rows_seen;
  return badness(a, counts) < badness(b, counts);
}

}  // namespace

Pilot pilot_of(const tally::Result& result, double cost) {
  Pilot out{.cost = cost};
  bool row_seen = false;
  for (std::size_t cell = 0; cell < result.echo.mean.size(); ++cell) {
    row_seen = cell % result.gates() != 0 && row_seen;
    std::optional<double>& squared_error = out.squared_error.emplace_back();
    const double relative = result.echo.standard_error[cell] / result.echo.mean[cell];
    if (!(relative >= 0)) continue;  // 0 / 0, or an error that is not known
    out.rows_seen += row_seen ? 0 : 1;
    row_seen = true;
    const double tail = std::max(1.0, result.largest_score_share[cell] / largest_known_score);
    squared_error = std::max(least_squared_error, relative * relative * tail);
  }
  return out;
}

std::vector<bool> gates_seen(const std::vector<Pilot>& pilots) {
  std::vector<bool> seen(pilots.front().squared_error.size());
  for (const Pilot& pilot : pilots) {
    for (std::size_t cell = 0; cell < seen.size(); ++cell)
      seen[cell] = seen[cell] || pilot.squared_error[cell];
  }
  return seen;
}

double badness(const Pilot& pilot, const std::vector<bool>& counts) {
  double sum = 0;
  double cells = 0;
  for (std::size_t cell = 0; cell < counts.size(); ++cell) {
    if (!counts[cell]) continue;
    sum += std::log(pilot.squared_error[cell].value_or(unknown_squared_error) * pilot.cost);
    cells += 1;
  }
  return sum / cells;
}

std::optional<std::size_t> best_of(const std::vector<Pilot>& pilots) {
  const std::vector<bool> counts = gates_seen(pilots);
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < pilots.size(); ++i) {
    if (pilots[i].rows_seen == 0) continue;
    if (!best || is_better(pilots[i], pilots[*best], counts)) best = i;
  }
  return best;
}

}  // namespace photic::engine
