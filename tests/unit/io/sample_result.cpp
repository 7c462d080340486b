#include "unit/io/sample_result.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace photic::test {
namespace {

struct Look {
  double at_surface, attenuation_per_m, relative_error, error_growth_m, single_share, seen_to_m;
};
// Rough shapes: an echo that falls exponentially, an error that grows; elastic is noisiest.
constexpr Look looks[] = {{4e-10, 0.15, 0.004, 9, 0.8, 49},
                          {6e-11, 0.28, 0.002, 14, 0.9, 47},
                          {9e-12, 0.40, 0.003, 13, 0.95, 47}};
constexpr double height_m = 12.0;
constexpr double step_m = 0.5;
constexpr std::size_t gates = 100;

std::vector<double> depth_edges() {
  std::vector<double> out;
  for (std::size_t k = 0; k <= gates; ++k) out.push_back(step_m * static_cast<double>(k));
  return out;
}

class Maker {
 public:
  Maker(const std::vector<std::string>& environments, const std::vector<std::string>& parameters) {
    result_.environment_name = environments;
    result_.parameter_name = parameters;
  }

  tally::Result make() {
    axes();
    for (std::size_t t = 0; t < 2; ++t)
      for (std::size_t c = 0; c < 3; ++c) channel(looks[c], t, c);
    for (std::size_t e = 0; e < result_.environment_name.size(); ++e)
      environment(static_cast<double>(e + 1));
    for (std::size_t p = 0; p < result_.parameter_name.size(); ++p)
      parameter(static_cast<double>(p + 1));
    run();
    groups();
    state();
    return std::move(result_);
  }

 private:
  void axes() {
    result_.telescope_name = {"narrow", "wide"};
    result_.channel_name = {"elastic", "raman", "chlorophyll"};
    for (const tally::Grid& grid : sample_shape().grids)
      result_.grids.push_back(tally::GridEstimates{{}, grid, {}});
    result_.channel_wavelength_nm = {532.0, 649.8, 685.0};
    for (std::size_t k = 0; k <= gates; ++k) {
      const double depth_m = step_m * static_cast<double>(k);
      result_.gate_time_edge_ns.push_back(2 * (height_m + 1.36 * depth_m) / 0.299792458);
    }
    // The second telescope looks on from a place 2 m higher.
    for (const double higher_m : {0.0, 2.0})
      for (const double stretch : {1.0, 1.004, 1.005})
        for (const double depth_m : depth_edges())
          result_.gate_depth_edge_m.push_back(stretch * (depth_m - higher_m));
  }

  void channel(const Look& look, std::size_t telescope, std::size_t c) {
    std::vector<double> echo(gates), error(gates);
    for (std::size_t k = 0; k < gates; ++k) {
      const double depth_m = step_m * (static_cast<double>(k) + 0.5);
      const double truth = static_cast<double>(telescope + 1) * look.at_surface *
                           std::exp(-look.attenuation_per_m * depth_m) /
                           std::pow(1 + depth_m / height_m, 2);
      const double relative = look.relative_error * std::exp(depth_m / look.error_growth_m);
      const bool seen = depth_m < look.seen_to_m;
      echo[k] = seen ? truth * std::max(0.2, 1 + std::min(relative, 0.4) * normal_(random_)) : 0;
      error[k] = seen ? relative * echo[k] : 0;
      gate(look, depth_m, relative, seen);
    }
    for (std::size_t k = 0; k < gates; ++k) push(result_.echo, echo[k], error[k]);
    for (std::size_t process = 0; process < 3; ++process)
      for (std::size_t k = 0; k < gates; ++k)
        part(process == c ? echo[k] : 0, process == c ? error[k] : 0,
             result_.grid("echo_by_process"), result_.grid("echo_by_process").flags);
    orders(look, echo, error);
    depths(echo, error);
  }

  void gate(const Look& look, double depth_m, double relative, bool seen) {
    std::int32_t flags = 0;
    if (!seen) flags |= tally::no_score;
    if (seen && relative > 0.1) flags |= tally::large_error;
    if (seen && relative > 0.05 && look.single_share < 0.85) flags |= tally::heavy_tail;
    result_.convergence_flags.push_back(flags);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    result_.largest_score_share.push_back(seen ? 0.01 * relative : nan);
    result_.variance_of_variance.push_back(seen ? 0.1 * relative : nan);
    result_.error_growth.push_back(seen ? 1 + relative : nan);
    result_.order_cut_share.push_back(seen ? 1e-6 * depth_m : nan);
  }

  void orders(const Look& look, const std::vector<double>& echo, const std::vector<double>& error) {
    for (std::size_t k = 0; k < gates; ++k)
      part(0, 0, result_.grid("echo_by_order"), result_.grid("echo_by_order").flags);
    for (int order = 1; order <= 6; ++order)
      for (std::size_t k = 0; k < gates; ++k) {
        // A geometric series whose first term loses ground with depth; the last order takes the
        // rest.
        const double first = look.single_share * std::exp(-0.02 * static_cast<double>(k));
        const double share =
            order < 6 ? first * std::pow(1 - first, order - 1) : std::pow(1 - first, 5);
        part(share * echo[k], std::sqrt(share) * error[k], result_.grid("echo_by_order"),
             result_.grid("echo_by_order").flags);
      }
  }

