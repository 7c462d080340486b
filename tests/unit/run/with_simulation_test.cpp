// One model, made for a scene and simulated in other ways.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.hpp"
#include "run/batches.hpp"
#include "scene/read.hpp"
#include "scene/waves.hpp"
#include "support/tables.hpp"

namespace photic::run {
namespace {

tally::TotalsState state_of(const estimator::Model& model) {
  const RunOptions options;
  RunControl control(model.scene.simulation, options);
  return run_batches(model, control, std::nullopt).state();
}

// Seen red, each for itself: with the settings of the first simulation; with its free paths; with
// its shape of the tallies.
TEST(WithSimulation, IsTheModelOfTheSceneWithIt) {
  using scene::Estimator;
  int compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(PHOTIC_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().stem());
    auto scene = scene::read_scene(entry.path()).scene;
    const estimator::Model given = estimator::make_model(scene, *test::tables());
    for (const Estimator way : {Estimator::forward, Estimator::bidirectional, Estimator::analog}) {
      if (way == Estimator::bidirectional && scene::bidirectional_lacks(scene)) continue;
      scene.simulation = scene::Simulation();
      scene.simulation.estimator = way;
      scene.simulation.photons = 3;
      const estimator::Model own = estimator::make_model(scene, *test::tables());
      const estimator::Model other = estimator::with_simulation(given, scene.simulation);
      EXPECT_EQ(other.scene, own.scene);
      EXPECT_EQ(estimator::describe(other).scene_toml, estimator::describe(own).scene_toml);
      EXPECT_EQ(state_of(other), state_of(own)) << scene::word_of(way);
      ++compared;
    }
  }
  EXPECT_GT(compared, 50);
}

}  // namespace
}  // namespace photic::run
