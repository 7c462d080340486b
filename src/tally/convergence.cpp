// Tests of whether the totals' error bars can be relied on, and of which rows need no more photons.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "tally/totals.hpp"

namespace photic::tally {
namespace {

// The thresholds below were set on runs against converged references (docs/theory.md, "Error
// bars").
constexpr double min_batches = 30;
constexpr double largest_relative_error = 0.10;
constexpr double tail_scores = 100;  // at least, to see how the largest ones are distributed
/// Scores like 1 / d^2, of points a distance d away, exceed x with a chance as x^-1.5: taken to be
/// known as well as if by tail_scores scores.
constexpr double expected_index = 1.5;
constexpr double min_tail_index = 1.05;  // tails have a mean
constexpr double largest_unseen = 1;     // in standard errors of the batches
/// Scores that fewer runs have are not in the errors: an interval of 95 % leaves out so many on a
/// side, and tails do not go on for ever (decision 51).
constexpr double share_of_runs = 1.0 / 40;
/// Below this chance that no larger score has come, scores have a bound. A run has hundreds of
/// gates, with several octaves each, and is to have none by chance (decision 51).
constexpr double unlikely = 1e-4;
/// The least number of scores of telescopes' walks: with fewer they have hardly ever come near the
/// beam, and the light that only they can find has not been seen (decision 39).
constexpr double min_scores_with_telescope = 300;
/// The share of an echo that its flags do not ask about (decision 47).
constexpr double negligible_share = 1e-3;
// Scores of environments and differences are not counted by octave, and ratios of the waters give
// them tails of their own: their second moment stands in no fewer scores than 30, by sums of fourth
// powers, and their variance is known as MCNP asks for (X-5 Monte Carlo Team, LA-UR-03-1987
// (2003)).
constexpr double largest_fourth_share = 1.0 / 30;
constexpr double largest_variance_of_variance = 0.1;

double scores_in(const Octaves& octaves) {
  return static_cast<double>(std::accumulate(octaves.begin(), octaves.end(), std::uint64_t{0}));
}

/// About the sum of a power of the scores, taken to be spread evenly over their octaves.
double sum_of_powers(const Octaves& octaves, int power) {
  double sum = 0;
  for (int k = 0; k < score_octaves; ++k)
    sum += std::ldexp(static_cast<double>(octaves[static_cast<std::size_t>(k)]),
                      power * (k - score_octaves));
  return sum * (std::exp2(power) - 1) / (power * std::numbers::ln2);
}

/// A Pareto distribution of the scores from an octave up.
struct Tail {
  int octave = 0;
  double index = 0, scores = 0;
};

/// The chance that a tail's scores are as close below the largest one as they are, none of them
/// beyond it: the least, over the octaves, of the chances of all the scores from an octave up, but
/// for the largest (Aban, Meerschaert and Panorska, J. Am. Stat. Assoc. 101, 270 (2006), for one
/// threshold). Where the largest score of all is in a higher octave than these, the edge of their
/// own highest octave takes its place.
double chance_of_no_larger(const Tail& tail, const Octaves& octaves, double largest) {
  double chance = 1;
  double above = 0;
  for (int k = score_octaves - 1; k >= tail.octave; --k) {
    const double edge = std::ldexp(1.0, k - score_octaves);
    if (above == 0) largest = std::min(largest, 2 * edge);
    above += static_cast<double>(octaves[static_cast<std::size_t>(k)]);
    if (above > 0 && edge < largest)
      chance = std::min(chance, std::pow(1 - std::pow(edge / largest, tail.index), above - 1));
  }
  return chance;
}

/// The tail of the scores: its index from the octaves that hold the top of all scores (Hill's
/// estimator, Ann. Stat. 3, 1163 (1975), of geometrically distributed octaves), with scores of the
/// expected index added to them. None of too few scores.
std::optional<Tail> tail_of(const Octaves& octaves) {
  const double above_expected = tail_scores / (std::exp2(expected_index) - 1);
  double top = 0;    // scores in the octaves seen so far, from the largest down
  double above = 0;  // octaves between each of them and the present one, all together
  for (int k = score_octaves - 1; k >= 0; --k) {
    above += top;
    top += static_cast<double>(octaves[static_cast<std::size_t>(k)]);
    if (top < tail_scores) continue;
    const double index = std::log2(1 + (top + tail_scores) / (above + above_expected));
    return Tail{k, std::max(min_tail_index, index), top};
  }
  return std::nullopt;
}

/// The scores to be expected larger than any expected so far, if the largest ones follow a Pareto
/// distribution. They hardly depend on whether the very largest have come, as they must not: flags
/// that do pick runs that lack them. Only where so many scores are so close to the largest that no
/// such distribution is likely, these have a bound, and nothing is beyond it. Scores that come
/// `together` count as one there. Infinite of too few scores.
Unseen unseen_beyond(const Octaves& octaves, double largest, double together) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const std::optional<Tail> tail = tail_of(octaves);
  if (!tail) return {infinite, infinite};
  const double chance = std::pow(chance_of_no_larger(*tail, octaves, largest), 1 / together);
  const double exceeded_once =
      std::ldexp(std::pow(tail->scores, 1 / tail->index), tail->octave - score_octaves);
  const double more = 1 - 1 / tail->index;
  const double sum = exceeded_once / more * std::min(1.0, chance / unlikely);
  return {sum, sum * (1 - std::pow(share_of_runs, more))};
}

/// The scores that count as one, such as those of a walk: the variance by batches over that of
/// independent scores, Kish's design effect (Survey Sampling (1965)); at least 1.
double together(const Sums& sums, const Counted& n, const Octaves& octaves) {
  const double of_batches = error_of_sum(sums, n);
  return std::max(1.0, of_batches * of_batches / sum_of_powers(octaves, 2));
}

/// Sum of the scores' fourth powers: the largest one's, and the others'.
double fourth_powers(Octaves octaves, double largest) {
  --octaves[static_cast<std::size_t>(score_octave(largest))];
  return std::pow(largest, 4) + sum_of_powers(octaves, 4);
}

/// Returns whether the unseen part of a sum exceeds its error, and is not negligible.
bool heavy(double unseen, double error, double sum) {
  return unseen > largest_unseen * error && unseen > negligible_share * std::abs(sum);
}

/// Returns whether few scores carry the second moment.
bool heavy(const Powers& p) { return p.fourth > largest_fourth_share * p.square * p.square; }

}  // namespace

