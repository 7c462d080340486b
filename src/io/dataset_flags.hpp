// Whether estimates have converged, and why not, as variables of a result's file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/dataset.hpp"

namespace photic::io {

struct Flagged {
  std::string prefix;  ///< before the names of the variables
  std::string what;    ///< the flags are of: "echo"
  std::vector<std::string> dimensions;
  std::string coordinates;  ///< empty: none but axes
};

/// Adds `…converged` and `…convergence_flags`, with their meanings (CF-1.10, section 3.5).
void add_flags(Dataset& dataset, const Flagged& of, const std::vector<std::int32_t>& all_flags);

}  // namespace photic::io
