#include "tally/totals.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/error.hpp"

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
/// Of environments scores are not counted by octave: their second moment stands in no fewer scores
/// than 30, as sums of fourth powers tell.
constexpr double largest_fourth_share = 1.0 / 30;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double error_of_sum(const Sums& s, const Totals::Counted& n) {
  const double spread = std::max(0.0, s.xx - s.x * s.x / n.photons);
  return n.batches > 1 ? std::sqrt(spread / (n.batches - 1) * n.photons) : 0.0;
}

double variance_of_variance(const TailSums& s, const Totals::Counted& n) {
  const auto [second, fourth] = s.central(n.photons);
  return second > 0 ? std::max(0.0, fourth / (second * second) - 1) / n.batches : 0.0;
}

/// What is to be expected of scores larger than any expected so far, if the largest ones follow a
/// Pareto distribution: its index by maximum likelihood from the octaves that hold the top of all
/// scores (Hill's estimator, Ann. Stat. 3, 1163 (1975), of geometrically distributed octaves). It
/// hardly depends on whether the very largest have come, as it must not: flags that do pick runs
/// that lack them. Infinite of too few scores.
double unseen_sum(const std::array<std::uint64_t, score_octaves>& octaves) {
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

/// The one of two ways to the same sum that loses no digits: an environment like the scene has the
/// scene's echo to the last bit, one without light has none.
double environment_echo(double echo, double difference, double scored) {
  return std::abs(difference) < echo / 2 ? echo + difference : scored;
}

/// Whether few scores carry the second moment.
bool heavy(const Powers& p) { return p.fourth > largest_fourth_share * p.square * p.square; }

/// Standard error of the ratio of two correlated means, to first order (Cochran, Sampling
/// Techniques, 3rd ed. (1977), chapter 6; docs/theory.md, eq. 48). The covariance follows from the
/// error of the sum.
double error_of_ratio(double ratio, double denominator, double error_of_numerator,
                      double error_of_denominator, double error_of_sum) {
  const double of_numerator = error_of_numerator * error_of_numerator;
  const double of_denominator = error_of_denominator * error_of_denominator;
  const double covariance = (error_of_sum * error_of_sum - of_numerator - of_denominator) / 2;
  const double variance = of_numerator - 2 * ratio * covariance + ratio * ratio * of_denominator;
  return std::sqrt(std::max(0.0, variance)) / denominator;
}

/// Flags gates most of whose neighbours are flagged, in the rows that the flags from one cell on
/// are made of. Weights that degenerate do so in all of them alike: a gate that seems right there
/// lacks the rare scores.
void flag_among_flagged(std::size_t first, std::size_t gates, std::vector<std::int32_t>& flags) {
  constexpr std::size_t reach = 2;
  const std::vector<std::int32_t> own = flags;
  for (std::size_t i = first; i < own.size(); ++i) {
    const std::size_t row = i - (i - first) % gates;
    int flagged = 0;
    int scored = 0;
    for (std::size_t k = std::max(row + reach, i) - reach; k < std::min(row + gates, i + reach + 1);
         ++k) {
      if ((own[k] & no_score) != 0) continue;
      ++scored;
      flagged += own[k] != 0;
    }
    if (own[i] == 0 && 2 * flagged > scored) flags[i] = among_flagged;
  }
}

bool fits(const TotalsState& state, const Shape& shape) {
  const std::size_t cells = shape.cells(), snapshots = snapshots_at(state.batches);
  return state.row.size() == shape.rows() && state.echo.size() == cells &&
         state.by_order.size() == cells * shape.orders &&
         state.by_process.size() == cells * shape.processes &&
         state.by_depth.size() == cells * shape.depths && state.cut_order.size() == cells &&
         state.largest.size() == cells && state.octaves.size() == cells &&
         state.environment.size() == cells * shape.environments &&
         state.snapshot_photons.size() == snapshots * shape.rows() &&
         state.snapshot_batches.size() == snapshots * shape.rows() &&
         state.snapshot_echo.size() == snapshots * cells;
}

}  // namespace

Totals::Totals(const Shape& shape, TotalsState state) : shape_(&shape), state_(std::move(state)) {
  expect(fits(state_, shape), "totals go on from a state of their own shape");
}

