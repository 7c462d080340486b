#include "run/contest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "core/stop.hpp"
#include "estimator/make_world.hpp"
#include "estimator/random_blocks.hpp"
#include "estimator/walk_attenuation.hpp"
#include "run/batches.hpp"
#include "run/prices.hpp"
#include "scene/tally_memory.hpp"
#include "scene/walk_settings.hpp"
#include "tally/batch_tally.hpp"
#include "tally/error_bars.hpp"
#include "tally/totals.hpp"

namespace photic::run {
namespace {

// Pilots have many small batches, for good estimates of their errors: those of the bidirectional
// estimator have so many photons each, fewer for a run of few.
constexpr std::uint64_t min_in_batch = 16, max_in_batch = 64;
/// Photons of the forward estimator cost so much less that its pilots have more of them.
constexpr std::uint64_t forward_factor = 8;
constexpr std::uint64_t first_batches = 16, max_batches = 160;

/// The squared error that the best pilot knows a gate to, if it counts: 10 % after the last stage,
/// in proportion before. The pilots of an estimator that misses rare large scores look best where
/// none knows more.
constexpr double known_at_last = 0.01;

/// The largest shares of the operations of the run that pilots take: those of the contenders, and
/// all.
constexpr double contenders_share = 0.05, pilots_share = 0.1;
/// A contender that needs so many times the work of the best after a stage does not come back.
constexpr double clearly_worse = 8;
/// A setting that is not so many times cheaper is taken for so large a gain, by which comparisons
/// of pilots scatter (docs/decisions/0052).
constexpr double clearly_cheaper = 1.2, gain = 1.3;
/// Pilots for a run that ends by the clock alone have so many batches.
constexpr std::uint64_t usual_batches = 64;

/// Sums that take more begin anew in each stage: those of several contenders are kept at once.
constexpr double max_kept_bytes = 1e8;

/// The engine of pilots, whichever engine runs after them: choices are to be the same, and soon
/// made. Scores of lanes are the same by any instructions, and so but for rounding are their sums.
Isa engine_of_pilots(const RunOptions& options) {
  return options.lanes.value_or(isas_here().back());
}

estimator::Model model_of(const estimator::Model& open, const Contender& contender,
                          const std::stop_token& stop) {
  scene::Simulation s = contender.simulation;
  s.seed ^= estimator::pilot_stream;
  s.photons.reset();
  s.target_relative_error.reset();
  s.max_time_s.reset();
  s.batch_photons.reset();
  s.batch_photons = estimator::batch_photons(s);  // of any run: pilots have smaller ones in these
  return estimator::simulated_by(open, s, stop);
}

PricedScene priced_scene(const estimator::Model& model) {
  constexpr std::size_t group = tally::EnvironmentScores::size;
  return {.layered = model.medium.layers() > 1 || model.air.has_value(),
          .film = model.scene.oil.has_value(),
          .environments = (model.shape.environments + group - 1) / group * group};
}

/// The pilot of one contender, which can go on.
class Trial {
 public:
  Trial(const estimator::Model& open, const Contender& contender, std::uint64_t in_batch,
        const std::stop_token& stop)
      : model_(model_of(open, contender, stop)),
        forward_(estimator() == scene::Estimator::forward),
        in_batch_(in_batch * (forward_ ? forward_factor : 1)),
        keeps_(scene::tally_memory(open.scene).bytes() < max_kept_bytes) {}

  void go_on_to(std::uint64_t batches, const RunOptions& options) {
    model_.scene.simulation.photons = photons_ = batches * in_batch_;
    RunOptions quiet;
    quiet.threads = options.threads;
    quiet.monitor = options.monitor;
    quiet.permits = options.permits;
    quiet.start = std::move(so_far_);
    RunControl control(model_.scene.simulation, quiet, in_batch_);
    tally::Totals totals = run_batches(model_, control, engine_of_pilots(options));
    break_off_if(options.stop());
    if (options.monitor != nullptr)
      options.monitor->update([](Progress& progress) { ++progress.pilots_done; });
    tally::Result result = estimator::describe(model_);
    totals.fill(result);
    // By batches alone: what a pilot has not seen does not fall off as 1 / sqrt(photons).
    for (std::size_t cell = 0; cell < result.echo.mean.size(); ++cell)
      result.echo.standard_error[cell] =
          tally::standard_error(totals.state().echo[cell].low, totals.counted(cell));
    scores_ = static_cast<double>(totals.scores());
    const double before = keeps_ ? pilot_.cost : 0;
    const double cost = instructions(forward_ ? forward_prices : bidirectional_prices,
                                     totals.state(), priced_scene(model_));
    pilot_ = pilot_of(result, cost, share_between_estimators);
    pilot_of_setting_ = pilot_of(result, cost, share_between_settings);
    operations_ += cost - before;
    if (keeps_)
      so_far_ = Start{.state = std::move(totals).state(), .wall_time_s = 0, .file = "a pilot run"};
  }

