#include "optics/fournier_forand.hpp"

#include <fmt/format.h>

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "core/constants.hpp"
#include "core/error.hpp"

namespace photic::optics {
namespace {

// The formula has 1 - delta in denominators; at delta = 1 (9.94 degrees for n = 1.10) it is 0/0. It
// is written with two quotients that are smooth there.

/// (1 - delta^a) / (1 - delta).
double first_quotient(double delta, double a) {
  const double log_delta = std::log(delta);
  return log_delta == 0 ? a : std::expm1(a * log_delta) / std::expm1(log_delta);
}

/// (delta^v - 1 + v (1 - delta)) / (1 - delta)^2: the binomial series of delta^v without its first
/// two terms.
double second_quotient(double delta, double v) {
  const double e = 1 - delta;
  if (std::abs(e) > 0.03) return (std::expm1(v * std::log(delta)) + v * e) / (e * e);
  double sum = 0;
  double term = v * (v - 1) / 2;
  for (int k = 2; k < 14; ++k) {  // 0.03^12 is below the rounding
    sum += term;
    term *= -e * (v - k) / (k + 1);
  }
  return sum;
}

}  // namespace

FournierForand::FournierForand(double refractive_index, double slope) : v_((3 - slope) / 2) {
  const bool good = refractive_index >= lowest_index && refractive_index <= highest_index &&
                    slope > slope_above && slope < slope_below;
  if (!good) {
    throw InputError(
        {{"", 0, 0,
          fmt::format("fournier-forand: refractive_index = {:g} with slope = {:g} is outside "
                      "{:g} to {:g} with {:g} < slope < {:g}",
                      refractive_index, slope, lowest_index, highest_index, slope_above,
                      slope_below),
          "the index is that of the particles relative to water"}});
  }
  const double delta_180 = 4 / (3 * (refractive_index - 1) * (refractive_index - 1));
  delta_per_x_ = delta_180 / 2;  // sin^2(angle/2) = x/2
  tail_ = -first_quotient(delta_180, v_) / (16 * pi * std::pow(delta_180, v_));
}

double FournierForand::p(double x) const {
  const double delta = delta_per_x_ * x;
  const double q = second_quotient(delta, v_);
  const double cosine = 1 - x;
  return (q - (v_ + delta * q) / (x / 2)) / (4 * pi * std::pow(delta, v_)) +
         tail_ * (3 * cosine * cosine - 1);
}

double FournierForand::below(double x) const {
  const double delta = delta_per_x_ * x;
  const double main = first_quotient(delta, v_ + 1) - first_quotient(delta, v_) * x / 2;
  // The tail's integral over 0 … x; sin^2 = x (2 - x).
  return main / std::pow(delta, v_) + 2 * pi * tail_ * (1 - x) * x * (2 - x);
}

FournierForand FournierForand::of_backscatter(double fraction) {
  if (!(fraction >= lowest_backscatter && fraction <= highest_backscatter)) {
    throw InputError({{"", 0, 0,
                       fmt::format("a backscatter fraction b_b/b of {:.4g} is outside {:g} to "
                                   "{:g}, where it sets the phase function",
                                   fraction, lowest_backscatter, highest_backscatter),
                       "give a phase_function instead"}});
  }
  const auto along = [](double slope) {
    return FournierForand(1.01 + 0.1542 * (slope - 3), slope);
  };
  // The fraction rises with the slope, from 0 at 3 to 1/2 at 5.
  const auto excess = [&](double slope) { return along(slope).backscatter_fraction() - fraction; };
  std::uintmax_t steps = 100;
  const auto [low, high] = boost::math::tools::toms748_solve(
      excess, 3.01, 4.99, boost::math::tools::eps_tolerance<double>(), steps);
  return along((low + high) / 2);
}

PhaseShape FournierForand::shape() const {
  return {[*this](double x) { return p(x); }, below(PhaseView::x_core),
          PhaseKey("fournier-forand").add(v_).add(delta_per_x_).add(tail_)};
}

}  // namespace photic::optics
