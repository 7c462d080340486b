// Sums over batches (state.hpp), and the estimates made of them: means and errors follow without
// any batch being kept. Batches are merged in their order, so that sums do not depend on threads.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "tally/batch_tally.hpp"
#include "tally/error_bars.hpp"
#include "tally/result.hpp"

namespace photic::tally {

class Totals {
 public:
  explicit Totals(const Shape& shape) : Totals(shape, TotalsState(shape)) {}
  /// Goes on from a state of the same shape.
  Totals(const Shape& shape, TotalsState state);

  /// Adds a batch, but for rows that rested in it. Batches come in their order.
  void merge(const BatchTally& batch);

  // Rows whose gates are all converged to a target need no more photons: they rest while others go
  // on, so that every row ends as if it had been simulated alone. Called at looks, a fixed number
  // of batches apart, and what is found counts from the look after: by then all know of it.

  /// Rows rest at this relative error from now on, or none does (0); with another one than before
  /// all are awake.
  void let_rest_at(double relative_error);
  void decide_rests();
  /// [row] True for rows that rest in batches up to the next look, or after it.
  [[nodiscard]] std::vector<bool> resting(bool after_next_look) const;

  [[nodiscard]] Counted counted(std::size_t cell) const;
  /// Of tallies beside echoes, which never rest.
  [[nodiscard]] Counted counted() const {
    return {static_cast<double>(state_.photons), static_cast<double>(state_.batches)};
  }

  /// Bits of ConvergenceFlag of an echo cell, the variance of its variance, and its reported
  /// relative error; 0 if nothing was scored.
  struct Health {
    std::int32_t flags = 0;
    double variance_of_variance = 0, relative_error = 0;
    void raise(bool condition, ConvergenceFlag flag) { flags |= condition ? flag : 0; }
  };
  [[nodiscard]] Health health(std::size_t cell) const;

  /// Returns whether every cell that has been scored in is below the relative error and not
  /// flagged.
  [[nodiscard]] bool all_converged(double relative_error) const;
  /// The health of a cell of the tallies beside echoes; a balance has no single scores.
  [[nodiscard]] Health tally_health(std::size_t cell, bool is_balance) const;
  [[nodiscard]] std::size_t converged_cells() const;
  [[nodiscard]] std::size_t scored_cells() const;
  /// The largest relative error of the cells that have been scored in; NaN after a single batch.
  [[nodiscard]] double worst_error() const;

  /// Estimates and counts of the tallies into a result. The last environments are the tangents of
  /// the parameters whose values the result has.
  void fill(Result& result) const;

  [[nodiscard]] std::uint64_t photons() const { return state_.photons; }
  /// Scores that were offered, of any size and time: what a run's work is counted by.
  [[nodiscard]] std::uint64_t scores() const { return state_.scores; }
  [[nodiscard]] const Operations& operations() const { return state_.operations; }
  [[nodiscard]] const TotalsState& state() const& { return state_; }
  [[nodiscard]] TotalsState state() && { return std::move(state_); }

