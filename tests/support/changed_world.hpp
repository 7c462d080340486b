// Runs in worlds that no scene describes.
#pragma once

#include <string>

#include "engine/batches.hpp"
#include "engine/problem.hpp"
#include "engine/scalar.hpp"
#include "support/scenes.hpp"

namespace photic::test {

/// A run in a world that is `change`d, one photon after the other, in double.
template <class Change>
tally::Result simulate_in(const std::string& scene, Change change) {
  const auto problem = engine::make_problem(read(scene));
  auto world = engine::make_world<double>(problem.scene, problem.medium, problem.gates);
  change(world);
  const engine::RunOptions options;
  engine::Conductor conductor(problem.scene.simulation, options);
  tally::Result result = engine::describe(problem);
  const engine::ScalarSimulator<double> simulator(world);
  engine::BatchRunner(problem, simulator, conductor).run().fill(result);
  return result;
}

}  // namespace photic::test
