#include "core/stop.hpp"

namespace photic {

void throw_stopped() { throw Stopped(); }

}  // namespace photic
