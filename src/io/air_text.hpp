// The effect of the air on light, for the terminal.
#pragma once

#include <string>

#include "medium/optical_table.hpp"

namespace photic::io {

/// Vertical optical depths of all layers of air, by what is in them; the layers' coefficients at
/// the first wavelength; and where the numbers come from.
std::string air_text(const medium::OpticalTable& table);

}  // namespace photic::io
