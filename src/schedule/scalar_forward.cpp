// The forward estimator in the scalar engine.
#include "schedule/engine_parts.hpp"
#include "schedule/forward.hpp"
#include "schedule/one_by_one.hpp"

namespace photic::schedule {
namespace {

using Histories = HistoriesOneByOne<double>;

}  // namespace

template <>
std::unique_ptr<Simulator> EngineParts<Scalar>::forward_simulator(const estimator::Model& model) {
  return std::make_unique<ForwardSimulator<Histories>>(model);
}
template <>
BesideWalks EngineParts<Scalar>::beside_walks_simulators(const estimator::Model& model) {
  return beside_walks<Histories>(model);
}

}  // namespace photic::schedule