  [[nodiscard]] const Pilot& pilot() const { return pilot_; }
  /// As it is compared with another setting of the same estimator.
  [[nodiscard]] const Pilot& pilot_of_setting() const { return pilot_of_setting_; }
  [[nodiscard]] std::uint64_t photons() const { return photons_; }
  [[nodiscard]] double scores() const { return scores_; }
  [[nodiscard]] scene::Estimator estimator() const { return model_.scene.simulation.estimator; }
  /// The operations of all stages.
  [[nodiscard]] double operations() const { return operations_; }
  [[nodiscard]] double cost_per_photon() const {
    return pilot_.cost / static_cast<double>(photons_);
  }

 private:
  estimator::Model model_;
  bool forward_;
  std::uint64_t in_batch_, photons_ = 0;
  bool keeps_;
  std::optional<Start> so_far_;
  double operations_ = 0, scores_ = 0;
  Pilot pilot_, pilot_of_setting_;
};

/// Has a monitor know of pilots before they run.
void announce(std::size_t pilots, const RunOptions& options) {
  if (options.monitor == nullptr) return;
  options.monitor->update([&](Progress& progress) {
    progress.phase = Phase::choosing;
    progress.pilots += pilots;
  });
}

class Contest {
 public:
  Contest(const estimator::Model& model, const std::vector<Contender>& contenders,
          const RunOptions& options)
      : model_(model), asked_(model.scene.simulation), options_(options) {
    in_batch_ = std::clamp(asked_.photons.value_or(std::numeric_limits<std::uint64_t>::max()) /
                               (first_batches * min_in_batch),
                           min_in_batch, max_in_batch);
    for (const Contender& c : contenders) trials_.emplace_back(model, c, in_batch_, options.stop());
    for (std::size_t i = 0; i < trials_.size(); ++i) staying_.push_back(i);
    out_.standing.resize(trials_.size());
    out_.aim = aim_of(asked_);
  }

  /// The best contender.
  std::optional<std::size_t> decide() {
    for (stage(batches_); goes_on(batches_); stage(batches_)) {
      batches_ = next(batches_);
      for (Standing& standing : out_.standing) standing.given_up_early = true;
      for (const std::size_t i : staying_) out_.standing[i].given_up_early = false;
    }
    return out_.best;
  }

  /// Tries settings with the best contender, whose simulation is `best`.
  void try_settings(const std::vector<Setting>& settings, const scene::Simulation& best) {
    out_.simulation = best;
    for (const Setting& setting : settings) try_with_best(setting);
  }
  Outcome outcome() && { return std::move(out_); }

 private:
  static std::uint64_t next(std::uint64_t batches) { return std::min(2 * batches, max_batches); }

  [[nodiscard]] std::vector<Pilot> pilots() const {
    std::vector<Pilot> out;
    for (const std::size_t i : staying_) out.push_back(trials_[i].pilot());
    return out;
  }

  void stage(std::uint64_t batches) {
    announce(staying_.size(), options_);
    for (const std::size_t i : staying_) {
      trials_[i].go_on_to(batches, options_);
      out_.standing[i].photons = trials_[i].photons();
    }
    out_.operations = 0;
    for (const Trial& trial : trials_) out_.operations += trial.operations();
    const std::vector<Pilot> now = pilots();
    const std::vector<bool> compared = gates_compared(now, known_to());
    const auto best = best_among(staying_, compared);
    if (!best) return;
    out_.best = best_ = *best;
    out_.gates = static_cast<std::size_t>(std::ranges::count(compared, true));
    const Trial& first = trials_[best_];
    work_of_worst_ = work_of_worst(first.pilot(), compared);
    std::vector<std::size_t> stay;
    for (const std::size_t i : staying_) {
      Standing& standing = out_.standing[i];
      standing.times_the_work = times_the_work(trials_[i], first, compared);
      standing.rows_unseen = first.pilot().rows_seen - trials_[i].pilot().rows_seen;
      if (i == best_ || standing.times_the_work < clearly_worse) stay.push_back(i);
    }
    staying_ = std::move(stay);
  }

  /// Of each estimator the best settings, and of these the best.
  [[nodiscard]] std::optional<std::size_t> best_among(const std::vector<std::size_t>& all,
                                                      const std::vector<bool>& compared) const {
    std::map<scene::Estimator, std::vector<std::size_t>> settings_of;
    for (const std::size_t i : all) settings_of[trials_[i].estimator()].push_back(i);
    const auto best_of_trials = [&](const std::vector<std::size_t>& some, auto pilot) {
      std::vector<Pilot> pilots;
      for (const std::size_t i : some) pilots.push_back((trials_[i].*pilot)());
      const auto best = best_of(pilots, compared, out_.aim);
      return best ? std::optional(some[*best]) : std::nullopt;
    };
    std::vector<std::size_t> best_of_each;
    for (const auto& [estimator, settings] : settings_of)
      if (const auto best = best_of_trials(settings, &Trial::pilot_of_setting))
        best_of_each.push_back(*best);
    if (best_of_each.empty()) return std::nullopt;
    return best_of_trials(best_of_each, &Trial::pilot);
  }

