#include "optics/fluorescence.hpp"

#include <cmath>

namespace photic::optics {

Emission chlorophyll_fluorescence(const Library& library, double laser_nm, double a_exciting_per_m,
                                  double yield) {
  const Sourced& centre = library.fluorescence.at("chlorophyll_emission_centre");
  const double sigma = library.fluorescence.at("chlorophyll_emission_sigma").value;
  const Sourced& shortest = library.fluorescence.at("chlorophyll_excitation_min");
  const Sourced& longest = library.fluorescence.at("chlorophyll_excitation_max");
  Emission out{{},
               centre.source + "; excitation from " + shortest.source + " to " + longest.source};
  if (laser_nm < shortest.value || laser_nm > longest.value) return out;
  const double share_above_laser =
      0.5 * std::erfc((laser_nm - centre.value) / (std::sqrt(2.0) * sigma));
  const double coefficient = yield * a_exciting_per_m * share_above_laser;
  if (coefficient > 0) out.lines.push_back({centre.value, coefficient});
  return out;
}

}  // namespace photic::optics