void Totals::merge(const BatchTally& batch) {
  const auto n = static_cast<double>(batch.photons);
  for (const std::uint32_t cell : batch.touched_cells) {
    if (batch.rests[shape_->row_of(cell)]) continue;
    double echo = 0;
    for (std::size_t o = cell * shape_->orders; o < (cell + 1) * shape_->orders; ++o) {
      echo += batch.by_order[o];
      if (batch.by_order[o] > 0) state_.by_order[o].add(batch.by_order[o], n);
    }
    for (std::size_t p = cell * shape_->processes; p < (cell + 1) * shape_->processes; ++p) {
      if (batch.by_process[p] > 0) state_.by_process[p].add(batch.by_process[p], n);
    }
    state_.echo[cell].add(echo, n);
    state_.cut_order[cell] += batch.cut_order[cell];
    state_.largest[cell] = std::max(state_.largest[cell], batch.largest[cell]);
    for (std::size_t k = 0; k < score_octaves; ++k)
      state_.octaves[cell][k] += batch.octaves[cell][k];
    merge_environments(batch, cell, echo);
  }
  for (const std::uint32_t k : batch.touched_depths) {
    if (!batch.rests[shape_->row_of(k / shape_->depths)])
      state_.by_depth[k].add(batch.by_depth[k], n);
  }
  for (std::size_t r = 0; r < state_.row.size(); ++r) {
    if (batch.rests[r]) continue;
    state_.row[r].photons += batch.photons;
    ++state_.row[r].batches;
  }

  state_.photons += batch.photons;
  ++state_.batches;
  state_.collisions += batch.collisions;
  state_.scores += batch.scores;
  state_.too_many_events += batch.too_many_events;
  state_.not_finite += batch.not_finite;
  state_.ledger.absorbed += batch.ledger.absorbed;
  state_.ledger.escaped += batch.ledger.escaped;
  state_.ledger.sea_bed += batch.ledger.sea_bed;
  state_.ledger.cut_by_time += batch.ledger.cut_by_time;
  state_.ledger.cut_by_order += batch.ledger.cut_by_order;
  state_.ledger.cut_by_weight += batch.ledger.cut_by_weight;
  state_.ledger.roulette += batch.ledger.roulette;
  state_.ledger.lost += batch.ledger.lost;

  if (std::has_single_bit(state_.batches)) {
    for (const Row& row : state_.row) {
      state_.snapshot_photons.push_back(static_cast<double>(row.photons));
      state_.snapshot_batches.push_back(static_cast<double>(row.batches));
    }
    for (const TailSums& s : state_.echo) state_.snapshot_echo.push_back(s.low);
  }
}

