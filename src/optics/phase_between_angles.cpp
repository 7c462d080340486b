#include "optics/phase_between_angles.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <memory>
#include <utility>

#include "core/constants.hpp"
#include "core/error.hpp"

namespace photic::optics {
namespace {

// Steps are a share of the angle from 0 (from 180) degrees, but not above one width nor below a
// share of another.
constexpr double forward_share = 0.12, forward_least_deg = 0.02;
constexpr double backward_share = 0.2, backward_least_deg = 0.2;
constexpr double widest_deg = 1.5;

/// Rises by 1 in a step.
double angle_coordinate(double degrees) {
  return degrees / widest_deg + std::log1p(degrees / forward_least_deg) / forward_share -
         std::log1p((180 - degrees) / backward_least_deg) / backward_share;
}

double degrees_of_coordinate(double wanted) {
  double low = 0, high = 180;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (angle_coordinate(middle) < wanted ? low : high) = middle;
  }
  return low;
}

/// With the digits that x has near 0.
double degrees_of_x(double x) {
  return 2 * std::asin(std::sqrt(std::min(x, 2.0) / 2)) / radian_per_degree;
}

class SmoothPhase {
 public:
  explicit SmoothPhase(const std::vector<double>& values) {
    expect(values.size() == angles_.degrees().size() && *std::ranges::min_element(values) > 0,
           "a phase function is above 0 at every angle");
    for (const double value : values) log_p_.push_back(std::log(value));
  }

  /// Hermite's cubic, with slopes from the neighbours of each angle.
  [[nodiscard]] double p(double degrees) const {
    const double step = angles_.step(degrees), last = static_cast<double>(log_p_.size() - 1);
    const auto i = static_cast<std::size_t>(std::clamp(std::floor(step), 0.0, last - 1));
    const double t = step - static_cast<double>(i), s = 1 - t;
    return std::exp(s * s * (1 + 2 * t) * log_p_[i] + t * t * (1 + 2 * s) * log_p_[i + 1] +
                    s * t * (s * slope(i) - t * slope(i + 1)));
  }

  /// Integral over the sphere between two angles.
  [[nodiscard]] double integral(double from_deg, double to_deg) const {
    using Rule = boost::math::quadrature::gauss<double, 7>;
    const auto integrand = [&](double degrees) {
      return p(degrees) * std::sin(degrees * radian_per_degree);
    };
    double sum = 0, from = from_deg;
    for (const double knot : angles_.degrees()) {
      const double to = std::clamp(knot, from, to_deg);
      if (to > from) sum += Rule::integrate(integrand, from, to);
      from = to;
    }
    return 2 * pi * radian_per_degree * sum;
  }

 private:
  [[nodiscard]] double slope(std::size_t i) const {
    const std::size_t below = i == 0 ? 0 : i - 1, above = std::min(i + 1, log_p_.size() - 1);
    return (log_p_[above] - log_p_[below]) / static_cast<double>(above - below);
  }

  PhaseAngles angles_;
  std::vector<double> log_p_;
};

}  // namespace

PhaseAngles::PhaseAngles() : first_(angle_coordinate(0)) {
  const double all = angle_coordinate(180) - first_;
  const int steps = static_cast<int>(std::ceil(all));
  per_step_ = all / steps;
  for (int i = 0; i <= steps; ++i)
    degrees_.push_back(degrees_of_coordinate(first_ + per_step_ * i));
  degrees_.front() = 0;
  degrees_.back() = 180;
}

double PhaseAngles::step(double degrees) const {
  return (angle_coordinate(degrees) - first_) / per_step_;
}

PhaseBetweenAngles phase_between_angles(const std::vector<double>& values_per_sr) {
  const auto curve = std::make_shared<const SmoothPhase>(values_per_sr);
  PhaseBetweenAngles out;
  out.integral = curve->integral(0, 180);
  const double scale = 1 / out.integral;
  out.shape.p = [curve, scale](double x) { return scale * curve->p(degrees_of_x(x)); };
  out.shape.core_mass = scale * curve->integral(0, degrees_of_x(PhaseView::x_core));
  out.shape.key = PhaseKey("between angles").add(values_per_sr);
  return out;
}

}  // namespace photic::optics
