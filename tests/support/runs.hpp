// Runs of scenes as users make them: in the lanes that this processor has.
#pragma once

#include "engine/run.hpp"

namespace photic::test {

inline tally::Result run_in_lanes(const scene::Scene& scene) {
  engine::RunOptions options;
  options.lanes = isas_here().back();
  return engine::run(scene, options);
}

}  // namespace photic::test
