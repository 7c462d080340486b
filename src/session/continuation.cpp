#include "session/continuation.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "estimator/model.hpp"
#include "scene/compare.hpp"
#include "schedule/engines.hpp"
#include "session/read.hpp"

namespace photic::session {
namespace {

/// The scene with what an earlier run of it chose, where it leaves the choice open.
scene::Scene as_chosen(scene::Scene now, const scene::Scene& then) {
  const auto take = [](auto& open, const auto& value) {
    if (!open) open = value;
  };
  scene::Simulation& s = now.simulation;
  const scene::Simulation& chosen = then.simulation;
  take(s.batch_photons, chosen.batch_photons);
  if (s.estimator == scene::Estimator::automatic && chosen.estimator_reason)
    s.estimator = chosen.estimator;
  else if (s.estimator != scene::Estimator::bidirectional || s.estimator != chosen.estimator)
    return now;
  take(s.estimator_reason, chosen.estimator_reason);
  take(s.conversion_probability, chosen.conversion_probability);
  take(s.walks, chosen.walks);
  take(s.meetings, chosen.meetings);
  take(s.connected_fraction, chosen.connected_fraction);
  take(s.walk_attenuation, chosen.walk_attenuation);
  take(s.directed_fraction, chosen.directed_fraction);
  take(s.scored_points, chosen.scored_points);
  take(s.free_telescope_meetings, chosen.free_telescope_meetings);
  take(s.free_laser_meetings, chosen.free_laser_meetings);
  return now;
}

/// Why the photons of a run are not those of a scene.
std::vector<Diagnostic> obstacles(const io::RunSoFar& run, const std::string& file,
                                  const scene::Scene& asked, const optics::Library& library) {
  if (run.version != PHOTIC_VERSION) {
    return {{.file = file,
             .reason = fmt::format("made by Photic {}; this one, {}, may simulate other photons",
                                   run.version, PHOTIC_VERSION),
             .suggestion = fmt::format("continue with Photic {}, or start anew", run.version)}};
  }
  scene::Scene then = scene::read_scene_text(run.scene_toml, file, folder_of(file)).scene;
  const scene::Scene now =
      estimator::reported_scene(estimator::make_model(as_chosen(asked, then), library));
  then.simulation.photons = now.simulation.photons;
  then.simulation.target_relative_error = now.simulation.target_relative_error;
  then.simulation.max_time_s = now.simulation.max_time_s;
  std::vector<Diagnostic> out;
  for (const scene::Difference& d : scene::differences(then, now)) {
    out.push_back({.file = file,
                   .reason = fmt::format("{} was {} and is {} now", d.path, d.left, d.right),
                   .suggestion = ""});
  }
  if (!out.empty()) {
    out.back().suggestion =
        "a continued run may change only photons, target_relative_error and max_time_s";
  }
  return out;
}

}  // namespace

scene::Reading read_earlier(const Context& context, const std::string& file,
                            const std::vector<scene::Override>& overrides) {
  return read(context, {io::read_run(file).scene_toml, file, folder_of(file)}, overrides);
}

scene::Scene as_chosen_in(const std::string& file, scene::Scene scene) {
  const std::string text = io::read_run(file).scene_toml;
  return as_chosen(std::move(scene), scene::read_scene_text(text, file, folder_of(file)).scene);
}

Earlier take_up(const std::string& file, const scene::Scene& scene, const optics::Library& library,
                const Words& words) {
  const io::RunSoFar run = io::read_run(file);
  std::vector<Diagnostic> problems = obstacles(run, file, scene, library);
  const auto asked = scene.simulation.photons;
  if (asked && *asked < run.photons) {
    problems.push_back(
        {.file = file,
         .reason = fmt::format("holds {} photons already, more than the {} requested", run.photons,
                               *asked),
         .suggestion = words.photons + " is the total, not what is added"});
  }
  if (!problems.empty()) throw InputError(problems);
  return {.start = {.state = io::read_state(file, estimator::make_model(scene, library).shape),
                    .wall_time_s = run.wall_time_s,
                    .file = file},
          .lanes = schedule::isa_of_engine(run.engine),
          .photons = run.photons,
          .history = run.history,
          .scene_file = run.scene_file};
}

bool is_same_scene(const io::RunSoFar& run, const std::string& file, const scene::Scene& scene,
                   const optics::Library& library) {
  scene::Scene open = scene;
  open.simulation.batch_photons.reset();  // a matter of the simulation, not of the scene
  try {
    return obstacles(run, file, open, library).empty();
  } catch (const InputError&) {  // its scene is none to this program
    return false;
  }
}

}  // namespace photic::session
