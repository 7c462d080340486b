// The mean of a phase function over the directions of a cone, as a sum over the cone's rim
// (theory.md, eq. 86).
#pragma once

#include <vector>

namespace photic::estimator {

/// A mean is the sum of weight F(x), with F(x) the share of light that is scattered by less than
/// the angle of x = 1 - cos.
struct MeanTerm {
  double x;
  double weight;  ///< [1/sr]
};
/// The terms of the mean over a cone about a direction off its axis. `a`: 1 - cos of the angle
/// between both, 0 < a <= 1; `d`: of the half angle, 0 < d < 2.
void mean_over_cone(double a, double d, std::vector<MeanTerm>& terms);

}  // namespace photic::estimator
