#include "instrument/disc.hpp"

namespace photic::instrument {

const std::array<double, rim_points> rim_cosines = [] {
  std::array<double, rim_points> out{};
  for (int i = 0; i < rim_points; ++i)
    out[static_cast<std::size_t>(i)] = std::cos(pi * (i + 0.5) / rim_points);
  return out;
}();

}  // namespace photic::instrument
