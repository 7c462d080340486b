// Phase functions of models that one library makes.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "estimator/model.hpp"
#include "scene/read.hpp"
#include "support/tables.hpp"

namespace photic::estimator {
namespace {

using Phases = std::vector<std::shared_ptr<const optics::PhaseTable>>;

/// Those that are still there, of the sea and of the air above it.
Phases phases_of(const Model& model) {
  Phases out;
  for (const auto& phase : model.medium.phases()) out.push_back(phase.lock());
  if (!model.air) return out;
  const Model air = model_of_air(model);
  for (const auto& phase : air.medium.phases()) out.push_back(phase.lock());
  return out;
}

// Two tables of the same numbers would be different objects. A library keeps no more than some
// hundreds. Seen red: with tables that are not kept; with a medium's or an air's made without the
// library.
TEST(SharedTables, AreAllThatASecondModelHas) {
  int shared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(PHOTIC_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().stem());
    const optics::Library library(PHOTIC_SOURCE_DIR "/data");
    const auto scene = scene::read_scene(entry.path()).scene;
    const Phases first = phases_of(make_model(scene, library));
    if (std::ranges::count(first, nullptr) > 0) continue;  // too many to be kept
    EXPECT_EQ(phases_of(make_model(scene, library)), first);
    ++shared;
  }
  EXPECT_GE(shared, 20);
}

/// A scene with a setting that has no effect.
scene::Reading read_with(const scene::Check& check) {
  return scene::read_scene(PHOTIC_SOURCE_DIR "/scenes/oil-spill.toml",
                           {"simulation.estimator=forward", "simulation.walks=3"}, check);
}

// Environments have the settings of their scene. Seen red: with a check that takes only the first
// scene it is asked of for one.
TEST(OpticsCheck, IsOfAnyNumberOfScenes) {
  const scene::Check check = optics_check(test::tables());
  const auto remarks = read_with(check).remarks;
  EXPECT_TRUE(std::ranges::any_of(remarks, [](const std::string& remark) {
    return remark.find("'walks' has no effect") != std::string::npos;
  }));
  EXPECT_EQ(read_with(check).remarks, remarks);
}

// The thread sanitizer looks on.
TEST(OpticsCheck, MayBeAskedBySeveralThreads) {
  const scene::Check check =
      optics_check(std::make_shared<const optics::Library>(PHOTIC_SOURCE_DIR "/data"));
  std::vector<std::vector<std::string>> remarks(4);
  std::vector<std::jthread> threads;
  for (auto& mine : remarks) threads.emplace_back([&] { mine = read_with(check).remarks; });
  threads.clear();
  for (const auto& mine : remarks) EXPECT_EQ(mine, read_with(check).remarks);
}

}  // namespace
}  // namespace photic::estimator