  /// An order or a process of a gate.
  static void part(double echo, double error, tally::Estimates& estimates,
                   std::vector<std::int32_t>& flags) {
    push(estimates, echo, error);
    const std::int32_t large = error > 0.1 * echo ? tally::large_error : 0;
    flags.push_back(echo > 0 ? large : tally::no_score);
  }

  void depths(const std::vector<double>& echo, const std::vector<double>& error) {
    for (std::size_t k = 0; k < gates; ++k)
      for (std::size_t d = 0; d < gates; ++d) {
        // Light of a gate turned at its depth or, scattered several times, above it.
        const double share =
            d > k ? 0 : std::pow(0.5, static_cast<double>(k - d) + (d == 0 ? 0 : 1));
        push(result_.grid("echo_by_depth"), share * echo[k], std::sqrt(share) * error[k]);
      }
  }

  /// Errors of the differences are far smaller than those of the echoes.
  void environment(double steps) {
    result_.environment_path = {"sea.layer.0.chlorophyll_mg_m3", "sea.layer.0.cdom_a440_per_m"};
    result_.environment_value.push_back(0.1 * steps);
    result_.environment_value.push_back(steps == 1 ? std::numeric_limits<double>::quiet_NaN()
                                                   : 0.02 / steps);
    for (std::size_t cell = 0; cell < result_.echo.mean.size(); ++cell) {
      const double depth_m = step_m * (static_cast<double>(cell % gates) + 0.5);
      const double echo = result_.echo.mean[cell], error = result_.echo.standard_error[cell];
      const double ratio = std::exp(-0.04 * steps * depth_m);
      const double growth = 1 + 0.02 * depth_m;
      push(result_.environment_echo, ratio * echo, ratio * growth * error);
      push(result_.environment_difference, (ratio - 1) * echo,
           0.3 * (1 - ratio) * ratio * growth * error);
      const std::int32_t flags = result_.convergence_flags[cell];
      const bool worse = echo > 0 && growth * error > 0.1 * echo;
      result_.environment_convergence_flags.push_back(worse ? flags | tally::large_error : flags);
    }
  }

  /// Parameters that take light away, each less than the one before, and send some of it back.
  void parameter(double number) {
    const double value = 0.1 * number;
    result_.parameter_value.push_back(value);
    for (std::size_t cell = 0; cell < result_.echo.mean.size(); ++cell) {
      const double depth_m = step_m * (static_cast<double>(cell % gates) + 0.5);
      const double echo = result_.echo.mean[cell];
      const double relative = echo > 0 ? result_.echo.standard_error[cell] / echo : 0;
      const double logarithmic = 0.6 - 0.05 * depth_m / number;
      const double error = 0.4 * relative * (0.1 + std::abs(logarithmic)) * (1 + 0.05 * depth_m);
      const double nan = std::numeric_limits<double>::quiet_NaN();
      push(result_.sensitivity, logarithmic * echo / value, error * echo / value);
      push(result_.logarithmic_sensitivity, echo > 0 ? logarithmic : nan, echo > 0 ? error : nan);
      const bool worse = depth_m > 30 && echo > 0;
      result_.sensitivity_convergence_flags.push_back(result_.convergence_flags[cell] |
                                                      (worse ? tally::uncertain_variance : 0));
    }
  }