std::span<const Octaves> Totals::kinds(std::size_t cell) const {
  return std::span(state_.octaves).subspan(cell * shape_->techniques, shape_->techniques);
}

Octaves Totals::octaves(std::size_t cell) const {
  Octaves sum{};
  for (const Octaves& kind : kinds(cell))
    std::ranges::transform(sum, kind, sum.begin(), std::plus());
  return sum;
}

double Totals::scores_together(std::size_t cell) const {
  return together(state_.echo[cell].low, counted(cell), octaves(cell));
}

Unseen Totals::unseen(std::size_t cell) const {
  const double together = scores_together(cell);
  const double largest = state_.largest[cell];
  Unseen of_kinds;
  for (const Octaves& kind : kinds(cell)) {
    const double scores = scores_in(kind);
    if (scores == 0) continue;  // none of the gate's light is found so
    if (scores < tail_scores) return unseen_beyond(octaves(cell), largest, together);
    of_kinds += unseen_beyond(kind, largest, together);
  }
  return of_kinds;
}

double Totals::fourth_powers(std::size_t cell) const {
  const double largest = state_.largest[cell];
  return largest > 0 ? tally::fourth_powers(octaves(cell), largest) : 0;
}

Totals::Whole Totals::whole(std::size_t cell, std::int32_t flags) const {
  const double x = state_.echo[cell].low.x;
  const Unseen unseen = this->unseen(cell);
  return {flags, unseen, x > 0 ? unseen * (1 / x) : Unseen{}, fourth_powers(cell)};
}

Unseen Totals::unseen_of(const Whole& whole, const Powers& scores) {
  if (scores.fourth == 0) return {};
  return whole.unseen * std::pow(scores.fourth / whole.fourth_powers, 0.25);
}

bool Totals::beam_missed(std::size_t cell) const {
  if (shape_->techniques == 1) return false;
  // Light scattered once the laser's walks find alone, all of it.
  if (shape_->max_order == 1) return false;
  const Octaves& of_laser = kinds(cell)[kind_of(Technique::laser)];
  const Octaves& with_telescope = kinds(cell)[kind_of(Technique::both)];
  if (scores_in(with_telescope) >= min_scores_with_telescope) return false;
  return sum_of_powers(of_laser, 1) + sum_of_powers(with_telescope, 1) >
         negligible_share * state_.echo[cell].low.x;
}

