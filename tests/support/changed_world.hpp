// Runs in worlds that no scene describes.
#pragma once

#include <string>

#include "estimator/problem.hpp"
#include "run/batches.hpp"
#include "schedule/scalar.hpp"
#include "support/scenes.hpp"

namespace photic::test {

/// A run in a world that is `change`d, one photon after the other, in double.
template <class Change>
tally::Result simulate_in(const std::string& scene, Change change) {
  const auto problem = estimator::make_problem(read(scene));
  auto world = estimator::make_world<double>(problem.scene, problem.medium, problem.gates);
  change(world);
  const run::RunOptions options;
  run::Conductor conductor(problem.scene.simulation, options);
  tally::Result result = estimator::describe(problem);
  const schedule::ScalarSimulator<double> simulator(world);
  run::BatchRunner(problem, simulator, conductor).run().fill(result);
  return result;
}

}  // namespace photic::test
