#include "support/scalar_engines.hpp"

#include "core/error.hpp"
#include "schedule/forward.hpp"
#include "schedule/one_by_one.hpp"
#include "schedule/walks.hpp"

namespace photic::test {
namespace {

template <class T>
using Forward = schedule::ForwardSimulator<schedule::HistoriesOneByOne<T>>;
template <class T>
using Bidirectional = schedule::BidirectionalSimulator<T, tally::Ledger>;
template <class T>
using Analog = schedule::AnalogSimulator<T, tally::Ledger>;

/// `from`: a model or a world.
template <class T, class From>
std::unique_ptr<schedule::Simulator> make(const From& from, scene::Estimator estimator,
                                          schedule::BesideWalks beside) {
  if (estimator == scene::Estimator::bidirectional)
    return std::make_unique<Bidirectional<T>>(from, std::move(beside));
  if (estimator == scene::Estimator::analog) return std::make_unique<Analog<T>>(from);
  return std::make_unique<Forward<T>>(from);
}

}  // namespace

template <class T>
std::unique_ptr<schedule::Simulator> scalar_engine(const estimator::Model& model) {
  const scene::Estimator estimator = model.scene.simulation.estimator;
  schedule::BesideWalks beside;
  if (estimator == scene::Estimator::bidirectional)
    beside = schedule::beside_walks<schedule::HistoriesOneByOne<T>>(model);
  return make<T>(model, estimator, std::move(beside));
}
template std::unique_ptr<schedule::Simulator> scalar_engine<float>(const estimator::Model& model);
template std::unique_ptr<schedule::Simulator> scalar_engine<double>(const estimator::Model& model);

std::unique_ptr<schedule::Simulator> scalar_engine(const estimator::World<double>& world) {
  expect(world.estimator != scene::Estimator::bidirectional ||
             world.sea.surface.one_direction_each && !world.sea.surface.emits,
         "histories beside walks have a world of their own");
  return make<double>(world, world.estimator, {});
}

}  // namespace photic::test
