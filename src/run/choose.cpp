#include "run/choose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "estimator/model.hpp"
#include "estimator/walk_attenuation.hpp"
#include "run/contest.hpp"
#include "scene/forward_settings.hpp"

namespace photic::run {
namespace {

/// What contends: those settings that the scene leaves open.
std::vector<Contender> contenders(const estimator::Model& model) {
  const scene::Simulation& asked = model.scene.simulation;
  std::vector<double> shares =
      estimator::walk_attenuations(estimator::highest_albedo(model.medium));
  if (asked.walk_attenuation) shares = {*asked.walk_attenuation};
  std::vector<Contender> out;
  for (const double share : shares) {
    out.push_back({fmt::format("bidirectional with walk_attenuation = {:.3g}", share), asked});
    out.back().simulation.estimator = scene::Estimator::bidirectional;
    out.back().simulation.walk_attenuation = share;
  }
  for (const auto& [directed_fraction, scored_points] : scene::forward_settings(model.scene)) {
    out.push_back({fmt::format("forward with directed_fraction = {} and scored_points = {}",
                               directed_fraction, scored_points),
                   asked});
    out.back().simulation.estimator = scene::Estimator::forward;
    out.back().simulation.directed_fraction = directed_fraction;
    out.back().simulation.scored_points = scored_points;
  }
  return out;
}

std::string told(const Standing& standing) {
  std::string out = standing.rows_unseen > 0
                        ? fmt::format("no light in {} channels", standing.rows_unseen)
                        : fmt::format("{:.3g}", standing.times_the_work);
  if (standing.given_up_early) out += fmt::format(" (after {} photons)", standing.photons);
  return out;
}

/// What is told of how the contenders did beside the best one.
std::string reason(const std::vector<Contender>& all, const Outcome& outcome,
                   const scene::Simulation& asked) {
  const std::string what =
      outcome.aim == Aim::worst_gates
          ? fmt::format("time until the worst fifth of {} gates has a relative error of {}",
                        outcome.gates, asked.target_relative_error.value())
          : fmt::format("squared error at equal cost, geometric mean over {} gates", outcome.gates);
  const auto [least, most] = std::ranges::minmax(outcome.standing, {}, &Standing::photons);
  std::string out = fmt::format(
      "pilot runs of {} to {} photons; {}, against the best:", least.photons, most.photons, what);
  for (std::size_t i = 0; i < all.size(); ++i) {
    out += fmt::format("{} {} {}", i == 0 ? "" : ",", all[i].name, told(outcome.standing[i]));
  }
  return out;
}

/// Where no pilot saw anything: what finds light that is hard to find, as a scene has it that names
/// this estimator alone.
scene::Scene unseen(scene::Scene scene) {
  scene.simulation.estimator = scene::Estimator::bidirectional;
  scene::Scene out = estimator::make_model(scene).scene;
  out.simulation.estimator_reason = reason_unseen;
  return out;
}

}  // namespace

scene::Scene choose_estimator(const scene::Scene& scene, const RunOptions& options) {
  if (scene.simulation.estimator != scene::Estimator::automatic) return scene;
  scene::Scene chosen = scene;
  scene::Simulation& simulation = chosen.simulation;
  if (scene.simulation.tools.any()) {
    simulation.estimator = scene::Estimator::forward;
    simulation.estimator_reason = "the only one that has the tools asked for in this version";
    return chosen;
  }
  const estimator::Model model = estimator::make_model(scene);
  const std::vector<Contender> all = contenders(model);
  const Outcome outcome = contend(model, all, options);
  if (!outcome.best) return unseen(scene);
  simulation = all[*outcome.best].simulation;
  simulation.estimator_reason = reason(all, outcome, scene.simulation);
  return chosen;
}

}  // namespace photic::run
