// The optics of a scene's layers for the terminal and for programs that run Photic.
#pragma once

#include <string>

#include "medium/optical_table.hpp"

namespace photic::io {

/// For each layer its coefficients, those of its constituents and what it emits; below, where the
/// numbers come from.
std::string optics_text(const medium::OpticalTable& table);

/// The same and the phase functions; what is not known or infinite is null. Ends with a newline.
std::string optics_json(const medium::OpticalTable& table);

}  // namespace photic::io
