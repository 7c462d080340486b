// Whether the totals' error bars can be relied on, and which rows need no more photons.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "tally/totals.hpp"

namespace photic::tally {
namespace {

// The thresholds below were set on runs against converged references (docs/theory.md, "Error
// bars").
constexpr double least_batches = 30;
constexpr double largest_relative_error = 0.10;
constexpr double largest_single_share = 0.02;
constexpr double largest_variance_of_variance =
    0.1;                             // as MCNP asks for: X-5 Monte Carlo Team, LA-UR-03-1987 (2003)
constexpr double tail_scores = 100;  // at least, that tell how the largest ones are distributed
constexpr double least_tail_index = 1.05;  // tails have a mean
constexpr double largest_unseen = 0.5;     // of scores beyond those expected, in standard errors
/// Of telescopes' walks, at least: with fewer they have hardly ever come near the beam, and what
/// only they can find has not been seen (decision 39).
constexpr double least_scores_with_telescope = 300;
/// Of environments scores are not counted by octave: their second moment stands in no fewer scores
/// than 30, as sums of fourth powers tell.
constexpr double largest_fourth_share = 1.0 / 30;

using Octaves = std::array<std::uint64_t, score_octaves>;

double scores_in(const Octaves& octaves) {
  return static_cast<double>(std::accumulate(octaves.begin(), octaves.end(), std::uint64_t{0}));
}
Octaves sum(const Octaves& a, const Octaves& b) {
  Octaves out{};
  std::ranges::transform(a, b, out.begin(), std::plus());
  return out;
}

/// What is to be expected of scores larger than any expected so far, if the largest ones follow a
/// Pareto distribution: its index by maximum likelihood from the octaves that hold the top of all
/// scores (Hill's estimator, Ann. Stat. 3, 1163 (1975), of geometrically distributed octaves). It
/// hardly depends on whether the very largest have come, as it must not: flags that do pick runs
/// that lack them. Infinite of too few scores.
double unseen_sum(const Octaves& octaves) {
  double top = 0;    // scores in the octaves seen so far, from the largest down
  double above = 0;  // octaves between each of them and the present one, all together
  for (int k = score_octaves - 1; k >= 0; --k) {
    above += top;
    top += static_cast<double>(octaves[static_cast<std::size_t>(k)]);
    if (top < tail_scores) continue;
    const double index = std::max(least_tail_index, std::log2(1 + top / above));
    const double exceeded_once = std::ldexp(std::pow(top, 1 / index), k - score_octaves);
    return exceeded_once / (1 - 1 / index);
  }
  return std::numeric_limits<double>::infinity();
}

/// Whether few scores carry the second moment.
bool heavy(const Powers& p) { return p.fourth > largest_fourth_share * p.square * p.square; }

}  // namespace

bool Totals::heavy_tail(std::size_t cell) const {
  const double error = error_of_sum(state_.echo[cell].low, counted(cell));
  const auto too_much = [error](const Octaves& octaves) {
    return unseen_sum(octaves) > largest_unseen * error;
  };
  const Octaves* kinds = &state_.octaves[cell * shape_->walked];
  if (shape_->walked == 1) return too_much(kinds[0]);
  return std::any_of(kinds, kinds + kinds_of_walked,
                     [&](const Octaves& kind) {
                       return scores_in(kind) >= tail_scores && too_much(kind);
                     }) ||
         too_much(sum(kinds[0], kinds[1]));
}

bool Totals::beam_missed(std::size_t cell) const {
  if (shape_->walked == 1) return false;
  // Light scattered once the laser's walks find alone, all of it.
  if (shape_->max_order == 1) return false;
  return scores_in(state_.octaves[cell * shape_->walked + kind_of(Walked::both)]) <
         least_scores_with_telescope;
}

Totals::Health Totals::health_of(const TailSums& s, double largest, const Counted& n) {
  if (s.low.x == 0) return {no_score, 0, 0};
  Health health;
  health.variance_of_variance = variance_of_variance(s, n);
  health.largest_score_share = largest / s.low.x;
  health.raise(n.batches < least_batches, few_batches);
  health.raise(standard_error(s.low, n) > largest_relative_error * mean(s.low, n), large_error);
  health.raise(health.largest_score_share > largest_single_share, large_score);
  return health;
}

Totals::Health Totals::health(std::size_t cell) const {
  Health health = health_of(state_.echo[cell], state_.largest[cell], counted(cell));
  if ((health.flags & no_score) != 0) return health;
  health.raise(heavy_tail(cell), ConvergenceFlag::heavy_tail);
  health.raise(beam_missed(cell), ConvergenceFlag::beam_missed);
  return health;
}

std::int32_t Totals::difference_flags(const EnvironmentSums& s, const Counted& n) {
  Health own;
  own.raise(variance_of_variance(s.difference, n) > largest_variance_of_variance,
            uncertain_variance);
  own.raise(heavy(s.of_differences), ConvergenceFlag::heavy_tail);
  return own.flags;
}

std::int32_t Totals::environment_flags(std::size_t cell, std::size_t environment) const {
  const EnvironmentSums& s = state_.environment[cell * shape_->environments + environment];
  Health own = health_of(s.echo, s.largest, counted(cell));
  own.raise(heavy(s.of_scores), ConvergenceFlag::heavy_tail);
  own.raise(own.variance_of_variance > largest_variance_of_variance, uncertain_variance);
  return own.flags | difference_flags(s, counted(cell));
}

std::int32_t Totals::tangent_flags(std::size_t cell, std::size_t tangent) const {
  return difference_flags(state_.environment[cell * shape_->environments + tangent], counted(cell));
}

bool Totals::row_converged(std::size_t row, double relative_error) const {
  for (std::size_t cell = row * shape_->gates; cell < (row + 1) * shape_->gates; ++cell) {
    const Sums& s = state_.echo[cell].low;
    if (s.x == 0) continue;
    const Counted n = counted(cell);
    if (standard_error(s, n) > relative_error * mean(s, n) || health(cell).flags != 0) return false;
  }
  return true;
}

bool Totals::all_converged(double relative_error) const {
  for (std::size_t row = 0; row < shape_->rows(); ++row)
    if (!row_converged(row, relative_error)) return false;
  return true;
}

std::size_t Totals::converged_cells() const {
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < state_.echo.size(); ++cell) count += health(cell).flags == 0;
  return count;
}

