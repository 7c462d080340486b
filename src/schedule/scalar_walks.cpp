// The bidirectional estimator and analog photons in the scalar engine.
#include "estimator/make_world.hpp"
#include "schedule/engine_parts.hpp"
#include "schedule/walks.hpp"

namespace photic::schedule {

template <>
std::unique_ptr<SetSimulator> EngineParts<Scalar>::walks_simulator(const Set& set) {
  return std::make_unique<WalksSimulator<double, tally::Ledger>>(
      estimator::make_world<double>(set));
}
template <>
std::unique_ptr<SetSimulator> EngineParts<Scalar>::analog_simulator(const Set& set) {
  return std::make_unique<AnalogSimulator<double, tally::Ledger>>(
      estimator::make_world<double>(set));
}

}  // namespace photic::schedule
