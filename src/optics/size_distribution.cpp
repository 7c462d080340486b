#include "optics/size_distribution.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/interpolation.hpp"

namespace photic::optics {
namespace {

constexpr double metres_per_um = 1e-6;

void check_radii(const std::vector<double>& radius_m) {
  const bool ascending = std::adjacent_find(radius_m.begin(), radius_m.end(),
                                            std::greater_equal<>()) == radius_m.end();
  expect(
      radius_m.size() >= 2 && radius_m.front() > 0 && ascending && std::isfinite(radius_m.back()),
      "the radii of a size distribution are positive and ascend");
}

/// The radii of each kind.
struct Radii {
  std::vector<double> operator()(const Junge& s) const {
    expect(std::isfinite(s.slope), "the slope of a Junge distribution is a number");
    return {s.min_radius_m, s.max_radius_m};
  }
  std::vector<double> operator()(const LogNormal& s) const {
    expect(s.mode_radius_m > 0 && s.spread > 1,
           "a log-normal distribution has a mode and a spread");
    return {s.min_radius_m, s.max_radius_m};
  }
  std::vector<double> operator()(const SizeTable& s) const {
    expect(s.number.size() == s.radius_m.size() && s.number.size() >= 2,
           "a size distribution has a number at every radius");
    expect(*std::min_element(s.number.begin(), s.number.end()) >= 0 &&
               *std::max_element(s.number.begin(), s.number.end()) > 0,
           "there are particles, and none of a negative number");
    return s.radius_m;
  }
};

/// Particles per ln(radius) of each kind, at a radius that it covers. Powers are taken of ratios
/// of radii, which do not overflow.
struct Number {
  double radius_m;

  double operator()(const Junge& s) const {
    return std::pow(radius_m / s.min_radius_m, 1 - s.slope);
  }
  double operator()(const LogNormal& s) const {
    const double deviations = std::log(radius_m / s.mode_radius_m) / std::log(s.spread);
    return std::exp(-deviations * deviations / 2);
  }
  double operator()(const SizeTable& s) const {
    const auto& r = s.radius_m;
    const auto [i, way] = interval_of(r, radius_m);
    const double lower = s.number[i - 1], upper = s.number[i];
    const bool straight = lower == 0 || upper == 0;
    const double t = straight ? way : std::log(radius_m / r[i - 1]) / std::log(r[i] / r[i - 1]);
    return radius_m * (straight ? std::lerp(lower, upper, t) : lower * std::pow(upper / lower, t));
  }
};

}  // namespace

SizeTable size_table(const DataTable& table) {
  SizeTable out{table.ascending_numbers("radius_um"), table.numbers("number_per_um")};
  if (out.radius_m.size() < 2)
    table.fail(0, "radius_um", "a size distribution needs at least two rows");
  if (out.radius_m.front() <= 0) table.fail(0, "radius_um", "a radius is above 0");
  for (double& radius : out.radius_m) radius *= metres_per_um;
  const auto bad =
      std::find_if(out.number.begin(), out.number.end(), [](double n) { return n < 0; });
  if (bad != out.number.end()) {
    table.fail(static_cast<std::size_t>(bad - out.number.begin()), "number_per_um",
               "a number of particles is not negative");
  }
  if (std::all_of(out.number.begin(), out.number.end(), [](double n) { return n == 0; }))
    table.fail(0, "number_per_um", "there are no particles");
  return out;
}

std::vector<double> smooth_between_m(const SizeDistribution& sizes) {
  std::vector<double> radius_m = std::visit(Radii{}, sizes);
  check_radii(radius_m);
  return radius_m;
}

double number_per_log_radius(const SizeDistribution& sizes, double radius_m) {
  return std::visit(Number{radius_m}, sizes);
}

}  // namespace photic::optics
