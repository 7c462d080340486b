#include "run/pilots.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace photic::run {
namespace {

/// The squared error of a gate without scores, equal to that of one score: a pilot that saw one is
/// no worse.
constexpr double unknown_squared_error = 1 / share_between_estimators;
/// No error is known to be smaller: they are differences of rounded sums.
constexpr double min_squared_error = 1e-16;

/// Pilots know the work of an estimator to about this factor: so much more of it is made up for by
/// less cost (docs/decisions/0052).
constexpr double alike = 1.2;

/// The work in each gate that is compared.
std::vector<double> work_in(const Pilot& pilot, const std::vector<bool>& compared) {
  std::vector<double> work;
  for (std::size_t cell = 0; cell < compared.size(); ++cell) {
    if (!compared[cell]) continue;
    work.push_back(pilot.squared_error[cell].value_or(unknown_squared_error) * pilot.cost);
  }
  return work;
}

}  // namespace

Pilot pilot_of(const tally::Result& result, double cost, double largest_share) {
  Pilot out{.cost = cost};
  bool row_seen = false;
  for (std::size_t cell = 0; cell < result.echo.mean.size(); ++cell) {
    row_seen = cell % result.gates() != 0 && row_seen;
    std::optional<double>& squared_error = out.squared_error.emplace_back();
    const double relative = result.echo.standard_error[cell] / result.echo.mean[cell];
    if (!(relative >= 0)) continue;  // 0 / 0, or an error that is not known
    out.rows_seen += row_seen ? 0 : 1;
    row_seen = true;
    const double largest = result.largest_score_share[cell];
    squared_error =
        std::max({min_squared_error, relative * relative, largest * largest / largest_share});
  }
  return out;
}

std::vector<bool> gates_compared(const std::vector<Pilot>& pilots, double known_to) {
  const std::size_t cells = pilots.front().squared_error.size();
  std::vector<bool> seen(cells), known(cells);
  for (const Pilot& pilot : pilots) {
    for (std::size_t cell = 0; cell < cells; ++cell) {
      const std::optional<double>& squared_error = pilot.squared_error[cell];
      seen[cell] = seen[cell] || squared_error;
      known[cell] = known[cell] || (squared_error && *squared_error <= known_to);
    }
  }
  return std::ranges::find(known, true) != known.end() ? known : seen;
}

double badness(const Pilot& pilot, const std::vector<bool>& compared, Aim aim) {
  return log_work(work_in(pilot, compared), aim);
}

double work_of_worst(const Pilot& pilot, const std::vector<bool>& compared) {
  return std::ranges::max(work_in(pilot, compared));
}

std::optional<std::size_t> best_of(const std::vector<Pilot>& pilots,
                                   const std::vector<bool>& compared, Aim aim) {
  const std::size_t rows = std::ranges::max(pilots, {}, &Pilot::rows_seen).rows_seen;
  if (rows == 0) return std::nullopt;
  const auto log_work = [&](const Pilot& pilot) {
    return pilot.rows_seen == rows ? badness(pilot, compared, aim)
                                   : std::numeric_limits<double>::infinity();
  };
  std::size_t least = 0;
  for (std::size_t i = 0; i < pilots.size(); ++i)
    if (log_work(pilots[i]) < log_work(pilots[least])) least = i;
  std::size_t best = least;
  for (std::size_t i = 0; i < pilots.size(); ++i) {
    const double cheaper = std::min(alike, pilots[least].cost / pilots[i].cost);
    if (log_work(pilots[i]) <= log_work(pilots[least]) + std::log(cheaper) &&
        pilots[i].cost < pilots[best].cost)
      best = i;
  }
  return best;
}

}  // namespace photic::run
