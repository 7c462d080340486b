// The result of a run, as plain arrays: what io/ writes and the terminal shows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/zeroed.hpp"
#include "tally/grid.hpp"
#include "tally/state.hpp"
#include "tally/tally_grid.hpp"

namespace photic::tally {

/// Estimates on a grid, flattened with the last axis fastest.
struct Estimates {
  ZeroedVector<double> mean;            ///< expected photons detected per photon emitted
  ZeroedVector<double> standard_error;  ///< of the mean; the same length
};

/// Estimates on a grid of a tally; its flags, [telescope][channel][cell of the grid][gate], are
/// none for a profile, whose estimates are [telescope][channel][gate][cell of the grid].
struct GridEstimates : Estimates {
  Grid grid;
  std::vector<std::int32_t> flags;
};

/// Estimates of a tally beside echoes, [cell of its grid], and their flags.
struct TallyEstimates : Estimates {
  TallyGrid grid;
  std::vector<std::int32_t> flags;
};

/// The reasons why an echo is not converged: bits of Result::convergence_flags (docs/theory.md,
/// "Error bars").
enum ConvergenceFlag : std::int32_t {
  no_score = 1,             ///< nothing was ever scored here
  few_batches = 2,          ///< too few batches to know a standard error
  large_error = 4,          ///< the standard error is above 10 % of the echo
  uncertain_variance = 16,  ///< of an environment: one batch carries much of the variance
  heavy_tail = 32,          ///< scores too rare to have been seen may carry too much
  among_flagged = 128,      ///< most of the gates around are flagged
  beam_missed = 256,        ///< the telescope's walks hardly came near the laser's light
};
struct FlagMeaning {
  ConvergenceFlag flag;
  const char* name;         ///< one word for files: "heavy_tail"
  const char* explanation;  ///< one line for people
};
const std::vector<FlagMeaning>& flag_meanings();

/// Means per photon by groups of batches (batch_groups.hpp), in single precision: far finer than
/// any scatter. NaN where a channel rested in a whole group.
struct GroupMeans {
  std::size_t groups = 0;                ///< 0: a scene keeps none
  std::vector<double> photons;           ///< [telescope][channel][group]
  ZeroedVector<float> echo;              ///< [telescope][channel][group][gate]
  ZeroedVector<float> environment_echo;  ///< [environment][telescope][channel][group][gate]
};

struct Result {
  // Axes.
  std::vector<std::string> telescope_name, channel_name;
  std::vector<double> channel_wavelength_nm;  ///< mean over the light it counts
  /// For scenes with a film of oil, [telescope][channel]: its absorption on the way down and up,
  /// per thickness, and the transmission of a clear film over that of bare water (medium/film.hpp).
  std::vector<double> film_attenuation_per_m, film_interface_ratio;
  std::vector<double> gate_time_edge_ns;  ///< gates + 1
  /// [telescope][channel][gates + 1]: depth of first-order light, or range; NaN where a telescope
  /// has none.
  std::vector<double> gate_depth_edge_m;
  bool gate_depth_is_range = false;  ///< along the axis of each telescope

  // The sums of the tallies.
  Estimates echo;                               ///< [telescope][channel][gate]
  std::vector<GridEstimates> grids;             ///< of Shape::grids
  std::vector<std::int32_t> convergence_flags;  ///< [telescope][channel][gate]; 0: converged
  std::vector<double> largest_score_share;      ///< [telescope][channel][gate] of the echo
  std::vector<double> variance_of_variance;     ///< [telescope][channel][gate]
  std::vector<double> error_growth;  ///< [telescope][channel][gate]: of error * sqrt(photons), over
                                     ///< the last factor of 4 to 8 in photons; NaN of short runs
  std::vector<double>
      order_cut_share;  ///< [telescope][channel][gate]: first order cut off, over the echo

  GroupMeans by_group;
  std::vector<TallyEstimates> tallies;    ///< of Shape::tallies
  std::optional<double> source_strength;  ///< as the scene gives it
  std::string source_strength_units;      ///< "W", "W m-2", "J", "1" (photons)

