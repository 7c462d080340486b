#include "support/scalar_engines.hpp"

#include "schedule/scalar.hpp"

namespace photic::test {

template <class T>
std::unique_ptr<schedule::Simulator> scalar_engine(const estimator::Model& model) {
  return std::make_unique<schedule::ScalarSimulator<T>>(model);
}
template std::unique_ptr<schedule::Simulator> scalar_engine<float>(const estimator::Model& model);
template std::unique_ptr<schedule::Simulator> scalar_engine<double>(const estimator::Model& model);

std::unique_ptr<schedule::Simulator> scalar_engine(const estimator::World<double>& world) {
  return std::make_unique<schedule::ScalarSimulator<double>>(world);
}

}  // namespace photic::test