Totals::Health Totals::health_of(const Sums& s, const Counted& n, const Unseen& unseen) {
  if (s.x == 0) return {no_score, 0, 0};
  Health health;
  health.relative_error = reported_error(s, n, unseen) / mean(s, n);
  health.raise(n.batches < min_batches, few_batches);
  const double with_all = with_unseen(standard_error(s, n), unseen.sum / n.photons);
  health.raise(with_all / mean(s, n) > largest_relative_error, large_error);
  health.raise(heavy(unseen.sum, error_of_sum(s, n), s.x), heavy_tail);
  return health;
}

Totals::Health Totals::health(std::size_t cell) const {
  const TailSums& echo = state_.echo[cell];
  Health health = health_of(echo.low, counted(cell), unseen(cell));
  if ((health.flags & no_score) != 0) return health;
  health.variance_of_variance = variance_of_variance(echo, counted(cell));
  health.raise(beam_missed(cell), ConvergenceFlag::beam_missed);
  return health;
}

Unseen Totals::unseen_in_tally(std::size_t cell, bool is_balance) const {
  const TallySums& s = state_.tallies[cell];
  if (is_balance || s.scored.low.x == 0) return {};
  const Octaves& octaves = state_.tally_octaves[cell];
  return unseen_beyond(octaves, s.largest, together(s.scored.low, counted(), octaves));
}

Totals::Health Totals::tally_health(std::size_t cell, bool is_balance) const {
  return health_of(state_.tallies[cell].scored.low, counted(), unseen_in_tally(cell, is_balance));
}

bool Totals::tallies_converged(double relative_error) const {
  std::size_t cell = 0;
  for (const TallyGrid& grid : shape_->tallies)
    for (std::size_t k = 0; k < grid.size(); ++k, ++cell) {
      const Health h = tally_health(cell, grid.is_balance);
      if ((h.flags & no_score) == 0 && (h.flags != 0 || h.relative_error > relative_error))
        return false;
    }
  return true;
}

std::int32_t Totals::difference_flags(std::size_t cell, const Whole& whole,
                                      const EnvironmentSums& s) const {
  const Sums& difference = s.difference.low;
  Health own;
  own.raise(heavy(unseen_of(whole, s.of_differences).sum, error_of_sum(difference, counted(cell)),
                  difference.x),
            heavy_tail);
  own.raise(heavy(s.of_differences), heavy_tail);
  own.raise(variance_of_variance(s.difference, counted(cell)) > largest_variance_of_variance,
            uncertain_variance);
  return own.flags;
}

std::int32_t Totals::environment_flags(std::size_t cell, const Whole& whole,
                                       const EnvironmentSums& s) const {
  Health own = health_of(s.echo.low, counted(cell), unseen_of(whole, s.of_scores));
  own.raise(heavy(s.of_scores), heavy_tail);
  own.raise(variance_of_variance(s.echo, counted(cell)) > largest_variance_of_variance,
            uncertain_variance);
  return own.flags | difference_flags(cell, whole, s);
}

std::int32_t Totals::part_flags(const Sums& part, std::size_t cell, const Whole& whole,
                                bool beside_walks) const {
  const Health own = health_of(part, counted(cell), whole.unseen_share * part.x);
  if ((own.flags & no_score) != 0) return own.flags;
  const std::int32_t shared = heavy_tail | (beside_walks ? 0 : ConvergenceFlag::beam_missed);
  return (own.flags & ~heavy_tail) | (whole.flags & shared);
}

bool Totals::row_converged(std::size_t row, double relative_error) const {
  for (std::size_t cell = row * shape_->gates; cell < (row + 1) * shape_->gates; ++cell) {
    const Health h = health(cell);
    if ((h.flags & no_score) != 0) continue;
    if (h.relative_error > relative_error || h.flags != 0) return false;
  }
  return true;
}

bool Totals::all_converged(double relative_error) const {
  for (std::size_t row = 0; row < shape_->rows(); ++row)
    if (!row_converged(row, relative_error)) return false;
  return tallies_converged(relative_error);
}

std::size_t Totals::converged_cells() const {
  std::size_t count = 0;
  each_health([&](const Health& health) { count += health.flags == 0; });
  return count;
}

std::size_t Totals::scored_cells() const {
  const auto scored = [](const TailSums& s) { return s.low.x > 0; };
  return static_cast<std::size_t>(
      std::ranges::count_if(state_.echo, scored) +
      std::ranges::count_if(state_.tallies, scored, &TallySums::scored));
}

double Totals::worst_error() const {
  double worst = 0;
  each_health([&](const Health& health) {
    if (!(health.relative_error <= worst)) worst = health.relative_error;
  });
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
