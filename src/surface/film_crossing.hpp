// The way of light at a film of oil: how it came, and how it went on.
#pragma once

#include "core/lanes.hpp"

namespace photic::surface {

/// By one of the ways of medium/waves.hpp.
template <class T>
struct FilmCrossing {
  Index<T> line{};
  Index<T> way{-1};  ///< below 0: it has come to none
  T cosine{1};  ///< to the film's normal: in the water, or of light that goes back into the air
};

}  // namespace photic::surface
