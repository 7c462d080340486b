// The bidirectional estimator and analog photons in lanes, compiled once for each instruction set,
// as PHOTIC_ISA (cmake/photic.cmake).
#include "core/pack.hpp"
#include "estimator/make_world.hpp"
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
std::unique_ptr<SetSimulator> Here::walks_simulator(const Set& set) {
  return std::make_unique<WalksSimulator<T, Ledger>>(estimator::make_world<T>(set));
}
template <>
std::unique_ptr<SetSimulator> Here::analog_simulator(const Set& set) {
  return std::make_unique<AnalogSimulator<T, Ledger>>(estimator::make_world<T>(set));
}

}  // namespace photic::schedule
