// The scalar engine, compiled once for all tests that ask for it: for any processor of its kind,
// where the program's is compiled for this one.
#pragma once

#include <memory>

#include "estimator/model.hpp"
#include "schedule/simulator.hpp"

namespace photic::estimator {
template <class T>
struct World;
}

namespace photic::test {

/// In the arithmetic of T, float or double. Keeps the model by reference.
template <class T>
std::unique_ptr<schedule::Simulator> scalar_engine(const estimator::Model& model);

/// In a world that no scene describes, for the one set of a model's plan.
std::unique_ptr<schedule::Simulator> scalar_engine(const estimator::World<double>& world,
                                                   const estimator::Model& model);

}  // namespace photic::test
