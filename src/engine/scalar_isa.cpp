// The scalar engine, compiled once for each instruction set, as PHOTIC_ISA (cmake/photic.cmake).
#include <memory>

#include "engine/scalar.hpp"

namespace photic::engine::PHOTIC_ISA {

std::unique_ptr<Simulator> make_scalar_simulator(const Problem& problem);
std::unique_ptr<Simulator> make_scalar_simulator(const Problem& problem) {
  return std::make_unique<ScalarSimulator<double>>(problem);
}

}  // namespace photic::engine::PHOTIC_ISA
