// The forward estimator in the scalar engine.
#include "estimator/make_world.hpp"
#include "schedule/engine_parts.hpp"
#include "schedule/one_by_one.hpp"
#include "schedule/surface_echo.hpp"

namespace photic::schedule {

template <>
std::unique_ptr<SetSimulator> EngineParts<Scalar>::histories_simulator(const Set& set) {
  return std::make_unique<HistoriesOneByOne<double>>(estimator::make_world<double>(set));
}
template <>
std::unique_ptr<SetSimulator> EngineParts<Scalar>::surface_echo_simulator(const Set& set) {
  return std::make_unique<SurfaceEchoSimulator<double, tally::Ledger>>(
      estimator::make_world<double>(set));
}

}  // namespace photic::schedule
