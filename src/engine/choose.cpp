#include "engine/choose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/batches.hpp"
#include "engine/problem.hpp"

namespace photic::engine {
namespace {

constexpr std::uint64_t pilot_photons = 10000;  // of the bidirectional estimator
/// Photons of the forward estimator cost so much less that its pilot has more of them.
constexpr std::uint64_t forward_pilot_photons = 8 * pilot_photons;
/// Folded into the seed: pilots share no random number with the run.
constexpr std::uint64_t pilot_stream = 0x1e3779b97f4a7c15;

/// What a score offered to the tallies costs, in units of a collision: of a walk that is to be
/// connected, or of the forward estimator, there for each telescope. Fitted to CPU times, which it
/// gives within a factor of 1.9 (docs/decisions/0009).
constexpr double cost_of_score = 0.43;

/// A short run of a heavy-tailed estimator looks better than it is. Where a single score carries
/// more than this share of a gate, the squared error is taken to be larger by as much as it does.
constexpr double largest_known_score = 2e-3;
/// And where nothing was scored at all:
constexpr double unknown_squared_error = 1.0;

/// Where c' is smaller than b, weights grow at every vertex. The tail that this makes is longer
/// than a pilot, so such settings do not contend.
constexpr double least_attenuation_per_albedo = 0.9;

struct Contender {
  scene::Scene scene;
  std::string name;
  double cost = 0;
  std::vector<double> squared_error{};  ///< relative, of the mean, by cell; 0: nothing was scored
};

scene::Scene settled(const scene::Scene& scene, const std::string& estimator) {
  scene::Scene out = scene;
  out.simulation.estimator = estimator;
  return out;
}

/// b / c of the laser's light where it is largest.
double highest_albedo(const scene::Scene& scene) {
  const medium::Medium medium = make_problem(settled(scene, "bidirectional")).medium;
  return *std::max_element(medium.albedo.begin(), medium.albedo.begin() + medium.layers());
}

std::vector<Contender> contenders(const scene::Scene& scene) {
  std::vector<Contender> out;
  const double least = least_attenuation_per_albedo * highest_albedo(scene);
  for (const double walk_attenuation : {0.35, 0.6, 0.9}) {
    if (walk_attenuation < least) continue;
    Contender c{settled(scene, "bidirectional"),
                fmt::format("bidirectional with walk_attenuation = {}", walk_attenuation)};
    c.scene.simulation.walk_attenuation = walk_attenuation;
    out.push_back(std::move(c));
  }
  out.push_back({settled(scene, "forward"), "forward"});
  return out;
}

/// What pilots run in, whichever engine runs after them: that choices are the same, and soon made.
/// Scores of lanes are the same by any instructions, and so but for rounding are their sums.
Isa engine_of_pilots(const RunOptions& options) {
  return options.lanes.value_or(isas_here().back());
}

void try_out(Contender& contender, const RunOptions& options) {
  scene::Scene pilot = contender.scene;
  pilot.simulation.seed ^= pilot_stream;
  const bool forward = pilot.simulation.estimator == "forward";
  pilot.simulation.photons = forward ? forward_pilot_photons : pilot_photons;
  pilot.simulation.target_relative_error.reset();
  pilot.simulation.max_time_s.reset();
  RunOptions quiet;  // and not interrupted: half a pilot would choose otherwise
  quiet.threads = options.threads;
  const Problem problem = make_problem(pilot);
  Conductor conductor(pilot.simulation, quiet);
  const tally::Totals totals = run_batches(problem, conductor, engine_of_pilots(options));
  tally::Result result = describe(problem);
  totals.fill(result);

  const double per_collision = forward ? static_cast<double>(pilot.telescope.size()) : 1.0;
  contender.cost = per_collision * static_cast<double>(result.collisions) +
                   cost_of_score * static_cast<double>(totals.scores());
  for (std::size_t cell = 0; cell < result.echo.mean.size(); ++cell) {
    const double mean = result.echo.mean[cell];
    const double relative = mean > 0 ? result.echo.standard_error[cell] / mean : 0.0;
    const double tail = std::max(1.0, result.largest_score_share[cell] / largest_known_score);
    contender.squared_error.push_back(relative * relative * tail);
  }
}

/// Mean over the gates of the logarithm of the squared error times the cost.
double badness(const Contender& contender, const std::vector<bool>& counts) {
  double sum = 0;
  double cells = 0;
  for (std::size_t cell = 0; cell < counts.size(); ++cell) {
    if (!counts[cell]) continue;
    const double e = contender.squared_error[cell];
    sum += std::log((e > 0 ? e : unknown_squared_error) * contender.cost);
    cells += 1;
  }
  return cells > 0 ? sum / cells : 0.0;
}

}  // namespace

scene::Scene choose_estimator(const scene::Scene& scene, const RunOptions& options) {
  if (scene.simulation.estimator != "auto") return scene;
  if (scene.simulation.tools.any()) {
    scene::Scene forward = settled(scene, "forward");
    forward.simulation.estimator_reason =
        "the only one that has the tools asked for in this version";
    return forward;
  }
  auto all = contenders(scene);
  for (Contender& contender : all) try_out(contender, options);
  std::vector<bool> counts(all.front().squared_error.size());  // gates that light reaches
  for (const Contender& contender : all) {
    for (std::size_t cell = 0; cell < counts.size(); ++cell)
      counts[cell] = counts[cell] || contender.squared_error[cell] > 0;
  }
  const auto best = std::min_element(all.begin(), all.end(), [&](const auto& a, const auto& b) {
    return badness(a, counts) < badness(b, counts);
  });
  std::string reason = fmt::format(
      "pilot runs of {} photons (forward {}); squared error at equal cost, geometric mean over {} "
      "gates:",
      pilot_photons, forward_pilot_photons, std::count(counts.begin(), counts.end(), true));
  for (const Contender& contender : all) {
    reason += fmt::format("{} {} {:.3g}", &contender == &all.front() ? "" : ",", contender.name,
                          std::exp(badness(contender, counts) - badness(*best, counts)));
  }
  best->scene.simulation.estimator_reason = reason;
  return best->scene;
}

}  // namespace photic::engine