  // The same of the environments, if there are any.
  std::vector<std::string> environment_name;
  std::vector<std::string> environment_changes;  ///< besides those in its name: "path = value, …"
  std::vector<std::string> environment_path;     ///< that any of them sets to a number, as of --set
  std::vector<double> environment_value;         ///< [environment][path]; NaN: no number
  Estimates environment_echo;                    ///< [environment][telescope][channel][gate]
  Estimates environment_difference;              ///< the same: less the echo; its error is its own
  std::vector<std::int32_t> environment_convergence_flags;  ///< of environment_echo

  // The derivatives with respect to parameters p of the water, if any are asked for.
  std::vector<std::string> parameter_name;  ///< as of --set
  std::vector<double> parameter_value;      ///< in the scene; not 0
  Estimates sensitivity;  ///< [parameter][telescope][channel][gate]: d echo / d p, per unit of p
  Estimates logarithmic_sensitivity;  ///< the same: p / echo * d echo / d p; NaN where echo is 0
  std::vector<std::int32_t> sensitivity_convergence_flags;  ///< the same: of both

  // The run.
  std::string title, scene_toml, version, engine, estimator;
  std::string estimator_reason;  ///< reason for the choice of "auto"; empty: the scene names it
  std::vector<std::string> strategies;  ///< in which ways it draws paths, and why not in others
  std::uint64_t seed = 0;
  std::uint64_t photons = 0;                   ///< emitted
  std::vector<std::uint64_t> channel_photons;  ///< [telescope][channel]: that its echoes are means
                                               ///< over; fewer where it rested, being converged
  std::string stopped_by;                      ///< photons | target | time | interrupt | checkpoint
  bool partial = false;                        ///< seen before what was asked for was reached
  std::uint64_t batches = 0;
  std::uint64_t collisions = 0;
  std::uint64_t lost_too_many_events = 0;  ///< photons
  std::uint64_t lost_not_finite = 0;       ///< photons
  double wall_time_s = 0;                  ///< of all sittings
  int threads = 0;                         ///< of the last one
  Ledger ledger;                     ///< as shares of the photons emitted; sums to 1 in expectation
  double ledger_standard_error = 0;  ///< of that sum; NaN of a single batch
  std::vector<std::string> warnings;  ///< for the user, one sentence each
  std::vector<std::string> sources;   ///< "a of water, 532 nm: source [status]" of the optics used

  /// The start of a longer run: the state after the last whole batch. An incomplete batch at the
  /// end is not in it, since a longer run would have done that batch whole.
  std::optional<TotalsState> state;

  [[nodiscard]] std::size_t telescopes() const { return telescope_name.size(); }
  [[nodiscard]] std::size_t channels() const { return channel_name.size(); }
  [[nodiscard]] std::size_t gates() const {
    return gate_time_edge_ns.empty() ? 0 : gate_time_edge_ns.size() - 1;
  }
  /// False of a scene that has tallies beside echoes alone.
  [[nodiscard]] bool has_echoes() const { return telescopes() * channels() * gates() > 0; }
  /// Throws std::out_of_range for one that there is not.
  [[nodiscard]] const GridEstimates& grid(std::string_view name) const;
  [[nodiscard]] GridEstimates& grid(std::string_view name);
  [[nodiscard]] const std::vector<std::string>& process_names() const {
    return grid("echo_by_process").grid.axes.front().labels;
  }
  /// So many: 0, 1, … and the last one and above.
  [[nodiscard]] std::size_t orders() const { return grid("echo_by_order").grid.size(); }
  /// The depth or range [m] in the middle of a gate; NaN where the telescope has none.
  [[nodiscard]] double gate_depth_m(std::size_t telescope, std::size_t channel,
                                    std::size_t gate) const {
    const std::size_t edge = (telescope * channels() + channel) * (gates() + 1) + gate;
    return 0.5 * (gate_depth_edge_m[edge] + gate_depth_edge_m[edge + 1]);
  }
};

}  // namespace photic::tally
