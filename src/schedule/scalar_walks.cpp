// The bidirectional estimator and analog photons in the scalar engine.
#include "schedule/engine_parts.hpp"
#include "schedule/walks.hpp"

namespace photic::schedule {

template <>
std::unique_ptr<Simulator> EngineParts<Scalar>::walks_simulator(const estimator::Model& model,
                                                                BesideWalks beside) {
  return std::make_unique<BidirectionalSimulator<double, tally::Ledger>>(model, std::move(beside));
}
template <>
std::unique_ptr<Simulator> EngineParts<Scalar>::analog_simulator(const estimator::Model& model) {
  return std::make_unique<AnalogSimulator<double, tally::Ledger>>(model);
}

}  // namespace photic::schedule
