// What the tests of the optics share.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "optics/fournier_forand.hpp"
#include "optics/library.hpp"
#include "optics/phase_functions.hpp"
#include "support/tables.hpp"

namespace photic::optics {

inline const std::string data_folder = PHOTIC_SOURCE_DIR "/data";

inline const Library& library() { return *test::tables(); }

/// The message of the exception E that f throws.
template <class E, class F>
std::string message(F f) {
  try {
    f();
  } catch (const E& e) {
    return e.what();
  }
  return "nothing of that kind was thrown";
}

inline void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is not in: " << text;
}

inline double cosine_of(double degrees) { return std::cos(degrees * radian_per_degree); }

/// 1 - cos of an angle.
inline double x_of(double degrees) {
  return 2 * std::pow(std::sin(degrees * radian_per_degree / 2), 2);
}

/// 2 pi times the integral of p over x0 … x1, x0 > 0: by quadrature over ln x, octave by octave.
inline double integral(const std::function<double(double)>& p, double x0, double x1) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  double sum = 0;
  for (double from = x0; from < x1; from *= 2) {
    const double to = std::min(2 * from, x1);
    const auto f = [&](double t) { return p(std::exp(t)) * std::exp(t); };
    sum += 2 * pi * Rule::integrate(f, std::log(from), std::log(to), 5, 1e-10);
  }
  return sum;
}

/// A folder of this process alone: tests run side by side.
inline std::filesystem::path scratch_folder(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / (name + "." + std::to_string(getpid()));
}

struct NamedShape {
  std::string name;
  PhaseShape shape;
};

/// One of each kind of phase function, sharp and blunt.
inline std::vector<NamedShape> all_shapes() {
  return {{"isotropic", isotropic()},
          {"rayleigh 0.039", rayleigh(0.039)},
          {"rayleigh 0.17", rayleigh(0.17)},
          {"raman 0.17", raman_phase(0.17)},
          {"henyey-greenstein -0.3", henyey_greenstein(-0.3)},
          {"henyey-greenstein 0", henyey_greenstein(0)},
          {"henyey-greenstein 0.924", henyey_greenstein(0.924)},
          {"henyey-greenstein 0.999", henyey_greenstein(0.999)},
          {"fournier-forand 1.10 3.5835", fournier_forand(1.10, 3.5835)},
          {"fournier-forand 1.02 3.1", fournier_forand(1.02, 3.1)},
          {"fournier-forand 1.02 4.9", fournier_forand(1.02, 4.9)},
          {"petzold", petzold(library())},
          {"mixture", mixture({{0.3, rayleigh(0.039)}, {0.7, fournier_forand(1.10, 3.5835)}})}};
}

}  // namespace photic::optics
