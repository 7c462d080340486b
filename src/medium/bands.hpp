// Spectra of emitted light, cut into lines.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "medium/filters.hpp"
#include "optics/emission.hpp"

namespace photic::medium {

/// A piece of a spectrum, as a line.
struct BandLine {
  double wavelength_nm = 0;
  double photons = 0;              ///< per photon and what the process says
  std::vector<double> counted_by;  ///< channels: the share of it
};

/// The lines of a spectrum at most 5 nm apart, cut where filters are. `counts_all`: channels that
/// count all of it, whatever the wavelength; without one only what some filter lets through is
/// kept.
std::vector<BandLine> cut_into_lines(const optics::EmissionSpectrum& spectrum,
                                     const std::vector<bool>& counts_all,
                                     const std::vector<std::optional<Filter>>& filters);

}  // namespace photic::medium