  /// The work of a trial over that of another one.
  [[nodiscard]] double times_the_work(const Trial& one, const Trial& other,
                                      const std::vector<bool>& compared) const {
    const auto work = [&](const Trial& trial) {
      const bool alike = one.estimator() == other.estimator();
      return badness(alike ? trial.pilot_of_setting() : trial.pilot(), compared, out_.aim);
    };
    return std::exp(work(one) - work(other));
  }

  /// The squared error that a gate has to be known to after so many batches as there are.
  [[nodiscard]] double known_to() const {
    return known_at_last * static_cast<double>(max_batches) / static_cast<double>(batches_);
  }

  void try_with_best(const Setting& setting) {
    if (setting.of_walks && out_.simulation.estimator != scene::Estimator::bidirectional) return;
    const Pilot best = trials_[best_].pilot_of_setting();
    scene::Simulation changed = out_.simulation;
    setting.apply(changed);
    if (changed == out_.simulation || !affords(best.cost)) return;
    announce(1, options_);
    trials_.emplace_back(model_, Contender{setting.name, changed}, in_batch_, options_.stop());
    trials_.back().go_on_to(batches_, options_);
    out_.operations += trials_.back().operations();
    const std::vector<Pilot> both{best, trials_.back().pilot_of_setting()};
    const std::vector<bool> compared = gates_compared(both, known_to());
    const double work = times_the_work(trials_.back(), trials_[best_], compared);
    const bool cheaper = both[1].cost * clearly_cheaper <= both[0].cost;
    const bool taken = best_of(both, compared, out_.aim) == 1U && (cheaper || work * gain <= 1);
    out_.tried.push_back({setting.name, work, taken});
    if (!taken) return;
    best_ = trials_.size() - 1;
    work_of_worst_ = work_of_worst(trials_.back().pilot(), compared);
    out_.simulation = changed;
  }
  [[nodiscard]] bool affords(double operations) const {
    const auto expected = expected_operations();
    return !expected || out_.operations + operations <= pilots_share * *expected;
  }

  /// The operations of the run, as the best pilot predicts them; none: it ends by the clock.
  [[nodiscard]] std::optional<double> expected_operations() const {
    std::optional<double> out;
    if (asked_.photons) {
      out = trials_[best_].cost_per_photon() * static_cast<double>(*asked_.photons);
    }
    if (asked_.target_relative_error) {
      const double to_target = work_of_worst_ / std::pow(*asked_.target_relative_error, 2);
      out = std::min(out.value_or(to_target), to_target);
    }
    return out;
  }

  [[nodiscard]] bool goes_on(std::uint64_t batches) const {
    if (batches == max_batches || (out_.best && staying_.size() == 1)) return false;
    const auto expected = out_.best ? expected_operations() : std::nullopt;
    if (!expected) return next(batches) <= usual_batches;
    const double factor = static_cast<double>(next(batches)) / static_cast<double>(batches);
    double then = out_.operations;
    for (const std::size_t i : staying_) then += (factor - 1) * trials_[i].pilot().cost;
    return then <= contenders_share * *expected;
  }

  const estimator::Model& model_;
  const scene::Simulation& asked_;
  const RunOptions& options_;
  std::uint64_t in_batch_ = min_in_batch, batches_ = first_batches;
  std::vector<Trial> trials_;
  std::vector<std::size_t> staying_;  ///< of the trials, ascending
  std::size_t best_ = 0;              ///< of the trials
  double work_of_worst_ = 0;          ///< of the best one
  Outcome out_;
};

}  // namespace

PilotScores scores_of_first_pilot(const estimator::Model& model,
                                  const scene::Simulation& simulation, const RunOptions& options) {
  announce(1, options);
  Trial trial(model, {{}, simulation}, min_in_batch, options.stop());
  trial.go_on_to(first_batches, options);
  const double receivers = static_cast<double>(estimator::count_receivers(model));
  return {trial.scores(), static_cast<double>(trial.photons()) * receivers /
                              static_cast<double>(simulation.walks.value_or(scene::usual_walks))};
}

Outcome contend(const estimator::Model& model, const std::vector<Contender>& contenders,
                const std::vector<Setting>& settings, const RunOptions& options) {
  Contest contest(model, contenders, options);
  if (const auto best = contest.decide())
    contest.try_settings(settings, contenders[*best].simulation);
  return std::move(contest).outcome();
}

}  // namespace photic::run