  void run() {
    result_.title = "Table 1 ship lidar over case-1 water";
    result_.scene_toml =
        "title = \"Table 1 ship lidar over case-1 water\"\n[source]\nwavelength_nm = 532.0\n";
    result_.version = "0.1.0";
    result_.engine = "scalar";
    result_.estimator = "forward";
    result_.environment_changes.assign(result_.environment_name.size(), "");
    result_.seed = 1;
    result_.photons = 20'000'000;
    result_.stopped_by = "photons";
    result_.batches = 200;
    for (std::size_t row = 0; row < result_.telescopes() * result_.channels(); ++row)
      result_.channel_photons.push_back(row == 4 ? 400'000 : result_.photons);
    result_.collisions = 187'654'321;
    result_.lost_too_many_events = 2;
    result_.lost_not_finite = 1;
    result_.wall_time_s = 23.5;
    result_.threads = 2;
    result_.ledger = {{.absorbed = 0.71,
                       .escaped = 0.08,
                       .sea_bed = 0.015,
                       .oil = 0.005,
                       .cut_by_time = 0.18,
                       .cut_by_order = 0.0099,
                       .cut_by_weight = 1e-4,
                       .roulette = 1e-5,
                       .lost = 1.5e-7}};
    result_.warnings = {
        "3 photons were lost: 2 had too many events, 1 a number that is not finite"};
    result_.strategies = {"walks from both sides connected: yes", "walks rotated: no: it is askew"};
    result_.sources = {"water absorption = mason-ioccg: Mason, Cone & Fry (2016) [published]",
                       "chlorophyll yield = 0.01: [placeholder]"};
  }

  /// Groups of two batches that scatter as errors have it. One channel rests in most of them.
  void groups() {
    tally::GroupMeans& out = result_.by_group;
    out.groups = result_.batches / 2;
    const auto count = static_cast<double>(out.groups);
    for (const std::uint64_t photons : result_.channel_photons) {
      auto left = static_cast<double>(photons);
      for (std::size_t group = 0; group < out.groups; ++group) {
        out.photons.push_back(std::min(left, static_cast<double>(result_.photons) / count));
        left -= out.photons.back();
      }
    }
    const auto fill = [&](const tally::Estimates& of, ZeroedVector<float>& means) {
      for (std::size_t row = 0; row < of.mean.size() / gates; ++row)
        for (std::size_t group = 0; group < out.groups; ++group)
          for (std::size_t cell = row * gates; cell < (row + 1) * gates; ++cell) {
            const bool rests = out.photons[row % 6 * out.groups + group] == 0;
            const double scatter = std::sqrt(count) * of.standard_error[cell] * normal_(random_);
            means.push_back(rests ? std::numeric_limits<float>::quiet_NaN()
                                  : static_cast<float>(of.mean[cell] + scatter));
          }
    };
    fill(result_.echo, out.echo);
    fill(result_.environment_echo, out.environment_echo);
  }

  /// No number twice, so that none can be taken for another.
  void state() {
    const tally::Shape shape =
        sample_shape(result_.environment_name.size(), result_.parameter_name.size());
    tally::TotalsState state(shape);
    state.photons = 19'998'000;
    state.batches = 9999;
    state.collisions = 187'654'000;
    tally::Operations::each(
        [&](const char*, auto& number) { number = static_cast<std::uint64_t>(++numbers_); },
        state.operations);
    state.too_many_events = 2;
    state.not_finite = 1;
    tally::Ledger::each([&](const char*, double& account) { account = next(); }, state.ledger);
    state.ledger_excess = {next(), next()};
    state.resting_target = next();
    for (auto& row : state.row) row = {++numbers_, ++numbers_, ++numbers_, ++numbers_};
    for (auto& s : state.echo) s = tail_sums();
    for (auto& sums : state.grids)
      for (auto& s : sums) s = {next(), next()};
    for (auto* values : {&state.cut_order, &state.largest})
      for (double& value : *values) value = next();
    for (auto& s : state.environment) {
      for (auto* sums : {&s.echo, &s.difference}) *sums = tail_sums();
      s.largest = next();
      for (auto* powers : {&s.of_scores, &s.of_differences}) *powers = {next(), next()};
    }
    state.groups.each(shape.rows(), shape.cells(), shape.waters(),
                      [&](auto& sums, std::size_t cells) {
                        sums.open(tally::groups_of(state.batches) - 1, cells);
                        for (auto& sum : sums.sums)
                          sum = static_cast<std::remove_reference_t<decltype(sum)>>(++numbers_);
                      });
    for (auto& counts : state.octaves)
      for (auto& count : counts) count = (std::uint64_t{1} << 60) + ++numbers_;
    for (std::size_t k = 0; k < tally::snapshots_at(state.batches); ++k) {
      for (std::size_t row = 0; row < state.row.size(); ++row) {
        state.snapshot_photons.push_back(next());
        state.snapshot_batches.push_back(next());
      }
      for (std::size_t cell = 0; cell < state.echo.size(); ++cell)
        state.snapshot_echo.push_back({next(), next()});
    }
    result_.state = std::move(state);
  }

  tally::TailSums tail_sums() {
    return {{next(), next()}, next(), next(), {next(), next(), next(), next()}};
  }

  double next() { return std::sqrt(static_cast<double>(++numbers_)); }

  static void push(tally::Estimates& estimates, double mean, double standard_error) {
    estimates.mean.push_back(mean);
    estimates.standard_error.push_back(standard_error);
  }

  tally::Result result_;
  std::mt19937 random_{7};
  std::normal_distribution<double> normal_;
  std::uint64_t numbers_ = 0;
};

}  // namespace

tally::Result sample_result() { return sample_result_in({}); }

tally::Result sample_result_in(const std::vector<std::string>& environments,
                               const std::vector<std::string>& parameters) {
  return Maker(environments, parameters).make();
}

tally::Shape sample_shape(std::size_t environments, std::size_t parameters) {
  tally::Shape shape;
  shape.telescopes = 2;
  shape.channels = 3;
  shape.grids = tally::echo_grids(7, {"elastic", "raman", "chlorophyll"}, depth_edges());
  shape.gates = gates;
  shape.environments = environments + parameters;
  shape.tangents = parameters;
  shape.keeps_groups = true;
  shape.techniques = tally::kinds_of_technique;
  return shape;
}

}  // namespace photic::test
