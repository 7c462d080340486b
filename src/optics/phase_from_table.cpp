#include "optics/phase_from_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "core/constants.hpp"
#include "core/error.hpp"

namespace photic::optics {
namespace {

/// p between two rows: p0 (x/x0)^-steepness, or a straight line where logarithms do not exist.
struct Segment {
  double x0, x1, p0, p1;

  [[nodiscard]] bool straight() const { return x0 <= 0 || p0 <= 0 || p1 <= 0; }
  [[nodiscard]] double steepness() const { return -std::log(p1 / p0) / std::log(x1 / x0); }

  [[nodiscard]] double p(double x) const {
    if (straight()) return std::lerp(p0, p1, (x - x0) / (x1 - x0));  // not below 0 by rounding
    return p0 * std::pow(x / x0, -steepness());
  }

  /// 2 pi times the integral of p over x0 … x.
  [[nodiscard]] double mass(double x) const {
    if (straight()) return pi * (p0 + p(x)) * (x - x0);
    const double power = 1 - steepness();
    const double octaves = std::log(x / x0);
    const double shape =
        std::abs(power * octaves) < 1e-12 ? octaves : std::expm1(power * octaves) / power;
    return 2 * pi * p0 * x0 * shape;
  }
};

/// A function of x over 0 … 2 by segments, the first of which is a power law down to 0.
class Curve {
 public:
  Curve(const std::vector<double>& x, const std::vector<double>& p) {
    for (std::size_t i = 1; i < x.size(); ++i)
      segments_.push_back({x[i - 1], x[i], p[i - 1], p[i]});
    const Segment& first = segments_.front();
    forward_steepness_ = first.straight() ? 0.0 : std::max(0.0, first.steepness());
  }

  /// The steepness of the power law towards 0; it has an integral below 1.
  [[nodiscard]] double forward_steepness() const { return forward_steepness_; }

  [[nodiscard]] double p(double x) const {
    const Segment& first = segments_.front();
    if (x < first.x0) return first.p0 * std::pow(x / first.x0, -forward_steepness_);
    const auto holds = std::find_if(segments_.begin(), segments_.end() - 1,
                                    [x](const Segment& s) { return x <= s.x1; });
    return holds->p(x);
  }

  /// 2 pi times the integral over 0 … x.
  [[nodiscard]] double mass_below(double x) const {
    const Segment& first = segments_.front();
    double sum = 0;
    if (first.x0 > 0) {
      const double end = std::min(x, first.x0);
      sum = 2 * pi * first.p0 * end * std::pow(end / first.x0, -forward_steepness_) /
            (1 - forward_steepness_);
    }
    for (const Segment& s : segments_) {
      if (x > s.x0) sum += s.mass(std::min(x, s.x1));
    }
    return sum;
  }

 private:
  std::vector<Segment> segments_;
  double forward_steepness_ = 0;
};

constexpr const char* angle_column = "angle_deg";
constexpr const char* p_column = "phase_function_per_sr";

std::vector<double> checked_x(const DataTable& table) {
  const std::vector<double> angle = table.ascending_numbers(angle_column);
  const std::size_t last = angle.size() - 1;
  if (last < 1) table.fail(0, angle_column, "a phase function needs at least two rows");
  if (angle.front() < 0) table.fail(0, angle_column, "scattering angles begin at 0 degrees");
  if (angle.back() != 180) {
    table.fail(last, angle_column,
               fmt::format("the last angle is {:g}, not 180 degrees", angle.back()),
               "end the table with the value at 180 degrees");
  }
  std::vector<double> x;
  for (const double degrees : angle) {
    const double half_sine = std::sin(0.5 * degrees * radian_per_degree);
    x.push_back(2 * half_sine * half_sine);  // 1 - cos with its digits
  }
  const auto same = std::adjacent_find(x.begin(), x.end(), std::greater_equal<>());
  if (same != x.end()) {
    table.fail(static_cast<std::size_t>(same - x.begin()) + 1, angle_column,
               "this angle cannot be distinguished from the one before it",
               "leave one of them out");
  }
  return x;
}

std::vector<double> checked_p(const DataTable& table) {
  std::vector<double> p = table.numbers(p_column);
  const auto bad = std::find_if(p.begin(), p.end(), [](double value) { return value < 0; });
  if (bad != p.end()) {
    table.fail(static_cast<std::size_t>(bad - p.begin()), p_column,
               "a phase function is not negative");
  }
  return p;
}

/// Returns the advice that makes 1 of the integral, by the customs of other fields. A volume
/// scattering function of 0.5 or 2 per metre is as likely as those, one of 4 pi is not.
std::string how_to_normalise(double integral) {
  struct Custom {
    double integral;
    const char* advice;
  };
  constexpr double nearly = 0.02;
  for (const Custom& custom :
       {Custom{4 * pi, "looks normalised to 4 pi, a mean of 1: divide it by 4 pi"},
        {2 * pi,
         "looks normalised to 1 over the cosine of the angle, without the azimuth: divide it "
         "by 2 pi"},
        {2,
         "looks normalised to 1 over half of the sphere: divide it by 2; or is it a volume "
         "scattering function? divide that by its scattering coefficient"},
        {0.5,
         "looks normalised to one half, as for each of two polarisations: multiply it by 2; or "
         "is it a volume scattering function? divide that by its scattering coefficient"}})
    if (std::abs(integral / custom.integral - 1) <= nearly) return custom.advice;
  return "divide a volume scattering function by its scattering coefficient";
}

}  // namespace

TabulatedPhase phase_from_table(const DataTable& table) {
  const std::vector<double> row_x = checked_x(table), row_p = checked_p(table);
  const Curve curve(row_x, row_p);
  if (curve.forward_steepness() >= 1) {
    table.fail(
        0, p_column,
        fmt::format(
            "the first two rows rise as angle^-{:.2f}: that has no integral towards 0 degrees",
            2 * curve.forward_steepness()),
        "give values at smaller angles, from 0 degrees on");
  }
  TabulatedPhase out;
  out.integral = curve.mass_below(2);
  if (!(std::abs(out.integral - 1) <= 0.01)) {
    table.fail(0, p_column,
               fmt::format("integrates to {:.4g} over the sphere, not 1 within 1 %", out.integral),
               how_to_normalise(out.integral));
  }
  if (std::abs(out.integral - 1) > 1e-4) {
    out.remark = fmt::format("{}: the phase function integrates to {:.5f}; scaled to 1",
                             table.name(), out.integral);
  }
  const double scale = 1 / out.integral;
  out.shape.p = [curve, scale](double x) { return scale * curve.p(x); };
  out.shape.key = PhaseKey("table").add(row_x).add(row_p);
  // Not a rounding above 1.
  out.shape.core_mass = std::min(1.0, scale * curve.mass_below(PhaseView::x_core));
  const double resolved = table_integral(out.shape);
  if (std::abs(resolved - 1) > 1e-4) {
    table.fail(0, p_column,
               fmt::format("has detail that is too fine: as tabulated by the program it integrates "
                           "to {:.5f}, not 1",
                           resolved),
               "smooth it; cells are 0.8 % of 1 - cos wide");
  }
  return out;
}

}  // namespace photic::optics
