#include "run/choose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "estimator/model.hpp"
#include "estimator/unused_settings.hpp"
#include "estimator/walk_attenuation.hpp"
#include "run/contest.hpp"
#include "run/free_meetings.hpp"
#include "scene/forward_settings.hpp"
#include "scene/waves.hpp"

namespace photic::run {
namespace {

/// A bidirectional estimator as it is, and with free walks, where a scene leaves these open and
/// they can be. `name`: of the former.
void add_bidirectional(const scene::Simulation& simulation, const std::string& name,
                       const std::optional<FreeMeetings>& free, std::vector<Contender>& out) {
  out.push_back({name, simulation});
  scene::Simulation& without = out.back().simulation;
  without.free_telescope_meetings = simulation.free_telescope_meetings.value_or(0);
  without.free_laser_meetings = simulation.free_laser_meetings.value_or(0);
  if (!free) return;
  out.push_back({name + " and free walks", simulation});
  scene::Simulation& with = out.back().simulation;
  with.free_telescope_meetings = simulation.free_telescope_meetings.value_or(free->telescope);
  with.free_laser_meetings = simulation.free_laser_meetings.value_or(free->laser);
}
std::optional<FreeMeetings> open_free_meetings(const estimator::Model& model,
                                               const scene::Simulation& bidirectional,
                                               const RunOptions& options) {
  const scene::Simulation& asked = model.scene.simulation;
  if (asked.free_telescope_meetings && asked.free_laser_meetings) return std::nullopt;
  return usual_free_meetings(model, bidirectional, options);
}

/// The settings of a model whose scene names the bidirectional estimator alone.
scene::Simulation usual_bidirectional(const estimator::Model& model) {
  scene::Simulation out = model.scene.simulation;
  out.estimator = scene::Estimator::bidirectional;
  out.walk_attenuation = estimator::walk_attenuation_in(model.medium, out);
  return out;
}

/// The contenders: estimators and settings that the scene leaves open.
std::vector<Contender> contenders(const estimator::Model& model, const RunOptions& options) {
  const scene::Simulation& asked = model.scene.simulation;
  std::vector<Contender> out;
  const scene::Simulation bidirectional = usual_bidirectional(model);
  add_bidirectional(bidirectional, "bidirectional",
                    open_free_meetings(model, bidirectional, options), out);
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

/// The settings to be tried with the best of them, where the scene leaves them open.
std::vector<Setting> settings_to_try(const estimator::Model& model) {
  const scene::Simulation& asked = model.scene.simulation;
  std::vector<Setting> out;
  const auto add = [&](bool of_walks, const char* name, auto member, auto value) {
    if (asked.*member) return;
    out.push_back({fmt::format("{} = {:.3g}", name, static_cast<double>(value)), of_walks,
                   [=](scene::Simulation& s) { s.*member = value; }});
  };
  using scene::Simulation;
  add(true, "meetings", &Simulation::meetings, 30.0);
  if (estimator::converts_light(model.medium))
    add(false, "conversion_probability", &Simulation::conversion_probability, 0.6);
  add(true, "walks", &Simulation::walks, std::int64_t{4});
  for (const double share : estimator::walk_attenuations(estimator::highest_albedo(model.medium)))
    add(true, "walk_attenuation", &Simulation::walk_attenuation, share);
  return out;
}

std::string text_of(const Standing& standing) {
  std::string out = standing.rows_unseen > 0
                        ? fmt::format("no light in {} channels", standing.rows_unseen)
                        : fmt::format("{:.3g}", standing.times_the_work);
  if (standing.given_up_early) out += fmt::format(" (after {} photons)", standing.photons);
  return out;
}

/// The report on how the contenders did beside the best one.
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
    out += fmt::format("{} {} {}", i == 0 ? "" : ",", all[i].name, text_of(outcome.standing[i]));
  }
  for (std::size_t i = 0; i < outcome.tried.size(); ++i) {
    const Tried& tried = outcome.tried[i];
    out += fmt::format("{} {} {:.3g}{}", i == 0 ? "; then, against the best so far:" : ",",
                       tried.name, tried.times_the_work, tried.taken ? " (taken)" : "");
  }
  return out;
}

/// The estimator and settings of the best of those that contend, and of `settings` those that are
/// better still. If no pilot saw anything: those that find light that is hard to find.
scene::Simulation best_of(const estimator::Model& model, const std::vector<Contender>& all,
                          const std::vector<Setting>& settings,
                          const scene::Simulation& where_unseen, const RunOptions& options) {
  const Outcome outcome = contend(model, all, settings, options);
  scene::Simulation best = outcome.best ? outcome.simulation : where_unseen;
  best.estimator_reason =
      outcome.best ? reason(all, outcome, model.scene.simulation) : reason_unseen;
  return best;
}

/// The model whose pilots decide whether walks are to be free. They follow the light in the water
/// alone, weakened by the air: gates above the sea would outvote those below.
estimator::Model without_light_of_air(estimator::Model model) {
  model.air.reset();
  return model;
}

/// The simulation of a scene that names the bidirectional estimator, and leaves open whether walks
/// are free.
scene::Simulation choose_free_walks(const scene::Simulation& asked,
                                    const estimator::Model& of_all_light,
                                    const RunOptions& options) {
  if (asked.free_telescope_meetings && asked.free_laser_meetings) return asked;
  const auto model = without_light_of_air(of_all_light);
  const auto free = open_free_meetings(model, model.scene.simulation, options);
  std::vector<Contender> all;
  add_bidirectional(asked, "without free walks", free, all);
  if (!free) return all.front().simulation;
  all.back().name = "with free walks";
  return best_of(model, all, {}, all.back().simulation, options);
}

/// The simulation by the forward estimator, where there is no choice.
scene::Simulation only_forward(scene::Simulation asked, const std::string& reason) {
  asked.estimator = scene::Estimator::forward;
  asked.estimator_reason = reason;
  return asked;
}

/// The model of a scene under air that leaves the estimator open, with a choice of free walks.
estimator::Model with_free_walks(estimator::Model model, const RunOptions& options) {
  scene::Simulation walks = model.scene.simulation;
  walks.estimator = scene::Estimator::bidirectional;
  const scene::Simulation free =
      choose_free_walks(walks, estimator::with_simulation(model, walks), options);
  model.scene.simulation.free_telescope_meetings = free.free_telescope_meetings;
  model.scene.simulation.free_laser_meetings = free.free_laser_meetings;
  return model;
}

/// The simulation of a scene that leaves the estimator open, by pilots.
scene::Simulation choose_by_pilots(const estimator::Model& model, const RunOptions& options) {
  return best_of(model, contenders(model, options), settings_to_try(model),
                 usual_bidirectional(model), options);
}

}  // namespace

scene::Simulation choose_estimator(const scene::Scene& scene, const estimator::Model& model,
                                   const RunOptions& options) {
  const scene::Simulation& asked = scene.simulation;
  if (asked.estimator == scene::Estimator::bidirectional)
    return choose_free_walks(asked, model, options);
  if (asked.estimator != scene::Estimator::automatic) return asked;
  if (!scene.tally.empty()) return only_forward(asked, "the only one with tallies beside echoes");
  if (asked.tools.any())
    return only_forward(asked, "the only one with the requested tools in this version");
  if (const auto reason = scene::bidirectional_lacks(scene))
    return only_forward(asked, "the bidirectional one cannot treat " + *reason);
  return model.air ? choose_by_pilots(with_free_walks(model, options), options)
                   : choose_by_pilots(model, options);
}

estimator::Model model_to_run(const scene::Scene& scene, const optics::Library& library,
                              const RunOptions& options) {
  estimator::Model model = estimator::make_model(scene, library, options.stop());
  const scene::Simulation chosen = choose_estimator(scene, model, options);
  return chosen == scene.simulation
             ? model
             : estimator::with_simulation(std::move(model), chosen, options.stop());
}

}  // namespace photic::run
