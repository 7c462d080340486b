#include "optics/sea_slopes.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace photic::optics {
namespace {

/// Simpson's rule over 8 standard deviations each way.
double norm_of(const GramCharlier& series) {
  constexpr int steps = 800;  // even
  constexpr double reach = 8;
  const auto weight = [](int i) { return i == 0 || i == steps ? 1 : (i % 2 == 1 ? 4 : 2); };
  double sum = 0;
  for (int i = 0; i <= steps; ++i)
    for (int k = 0; k <= steps; ++k) {
      const double xi = reach * (2.0 * i / steps - 1), eta = reach * (2.0 * k / steps - 1);
      sum += weight(i) * weight(k) * std::exp(-(xi * xi + eta * eta) / 2) *
             std::max(0.0, series(xi, eta));
    }
  const double third = 2 * reach / steps / 3;
  return sum * third * third / (2 * pi);
}

}  // namespace

double SlopeLaw::density(double upwind, double crosswind) const {
  const double up = upwind / std::sqrt(upwind_variance);
  const double across = crosswind / std::sqrt(crosswind_variance);
  return std::exp(-(up * up + across * across) / 2) * std::max(0.0, series(across, up)) /
         (2 * pi * std::sqrt(upwind_variance * crosswind_variance) * norm);
}

SlopeLaw paper_slopes(double wind_speed_m_s) {
  return {.upwind_variance = 0.008 + 0.0156 * wind_speed_m_s,
          .source =
              "PREMAR-2F, slopes along the wind of variance 0.008 + 0.0156 v as printed "
              "[Cox & Munk 1954 have 0.00156 v for a slick]"};
}

SlopeLaw cox_munk_slopes(double wind_speed_m_s, bool slick, bool with_series) {
  const double w = wind_speed_m_s;
  SlopeLaw law;
  if (slick) {
    law = {.upwind_variance = 0.005 + 0.00078 * w,
           .crosswind_variance = 0.003 + 0.00084 * w,
           .source = "Cox & Munk 1954, J. Opt. Soc. Am. 44, 838, slick [from memory, unverified]"};
  } else {
    law = {.upwind_variance = 0.00316 * w,
           .crosswind_variance = 0.003 + 0.00192 * w,
           .source = "Cox & Munk 1954, J. Opt. Soc. Am. 44, 838, clean sea"};
  }
  if (!with_series) return law;
  law.series = {
      .c21 = 0.01 - 0.0086 * w, .c03 = 0.04 - 0.033 * w, .c40 = 0.40, .c22 = 0.12, .c04 = 0.23};
  law.norm = norm_of(law.series);
  law.source += ", with the Gram-Charlier series of the clean sea";
  return law;
}

SlopeLaw gaussian_slopes(double upwind_variance, double crosswind_variance) {
  return {.upwind_variance = upwind_variance,
          .crosswind_variance = crosswind_variance,
          .source = "a Gaussian of the scene's own variances"};
}

}  // namespace photic::optics
