// Sums over batches, and the estimates made of them.
//
// A batch of n photons that scored X in a cell enters as X and X^2/n; means and errors follow
// without any batch being kept. Batches are merged in their order, so that sums do not depend on
// threads.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tally/batch_tally.hpp"
#include "tally/result.hpp"

namespace photic::tally {

/// Power sums of the batches' scores in one cell.
struct Sums {
  double x = 0, xx = 0;
  void add(double score, double photons) {
    x += score;
    xx += score * score / photons;
  }
};

/// The same with what the shape of the distribution needs.
struct TailSums {
  Sums low;
  void add(double score, double photons);

  /// Second and fourth central moments of the batches' means per photon, each batch weighted by its
  /// photons; of `all_photons`, those whose batches did not score included.
  struct Moments {
    double second = 0, fourth = 0;
  };
  [[nodiscard]] Moments central(double all_photons) const;

 private:
  // Powers of the distance from the first batch that scored: raw powers of a quiet gate would
  // differ from its moments in all digits.
  double origin_ = 0, photons_ = 0;
  std::array<double, 4> power_{};  ///< sums of n (X/n - origin)^k, k = 1 … 4
};

/// The state of one echo cell at an earlier number of batches.
struct Snapshot {
  double photons = 0, batches = 0;
  std::vector<Sums> echo;
};

class Totals {
 public:
  explicit Totals(const Shape& shape);

  /// Adds a batch. Batches come in their order.
  void merge(const BatchTally& batch);

  /// Mean and standard error of the mean per photon.
  [[nodiscard]] double mean(const Sums& sums) const;
  [[nodiscard]] double standard_error(const Sums& sums) const;

  /// Bits of ConvergenceFlag of an echo cell, the variance of its variance, its largest score's
  /// share.
  struct Health {
    std::int32_t flags = 0;
    double variance_of_variance = 0, largest_score_share = 0;
  };
  [[nodiscard]] Health health(std::size_t cell) const;

  /// Whether every cell that has been scored in is below the relative error and not flagged.
  [[nodiscard]] bool all_converged(double relative_error) const;
  [[nodiscard]] std::size_t converged_cells() const;
  [[nodiscard]] std::size_t scored_cells() const;

  /// Estimates and counts of the tallies into a result.
  void fill(Result& result) const;

  [[nodiscard]] std::uint64_t photons() const { return photons_; }
  [[nodiscard]] std::uint64_t scores() const {
    return scores_;
  }  ///< offered, seen in a gate or not

 private:
  [[nodiscard]] bool heavy_tail(std::size_t cell) const;
  [[nodiscard]] bool error_not_falling(std::size_t cell) const;

  const Shape* shape_;
  std::uint64_t photons_ = 0, batches_ = 0, collisions_ = 0, scores_ = 0, too_many_events_ = 0,
                not_finite_ = 0;
  std::vector<TailSums> echo_;
  std::vector<Sums> by_order_, by_process_, by_depth_;
  std::vector<double> cut_order_, largest_;
  std::vector<std::array<std::uint64_t, score_octaves>> octaves_;
  std::vector<Snapshot> snapshots_;  ///< at 2^k batches
  Ledger ledger_;
};

}  // namespace photic::tally
