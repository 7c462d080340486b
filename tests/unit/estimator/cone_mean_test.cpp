// Means over cones of functions whose means have closed forms, and the work that they take.
#include "estimator/cone_mean.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/constants.hpp"
#include "estimator/averaged_phases.hpp"
#include "estimator/entry_cone.hpp"
#include "optics/fournier_forand.hpp"

namespace photic::estimator {
namespace {

template <class Cumulative>
double mean_by_rim(double a, double d, const Cumulative& up_to) {
  std::vector<MeanTerm> terms;
  mean_over_cone(a, d, terms);
  double sum = 0;
  for (const auto& [x, weight] : terms) sum += weight * up_to(x);
  return sum;
}

// Of 1, 1 - cos and the Legendre polynomial of cos of second order, in cones up to wider than a
// half space. Seen red: with the half angle's cosine 1; without what is scattered straight back;
// with 3 nodes at least.
TEST(ConeMean, HasTheClosedFormsOfPolynomials) {
  for (const double half_angle : {1e-6, 4e-5, 3e-3, 0.1, 0.5, 1.2, pi / 2, 1.7, 2.5}) {
    const double d = one_minus_cos_of(half_angle);
    for (double angle = 2e-7; angle < pi / 2; angle *= 1.03) {
      const double a = one_minus_cos_of(angle);
      const auto where = [&] {
        return "half angle " + std::to_string(half_angle) + ", at " + std::to_string(angle);
      };
      const double one = mean_by_rim(a, d, [](double x) { return 2 * pi * x; });
      EXPECT_NEAR(one, 1, 3e-6) << where();
      const double linear = mean_by_rim(a, d, [](double x) { return pi * x * x; });
      const double of_linear = a + d / 2 - a * d / 2;
      EXPECT_NEAR(linear / of_linear, 1, 3e-6) << where();
      const double square = mean_by_rim(a, d, [](double x) { return pi * x * (1 - x) * (2 - x); });
      EXPECT_NEAR(square, (1.5 * (1 - a) * (1 - a) - 0.5) * (1 - d) * (1 - d / 2), 3e-6) << where();
    }
  }
}

/// The mean over a cone of half angle d at an angle a off its axis, from the rings about that
/// direction, of which a share lies in the cone.
double mean_of_rings(const optics::FournierForand& phase, double a, double d) {
  constexpr int rings = 100000;
  const double first = std::log(std::abs(d - a)), last = std::log(d + a);
  double sum = a < d ? phase.below(one_minus_cos_of(d - a)) : 0;
  for (int i = 0; i < rings; ++i) {
    const double t = std::exp(first + (last - first) * (i + 0.5) / rings);
    const double inside =
        std::sin((d + a - t) / 2) * std::sin((d - a + t) / 2) / (std::sin(a) * std::sin(t));
    sum += 4 * phase.p(one_minus_cos_of(t)) * std::sin(t) * std::asin(std::sqrt(inside)) * t *
           (last - first) / rings;
  }
  return sum / (2 * pi * one_minus_cos_of(d));
}

// Of a peaked phase function, inside and outside. Seen red: with 2 nodes for each power of e.
TEST(ConeMean, IsThatOfRingsNearTheRim) {
  const optics::FournierForand phase(1.10, 3.5835);
  for (const double d : {3e-3, 0.1, 1.2})
    for (const double share : {0.01, 0.2, 0.7, 0.97, 0.999, 1.001, 1.03, 1.3}) {
      const double a = share * d, known = mean_of_rings(phase, a, d);
      const double by_rim = mean_by_rim(one_minus_cos_of(a), one_minus_cos_of(d),
                                        [&](double x) { return phase.below(x); });
      EXPECT_NEAR(by_rim / known, 1, 2e-7) << "half angle " << d << ", at " << share;
    }
}

// On the rim itself, which is far from all other directions there. Seen red: without directions put
// aside of it.
TEST(ConeMean, IsFiniteOnTheRim) {
  for (const double half_angle : {1e-6, 0.1, 1.5}) {
    const double d = one_minus_cos_of(half_angle);
    EXPECT_NEAR(mean_by_rim(d, d, [](double x) { return 2 * pi * x; }), 1, 2e-6) << half_angle;
  }
}

// The price of a model: over waves free walks begin in fourteen cones, each term of which takes
// some 150 instructions, at two directions in each cell. Seen red: with 20 nodes at least; with 20
// for each power of e.
TEST(ConeMean, TakesFewTerms) {
  std::vector<MeanTerm> terms;
  for (const double half_angle : {1e-6, 1e-3, 0.03, 0.2, 1.2}) {
    std::size_t count = 0;
    for (int i = 0; i < AveragedPhases::cells; ++i) {
      const auto [from, to] = AveragedPhases::edges(i);
      mean_over_cone((from + to) / 2, one_minus_cos_of(half_angle), terms);
      count += terms.size();
    }
    EXPECT_LT(static_cast<double>(count) / AveragedPhases::cells, 8) << half_angle;
  }
}

}  // namespace
}  // namespace photic::estimator
