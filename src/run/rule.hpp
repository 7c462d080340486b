// By which rule estimators and their settings are compared: in the pilot runs of "auto", and in
// what `photic bench` recommends.
#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace photic::run {

/// The quantity to be made small.
enum class Aim {
  all_gates,    ///< the error that all gates have at equal cost
  worst_gates,  ///< the cost until every gate has met a target
};

Aim aim_of(const scene::Simulation& simulation);

/// Logarithm of the work that an estimator needs. `work`: of every gate that is compared, its
/// relative variance times the cost that it was had at; above 0, at least one. The geometric mean
/// over all gates, or over the fifth of them with most work: that of a single gate, which a run to
/// a target waits for, is known too badly to decide.
double log_work(std::vector<double> work, Aim aim);

}  // namespace photic::run
