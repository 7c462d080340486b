// The light of the tallies' tests: a green laser, its Raman light and chlorophyll's.
#pragma once

#include "medium/medium.hpp"
#include "support/ship_scene.hpp"

namespace photic::tally {

inline std::vector<medium::Line> lines() {
  return {{medium::Process::elastic, 532, 1.3415, 1.3638},
          {medium::Process::raman, 649, 1.3377, 1.3541},
          {medium::Process::chlorophyll, 685, 1.3368, 1.3525}};
}

/// The same under three layers of air.
inline std::vector<medium::Line> lines_in_air() {
  auto out = lines();
  out[0].air_delay = {{0, 2, 5, 9}, {0, 0.6, 0.9, 0.98}};
  out[1].air_delay = {{0, 2, 5, 9}, {0, 0.8, 1.4, 1.4}};
  out[2].air_delay = out[1].air_delay;
  return out;
}

}  // namespace photic::tally
