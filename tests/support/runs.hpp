// Runs of scenes as users make them: in lanes.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "run/run.hpp"
#include "support/tables.hpp"

namespace photic::test {

/// The instruction set of lanes: the best that is here, or PHOTIC_TEST_ISA (tools/test_each_isa).
inline Isa isa_of_tests() {
  const char* asked = std::getenv("PHOTIC_TEST_ISA");
  if (asked == nullptr) return isas_here().back();
  const auto isa = isa_of(asked);
  if (!isa || !runs_here(*isa))
    throw std::invalid_argument(std::string("not here: PHOTIC_TEST_ISA=") + asked);
  return *isa;
}

/// How many seeds statistical tests that can use more than one take: 1, or PHOTIC_TEST_SEEDS.
inline std::uint64_t seeds_of_tests() {
  const char* asked = std::getenv("PHOTIC_TEST_SEEDS");
  return asked == nullptr ? 1 : std::stoull(asked);
}

inline tally::Result run_in_lanes(const scene::Scene& scene) {
  run::RunOptions options;
  options.lanes = isa_of_tests();
  return run::run(scene, *test::tables(), options);
}

}  // namespace photic::test
