// The bidirectional estimator and analog photons in lanes, compiled once for each instruction set,
// as PHOTIC_ISA (cmake/photic.cmake).
#include "core/pack.hpp"
#include "lanes/lane_ledger.hpp"
#include "schedule/engine_parts.hpp"
#include "schedule/walks.hpp"

namespace photic::schedule {
namespace {

using T = Pack<float, native::float_lanes>;
using Ledger = lanes::LaneLedger<T>;
using Here = EngineParts<Lanes<Isa::PHOTIC_ISA>>;

}  // namespace

template <>
std::unique_ptr<Simulator> Here::walks_simulator(const estimator::Model& model,
                                                 BesideWalks beside) {
  return std::make_unique<BidirectionalSimulator<T, Ledger>>(model, std::move(beside));
}
template <>
std::unique_ptr<Simulator> Here::analog_simulator(const estimator::Model& model) {
  return std::make_unique<AnalogSimulator<T, Ledger>>(model);
}

}  // namespace photic::schedule
