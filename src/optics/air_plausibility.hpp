// Checks whether a profile can be one of air: what no air does is in another unit, or in another
// order.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "optics/atmosphere.hpp"

namespace photic::optics {

/// A number that no air has, or not at its altitude.
struct AirFault {
  enum class Of { altitude, pressure, density };

  std::size_t level = 0;
  Of of = Of::altitude;
  std::string reason, suggestion;
};

/// The first fault of a profile whose pressures are known to `rounding_hpa`: pressures fall with
/// altitude as in hydrostatic air (docs/theory.md, eq. A7), those at the sea are not far from the
/// standard one, and there are as many molecules as in an ideal gas, all within a factor of 1.5.
std::optional<AirFault> fault_of(const AirProfile& profile, double rounding_hpa);

/// Remarks on values that are possible, but more likely to be in another unit.
std::vector<std::string> doubts_about(const AirProfile& profile);

}  // namespace photic::optics
