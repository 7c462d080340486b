// The forward estimator in lanes, compiled once for each instruction set, as
// PHOTIC_ISA (cmake/photic.cmake).
#include "core/pack.hpp"
#include "estimator/make_world.hpp"
#include "lanes/lane_ledger.hpp"
#include "schedule/engine_parts.hpp"
#include "schedule/pools.hpp"
#include "schedule/surface_echo.hpp"

namespace photic::schedule {
namespace {

using T = Pack<float, native::float_lanes>;
using Ledger = lanes::LaneLedger<T>;
using Here = EngineParts<Lanes<Isa::PHOTIC_ISA>>;

}  // namespace

template <>
std::unique_ptr<SetSimulator> Here::histories_simulator(const Set& set) {
  return std::make_unique<Pools<T>>(estimator::make_world<T>(set));
}
template <>
std::unique_ptr<SetSimulator> Here::surface_echo_simulator(const Set& set) {
  return std::make_unique<SurfaceEchoSimulator<T, Ledger>>(estimator::make_world<T>(set));
}

}  // namespace photic::schedule
