#include "photic/interrupt.hpp"

#include <csignal>

namespace photic::app {
namespace {

// A signal handler has no other way to reach the program; only this file writes them.
// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables)
std::atomic<bool> flag{false};
std::atomic<int> signal_number{0};
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "only lock-free atomics may be written by a signal handler");

extern "C" void on_signal(int number) {
  int none = 0;
  if (signal_number.compare_exchange_strong(none, number)) {
    flag.store(true);
  } else {
    std::signal(number, SIG_DFL);
    std::raise(number);
  }
}

}  // namespace

void listen_for_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;  // a write to the terminal goes on
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

const std::atomic<bool>& interrupted() { return flag; }

int interrupt_exit_code() {
  const int number = signal_number.load();
  return number == 0 ? 0 : 128 + number;
}

}  // namespace photic::app
