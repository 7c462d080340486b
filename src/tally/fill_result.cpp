// The totals' estimates, into a result.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/error.hpp"
#include "tally/totals.hpp"

namespace photic::tally {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

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

}  // namespace

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

void Totals::estimate(const Sums& sums, std::size_t cell, const Unseen& unseen,
                      Estimates& out) const {
  const Counted n = counted(cell);
  out.mean.push_back(mean(sums, n));
  out.standard_error.push_back(reported_error(sums, n, unseen));
}

void Totals::fill_environment(std::size_t environment, const std::vector<Whole>& wholes,
                              Result& result) const {
  const std::size_t first = result.environment_convergence_flags.size();
  for (std::size_t cell = 0; cell < state_.echo.size(); ++cell) {
    const EnvironmentSums& s = state_.environment[cell * shape_->environments + environment];
    estimate(s.echo.low, cell, unseen_of(wholes[cell], s.of_scores), result.environment_echo);
    estimate(s.difference.low, cell, unseen_of(wholes[cell], s.of_differences),
             result.environment_difference);
    result.environment_convergence_flags.push_back(
        environment_flags(cell, wholes[cell], s) |
        (result.convergence_flags[cell] & (heavy_tail | ConvergenceFlag::beam_missed)));
  }
  flag_among_flagged(first, shape_->gates, result.environment_convergence_flags);
}

void Totals::fill_sensitivity(std::size_t tangent, double value, const std::vector<Whole>& wholes,
                              Result& result) const {
  const std::size_t first = result.sensitivity_convergence_flags.size();
  for (std::size_t cell = 0; cell < state_.echo.size(); ++cell) {
    const EnvironmentSums& s = state_.environment[cell * shape_->environments + tangent];
    const Sums& scene = state_.echo[cell].low;
    const Counted n = counted(cell);
    const double echo = mean(scene, n);
    const double change = mean(s.difference.low, n);  // p d echo / d p
    const Unseen unseen = unseen_of(wholes[cell], s.of_differences);
    result.sensitivity.mean.push_back(change / value);
    result.sensitivity.standard_error.push_back(reported_error(s.difference.low, n, unseen) /
                                                std::abs(value));
    const double of_ratio = error_of_ratio(change / echo, echo, standard_error(s.difference.low, n),
                                           standard_error(scene, n), standard_error(s.echo.low, n));
    Estimates& logarithmic = result.logarithmic_sensitivity;
    logarithmic.mean.push_back(echo > 0 ? change / echo : nan);
    logarithmic.standard_error.push_back(
        echo > 0 ? with_unseen(of_ratio, unseen.in_error / (n.photons * echo)) : nan);
    result.sensitivity_convergence_flags.push_back(result.convergence_flags[cell] |
                                                   difference_flags(cell, wholes[cell], s));
  }
  flag_among_flagged(first, shape_->gates, result.sensitivity_convergence_flags);
}

void Totals::fill_parts(const ZeroedVector<Sums>& parts, const std::vector<Whole>& wholes,
                        GridEstimates& out) const {
  const auto& beside_walks = out.grid.beside_walks;
  const std::size_t count = out.grid.size();
  for (std::size_t row = 0; row < shape_->rows(); ++row) {
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t cell = row * shape_->gates; cell < (row + 1) * shape_->gates; ++cell) {
        const Sums& part = parts[cell * count + k];
        estimate(part, cell, wholes[cell].unseen_share * part.x, out);
        out.flags.push_back(
            part_flags(part, cell, wholes[cell], k < beside_walks.size() && beside_walks[k]));
      }
    }
  }
}

void Totals::fill_profile(const ZeroedVector<Sums>& parts, const std::vector<Whole>& wholes,
                          GridEstimates& out) const {
  const std::size_t count = out.grid.size();
  out.mean.reserve(parts.size());
  out.standard_error.reserve(parts.size());
  for (std::size_t k = 0; k < parts.size(); ++k)
    estimate(parts[k], k / count, wholes[k / count].unseen_share * parts[k].x, out);
}

