// The parts of which engines are made, one for each kind of history sets. Those of an estimator are
// compiled in a file of their own, those of lanes once for each instruction set
// (cmake/photic.cmake).
#pragma once

#include <memory>

#include "core/isa.hpp"
#include "estimator/plan.hpp"
#include "schedule/simulator.hpp"

namespace photic::schedule {

struct Scalar;
template <Isa isa>
struct Lanes;

/// Kind: Scalar or Lanes. Sealed objects export only the functions whose names contain _simulator.
template <class Kind>
struct EngineParts {
  using Set = estimator::HistorySet;
  static std::unique_ptr<SetSimulator> histories_simulator(const Set& set);
  static std::unique_ptr<SetSimulator> surface_echo_simulator(const Set& set);
  static std::unique_ptr<SetSimulator> walks_simulator(const Set& set);
  static std::unique_ptr<SetSimulator> analog_simulator(const Set& set);
};

}  // namespace photic::schedule
