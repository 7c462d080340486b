// Optical depths between two places in the water.
#pragma once

#include "geometry/free_paths.hpp"

namespace photic::geometry {

/// Optical depths of the light, and of the coefficient that free paths are drawn from.
template <class T>
struct OpticalDepths {
  T all, walk;
};

/// The level of a thing in the water: a photon, a vertex, a ray where it begins.
template <class Placed>
auto level_of(const medium::MediumView& sea, const Placed& at) {
  return sea.level(at.layer, -at.position.z);
}

/// The optical depths of a straight way of the given length between two levels.
template <class T>
OpticalDepths<T> depths_between(const Slabs& sea, const Index<T>& line,
                                const medium::Level<T>& from, const medium::Level<T>& to,
                                const T& length) {
  return {sea.slant_optical_depth(line, from, to, length),
          sea.walk_slant_optical_depth(line, from, to, length)};
}

}  // namespace photic::geometry
