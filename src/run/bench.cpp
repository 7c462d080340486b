#include "run/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <utility>

#include "core/error.hpp"
#include "core/stop.hpp"
#include "estimator/model.hpp"
#include "estimator/random_blocks.hpp"
#include "estimator/unused_settings.hpp"
#include "estimator/walk_attenuation.hpp"
#include "run/batches.hpp"
#include "run/choose.hpp"
#include "run/free_meetings.hpp"
#include "scene/forward_settings.hpp"
#include "scene/walk_settings.hpp"
#include "scene/waves.hpp"
#include "schedule/engines.hpp"

namespace photic::run {
namespace {

constexpr int repeat_count = 12;
constexpr double reference_share = 0.5;  // of the time
/// The largest share of the squared distance from the reference that may be the reference's own.
constexpr double largest_own_share = 0.25;

constexpr std::uint64_t first_trial_photons = 100;
constexpr double trial_share = 0.02;  // of a candidate's time: long enough to measure its speed

Candidate candidate(const scene::Scene& scene, scene::Estimator estimator,
                    const std::string& name) {
  const scene::Simulation defaults;
  Candidate c{.name = name, .simulation = scene.simulation};
  c.lanes = isas_here().back();
  scene::Simulation& s = c.simulation;
  s.estimator = estimator;
  s.estimator_reason.reset();
  s.photons.reset();
  s.target_relative_error.reset();
  s.max_time_s.reset();
  s.reception = defaults.reception;
  s.walks = scene::usual_walks;
  s.meetings = s.meetings.value_or(scene::usual_meetings);
  s.connected_fraction = scene::usual_connected_fraction;
  s.walk_attenuation.reset();
  s.sampling = defaults.sampling;
  if (estimator == scene::Estimator::forward) {
    s.directed_fraction = scene::directed_fraction_in(scene);
    s.scored_points = scene::scored_points_in(scene);
  } else {
    s.tools = defaults.tools;
  }
  return c;
}

/// Walks that take a share of the attenuation; `more`: what else its name says.
Candidate bidirectional(const scene::Scene& scene, double walk_attenuation,
                        const std::string& more = "") {
  Candidate c = candidate(scene, scene::Estimator::bidirectional,
                          fmt::format("bidirectional, {}{}", walk_attenuation, more));
  c.simulation.walk_attenuation = walk_attenuation;
  return c;
}

/// The choice of `auto`.
Candidate chosen_by_auto(const scene::Scene& scene, const optics::Library& library,
                         const RunOptions& pilots) {
  scene::Scene open = scene;
  open.simulation.estimator = scene::Estimator::automatic;
  open.simulation.estimator_reason.reset();
  const auto chosen = model_to_run(open, library, pilots).scene.simulation;
  Candidate c = candidate(scene, chosen.estimator, "as auto chooses");
  c.simulation = chosen;
  c.simulation.batch_photons = scene.simulation.batch_photons;  // its repeats have fewer
  c.simulation.photons.reset();
  c.simulation.target_relative_error.reset();
  c.simulation.max_time_s.reset();
  return c;
}

std::vector<Candidate> candidates(const scene::Scene& scene, const optics::Library& library,
                                  const RunOptions& pilots) {
  const estimator::Model model = estimator::make_model(scene, library);
  const double highest_albedo = estimator::highest_albedo(model.medium);
  std::vector<Candidate> out{chosen_by_auto(scene, library, pilots)};
  out.push_back(candidate(scene, scene::Estimator::forward, "forward, ray"));
  const scene::Simulation usual_forward = out.back().simulation;
  for (const auto& [directed_fraction, scored_points] : scene::forward_settings(scene)) {
    if (directed_fraction == usual_forward.directed_fraction &&
        scored_points == usual_forward.scored_points)
      continue;
    Candidate c = candidate(
        scene, scene::Estimator::forward,
        fmt::format("forward, ray, {} directed, points {}", directed_fraction, scored_points));
    c.simulation.directed_fraction = directed_fraction;
    c.simulation.scored_points = scored_points;
    out.push_back(std::move(c));
  }
  if (!scene.sea.surface.is_rough() && !scene.oil && !scene.atmosphere) {  // they have no overlap
    out.push_back(candidate(scene, scene::Estimator::forward, "forward, overlap"));
    out.back().simulation.reception = scene::Reception::overlap;
    out.back().exact = false;
  }
  for (const double walk_attenuation : estimator::walk_attenuations(highest_albedo))
    out.push_back(bidirectional(scene, walk_attenuation));
  const double usual = estimator::usual_walk_attenuation(highest_albedo);
  out.push_back(bidirectional(scene, usual, ", free walks"));
  if (const auto free = usual_free_meetings(model, out.back().simulation, pilots)) {
    out.back().simulation.free_telescope_meetings = free->telescope;
    out.back().simulation.free_laser_meetings = free->laser;
  } else {
    out.pop_back();
  }
  if (estimator::converts_light(model.medium)) {
    out.push_back(bidirectional(scene, usual, ", conversion 0.6"));
    out.back().simulation.conversion_probability = 0.6;
  }
  out.push_back(bidirectional(scene, usual, ", meetings 30"));
  out.back().simulation.meetings = 30;
  out.push_back(bidirectional(scene, usual, ", walks 4"));
  out.back().simulation.walks = 4;
  out.push_back(bidirectional(scene, usual, ", all connected"));
  out.back().simulation.connected_fraction = 1;
  out.push_back(bidirectional(scene, usual, ", random"));
  out.back().simulation.sampling = scene::Sampling::random;
  out.push_back(candidate(scene, scene::Estimator::forward, "forward, ray, scalar"));
  out.back().lanes.reset();
  out.push_back(bidirectional(scene, usual, ", scalar"));
  out.back().lanes.reset();
  return out;
}

double cpu_now_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Timed {
  tally::Totals totals;
  double cpu_s = 0;
};

/// Runs of one candidate on threads; every one has random numbers of its own.
class Bench {
 public:
  Bench(scene::Scene scene, const optics::Library& library, const Candidate& candidate,
        const BenchOptions& options)
      : options_(options), lanes_(candidate.lanes) {
    scene.simulation = candidate.simulation;
    scene.environment.clear();  // not all estimators have them
    scene.sensitivity.clear();
    model_ = std::make_unique<estimator::Model>(estimator::make_model(scene, library));
  }

