// Runs in worlds that no scene describes.
#pragma once

#include <string>

#include "estimator/make_world.hpp"
#include "estimator/model.hpp"
#include "run/batches.hpp"
#include "support/scalar_engines.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::test {

/// A run in a world that is `change`d, one photon after the other, in double.
template <class Change>
tally::Result simulate_in(const std::string& scene, Change change) {
  const auto model = estimator::make_model(read(scene), *test::tables());
  auto world = estimator::make_world<double>(model);
  change(world);
  const run::RunOptions options;
  run::RunControl control(model.scene.simulation, options);
  tally::Result result = estimator::describe(model);
  const auto simulator = scalar_engine(world, model);
  run::BatchRunner(model, *simulator, control).run().fill(result);
  return result;
}

}  // namespace photic::test
