// The data tables of this process, and what its runs share.
#pragma once

#include "session/context.hpp"

namespace photic::app {

/// Read when first asked for. Throws EnvironmentError.
const session::Context& context();

}  // namespace photic::app