  /// The photons of one.
  [[nodiscard]] std::uint64_t batch() const {
    return estimator::batch_photons(model_->scene.simulation);
  }

  /// Until the photons or the time of the simulation are used up.
  Timed run(std::uint64_t number, std::optional<std::uint64_t> photons,
            std::optional<double> max_time_s = {}) {
    scene::Simulation& s = model_->scene.simulation;
    const std::uint64_t seed = s.seed;
    s.seed = (seed ^ estimator::bench_stream) + number;
    s.photons = photons;
    s.max_time_s = max_time_s;
    RunOptions quiet;
    quiet.threads = options_.threads;
    quiet.monitor = options_.monitor;
    RunControl control(s, quiet);
    const double begin = cpu_now_s();
    Timed out{run_batches(*model_, control, lanes_)};
    out.cpu_s = cpu_now_s() - begin;
    s.seed = seed;
    break_off_if(quiet.stop());
    return out;
  }

  /// The result of the totals of a run.
  [[nodiscard]] tally::Result result(const tally::Totals& totals) const {
    tally::Result out = estimator::describe(*model_);
    totals.fill(out);
    return out;
  }

 private:
  const BenchOptions& options_;
  std::optional<Isa> lanes_;
  std::unique_ptr<estimator::Model> model_;
};

/// The number of photons that take this CPU time, by trials that grow until they last long enough.
std::uint64_t photons_in(double cpu_s, double trial_cpu_s, Bench& bench, std::uint64_t number) {
  std::uint64_t photons = first_trial_photons;
  double took = bench.run(number, photons).cpu_s;
  while (took < trial_cpu_s) {
    photons *= 4;
    took = bench.run(number, photons).cpu_s;
  }
  const double asked = static_cast<double>(photons) * cpu_s / took;
  const auto out = static_cast<std::uint64_t>(std::max(asked, 1.0));
  const std::uint64_t whole_batch = bench.batch();
  return out < whole_batch ? out : out / whole_batch * whole_batch;
}

void measure(Candidate& candidate, std::size_t place, const scene::Scene& scene,
             const optics::Library& library, const Comparison& comparison, double cpu_s,
             const BenchOptions& options) {
  Bench bench(scene, library, candidate, options);
  std::uint64_t number = 1 + place * (repeat_count + 1);  // 0 is the reference's
  candidate.photons = photons_in(cpu_s / repeat_count, trial_share * cpu_s, bench, number);
  const tally::Result& reference = comparison.reference;
  std::vector<std::vector<double>> echo(reference.echo.mean.size());
  double cpu_sum_s = 0;
  for (int i = 0; i < repeat_count; ++i) {
    const Timed repeat = bench.run(++number, candidate.photons);
    cpu_sum_s += repeat.cpu_s;
    const tally::Result result = bench.result(repeat.totals);
    for (std::size_t cell = 0; cell < echo.size(); ++cell)
      echo[cell].push_back(result.echo.mean[cell]);
  }
  candidate.cpu_s = cpu_sum_s / repeat_count;
  for (std::size_t cell = 0; cell < echo.size(); ++cell) {
    const bool converged = reference.convergence_flags[cell] == 0;
    candidate.merit.push_back(
        converged
            ? merit_of(echo[cell], {reference.echo.mean[cell], reference.echo.standard_error[cell]},
                       candidate.cpu_s)
            : Merit{});
  }
}

void find_compared(Comparison& comparison) {
  const std::size_t cells = comparison.reference.echo.mean.size();
  for (std::size_t cell = 0; cell < cells; ++cell) {
    comparison.compared.push_back(
        std::all_of(comparison.candidates.begin(), comparison.candidates.end(),
                    [cell](const Candidate& c) { return c.merit[cell].known; }));
  }
}

Comparison compare_all(const scene::Scene& scene, const optics::Library& library,
                       const BenchOptions& options) {
  const auto report = [&](const std::string& line) {
    if (options.report) options.report(line);
  };
  if (const auto reason = scene::bidirectional_lacks(scene))
    throw InputError(
        {{"", 0, 0,
          "photic bench compares the estimators, and the bidirectional one cannot treat " + *reason,
          scene.sea.column.empty() ? "compare them with sea.surface = { model = \"flat\" }"
                                   : "compare them in one of its waters, as [[sea.layer]]"}});
  Comparison out;
  out.repeats = repeat_count;
  out.aim = aim_of(scene.simulation);
  report("the reference");
  const double albedo = estimator::highest_albedo(estimator::make_model(scene, library).medium);
  const Candidate best_known = bidirectional(scene, estimator::usual_walk_attenuation(albedo));
  out.reference_name = best_known.name;
  Bench bench(scene, library, best_known, options);
  const Timed reference = bench.run(0, {}, reference_share * options.time_s);
  out.reference = bench.result(reference.totals);
  out.reference_cpu_s = reference.cpu_s;

  report("what auto chooses");
  RunOptions pilots;
  pilots.threads = options.threads;
  pilots.monitor = options.monitor;
  out.candidates = candidates(scene, library, pilots);
  // The reference has had all threads for as long as the candidates have together.
  const double cpu_s = reference.cpu_s * (1 - reference_share) / reference_share /
                       static_cast<double>(out.candidates.size());
  for (std::size_t i = 0; i < out.candidates.size(); ++i) {
    report(out.candidates[i].name);
    measure(out.candidates[i], i, scene, library, out, cpu_s, options);
  }
  find_compared(out);
  return out;
}

}  // namespace

Merit merit_of(const std::vector<double>& repeats, const ReferenceEcho& reference, double cpu_s) {
  expect(!repeats.empty() && reference.mean > 0, "repeats of an echo that is there");
  double sum = 0;
  for (const double x : repeats) sum += (x - reference.mean) * (x - reference.mean);
  const double distance = sum / static_cast<double>(repeats.size());
  const double own = reference.standard_error * reference.standard_error;
  Merit out;
  out.known = distance > 0 && own <= largest_own_share * distance;
  out.relative_variance =
      (out.known ? distance - own : distance) / (reference.mean * reference.mean);
  if (distance > 0) out.figure_of_merit = 1 / (out.relative_variance * cpu_s);
  return out;
}

double relative_uncertainty(int repeats) { return std::sqrt(2.0 / repeats); }

std::optional<double> merit_in(const Comparison& comparison, const Candidate& candidate,
                               std::size_t first, std::size_t last, Aim aim) {
  std::vector<double> work;
  for (std::size_t cell = first; cell < last; ++cell)
    if (comparison.compared[cell]) work.push_back(1 / candidate.merit[cell].figure_of_merit);
  if (work.empty()) return std::nullopt;
  return std::exp(-log_work(std::move(work), aim));
}

const Candidate* best_of(const Comparison& comparison) {
  const Candidate* best = nullptr;
  double largest = 0;
  for (const Candidate& c : comparison.candidates) {
    const auto merit = merit_in(comparison, c, 0, comparison.compared.size(), comparison.aim);
    if (!c.exact || !merit || *merit <= largest) continue;
    largest = *merit;
    best = &c;
  }
  return best;
}

std::optional<Comparison> compare_estimators(const scene::Scene& scene,
                                             const optics::Library& library,
                                             const BenchOptions& options) {
  try {
    return compare_all(scene, library, options);
  } catch (const Stopped&) {
    return std::nullopt;
  }
}

}  // namespace photic::run
