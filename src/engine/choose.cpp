#include "engine/choose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "engine/batches.hpp"
#include "engine/pilots.hpp"
#include "engine/problem.hpp"
#include "medium/walk_attenuation.hpp"

namespace photic::engine {
namespace {

constexpr std::uint64_t pilot_photons = 10000;  // of the bidirectional estimator
/// Photons of the forward estimator cost so much less that its pilot has more of them.
constexpr std::uint64_t forward_pilot_photons = 8 * pilot_photons;
/// Folded into the seed: pilots share no random number with the run.
constexpr std::uint64_t pilot_stream = 0x1e3779b97f4a7c15;

/// What a photon costs, in units of a collision, whatever becomes of it: all there is in water that
/// hardly scatters, where the forward estimator takes 0.09 us for one; a collision and what is
/// scored of it take 0.24 us.
constexpr double cost_of_photon = 1;

/// What a score offered to the tallies costs, in units of a collision: of a walk that is to be
/// connected, or of the forward estimator, there for each telescope. Fitted to CPU times, which it
/// gives within a factor of 1.9 (docs/decisions/0009).
constexpr double cost_of_score = 0.43;

struct Contender {
  scene::Scene scene;
  std::string name;
};

scene::Scene settled(const scene::Scene& scene, const std::string& estimator) {
  scene::Scene out = scene;
  out.simulation.estimator = estimator;
  return out;
}

/// Those shares of the attenuation that the scene leaves open.
std::vector<double> walk_attenuations(const scene::Scene& scene) {
  if (scene.simulation.walk_attenuation) return {*scene.simulation.walk_attenuation};
  return medium::walk_attenuations(medium::highest_albedo(make_problem(scene).medium));
}

std::vector<Contender> contenders(const scene::Scene& scene) {
  std::vector<Contender> out;
  for (const double walk_attenuation : walk_attenuations(scene)) {
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

Pilot try_out(const Contender& contender, const RunOptions& options) {
  scene::Scene pilot = contender.scene;
  pilot.simulation.seed ^= pilot_stream;
  const bool forward = pilot.simulation.estimator == "forward";
  pilot.simulation.photons = forward ? forward_pilot_photons : pilot_photons;
  pilot.simulation.target_relative_error.reset();
  pilot.simulation.max_time_s.reset();
  RunOptions quiet;
  quiet.threads = options.threads;
  quiet.interrupt = options.interrupt;
  const Problem problem = make_problem(pilot);
  Conductor conductor(pilot.simulation, quiet);
  const tally::Totals totals = run_batches(problem, conductor, engine_of_pilots(options));
  if (options.interrupt != nullptr && options.interrupt->load()) throw InterruptedPilots();
  tally::Result result = describe(problem);
  totals.fill(result);

  const double per_collision = forward ? static_cast<double>(pilot.telescope.size()) : 1.0;
  return pilot_of(result, cost_of_photon * static_cast<double>(result.photons) +
                              per_collision * static_cast<double>(result.collisions) +
                              cost_of_score * static_cast<double>(totals.scores()));
}

/// What is told of how the contenders did beside the best one.
std::string reason(const std::vector<Contender>& all, const std::vector<Pilot>& pilots,
                   const Pilot& best) {
  const std::vector<bool> counts = gates_seen(pilots);
  std::string out = fmt::format(
      "pilot runs of {} photons (forward {}); squared error at equal cost, geometric mean over {} "
      "gates:",
      pilot_photons, forward_pilot_photons, std::count(counts.begin(), counts.end(), true));
  for (std::size_t i = 0; i < all.size(); ++i) {
    out += fmt::format("{} {} ", i == 0 ? "" : ",", all[i].name);
    const std::size_t seen = pilots[i].rows_seen;
    out +=
        seen < best.rows_seen
            ? fmt::format("saw light in {} channels of {}", seen, best.rows_seen)
            : fmt::format("{:.3g}", std::exp(badness(pilots[i], counts) - badness(best, counts)));
  }
  return out;
}

/// Where no pilot saw anything: what finds light that is hard to find, as a scene has it that names
/// this estimator alone.
scene::Scene unseen(const scene::Scene& scene) {
  scene::Scene out = make_problem(settled(scene, "bidirectional")).scene;
  out.simulation.estimator_reason = reason_unseen;
  return out;
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
  const std::vector<Contender> all = contenders(scene);
  std::vector<Pilot> pilots;
  for (const Contender& contender : all) pilots.push_back(try_out(contender, options));
  const auto best = best_of(pilots);
  if (!best) return unseen(scene);
  scene::Scene chosen = all[*best].scene;
  chosen.simulation.estimator_reason = reason(all, pilots, pilots[*best]);
  return chosen;
}

}  // namespace photic::engine
