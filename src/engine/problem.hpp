// A scene made ready to run: the medium, the gates and the shape of the tallies.
#pragma once

#include "medium/medium.hpp"
#include "scene/scene.hpp"
#include "tally/gates.hpp"
#include "tally/result.hpp"
#include "tally/shape.hpp"

namespace photic::engine {

struct Problem {
  scene::Scene scene;
  medium::Medium medium;
  tally::Gates gates;
  tally::Shape shape;
};

/// Throws InputError for optics without data at a wavelength, EnvironmentError for missing data
/// files.
Problem make_problem(const scene::Scene& scene);

/// A result's axes, and what it says of the scene; the tallies are still to be filled in.
tally::Result describe(const Problem& problem);

}  // namespace photic::engine
