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

}  // namespace photic::tally
