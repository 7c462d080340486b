// Light that water gives back at another wavelength than the laser's.
#pragma once

#include <string>
#include <vector>

namespace photic::optics {

/// All light of a process at one wavelength: the weight in a list that stands for its spectrum.
struct EmissionLine {
  double wavelength_nm = 0;
  double coefficient_per_m = 0;  ///< photons emitted per metre and photon of the laser's wavelength
};

struct Emission {
  std::vector<EmissionLine> lines;  ///< empty: nothing is emitted
  std::string source;
};

}  // namespace photic::optics
