#include "run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include "core/error.hpp"
#include "core/stop.hpp"
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
                        const std::optional<Isa>& lanes) {
  tally::Result result = estimator::describe(model);
  totals.fill(result);
  result.engine = schedule::engine_name(lanes);
  result.version = PHOTIC_VERSION;
  result.stopped_by = stopped_by;
  result.partial = stopped_by == "interrupt" || stopped_by == "checkpoint";
  result.wall_time_s = ending.wall_time_before_s + ending.wall_time_s;
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

using SharedModel = std::shared_ptr<const estimator::Model>;

/// A scene whose estimator has been chosen, ready to be simulated.
struct Prepared {
  SharedModel model;
  std::unique_ptr<schedule::Simulator> simulator;
};

Prepared prepare(const scene::Scene& asked, const optics::Library& library,
                 const RunOptions& options) {
  try {
    Prepared out;
    out.model = std::make_shared<const estimator::Model>(model_to_run(asked, library, options));
    out.simulator = schedule::make_simulator(*out.model, options.lanes, options.stop());
    break_off_if(options.stop());
    return out;
  } catch (const Stopped&) {
    throw StoppedBeforeFirstBatch();
  }
}

/// A builder of results for a monitor, from a copy: the run may have ended by then.
Monitor::Builder builder(const SharedModel& model, std::optional<BatchRunner::SoFar> so_far,
                         const std::optional<Isa>& lanes) {
  if (!so_far) return nullptr;
  return [model, lanes, so_far = std::move(so_far)](bool with_state) {
    tally::Result result = result_of(*model, so_far->totals, so_far->ending, "checkpoint", lanes);
    if (with_state) result.state = so_far->totals.state();
    return result;
  };
}

/// Shows the batches of a run to its monitor while they are simulated.
class Shown {
 public:
  Shown(const SharedModel& model, RunControl& control, BatchRunner& runner,
        const RunOptions& options)
      : monitor_(options.monitor) {
    if (monitor_ == nullptr) return;
    control.shown_to = monitor_;
    monitor_->update([&](Progress& progress) {
      const scene::Simulation& asked = model->scene.simulation;
      progress.phase = Phase::running;
      progress.photons_before = options.start ? options.start->state.photons : 0;
      progress.photons = progress.photons_before;
      progress.photons_asked = asked.photons;
      progress.max_time_s = asked.max_time_s;
      progress.target = asked.target_relative_error;
    });
    monitor_->show(
        [=, &runner, lanes = options.lanes] { return builder(model, runner.so_far(), lanes); });
  }
  Shown(const Shown&) = delete;
  Shown& operator=(const Shown&) = delete;
  ~Shown() {
    if (monitor_ != nullptr) monitor_->hide();
  }

 private:
  Monitor* monitor_;
};

/// Has a monitor see the end of a run, with a result or without.
class Ended {
 public:
  explicit Ended(Monitor* monitor) : monitor_(monitor) {}
  Ended(const Ended&) = delete;
  Ended& operator=(const Ended&) = delete;
  ~Ended() {
    if (monitor_ == nullptr) return;
    monitor_->update([](Progress& progress) { progress.phase = Phase::ended; });
  }

 private:
  Monitor* monitor_;
};

/// Simulates, for all to see. What that takes besides the totals is gone at its end.
tally::Totals simulate(const SharedModel& model, std::unique_ptr<schedule::Simulator> simulator,
                       RunControl& control, const RunOptions& options) {
  BatchRunner runner(*model, *simulator, control);
  const Shown shown(model, control, runner, options);
  return runner.run();
}

}  // namespace

tally::Totals run_batches(const estimator::Model& model, RunControl& control,
                          const std::optional<Isa>& lanes) {
  return BatchRunner(model, *schedule::make_simulator(model, lanes, control.stop()), control).run();
}

tally::Result run(const scene::Scene& asked, const optics::Library& library,
                  const RunOptions& options) {
  const Ended ended(options.monitor);
  if (options.lanes) check_lanes(*options.lanes);
  if (options.lanes && asked.is_of_spherical_air())
    throw InputError({{.file = "--engine lanes",
                       .reason = "spherical air is followed in double, by the scalar engine alone",
                       .suggestion = "leave out --engine and --isa"}});
  auto [model, simulator] = prepare(asked, library, options);
  RunControl control(model->scene.simulation, options);
  tally::Totals totals = simulate(model, std::move(simulator), control, options);
  if (totals.state().batches == 0) throw StoppedBeforeFirstBatch();
  const Ending& ending = control.ending;
  tally::Result result = result_of(*model, totals, ending, ending.stopped_by, options.lanes);
  result.state = ending.whole ? std::move(control.ending.whole) : std::move(totals).state();
  return result;
}

}  // namespace photic::run