std::size_t Totals::scored_cells() const {
  std::size_t count = 0;
  for (const TailSums& s : state_.echo) count += s.low.x > 0;
  return count;
}

double Totals::worst_error() const {
  double worst = 0;
  for (std::size_t cell = 0; cell < state_.echo.size(); ++cell) {
    const Sums& s = state_.echo[cell].low;
    if (s.x == 0) continue;
    const double error = standard_error(s, counted(cell)) / mean(s, counted(cell));
    if (!(error <= worst)) worst = error;
  }
  return worst;
}

void Totals::let_rest_at(double relative_error) {
  if (state_.resting_target == relative_error) return;
  state_.resting_target = relative_error;
  for (Row& row : state_.row) row.rests = row.will_rest = 0;
}

void Totals::decide_rests() {
  if (state_.resting_target == 0) return;
  for (std::size_t r = 0; r < state_.row.size(); ++r) {
    Row& row = state_.row[r];
    const auto first = state_.echo.begin() + static_cast<std::ptrdiff_t>(r * shape_->gates);
    const bool scored = std::any_of(first, first + static_cast<std::ptrdiff_t>(shape_->gates),
                                    [](const TailSums& s) { return s.low.x > 0; });
    const bool rests = scored && row_converged(r, state_.resting_target);
    row.rests = std::exchange(row.will_rest, rests ? 1 : 0);
  }
}

std::vector<bool> Totals::resting(bool after_next_look) const {
  std::vector<bool> out;
  for (const Row& row : state_.row)
    out.push_back((after_next_look ? row.will_rest : row.rests) != 0);
  return out;
}

}  // namespace photic::tally
