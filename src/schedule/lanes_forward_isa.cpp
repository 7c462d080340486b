// The forward estimator in lanes, compiled once for each instruction set, as
// PHOTIC_ISA (cmake/photic.cmake).
#include "core/pack.hpp"
#include "schedule/engine_parts.hpp"
#include "schedule/forward.hpp"
#include "schedule/pools.hpp"

namespace photic::schedule {
namespace {

using Histories = Pools<Pack<float, native::float_lanes>>;
using Here = EngineParts<Lanes<Isa::PHOTIC_ISA>>;

}  // namespace

template <>
std::unique_ptr<Simulator> Here::forward_simulator(const estimator::Model& model) {
  return std::make_unique<ForwardSimulator<Histories>>(model);
}
template <>
BesideWalks Here::beside_walks_simulators(const estimator::Model& model) {
  return beside_walks<Histories>(model);
}

}  // namespace photic::schedule
