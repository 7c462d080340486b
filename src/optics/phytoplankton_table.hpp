// Absorption and scattering by phytoplankton as a user measured them.
#pragma once

#include <string>

#include "core/interpolation.hpp"
#include "optics/data_table.hpp"
#include "optics/phytoplankton.hpp"

namespace photic::optics {

/// Per concentration of chlorophyll, against wavelength [nm], with straight lines between.
struct PhytoplanktonTable {
  LinearTable a_m2_per_mg, b_m2_per_mg;
  LinearTable a_exciting_m2_per_mg;  ///< the share of a that excites fluorescence
  std::string source;
};

/// Columns wavelength_nm (ascending), a_m2_per_mg, b_m2_per_mg and, if not all absorption excites,
/// a_exciting_m2_per_mg, none of them negative. Throws InputError.
PhytoplanktonTable phytoplankton_table(const DataTable& table);

/// All in proportion to the concentration. Throws InputError outside the table unless it is 0.
Phytoplankton phytoplankton_of_table(const PhytoplanktonTable& table, double chlorophyll_mg_m3,
                                     double wavelength_nm);

}  // namespace photic::optics
