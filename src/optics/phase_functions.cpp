#include "optics/phase_functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/constants.hpp"
#include "core/error.hpp"

namespace photic::optics {
namespace {

constexpr double x_core = PhaseView::x_core;

/// level (1 + a cos^2), the form of all dipole scattering.
PhaseShape dipole(double level, double a) {
  PhaseShape shape;
  shape.p = [level, a](double x) { return level * (1 + a * (1 - x) * (1 - x)); };
  // 2 pi times the integral of p over 0 … x_core.
  const double squares = x_core - x_core * x_core + x_core * x_core * x_core / 3;
  shape.core_mass = 2 * pi * level * (x_core + a * squares);
  shape.key = PhaseKey("dipole").add(level).add(a);
  return shape;
}

void check_range(const char* model, const char* name, double value, bool inside,
                 const std::string& range) {
  if (inside) return;
  throw InputError(
      {{"", 0, 0, fmt::format("{}: {} = {:g} is outside {}", model, name, value, range), ""}});
}

/// The order of the parts is that of their sum.
PhaseKey key_of_mixture(const std::vector<std::pair<double, PhaseShape>>& parts) {
  PhaseKey key("mixture");
  for (const auto& [share, part] : parts) {
    if (part.key.empty()) return {};
    key.add(share).add(part.key);
  }
  return key;
}

}  // namespace

PhaseShape isotropic() { return dipole(1 / (4 * pi), 0); }

PhaseShape rayleigh(double rho) {
  check_range("rayleigh", "depolarisation", rho, rho >= 0 && rho <= 1, "0 to 1");
  return dipole(3 / (16 * pi) * 2 / (2 + rho) * (1 + rho), (1 - rho) / (1 + rho));
}

PhaseShape raman_phase(double rho) {
  check_range("raman", "depolarisation", rho, rho >= 0 && rho <= 1, "0 to 1");
  return dipole(3 / (16 * pi) * (1 + 3 * rho) / (1 + 2 * rho), (1 - rho) / (1 + 3 * rho));
}

PhaseShape henyey_greenstein(double g) {
  check_range("henyey-greenstein", "g", g, g >= lowest_henyey_greenstein_g && g < 1,
              fmt::format("{:g} to below 1", lowest_henyey_greenstein_g));
  // 1 + g^2 - 2 g cos, with its digits near the forward direction.
  const auto distance_squared = [g](double x) { return (1 - g) * (1 - g) + 2 * g * x; };
  PhaseShape shape;
  shape.p = [g, distance_squared](double x) {
    const double d = distance_squared(x);
    return (1 - g * g) / (4 * pi * d * std::sqrt(d));
  };
  // (1-g^2)/(2g) [1/(1-g) - 1/d], without the difference.
  const double d = std::sqrt(distance_squared(x_core));
  shape.core_mass = (1 + g) * x_core / (d * (1 - g + d));
  shape.key = PhaseKey("henyey-greenstein").add(g);
  return shape;
}

PhaseShape petzold(const Library& library) { return library.petzold.shape; }

PhaseShape mixture(const std::vector<std::pair<double, PhaseShape>>& parts) {
  double sum = 0;
  PhaseShape shape;
  for (const auto& [share, part] : parts) {
    check_range("mixture", "fraction", share, share >= 0 && share <= 1, "0 to 1");
    sum += share;
    shape.core_mass += share * part.core_mass;
  }
  check_range("mixture", "sum of the fractions", sum, std::abs(sum - 1) < 1e-9, "1");
  shape.core_mass = std::min(1.0, shape.core_mass);  // not a rounding more
  shape.p = [parts](double x) {
    double p = 0;
    for (const auto& [share, part] : parts) p += share * part.p(x);
    return p;
  };
  shape.key = key_of_mixture(parts);
  return shape;
}

}  // namespace photic::optics
