// The light of a beam by its share of the whole: of the solid angle about the axis or, of parallel
// light, of the disc's area. Even, or a Gaussian that is cut off where it has fallen to exp(-decay)
// of its peak (docs/theory.md, eq. 108). The sampler, and its density.
#pragma once

#include "core/elementary.hpp"
#include "core/lanes.hpp"

namespace photic::instrument {

template <class T>
struct BeamProfile {
  bool is_even = true;
  T decay{};
  T at_edge{};  ///< exp(-decay)

  /// From a uniform, the share of the whole that is nearer to the axis.
  [[nodiscard]] T draw(const T& u) const {
    if (is_even) return u;
    return minus_log(at_edge + u * (T(1) - at_edge)) / decay;
  }
  /// 1 over the density there, which is 1 of an even beam. Beyond the edge that at the edge.
  [[nodiscard]] T per_density(const T& share) const {
    if (is_even) return T(1);
    const T within = select(share < T(1), share, T(1));
    return (T(1) - at_edge) / (decay * exp_minus(decay * within));
  }
};

}  // namespace photic::instrument
