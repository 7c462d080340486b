// The parts of which engines are made, one for each estimator: each is compiled in a file of its
// own, those of lanes once for each instruction set (cmake/photic.cmake).
#pragma once

#include <memory>

#include "core/isa.hpp"
#include "estimator/model.hpp"
#include "schedule/simulator.hpp"

namespace photic::schedule {

struct Scalar;
template <Isa isa>
struct Lanes;

/// Kind: Scalar or Lanes. Each simulator keeps the model by reference. Sealed objects export only
/// the functions whose names contain _simulator.
template <class Kind>
struct EngineParts {
  static std::unique_ptr<Simulator> forward_simulator(const estimator::Model& model);
  static BesideWalks beside_walks_simulators(const estimator::Model& model);
  static std::unique_ptr<Simulator> walks_simulator(const estimator::Model& model,
                                                    BesideWalks beside);
  static std::unique_ptr<Simulator> analog_simulator(const estimator::Model& model);
};

}  // namespace photic::schedule
