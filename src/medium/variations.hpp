// The changes that environments, and the steps of derivatives, make to the optics of each layer:
// the tables that go into a medium (medium.hpp, EnvironmentTables).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "medium/medium.hpp"

namespace photic::medium {

/// The coefficients of one layer at one line.
struct Coefficients {
  double c_per_m = 0, b_per_m = 0;
  double emitted_per_m = 0;  ///< into this line, of the laser's light
  struct Part {
    double b_per_m = 0;
    std::int32_t phase = 0;  ///< table of the medium
  };
  std::vector<Part> part;  ///< of the scattering
};
using LayerCoefficients = std::vector<Coefficients>;  ///< [line][layer]

/// The change by an environment, or a tangent, in units of `scale`.
struct Variation {
  std::string name;  ///< as users know it
  LayerCoefficients from, to;
  double scale = 1;
};

/// The tables of variations of what the medium itself has, of which those from `first_tangent` on
/// are tangents.
void add_variations(const LayerCoefficients& here, const std::vector<Variation>& variations,
                    std::size_t first_tangent, EnvironmentTables& out);

}  // namespace photic::medium
