// The scores of one batch of photons. One worker fills it; then it is merged into the Totals and
// cleared.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "core/zeroed.hpp"
#include "tally/gates.hpp"
#include "tally/operations.hpp"
#include "tally/shape.hpp"
#include "tally/state.hpp"
#include "tally/tally_scores.hpp"

namespace photic::tally {

/// The numbers of scores in a cell.
struct CellScores {
  double largest = 0;    ///< single score
  double cut_order = 0;  ///< first order beyond max_order
  std::uint64_t scores = 0;

  [[nodiscard]] bool touched() const { return largest > 0 || cut_order > 0; }
  void add(double value) {
    largest = std::max(largest, value);
    ++scores;
  }
  void add(const CellScores& others);
  friend bool operator==(const CellScores&, const CellScores&) = default;
};

/// One contribution of a collision to a telescope, of one light.
struct Score {
  std::size_t telescope = 0;
  std::int32_t light = 0;  ///< index in Shape::process_of_light
  std::int32_t order = 0;
  double depth = 0;  ///< of the collision [m]
  double path = 0;   ///< group path from the laser's disc to the aperture [m], as if emitters
                     ///< gave light back at once
  double value = 0;  ///< expected photons
  Technique technique = Technique::none;
};

/// The place of scores: the gate, if their light is emitted at once, and the cell of depth; -1:
/// none. Integer: an integer, or one in each lane.
template <class Integer>
struct Bins {
  Integer gate{}, depth{};
};

/// The scores of a batch in one cell for some environments, one behind the other: added up for all
/// of them at once.
struct EnvironmentScores {
  static constexpr std::size_t size = 8;
  using Each = std::array<double, size>;
  Each echo{};
  Each difference{};          ///< to the scene's echo
  Each largest{};             ///< single score
  Each squares{}, fourths{};  ///< sums of powers of scores
  Each squares_of_differences{}, fourths_of_differences{};

  /// Adds a score that is so many times as large in the environments, all of them finite.
  template <class Number>
  void add(double score, const Number* ratios) {
    for (std::size_t e = 0; e < size; ++e) {
      const auto ratio = static_cast<double>(ratios[e]);
      const double value = score * ratio;
      const double change = score * (ratio - 1);
      echo[e] += value;
      difference[e] += change;
      largest[e] = value > largest[e] ? value : largest[e];
      squares[e] += value * value;
      fourths[e] += value * value * (value * value);
      squares_of_differences[e] += change * change;
      fourths_of_differences[e] += change * change * (change * change);
    }
  }
  void add(const EnvironmentScores& others);
  friend bool operator==(const EnvironmentScores&, const EnvironmentScores&) = default;
};

/// The place of a grid of parts among the sums of a cell.
struct GridPlaces {
  std::size_t size = 0;  ///< cells for each gate
  std::size_t offset = 0;
};

/// The scores of a batch on a grid that is a profile.
struct ProfileScores {
  std::size_t size = 0;                               ///< cells for each gate
  ZeroedVector<double> sums{};                        ///< [cell][cell of the grid]
  std::vector<std::vector<std::uint32_t>> touched{};  ///< [row] sums that are not 0
};

class BatchTally {
 public:
  BatchTally(const Shape& shape, const Gates& gates);

  /// Double: one, or one in each lane.
  template <class Double>
  [[nodiscard]] auto bins(const Double& path, const Double& depth) const {
    const auto gate = gates_->find(path);
    return Bins<std::remove_const_t<decltype(gate)>>{
        gate, cell_below((depth - Double(depth_min_)) * Double(per_depth_step_), depths_)};
  }

  void score(const Score& s) { score(s, bins(s.path, s.depth)); }
  /// The same of which it is known where it belongs.
  void score(const Score& s, const Bins<std::int32_t>& at) {
    const Light& light = light_[static_cast<std::size_t>(s.light)];
    each_gate(s, light, at.gate, [&](std::int32_t gate, double part) {
      each_cell(s, light, gate, [&](std::size_t cell, double share) {
        add(s, light, at.depth, cell, part * share);
      });
    });
  }
  /// The same with environments, in which the score is ratios[e] times as large; there are whole
  /// groups of EnvironmentScores::size of them, the last ones perhaps of no environment.
  template <class Number>
  void score(const Score& s, const Bins<std::int32_t>& at, const Number* ratios) {
    const Light& light = light_[static_cast<std::size_t>(s.light)];
    each_gate(s, light, at.gate, [&](std::int32_t gate, double part) {
      each_cell(s, light, gate, [&](std::size_t cell, double share) {
        if (!add(s, light, at.depth, cell, part * share)) return;
        for (std::size_t g = 0; g < environment_groups; ++g)
          environment[cell * environment_groups + g].add(s.value * (part * share),
                                                         ratios + g * EnvironmentScores::size);
      });
    });
  }
  /// At the end of a batch: gives what each telescope has scored to all whose views hold its own.
  /// Light that several see is scored in the narrowest of them.
  void pass_to_wider();
  void clear();

  std::vector<bool> rests;  ///< [row] whose scores are not asked for
  /// Returns whether any channel of a telescope asks for the light of a line, or of one within its
  /// view.
  [[nodiscard]] bool wants(std::size_t telescope, std::int32_t line) const;

