// Phase functions of models that one library makes.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "estimator/model.hpp"
#include "scene/read.hpp"
#include "support/tables.hpp"

namespace photic::estimator {
namespace {

using Phases = std::vector<std::shared_ptr<const optics::PhaseTable>>;

/// Of the sea, and of the air above it.
Phases phases_of(const Model& model) {
  Phases out = model.medium.phases();
  if (!model.air) return out;
  const auto of_air = model_of_air(model).medium.phases();
  out.insert(out.end(), of_air.begin(), of_air.end());
  return out;
}

// Two tables of the same numbers would be different objects. Seen red: with tables that are not
// kept; with a medium's or an air's made without the library.
TEST(SharedTables, AreAllThatASecondModelHas) {
  const optics::Library& library = *test::tables();
  for (const auto& entry : std::filesystem::directory_iterator(PHOTIC_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().stem());
    const auto scene = scene::read_scene(entry.path()).scene;
    const Phases first = phases_of(make_model(scene, library));
    EXPECT_EQ(phases_of(make_model(scene, library)), first);
    EXPECT_LE(std::set(first.begin(), first.end()).size(), optics::PhaseTableCache::most_kept);
  }
}

}  // namespace
}  // namespace photic::estimator
