// The scalar engine, compiled once for each instruction set, as PHOTIC_ISA (cmake/photic.cmake).
#include <memory>

#include "schedule/scalar.hpp"

namespace photic::schedule::PHOTIC_ISA {

std::unique_ptr<Simulator> make_scalar_simulator(const estimator::Model& model);
std::unique_ptr<Simulator> make_scalar_simulator(const estimator::Model& model) {
  return std::make_unique<ScalarSimulator<double>>(model);
}

}  // namespace photic::schedule::PHOTIC_ISA
