#include "support/scalar_engines.hpp"

#include "core/error.hpp"
#include "estimator/make_world.hpp"
#include "estimator/plan.hpp"
#include "schedule/one_by_one.hpp"
#include "schedule/surface_echo.hpp"
#include "schedule/walks.hpp"
#include "surface/oil.hpp"

namespace photic::test {
namespace {

using estimator::HistorySet;

template <class T>
std::unique_ptr<schedule::SetSimulator> make_set(HistorySet::Kind kind, estimator::World<T> world) {
  using enum HistorySet::Kind;
  switch (kind) {
    case walks:
      return std::make_unique<schedule::WalksSimulator<T, tally::Ledger>>(std::move(world));
    case surface_echo:
      return std::make_unique<schedule::SurfaceEchoSimulator<T, tally::Ledger>>(std::move(world));
    case analog:
      return std::make_unique<schedule::AnalogSimulator<T, tally::Ledger>>(std::move(world));
    case histories:
      break;
  }
  return std::make_unique<schedule::HistoriesOneByOne<T>>(std::move(world));
}

}  // namespace

template <class T>
std::unique_ptr<schedule::Simulator> scalar_engine(const estimator::Model& model) {
  return std::make_unique<schedule::Simulator>(
      estimator::make_plan(model),
      [](const HistorySet& set) { return make_set<T>(set.kind, estimator::make_world<T>(set)); });
}
template std::unique_ptr<schedule::Simulator> scalar_engine<float>(const estimator::Model& model);
template std::unique_ptr<schedule::Simulator> scalar_engine<double>(const estimator::Model& model);

std::unique_ptr<schedule::Simulator> scalar_engine(const estimator::World<double>& world,
                                                   const estimator::Model& model) {
  estimator::Plan plan = estimator::make_plan(model);
  expect(plan.sets.size() == 1, "histories of other sets have a world of their own");
  return std::make_unique<schedule::Simulator>(
      std::move(plan), [&](const HistorySet& set) { return make_set<double>(set.kind, world); });
}

}  // namespace photic::test
