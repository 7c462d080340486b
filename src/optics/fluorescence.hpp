// Fluorescence: of chlorophyll a and of coloured dissolved organic matter.
#pragma once

#include <string>

#include "optics/data_table.hpp"
#include "optics/emission.hpp"
#include "optics/library.hpp"

namespace photic::optics {

/// Photons per photon that phytoplankton absorbs and that its yield lets fluoresce: a Gaussian of
/// sigma 10.6 nm at 685 nm, and `share_730` of them in a second one of sigma 21.2 nm at 730 nm.
/// Excited at 300 to 690 nm only. The part of it at wavelengths shorter than the laser's is lost.
Emission chlorophyll_fluorescence(const Library& library, double laser_nm, double share_730);

/// Photons per photon absorbed by CDOM: Hawes's function of the fulvic acid FA7 (Hawes 1992, as in
/// Mobley 1994, Light and Water, sect. 5.15), its A0 interpolated and as at 310 nm below. Up to 750
/// nm: less than 1 % lies beyond. There are none at wavelengths shorter than the laser's.
Emission cdom_fluorescence(const Library& library, double laser_nm);

/// The same of a user's table: columns excitation_nm, emission_nm, yield_per_nm (photons per
/// photon and nm), each excitation with the same emissions, ascending. Straight lines between.
/// Throws InputError if the table is none, or does not cover the laser.
Emission cdom_fluorescence(const DataTable& table, double laser_nm);

}  // namespace photic::optics
