#include "scene/cut.hpp"

#include <algorithm>
#include <cmath>

namespace photic::scene {
namespace {

/// The profiles of a layer and how far each may depart from its mean.
class Cutter {
 public:
  Cutter(const std::vector<Varying>& profiles, const Span& span, double tolerance)
      : profiles_(profiles) {
    for (const Varying& varying : profiles)
      allowed_.push_back(allowed_departure(varying, span, tolerance));
  }

  /// The end of a layer from `top` down, at `bottom` at the deepest.
  [[nodiscard]] double end_of(double top, double bottom) const {
    if (holds(top, bottom)) return bottom;
    double good = top, bad = bottom;
    for (int halving = 0; halving < 50 && bad - good > 1e-3 * (bad - top); ++halving) {
      const double middle = (good + bad) / 2;
      (holds(top, middle) ? good : bad) = middle;
    }
    const double round = rounded_down(good, good - top);
    return round > top && holds(top, round) ? round : good;
  }

 private:
  [[nodiscard]] bool holds(double a, double b) const {
    for (std::size_t i = 0; i < profiles_.size(); ++i)
      if (!(departure(profiles_[i].profile, a, b) <= allowed_[i])) return false;
    return true;
  }

  /// To a tenth of the power of ten below a length; the nearest double to that decimal.
  static double rounded_down(double depth, double length) {
    const double power = std::floor(std::log10(length)) - 1;
    const double scale = std::pow(10.0, std::fabs(power));
    return power < 0 ? std::floor(depth * scale) / scale : std::floor(depth / scale) * scale;
  }

  const std::vector<Varying>& profiles_;
  std::vector<double> allowed_;
};

}  // namespace

double mean(const Profile& profile, double a_m, double b_m) {
  return std::visit([&](const auto& p) { return p.integral(a_m, b_m) / (b_m - a_m); }, profile);
}

double greatest(const Profile& profile, double a_m, double b_m) {
  return std::visit([&](const auto& p) { return p.extremes(a_m, b_m).greatest; }, profile);
}

double departure(const Profile& profile, double a_m, double b_m) {
  const auto [low, high] = std::visit([&](const auto& p) { return p.extremes(a_m, b_m); }, profile);
  const double centre = mean(profile, a_m, b_m);
  return std::max(high - centre, centre - low);
}

double allowed_departure(const Varying& varying, const Span& span, double tolerance) {
  return tolerance * varying.scale.value_or(greatest(varying.profile, span.top_m, span.bottom_m));
}

std::optional<std::vector<double>> cut(const std::vector<Varying>& profiles, const Span& span,
                                       double tolerance) {
  const Cutter cutter(profiles, span, tolerance);
  std::vector<double> ends;
  double top = span.top_m;
  while (top < span.bottom_m) {
    if (ends.size() == max_cuts) return std::nullopt;
    const double end = cutter.end_of(top, span.bottom_m);
    if (!(end > top)) return std::nullopt;  // too thin for doubles
    ends.push_back(end);
    top = end;
  }
  return ends;
}

std::optional<double> tolerance_to_keep(const std::vector<Varying>& profiles, const Span& span,
                                        double tolerance) {
  for (const double power : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1.0}) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double more = digit * power;
      if (more > tolerance && more <= 1 && cut(profiles, span, more)) return more;
    }
  }
  return std::nullopt;
}

}  // namespace photic::scene
