// Ctrl-C and SIGTERM: the first one asks the run to end soon, the second one ends the
// program.
#pragma once

#include <atomic>

namespace photic::app {

/// Listens from here on.
void listen_for_interrupts();

/// Becomes true with the first SIGINT or SIGTERM.
const std::atomic<bool>& interrupted();

/// 128 + the signal that came (130, 143); 0 if none did.
int interrupt_exit_code();

}  // namespace photic::app