 private:
  /// Calls f(health) for all cells, of echoes and of other tallies.
  template <class F>
  void each_health(F f) const {
    for (std::size_t cell = 0; cell < state_.echo.size(); ++cell) f(health(cell));
    std::size_t cell = 0;
    for (const TallyGrid& grid : shape_->tallies)
      for (std::size_t k = 0; k < grid.size(); ++k) f(tally_health(cell++, grid.is_balance));
  }
  /// Adds all that a batch scored in a row.
  void merge_row(const BatchTally& batch, std::size_t row);
  /// Calls f(sums, size of a group) for all that is kept by groups.
  template <class F>
  void each_group_sums(F f) {
    state_.groups.each(shape_->rows(), shape_->cells(), shape_->waters(), f);
  }
  /// The group of the batch that is merged; none where none are kept.
  [[nodiscard]] std::optional<std::size_t> group() const;
  void merge_cell(const BatchTally& batch, std::size_t cell);
  /// Adds the scores of the tallies beside echoes. The balance comes after what it is the sum of.
  void merge_tallies(const BatchTally& batch);
  /// Merges the scores of a batch in the environments of a cell whose echo in the scene is given.
  void merge_environments(const BatchTally& batch, std::size_t cell, double echo);
  /// The scores of a tally's cell that have not been seen.
  [[nodiscard]] Unseen unseen_in_tally(std::size_t cell, bool is_balance) const;
  /// As all_converged, of the tallies beside echoes.
  [[nodiscard]] bool tallies_converged(double relative_error) const;
  void fill_tallies(Result& result) const;
  void fill_groups(Result& result) const;
  /// As all_converged, of a row's cells.
  [[nodiscard]] bool row_converged(std::size_t row, double relative_error) const;
  /// Estimates sums in a cell with what has not been seen of them.
  void estimate(const Sums& sums, std::size_t cell, const Unseen& unseen, Estimates& out) const;
  /// The octaves of the scores of each kind.
  [[nodiscard]] std::span<const Octaves> kinds(std::size_t cell) const;
  /// The octaves of the scores of all kinds, together.
  [[nodiscard]] Octaves octaves(std::size_t cell) const;
  /// The scores that count as one, such as those of a walk; at least 1.
  [[nodiscard]] double scores_together(std::size_t cell) const;
  /// The unseen scores of all kinds; infinite sums if there are too few scores.
  [[nodiscard]] Unseen unseen(std::size_t cell) const;
  /// The sum of the fourth powers of the scores of all kinds; 0 without any.
  [[nodiscard]] double fourth_powers(std::size_t cell) const;
  /// Properties of a gate that its parts and its environments share.
  struct Whole {
    std::int32_t flags = 0;
    Unseen unseen;             ///< of the echo
    Unseen unseen_share;       ///< over the echo, for its parts
    double fourth_powers = 0;  ///< of its scores, for its environments
  };
  [[nodiscard]] Whole whole(std::size_t cell, std::int32_t flags) const;
  /// The unseen ones of scores that go with those of the echo, in an environment or a difference.
  [[nodiscard]] static Unseen unseen_of(const Whole& whole, const Powers& scores);
  [[nodiscard]] static Health health_of(const Sums& s, const Counted& n, const Unseen& unseen);
  /// Bits of ConvergenceFlag of an environment's echo and difference by themselves: a difference
  /// can have a heavier tail than either echo.
  [[nodiscard]] std::int32_t environment_flags(std::size_t cell, const Whole& whole,
                                               const EnvironmentSums& s) const;
  /// The bits of a difference alone, as tangents are: their echo is a line through the scene's, and
  /// no echo.
  [[nodiscard]] std::int32_t difference_flags(std::size_t cell, const Whole& whole,
                                              const EnvironmentSums& s) const;
  /// Bits of ConvergenceFlag of a part. beside_walks: no walk carries its light.
  [[nodiscard]] std::int32_t part_flags(const Sums& part, std::size_t cell, const Whole& whole,
                                        bool beside_walks) const;
  /// Fills in a grid: parts, with flags, [row][part][gate], or a profile, [cell][part].
  void fill_parts(const ZeroedVector<Sums>& parts, const std::vector<Whole>& wholes,
                  GridEstimates& out) const;
  void fill_profile(const ZeroedVector<Sums>& parts, const std::vector<Whole>& wholes,
                    GridEstimates& out) const;
  void fill_environment(std::size_t environment, const std::vector<Whole>& wholes,
                        Result& result) const;
  /// Fills in the derivatives by a parameter, with its value in the scene; `tangent` counts from
  /// the first environment.
  void fill_sensitivity(std::size_t tangent, double value, const std::vector<Whole>& wholes,
                        Result& result) const;
  [[nodiscard]] bool beam_missed(std::size_t cell) const;
  /// The growth of the error times the root of the photons, over the last factor of four to eight
  /// in them.
  [[nodiscard]] double error_growth(std::size_t cell) const;

  const Shape* shape_;
  TotalsState state_;  ///< all there is: nothing but the shape is kept beside it
};

}  // namespace photic::tally
