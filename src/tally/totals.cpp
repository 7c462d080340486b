#include "tally/totals.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace photic::tally {
namespace {

// The thresholds below were set on runs against converged references (docs/theory.md, "Error
// bars").
constexpr double least_batches = 30;
constexpr double largest_relative_error = 0.10;
constexpr double largest_single_share = 0.02;
constexpr double largest_variance_of_variance =
    0.1;                           // as MCNP asks for: X-5 Monte Carlo Team, LA-UR-03-1987 (2003)
constexpr double few_scores = 30;  // scores that make up the top of a distribution
constexpr double largest_top_share = 0.50;  // of the second moment, in those few
constexpr double largest_error_growth =
    1.4;  // of error * sqrt(photons), over a factor of four in photons

double error_of_sum(const Sums& s, double photons, double batches) {
  const double spread = std::max(0.0, s.xx - s.x * s.x / photons);
  return batches > 1 ? std::sqrt(spread / (batches - 1) * photons) : 0.0;
}

}  // namespace

void TailSums::add(double score, double photons) {
  low.add(score, photons);
  const double mean = score / photons;
  if (photons_ == 0) origin_ = mean;
  photons_ += photons;
  double weighted = photons;
  for (double& sum : power_) sum += weighted *= mean - origin_;
}

TailSums::Moments TailSums::central(double all_photons) const {
  std::array<double, 4> about_origin{};
  double missed = all_photons - photons_;
  for (std::size_t k = 0; k < about_origin.size(); ++k)
    about_origin[k] = (power_[k] + (missed *= -origin_)) / all_photons;
  const auto& [m1, m2, m3, m4] = about_origin;
  return {std::max(0.0, m2 - m1 * m1), m4 - 4 * m1 * m3 + 6 * m1 * m1 * m2 - 3 * m1 * m1 * m1 * m1};
}

Totals::Totals(const Shape& shape)
    : shape_(&shape),
      echo_(shape.cells()),
      by_order_(shape.cells() * shape.orders),
      by_process_(shape.cells() * shape.processes),
      by_depth_(shape.cells() * shape.depths),
      cut_order_(shape.cells()),
      largest_(shape.cells()),
      octaves_(shape.cells()) {}

void Totals::merge(const BatchTally& batch) {
  const auto n = static_cast<double>(batch.photons);
  for (const std::uint32_t cell : batch.touched_cells) {
    double echo = 0;
    for (std::size_t o = cell * shape_->orders; o < (cell + 1) * shape_->orders; ++o) {
      echo += batch.by_order[o];
      if (batch.by_order[o] > 0) by_order_[o].add(batch.by_order[o], n);
    }
    for (std::size_t p = cell * shape_->processes; p < (cell + 1) * shape_->processes; ++p) {
      if (batch.by_process[p] > 0) by_process_[p].add(batch.by_process[p], n);
    }
    echo_[cell].add(echo, n);
    cut_order_[cell] += batch.cut_order[cell];
    largest_[cell] = std::max(largest_[cell], batch.largest[cell]);
    for (std::size_t k = 0; k < score_octaves; ++k) octaves_[cell][k] += batch.octaves[cell][k];
  }
  for (const std::uint32_t k : batch.touched_depths) by_depth_[k].add(batch.by_depth[k], n);

  photons_ += batch.photons;
  ++batches_;
  collisions_ += batch.collisions;
  scores_ += batch.scores;
  too_many_events_ += batch.too_many_events;
  not_finite_ += batch.not_finite;
  ledger_.absorbed += batch.ledger.absorbed;
  ledger_.escaped += batch.ledger.escaped;
  ledger_.sea_bed += batch.ledger.sea_bed;
  ledger_.cut_by_time += batch.ledger.cut_by_time;
  ledger_.cut_by_order += batch.ledger.cut_by_order;
  ledger_.roulette += batch.ledger.roulette;
  ledger_.lost += batch.ledger.lost;

  if (std::has_single_bit(batches_)) {
    Snapshot now{static_cast<double>(photons_), static_cast<double>(batches_), {}};
    for (const TailSums& s : echo_) now.echo.push_back(s.low);
    snapshots_.push_back(std::move(now));
  }
}

double Totals::mean(const Sums& sums) const { return sums.x / static_cast<double>(photons_); }

double Totals::standard_error(const Sums& sums) const {
  const auto photons = static_cast<double>(photons_);
  return error_of_sum(sums, photons, static_cast<double>(batches_)) / photons;
}