  /// Calls f(array, size) for all that is summed in cells, `size` elements of each; but for
  /// profiles, which are listed where they are touched.
  template <class F>
  void each_array(F f) {
    f(parts, parts_size);
    f(cells, 1);
    for (auto& kind : octaves) f(kind, 1);
    f(environment, environment_groups);
  }

  // Sums over the batch. The echo of a cell is the sum of the first grid's cells.
  std::vector<GridPlaces> grids;   ///< of parts, in the order of the shape's
  std::size_t parts_size = 0;      ///< of all of them
  ZeroedVector<double> parts;      ///< [cell][grid of parts][cell of the grid]
  ProfileScores profile;           ///< by depth, if there is one
  ZeroedVector<CellScores> cells;  ///< [cell]
  /// [cell], by the walks that the scores are of. Kinds without a score take no memory.
  std::array<ZeroedVector<OctavesOfBatch>, kinds_of_technique> octaves;
  std::size_t environment_groups;
  ZeroedVector<EnvironmentScores> environment;            ///< [cell][group of environments]
  std::vector<std::vector<std::uint32_t>> touched_cells;  ///< [row]

  TallyScores tallies;  ///< beside echoes

  Ledger ledger;  ///< sums of weights
  Operations operations;
  std::uint64_t photons = 0, collisions = 0, scores = 0, too_many_events = 0, not_finite = 0;

 private:
  /// A row of the first telescope that counts light, and the share that it does.
  struct CountingRow {
    std::size_t first_cell = 0;
    double share = 1;
  };
  /// As scores need it.
  struct Light {
    std::vector<CountingRow> counting;
    std::size_t process = 0, by_process = 0;  ///< and its place among the parts of a cell
    const Decay* decay = nullptr;             ///< none: all of it is emitted at once
  };

  /// Calls act(gate, share) for the gates that a score falls into, if it is one.
  template <class Act>
  void each_gate(const Score& s, const Light& light, std::int32_t at_once, Act act) {
    ++scores;
    if (!(s.value > 0)) {
      if (std::isnan(s.value)) ++not_finite;
      return;
    }
    if (const Decay* decay = light.decay) {
      decay->spread(s.path, *gates_, shares_);
      for (const auto& [gate, share] : shares_) act(gate, share);
    } else if (at_once >= 0) {
      act(at_once, 1.0);
    }
  }
  /// Calls act(cell, share) for the channels that count a score.
  template <class Act>
  void each_cell(const Score& s, const Light& light, std::int32_t gate, Act act) const {
    const std::size_t at = s.telescope * cells_of_telescope_ + static_cast<std::size_t>(gate);
    for (const auto& [first_cell, share] : light.counting) act(at + first_cell, share);
  }
  /// A telescope's scores are added to those of the next wider one.
  struct Pass {
    std::size_t from = 0, to = 0;
  };
  /// Axes of one quantity are the same in all grids.
  void know(const Axis& axis);
  void add_further(const Grid& grid, std::size_t offset);
  /// Adds all that a cell has to another one.
  void add_cell(std::size_t from, std::size_t to);
  /// Adds to a sum of a profile.
  void add_to_profile(std::size_t cell, std::size_t at, double value);
  /// Adds a share of a score to a cell. Returns whether its echo has it.
  bool add(const Score& s, const Light& light, std::int32_t depth, std::size_t cell, double share);

  const Shape* shape_;
  const Gates* gates_;
  std::size_t cells_of_telescope_;
  std::size_t last_order_bin_ = 0;  ///< of the axis of orders
  /// A grid of parts after the first two; 0 per what it is not by.
  struct Further {
    std::size_t offset = 0, per_process = 0, per_order = 0;
  };
  std::vector<Further> further_;
  std::int32_t depths_ = 0;  ///< of the axis of depths, if there is one
  double depth_min_ = 0, per_depth_step_ = 1;
  std::vector<Light> light_;       ///< [light]
  std::vector<Pass> passes_;       ///< from narrow views to wide ones
  std::int32_t last_order_;        ///< beyond it scores are cut off
  std::vector<GateShare> shares_;  ///< of the last score that was not emitted at once
};

inline void BatchTally::add_to_profile(std::size_t cell, std::size_t at, double value) {
  if (profile.sums[at] == 0)
    profile.touched[shape_->row_of(cell)].push_back(static_cast<std::uint32_t>(at));
  profile.sums[at] += value;
}

inline bool BatchTally::add(const Score& s, const Light& light, std::int32_t depth,
                            std::size_t cell, double share) {
  const double value = s.value * share;
  if (!(value > 0)) return false;  // a share of nothing: the cell would be touched twice
  CellScores& here = cells[cell];
  if (!here.touched())
    touched_cells[shape_->row_of(cell)].push_back(static_cast<std::uint32_t>(cell));
  if (s.order > last_order_) {
    here.cut_order += value;
    return false;
  }
  here.add(value);
  ++octaves[kind_of(s.technique)][cell][static_cast<std::size_t>(score_octave(value))];
  const std::size_t order = std::min(static_cast<std::size_t>(s.order), last_order_bin_);
  double* const of_cell = &parts[cell * parts_size];
  of_cell[order] += value;             // the first two grids, which are always there,
  of_cell[light.by_process] += value;  // are not worth a loop
  for (const Further& grid : further_)
    of_cell[grid.offset + grid.per_process * light.process + grid.per_order * order] += value;
  if (depth >= 0)
    add_to_profile(cell, cell * profile.size + static_cast<std::size_t>(depth), value);
  return true;
}

}  // namespace photic::tally
