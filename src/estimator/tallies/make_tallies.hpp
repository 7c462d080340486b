// The tallies of a world, made of its model.
#pragma once

#include <memory>

#include "estimator/model.hpp"
#include "estimator/tallies/tallies.hpp"

namespace photic::estimator {

/// None if the scene has none.
std::shared_ptr<const Tallies> make_tallies(const Model& model, const geometry::Slabs& slabs);

}  // namespace photic::estimator