void Totals::fill_tallies(Result& result) const {
  std::size_t cell = 0;
  for (const TallyGrid& grid : shape_->tallies) {
    TallyEstimates& out = result.tallies.emplace_back(TallyEstimates{{}, grid, {}});
    for (std::size_t k = 0; k < grid.size(); ++k, ++cell) {
      const Sums& sums = state_.tallies[cell].scored.low;
      const double per_score = (grid.factor.empty() ? 1 : grid.factor[k]) / tally_score_unit;
      out.mean.push_back(per_score * mean(sums, counted()));
      out.standard_error.push_back(
          per_score * reported_error(sums, counted(), unseen_in_tally(cell, grid.is_balance)));
      out.flags.push_back(tally_health(cell, grid.is_balance).flags);
    }
  }
}

void Totals::fill_groups(Result& result) const {
  if (!shape_->keeps_groups) return;
  const BatchGroups& sums = state_.groups;
  GroupMeans& out = result.by_group;
  out.groups = groups_of(state_.batches);
  const std::size_t rows = shape_->rows(), gates = shape_->gates, cells = shape_->cells();
  const auto photons = [&](std::size_t row, std::size_t group) {
    return static_cast<double>(sums.photons.sums[group * rows + row]);
  };
  const auto each_place = [&](auto f) {
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t group = 0; group < out.groups; ++group) f(row, group);
  };
  /// Appends the means of a row in a group.
  const auto add_means = [&](ZeroedVector<float>& means, std::size_t row, std::size_t group,
                             auto sum_at) {
    for (std::size_t gate = 0; gate < gates; ++gate)
      means.push_back(
          static_cast<float>(sum_at(group * cells + row * gates + gate) / photons(row, group)));
  };
  each_place([&](std::size_t row, std::size_t group) {
    out.photons.push_back(photons(row, group));
    add_means(out.echo, row, group, [&](std::size_t at) { return sums.echo.sums[at]; });
  });
  for (std::size_t e = 0; e < shape_->waters(); ++e)
    each_place([&](std::size_t row, std::size_t group) {
      add_means(out.environment_echo, row, group,
                [&](std::size_t at) { return sums.environment.sums[at * shape_->waters() + e]; });
    });
}

void Totals::fill(Result& result) const {
  fill_tallies(result);
  std::vector<Whole> wholes;
  for (std::size_t cell = 0; cell < state_.echo.size(); ++cell) {
    const double x = state_.echo[cell].low.x;
    const Health h = health(cell);
    const Whole& whole = wholes.emplace_back(this->whole(cell, h.flags));
    estimate(state_.echo[cell].low, cell, whole.unseen, result.echo);
    result.convergence_flags.push_back(h.flags);
    result.variance_of_variance.push_back(h.variance_of_variance);
    result.error_growth.push_back(error_growth(cell));
    result.largest_score_share.push_back(x > 0 ? state_.largest[cell] / x : 0.0);
    result.order_cut_share.push_back(x > 0 ? state_.cut_order[cell] / x : 0.0);
  }
  for (const Row& row : state_.row) result.channel_photons.push_back(row.photons);
  for (std::size_t g = 0; g < shape_->grids.size(); ++g) {
    GridEstimates& out = result.grids.emplace_back(GridEstimates{{}, shape_->grids[g], {}});
    if (out.grid.profile)
      fill_profile(state_.grids[g], wholes, out);
    else
      fill_parts(state_.grids[g], wholes, out);
  }
  expect(result.parameter_value.size() == shape_->tangents, "every parameter has a tangent");
  fill_groups(result);
  for (std::size_t e = 0; e < shape_->waters(); ++e) fill_environment(e, wholes, result);
  for (std::size_t p = 0; p < shape_->tangents; ++p)
    fill_sensitivity(shape_->waters() + p, result.parameter_value[p], wholes, result);

  const double per_photon = state_.photons > 0 ? 1.0 / static_cast<double>(state_.photons) : 0.0;
  result.ledger = state_.ledger * per_photon;
  result.ledger_standard_error =
      standard_error(state_.ledger_excess,
                     {static_cast<double>(state_.photons), static_cast<double>(state_.batches)});
  result.photons = state_.photons;
  result.batches = state_.batches;
  result.collisions = state_.collisions;
  result.lost_too_many_events = state_.too_many_events;
  result.lost_not_finite = state_.not_finite;
}

}  // namespace photic::tally
