// estimator = "auto": which estimator, and with which settings, a scene is simulated with.
#pragma once

#include "estimator/model.hpp"
#include "run/run.hpp"
#include "scene/scene.hpp"

namespace photic::run {

/// The reason where no pilot run saw any light.
inline constexpr const char* reason_unseen =
    "no pilot run saw any light, so that nothing could be compared";

/// The simulation of a scene, whose model there is, with an estimator and its settings in place of
/// "auto", and the reason in Simulation::estimator_reason; any other as it is. Candidates are
/// compared by pilot runs with random numbers of their own, by variances and counted operations,
/// never by a clock: the same scene always gets the same answer, whatever engine is to run it.
/// Throws what run() throws.
scene::Simulation choose_estimator(const scene::Scene& scene, const estimator::Model& model,
                                   const RunOptions& options);

/// The model of a scene with what choose_estimator() chooses.
estimator::Model model_to_run(const scene::Scene& scene, const optics::Library& library,
                              const RunOptions& options);

}  // namespace photic::run
