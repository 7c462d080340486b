// All that is known of the batches merged so far, as plain values: the state that a run goes on
// from.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/zeroed.hpp"
#include "tally/batch_groups.hpp"
#include "tally/operations.hpp"

namespace photic::tally {

struct Shape;

/// The weight of the emitted photons by destination, in accounts: doubles, or a sum for each lane.
template <class Account>
struct Accounts {
  Account absorbed{};  ///< in the water, and not emitted again
  /// Through the surface (what a telescope detects is part of it) or never in the water.
  Account escaped{};
  Account sea_bed{};        ///< absorbed by the sea bed
  Account oil{};            ///< absorbed in a film of oil, and not emitted again out of it
  Account cut_by_time{};    ///< could no longer come back within the last gate
  Account cut_by_order{};   ///< ended at max_order
  Account cut_by_weight{};  ///< ended below the weight threshold
  Account roulette{};  ///< killed less gained by Russian roulette and splitting; 0 in expectation
  Account lost{};      ///< too many events, or a number that is not finite

  /// Calls f(name, account of each) for all accounts of some.
  template <class F, class... Of>
  static void each(F f, Of&... of) {
    f("absorbed", of.absorbed...);
    f("escaped", of.escaped...);
    f("sea_bed", of.sea_bed...);
    f("oil", of.oil...);
    f("cut_by_time", of.cut_by_time...);
    f("cut_by_order", of.cut_by_order...);
    f("cut_by_weight", of.cut_by_weight...);
    f("roulette", of.roulette...);
    f("lost", of.lost...);
  }
  friend bool operator==(const Accounts&, const Accounts&) = default;
};

struct Ledger : Accounts<double> {
  [[nodiscard]] double sum() const {
    double out = 0;
    each([&](const char*, double account) { out += account; }, *this);
    return out;
  }
  Ledger& operator+=(const Ledger& other) {
    each([](const char*, double& mine, double theirs) { mine += theirs; }, *this, other);
    return *this;
  }
  friend Ledger operator*(Ledger ledger, double factor) {
    each([&](const char*, double& account) { account *= factor; }, ledger);
    return ledger;
  }
  friend bool operator==(const Ledger&, const Ledger&) = default;
};

/// Power sums of the batches' scores in one cell. A batch of n photons that scored X enters as X
/// and X^2/n.
struct Sums {
  double x = 0, xx = 0;
  void add(double score, double photons) {
    x += score;
    xx += score * score / photons;
  }
  friend bool operator==(const Sums&, const Sums&) = default;
};

/// The same with what the shape of the distribution needs.
struct TailSums {
  Sums low;
  // Powers of the distance from the first batch that scored: raw powers of a quiet gate would
  // differ from its moments in all digits.
  double origin = 0, photons = 0;  ///< of the batches that scored
  std::array<double, 4> power{};   ///< sums of n (X/n - origin)^k, k = 1 … 4

  void add(double score, double batch_photons);

  /// Second and fourth central moments of the batches' means per photon, each batch weighted by its
  /// photons; of `all_photons`, those whose batches did not score included.
  struct Moments {
    double second = 0, fourth = 0;
  };
  [[nodiscard]] Moments central(double all_photons) const;
  friend bool operator==(const TailSums&, const TailSums&) = default;
};

/// Sums of powers of single scores: few that carry all stand out in the fourth.
struct Powers {
  double square = 0, fourth = 0;
  friend Powers operator+(const Powers& a, const Powers& b) {
    return {a.square + b.square, a.fourth + b.fourth};
  }
  friend bool operator==(const Powers&, const Powers&) = default;
};

/// The sums of one cell for an environment, whose scores are those of the scene times the ratios of
/// their paths' weights.
struct EnvironmentSums {
  TailSums echo, difference;  ///< the latter to the scene's echo
  double largest = 0;         ///< single score
  Powers of_scores, of_differences;
  friend bool operator==(const EnvironmentSums&, const EnvironmentSums&) = default;
};

/// The photons and batches that a row of gates, a channel of a telescope, has been scored in: all
/// that were emitted, but for those it rested in (Totals::decide_rests).
struct Row {
  std::uint64_t photons = 0, batches = 0;
  std::uint64_t rests = 0, will_rest = 0;  ///< 1: in the batches up to the next look, or after it
  friend bool operator==(const Row&, const Row&) = default;
};

/// The walks of the bidirectional estimator that a scored path is made of: the laser's alone, the
/// telescope's alone, or both. None: a history of another estimator, by itself or beside walks.
enum class Technique : std::int8_t { none, laser, telescope, both };
/// Kinds that scores are counted apart for: of no walk, of the laser's alone, with a telescope's.
inline constexpr std::size_t kinds_of_technique = 3;
inline std::size_t kind_of(Technique technique) {
  return std::min(static_cast<std::size_t>(technique), kinds_of_technique - 1);
}

/// Scores are also counted by octave of their size: what shows a heavy tail.
inline constexpr int score_octaves = 128;  ///< 2^-128 … 1
using Octaves = std::array<std::uint64_t, score_octaves>;
using OctavesOfBatch = std::array<std::uint32_t, score_octaves>;

/// The octave of a score's size, not below 0: 0 … score_octaves - 1.
inline int score_octave(double value) {
  constexpr std::uint64_t first = 1023 - score_octaves;
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(value) >> 52;
  if (exponent - first < score_octaves) [[likely]]
    return static_cast<int>(exponent - first);
  return exponent < first ? 0 : score_octaves - 1;
}

/// The sums of a cell of a tally beside echoes, in units of tally_score_unit.
struct TallySums {
  TailSums scored;
  double largest = 0;  ///< single score
  friend bool operator==(const TallySums&, const TallySums&) = default;
};

/// The whole state of Totals. Two of the same scene that are equal go on alike to the last bit.
struct TotalsState {
  TotalsState() = default;
  /// The state of no batch yet.
  explicit TotalsState(const Shape& shape);

  std::uint64_t photons = 0, batches = 0, collisions = 0, scores = 0, too_many_events = 0,
                not_finite = 0;
  Operations operations;
  Ledger ledger;               ///< sums of weights
  Sums ledger_excess;          ///< over the batches: of all in their ledgers less their photons
  std::vector<Row> row;        ///< [row]
  double resting_target = 0;   ///< relative error that rows rest at; 0: none does
  std::vector<TailSums> echo;  ///< [cell]
  std::vector<ZeroedVector<Sums>> grids;      ///< of each grid, [cell][cell of the grid]
  std::vector<double> cut_order;              ///< [cell] first order beyond max_order
  std::vector<double> largest;                ///< [cell] largest single score
  ZeroedVector<Octaves> octaves;              ///< [cell][kind]
  ZeroedVector<EnvironmentSums> environment;  ///< [cell][environment]
  BatchGroups groups;
  std::vector<TallySums> tallies;       ///< [cell of all grids of tallies]
  ZeroedVector<Octaves> tally_octaves;  ///< the same
  // The echo when there were 2^k batches, one snapshot after the other.
  std::vector<double> snapshot_photons, snapshot_batches;  ///< [snapshot][row]
  std::vector<Sums> snapshot_echo;                         ///< [snapshot][cell]
  friend bool operator==(const TotalsState&, const TotalsState&) = default;
};

/// The number of snapshots that a state of so many batches holds.
[[nodiscard]] std::size_t snapshots_at(std::uint64_t batches);

}  // namespace photic::tally