bool Totals::heavy_tail(std::size_t cell) const {
  double top_count = 0;
  double top = 0;
  double all = 0;
  for (int k = score_octaves - 1; k >= 0; --k) {
    const auto count = static_cast<double>(octaves_[cell][static_cast<std::size_t>(k)]);
    if (count == 0) continue;
    const double square =
        std::ldexp(1.0, 2 * (k - score_octaves));  // of a score of this octave, about
    const double taken = std::min(count, few_scores - top_count);
    top += taken * square;
    top_count += taken;
    all += count * square;
  }
  return top > largest_top_share * all;
}

bool Totals::error_not_falling(std::size_t cell) const {
  if (snapshots_.size() < 3) return false;
  const Snapshot& before = snapshots_[snapshots_.size() - 3];
  const auto photons = static_cast<double>(photons_);
  const double now =
      error_of_sum(echo_[cell].low, photons, static_cast<double>(batches_)) / std::sqrt(photons);
  const double then =
      error_of_sum(before.echo[cell], before.photons, before.batches) / std::sqrt(before.photons);
  return now > largest_error_growth * then;
}

Totals::Health Totals::health(std::size_t cell) const {
  const TailSums& s = echo_[cell];
  if (s.low.x == 0) return {no_score, 0, 0};
  const auto n = static_cast<double>(photons_);
  const auto b = static_cast<double>(batches_);
  const double m = s.low.x / n;
  const auto [second, fourth] = s.central(n);
  Health health;
  health.variance_of_variance =
      second > 0 ? std::max(0.0, fourth / (second * second) - 1) / b : 0.0;
  health.largest_score_share = largest_[cell] / s.low.x;
  const auto raise = [&](bool condition, ConvergenceFlag flag) {
    health.flags |= condition ? flag : 0;
  };
  raise(b < least_batches, few_batches);
  raise(standard_error(s.low) > largest_relative_error * m, large_error);
  raise(health.largest_score_share > largest_single_share, large_score);
  raise(health.variance_of_variance > largest_variance_of_variance, uncertain_variance);
  raise(heavy_tail(cell), ConvergenceFlag::heavy_tail);
  raise(error_not_falling(cell), ConvergenceFlag::error_not_falling);
  return health;
}

bool Totals::all_converged(double relative_error) const {
  for (std::size_t cell = 0; cell < echo_.size(); ++cell) {
    const Sums& s = echo_[cell].low;
    if (s.x == 0) continue;
    if (standard_error(s) > relative_error * mean(s) || health(cell).flags != 0) return false;
  }
  return true;
}

std::size_t Totals::converged_cells() const {
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < echo_.size(); ++cell) count += health(cell).flags == 0;
  return count;
}

std::size_t Totals::scored_cells() const {
  std::size_t count = 0;
  for (const TailSums& s : echo_) count += s.low.x > 0;
  return count;
}

void Totals::fill(Result& result) const {
  const auto estimate = [this](Estimates& out, const Sums& s) {
    out.mean.push_back(mean(s));
    out.standard_error.push_back(standard_error(s));
  };
  const auto gates = shape_->gates;
  for (std::size_t cell = 0; cell < echo_.size(); ++cell) {
    estimate(result.echo, echo_[cell].low);
    const Health h = health(cell);
    result.convergence_flags.push_back(h.flags);
    result.variance_of_variance.push_back(h.variance_of_variance);
    result.largest_score_share.push_back(h.largest_score_share);
    const double x = echo_[cell].low.x;
    result.order_cut_share.push_back(x > 0 ? cut_order_[cell] / x : 0.0);
  }
  // The result has gates last but for the depths.
  for (std::size_t tc = 0; tc < shape_->telescopes * shape_->channels; ++tc) {
    for (std::size_t p = 0; p < shape_->processes; ++p) {
      for (std::size_t g = 0; g < gates; ++g) {
        estimate(result.echo_by_process, by_process_[(tc * gates + g) * shape_->processes + p]);
      }
    }
    for (std::size_t o = 0; o < shape_->orders; ++o) {
      for (std::size_t g = 0; g < gates; ++g) {
        estimate(result.echo_by_order, by_order_[(tc * gates + g) * shape_->orders + o]);
      }
    }
  }
  for (const Sums& s : by_depth_) estimate(result.echo_by_depth, s);

  const double per_photon = photons_ > 0 ? 1.0 / static_cast<double>(photons_) : 0.0;
  result.ledger = {ledger_.absorbed * per_photon,     ledger_.escaped * per_photon,
                   ledger_.sea_bed * per_photon,      ledger_.cut_by_time * per_photon,
                   ledger_.cut_by_order * per_photon, ledger_.roulette * per_photon,
                   ledger_.lost * per_photon};
  result.photons = photons_;
  result.batches = batches_;
  result.collisions = collisions_;
  result.lost_too_many_events = too_many_events_;
  result.lost_not_finite = not_finite_;
}

}  // namespace photic::tally