void Totals::merge_environments(const BatchTally& batch, std::size_t cell, double echo) {
  const auto n = static_cast<double>(batch.photons);
  for (std::size_t e = 0; e < shape_->environments; ++e) {
    const std::size_t group = cell * batch.environment_groups + e / EnvironmentScores::size;
    const std::size_t k = e % EnvironmentScores::size;
    const EnvironmentScores& scored = batch.environment[group];
    EnvironmentSums& sums = state_.environment[cell * shape_->environments + e];
    sums.echo.add(environment_echo(echo, scored.difference[k], scored.echo[k]), n);
    sums.difference.add(scored.difference[k], n);
    sums.largest = std::max(sums.largest, scored.largest[k]);
    sums.of_scores = sums.of_scores + Powers{scored.squares[k], scored.fourths[k]};
    sums.of_differences = sums.of_differences + Powers{scored.squares_of_differences[k],
                                                       scored.fourths_of_differences[k]};
  }
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

Totals::Counted Totals::counted(std::size_t cell) const {
  const Row& row = state_.row[shape_->row_of(cell)];
  return {static_cast<double>(row.photons), static_cast<double>(row.batches)};
}

double Totals::mean(const Sums& sums, const Counted& n) { return sums.x / n.photons; }

double Totals::standard_error(const Sums& sums, const Counted& n) {
  return error_of_sum(sums, n) / n.photons;
}

bool Totals::heavy_tail(std::size_t cell) const {
  const double error = error_of_sum(state_.echo[cell].low, counted(cell));
  return unseen_sum(state_.octaves[cell]) > largest_unseen * error;
}

double Totals::error_growth(std::size_t cell) const {
  if (state_.echo[cell].low.x == 0) return nan;
  const Counted n = counted(cell);
  const std::size_t rows = shape_->rows(), row = shape_->row_of(cell);
  for (std::size_t k = state_.snapshot_batches.size() / rows; k-- > 0;) {
    const Counted then{state_.snapshot_photons[k * rows + row],
                       state_.snapshot_batches[k * rows + row]};
    if (4 * then.batches > n.batches) continue;
    const double before = error_of_sum(state_.snapshot_echo[k * state_.echo.size() + cell], then) /
                          std::sqrt(then.photons);
    const double now = error_of_sum(state_.echo[cell].low, n) / std::sqrt(n.photons);
    return before > 0 ? now / before : nan;
  }
  return nan;
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

void Totals::estimate(const Sums& sums, std::size_t cell, Estimates& out) const {
  const Counted n = counted(cell);
  out.mean.push_back(mean(sums, n));
  out.standard_error.push_back(standard_error(sums, n));
}

void Totals::fill_environment(std::size_t environment, Result& result) const {
  const std::size_t first = result.environment_convergence_flags.size();
  for (std::size_t cell = 0; cell < state_.echo.size(); ++cell) {
    const EnvironmentSums& s = state_.environment[cell * shape_->environments + environment];
    estimate(s.echo.low, cell, result.environment_echo);
    estimate(s.difference.low, cell, result.environment_difference);
    result.environment_convergence_flags.push_back(
        environment_flags(cell, environment) |
        (result.convergence_flags[cell] & ConvergenceFlag::heavy_tail));
  }
  flag_among_flagged(first, shape_->gates, result.environment_convergence_flags);
}

void Totals::fill_sensitivity(std::size_t tangent, double value, Result& result) const {
  const std::size_t first = result.sensitivity_convergence_flags.size();
  for (std::size_t cell = 0; cell < state_.echo.size(); ++cell) {
    const EnvironmentSums& s = state_.environment[cell * shape_->environments + tangent];
    const Sums& scene = state_.echo[cell].low;
    const Counted n = counted(cell);
    const double echo = mean(scene, n);
    const double change = mean(s.difference.low, n);  // p d echo / d p
    const double error = standard_error(s.difference.low, n);
    result.sensitivity.mean.push_back(change / value);
    result.sensitivity.standard_error.push_back(error / std::abs(value));
    Estimates& logarithmic = result.logarithmic_sensitivity;
    logarithmic.mean.push_back(echo > 0 ? change / echo : nan);
    logarithmic.standard_error.push_back(echo > 0 ? error_of_ratio(change / echo, echo, error,
                                                                   standard_error(scene, n),
                                                                   standard_error(s.echo.low, n))
                                                  : nan);
    result.sensitivity_convergence_flags.push_back(result.convergence_flags[cell] |
                                                   tangent_flags(cell, tangent));
  }
  flag_among_flagged(first, shape_->gates, result.sensitivity_convergence_flags);
}

void Totals::fill(Result& result) const {
  const auto gates = shape_->gates;
  for (std::size_t cell = 0; cell < state_.echo.size(); ++cell) {
    estimate(state_.echo[cell].low, cell, result.echo);
    const Health h = health(cell);
    result.convergence_flags.push_back(h.flags);
    result.variance_of_variance.push_back(h.variance_of_variance);
    result.error_growth.push_back(error_growth(cell));
    result.largest_score_share.push_back(h.largest_score_share);
    const double x = state_.echo[cell].low.x;
    result.order_cut_share.push_back(x > 0 ? state_.cut_order[cell] / x : 0.0);
  }
  // The result has gates last but for the depths.
  for (std::size_t tc = 0; tc < shape_->rows(); ++tc) {
    result.channel_photons.push_back(state_.row[tc].photons);
    for (std::size_t p = 0; p < shape_->processes; ++p) {
      for (std::size_t g = 0; g < gates; ++g) {
        const std::size_t cell = tc * gates + g;
        estimate(state_.by_process[cell * shape_->processes + p], cell, result.echo_by_process);
      }
    }
    for (std::size_t o = 0; o < shape_->orders; ++o) {
      for (std::size_t g = 0; g < gates; ++g) {
        const std::size_t cell = tc * gates + g;
        estimate(state_.by_order[cell * shape_->orders + o], cell, result.echo_by_order);
      }
    }
  }
  for (std::size_t k = 0; k < state_.by_depth.size(); ++k)
    estimate(state_.by_depth[k], k / shape_->depths, result.echo_by_depth);
  const std::size_t parameters = result.parameter_value.size();
  expect(parameters <= shape_->environments, "every parameter has a tangent");
  const std::size_t environments = shape_->environments - parameters;
  for (std::size_t e = 0; e < environments; ++e) fill_environment(e, result);
  for (std::size_t p = 0; p < parameters; ++p)
    fill_sensitivity(environments + p, result.parameter_value[p], result);

  const double per_photon = state_.photons > 0 ? 1.0 / static_cast<double>(state_.photons) : 0.0;
  result.ledger = {
      state_.ledger.absorbed * per_photon,     state_.ledger.escaped * per_photon,
      state_.ledger.sea_bed * per_photon,      state_.ledger.cut_by_time * per_photon,
      state_.ledger.cut_by_order * per_photon, state_.ledger.cut_by_weight * per_photon,
      state_.ledger.roulette * per_photon,     state_.ledger.lost * per_photon};
  result.photons = state_.photons;
  result.batches = state_.batches;
  result.collisions = state_.collisions;
  result.lost_too_many_events = state_.too_many_events;
  result.lost_not_finite = state_.not_finite;
}

}  // namespace photic::tally
