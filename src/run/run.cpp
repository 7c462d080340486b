#include "run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/error.hpp"
#include "estimator/model.hpp"
#include "estimator/world.hpp"
#include "run/batches.hpp"
#include "run/choose.hpp"

namespace photic::run {
namespace {

constexpr double tolerated_cut = 1e-3;  // of a gate, by max_order

// Tolerances of the ledger's sum: it may be off by so much, and, since it scatters, by so many of
// its standard errors. Ten batches suffice for these, but for rare large weights: far off is off
// all the same.
constexpr double tolerated_excess = 0.02;
constexpr double tolerated_errors = 4;
constexpr double far_off = 0.10;
constexpr std::uint64_t batches_of_ledger = 10;

/// The reason why weights scatter, and a remedy.
std::string about_weights(const scene::Simulation& s) {
  if (s.estimator == scene::Estimator::bidirectional)
    return "weights that grow from vertex to vertex, since walk_attenuation is small for water "
           "that scatters so much: leave it out, or raise it";
  if (s.directed_fraction.value_or(0) > 0)
    return "directed sampling, which doubles weights at each scattering: set directed_fraction = "
           "0, or use estimator = \"bidirectional\"";
  return "tools or conversions: more photons are needed, or estimator = \"bidirectional\"";
}

/// In expectation the ledger sums to 1. If it does not, photons that carry much weight are too rare
/// to have come (docs/theory.md, section 5).
void warn_of_ledger(tally::Result& result, const scene::Simulation& simulation) {
  if (result.batches < batches_of_ledger) return;
  const double excess = std::abs(result.ledger.sum() - 1);
  const double scatter = tolerated_errors * result.ledger_standard_error;
  if (excess <= std::max(tolerated_excess, std::min(scatter, far_off))) return;
  result.warnings.push_back(fmt::format(
      "the photons' weights add up to {:.2f}, not 1: most is carried by photons too rare to occur "
      "in the run, and echoes of light scattered many times are off, mostly low, even in gates "
      "that seem converged. The reason is {}",
      result.ledger.sum(), about_weights(simulation)));
}

void warn(tally::Result& result, const scene::Simulation& simulation) {
  const auto cut = std::count_if(result.order_cut_share.begin(), result.order_cut_share.end(),
                                 [](double share) { return share > tolerated_cut; });
  if (cut > 0) {
    result.warnings.push_back(fmt::format(
        "max_order cuts off more than 0.1 % of the echo in {} gates: raise it or leave it out",
        cut));
  }
  if (!result.tallies.empty() && result.ledger.cut_by_order > tolerated_cut)
    result.warnings.push_back(
        fmt::format("max_order ends {:.2g} of the light, which the tallies leave out from there on",
                    result.ledger.cut_by_order));
  if (result.ledger.cut_by_weight > 0) {
    result.warnings.push_back(
        fmt::format("at_threshold = \"end\" ended photons that carried {:.2g} of the launched "
                    "weight: echoes are "
                    "low",
                    result.ledger.cut_by_weight));
  }
  if (result.lost_too_many_events > 0) {
    result.warnings.push_back(
        simulation.estimator == scene::Estimator::bidirectional
            ? fmt::format("{} walks were cut after {} vertices ({:.2g} of all weight): echoes of "
                          "light scattered so often are low",
                          result.lost_too_many_events, estimator::max_vertices, result.ledger.lost)
            : fmt::format("{} photons were lost after too many events ({:.2g} of all weight)",
                          result.lost_too_many_events, result.ledger.lost));
  }
  if (result.lost_not_finite > 0) {
    result.warnings.push_back(
        fmt::format("{} scores were not finite and are missing: echoes may be too low",
                    result.lost_not_finite));
  }
  for (std::size_t c = 0; c < result.channels(); ++c) {
    double sum = 0;
    for (std::size_t t = 0; t < result.telescopes(); ++t) {
      const auto first = result.echo.mean.begin() +
                         static_cast<std::ptrdiff_t>((t * result.channels() + c) * result.gates());
      sum += std::accumulate(first, first + static_cast<std::ptrdiff_t>(result.gates()), 0.0);
    }
    if (sum == 0) {
      result.warnings.push_back(
          fmt::format("no light reaches channel \"{}\"", result.channel_name[c]));
    }
  }
}

/// The result of the totals so far but for their state; `stopped_by` says why they go no further.
tally::Result result_of(const estimator::Model& model, const tally::Totals& totals,
                        const Ending& ending, const std::string& stopped_by,
                        const RunOptions& options) {
  tally::Result result = estimator::describe(model);
  totals.fill(result);
  result.engine = schedule::engine_name(options.lanes);
  result.version = PHOTIC_VERSION;
  result.stopped_by = stopped_by;
  result.partial = stopped_by == "interrupt" || stopped_by == "checkpoint";
  result.wall_time_s = ending.wall_time_s + (options.start ? options.start->wall_time_s : 0);
  result.threads = ending.threads;
  warn(result, model.scene.simulation);
  warn_of_ledger(result, model.scene.simulation);
  if (model.scene.simulation.estimator_reason == reason_unseen) {
    result.warnings.push_back(
        "the pilot runs of estimator = \"auto\" saw no light at all: it chose \"bidirectional\" "
        "without a comparison; check that telescopes and gates are where the light is, or name an "
        "estimator");
  }
  return result;
}

/// Throws InputError for lanes that do not run here.
void check_lanes(Isa isa) {
  if (runs_here(isa)) return;
  const std::string_view best = isa_name(isas_here().back());
  throw InputError(
      {{.file = fmt::format("--isa {}", isa_name(isa)),
        .reason = is_built(isa) ? "this processor does not have it" : "it was not built",
        .suggestion =
            is_of_processor(isa)
                ? fmt::format("leave it out, choose {}, or build it: cmake -DPHOTIC_ISAS=all", best)
                : fmt::format("leave it out, or choose {}", best)}});
}

}  // namespace

tally::Totals run_batches(const estimator::Model& model, RunControl& control,
                          const std::optional<Isa>& lanes) {
  return BatchRunner(model, *schedule::make_simulator(model, lanes), control).run();
}

tally::Result run(const scene::Scene& asked, const RunOptions& options) {
  if (options.lanes) check_lanes(*options.lanes);
  if (options.lanes && asked.is_of_spherical_air())
    throw InputError({{.file = "--engine lanes",
                       .reason = "spherical air is followed in double, by the scalar engine alone",
                       .suggestion = "leave out --engine and --isa"}});
  const scene::Scene scene = choose_estimator(asked, options);
  const estimator::Model model = estimator::make_model(scene);
  RunControl control(scene.simulation, options);
  if (options.checkpoints.write) {
    control.checkpoint = [&](const tally::Totals& totals) {
      tally::Result result = result_of(model, totals, control.ending, "checkpoint", options);
      result.state = totals.state();
      options.checkpoints.write(result);
    };
  }
  tally::Totals totals = run_batches(model, control, options.lanes);
  Ending& ending = control.ending;
  tally::Result result = result_of(model, totals, ending, ending.stopped_by, options);
  result.state = ending.whole ? std::move(*ending.whole) : std::move(totals).state();
  return result;
}

}  // namespace photic::run
