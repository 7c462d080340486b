// Long work on a thread of its own, so that this one can listen.
#pragma once

#include <chrono>
#include <future>

#include "photic/interrupt.hpp"
#include "run/monitor.hpp"

namespace photic::app {

/// The value of work(), whose monitor is stopped by an interrupt; tick() is called meanwhile, some
/// times a second.
template <class Work, class Tick>
auto beside(run::Monitor& monitor, Work work, Tick tick) {
  auto value = std::async(std::launch::async, work);
  while (value.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready) {
    if (interrupted()) monitor.stop();
    tick();
  }
  return value.get();
}
template <class Work>
auto beside(run::Monitor& monitor, Work work) {
  return beside(monitor, work, [] {});
}

}  // namespace photic::app
