#include "optics/refractive_index.hpp"

#include "optics/library.hpp"

namespace photic::optics {
namespace {

// Quan & Fry's n0 … n9; wavelength in nm, S in PSU, T in C.
constexpr double n0 = 1.31405, n1 = 1.779e-4, n2 = -1.05e-6, n3 = 1.6e-8, n4 = -2.02e-6;
constexpr double n5 = 15.868, n6 = 0.01155, n7 = -0.00423, n8 = -4382.0, n9 = 1.1455e6;

/// The terms in 1/wavelength, its square and its cube.
struct Dispersion {
  double first, second, third;

  Dispersion(double nm, double s, double t)
      : first((n5 + n6 * s + n7 * t) / nm), second(n8 / (nm * nm)), third(n9 / (nm * nm * nm)) {
    if (!(nm >= refractive_index_min_nm && nm <= refractive_index_max_nm))
      no_data("refractive index", nm, refractive_index_source, refractive_index_min_nm,
              refractive_index_max_nm,
              "choose another wavelength, or give refractive_index and group_index of the sea");
  }
};

}  // namespace

double refractive_index(double nm, double s, double t) {
  const Dispersion d(nm, s, t);
  return n0 + (n1 + n2 * t + n3 * t * t) * s + n4 * t * t + d.first + d.second + d.third;
}

double group_index(double nm, double s, double t) {
  const Dispersion d(nm, s, t);
  return refractive_index(nm, s, t) + d.first + 2 * d.second + 3 * d.third;
}

double refractive_index_per_psu(double nm, double t) { return n1 + n2 * t + n3 * t * t + n6 / nm; }

}  // namespace photic::optics
