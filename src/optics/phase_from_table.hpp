// A phase function from a table of angles: Petzold's, or a user's.
#pragma once

#include <string>

#include "optics/data_table.hpp"
#include "optics/phase_table.hpp"

namespace photic::optics {

/// A tabulated phase function, scaled to an integral of 1.
struct TabulatedPhase {
  PhaseShape shape;
  double integral = 1;  ///< over the sphere, before it was scaled
  std::string remark;   ///< a hint for its user; may be empty
};

/// Columns angle_deg (ascending, 0 to 180, ending at 180) and phase_function_per_sr. Between the
/// rows it is a power law of x = 1 - cos (a straight line in x where a value or x is 0); from the
/// first row to 0 degrees the power law of the first two rows goes on (flat if it falls towards 0).
/// Throws InputError if the integral is not 1 within 1 %, or if a PhaseTable cannot resolve the
/// function.
TabulatedPhase phase_from_table(const DataTable& table);

}  // namespace photic::optics
