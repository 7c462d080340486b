#include "optics/mie.hpp"

#include <algorithm>
#include <boost/math/tools/fraction.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"

namespace photic::optics {
namespace {

using Complex = std::complex<double>;

/// psi_(n-1) / psi_n of argument z as a continued fraction (Lentz 1976, Appl. Opt. 15, 668).
Complex ratio_of_neighbours(Complex z, int n) {
  struct Terms {
    using result_type = std::pair<Complex, Complex>;
    Complex z;
    int twice;
    result_type operator()() {
      twice += 2;
      return {Complex(-1), static_cast<double>(twice) / z};
    }
  };
  Terms terms{z, 2 * n - 1};
  return boost::math::tools::continued_fraction_b(terms, std::numeric_limits<double>::epsilon());
}

/// psi_n' / psi_n of argument z for n = 0 … last, downwards, which is stable for every z.
std::vector<Complex> logarithmic_derivatives(Complex z, int last) {
  std::vector<Complex> d(static_cast<std::size_t>(last) + 1);
  d.back() = ratio_of_neighbours(z, last) - static_cast<double>(last) / z;
  for (std::size_t n = d.size() - 1; n > 0; --n) {
    const Complex n_z = static_cast<double>(n) / z;
    d[n - 1] = n_z - 1.0 / (d[n] + n_z);
  }
  return d;
}

/// Numerator and numerator + i rest: apart, so that the real part keeps its digits in a small
/// sphere that does not absorb.
Complex coefficient(Complex factor, double psi, double psi_before, double chi, double chi_before) {
  const Complex numerator = factor * psi - psi_before;
  const Complex rest = factor * chi - chi_before;
  return numerator / (numerator + Complex(-rest.imag(), rest.real()));
}

/// Angles that are summed side by side, in the compilers' vector extension.
constexpr std::size_t abreast = 4;
using Angles = double __attribute__((vector_size(abreast * sizeof(double))));

/// Sum and difference of S1 and S2.
struct Sums {
  Angles plus_re{}, plus_im{}, minus_re{}, minus_im{};

  [[nodiscard]] MieAmplitudes at(std::size_t j) const {
    const Complex plus(plus_re[j], plus_im[j]), minus(minus_re[j], minus_im[j]);
    return {0.5 * (plus + minus), 0.5 * (plus - minus)};
  }
};

/// Wiscombe 1980, sec. III: S1 +- S2 are sums of (a +- b) (pi +- tau).
void sum_orders(const std::vector<Complex>& a, const std::vector<Complex>& b, const Angles& cosine,
                Sums& sums) {
  Angles pi_before{}, pi = pi_before + 1;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double n = static_cast<double>(i) + 1;
    const double weight = (2 * n + 1) / (n * (n + 1)), ratio = (n + 1) / n;
    const Complex plus = weight * (a[i] + b[i]), minus = weight * (a[i] - b[i]);
    const Angles along = cosine * pi, rise = along - pi_before;
    const Angles tau = n * rise - pi_before;
    const Angles add = pi + tau, subtract = pi - tau;
    sums.plus_re += plus.real() * add;
    sums.plus_im += plus.imag() * add;
    sums.minus_re += minus.real() * subtract;
    sums.minus_im += minus.imag() * subtract;
    pi_before = pi;
    pi = along + ratio * rise;
  }
}

}  // namespace

int mie_orders(double x) { return static_cast<int>(std::ceil(x + 4.05 * std::cbrt(x) + 2)); }

MieContrast::MieContrast(Complex m) : index(m) {
  const Complex contrast = m - 1.0;
  if (std::abs(contrast) >= faintest) return;
  const Complex faint(faintest, -faintest);
  index = 1.0 + faint;
  scattering = std::norm(contrast * (m + 1.0)) / std::norm(faint * (index + 1.0));
  absorption = m.real() * m.imag() / (index.real() * index.imag());
}

MieSphere::MieSphere(double x, Complex m) : size_(x) {
  expect(x >= smallest_size && x <= largest_size, "Mie theory is asked for a size it can do");
  expect(m.real() > 0 && m.imag() <= 0, "the index of a sphere is n - ik with n > 0, k >= 0");
  const int orders = mie_orders(x);
  const std::vector<Complex> inside = logarithmic_derivatives(m * x, orders);
  const std::vector<Complex> outside = logarithmic_derivatives(x, orders);
  double psi_before = std::cos(x), psi = std::sin(x);
  double chi_before = -psi, chi = psi_before;
  for (int i = 1; i <= orders; ++i) {
    const double n = i, n_x = n / x;
    const auto k = static_cast<std::size_t>(i);
    // Upwards, psi loses its digits above n = x; there the ratio of neighbours has no zeros.
    const double next =
        n <= x ? (2 * n - 1) / x * psi - psi_before : psi / (outside[k].real() + n_x);
    psi_before = std::exchange(psi, next);
    chi_before = std::exchange(chi, (2 * n - 1) / x * chi - chi_before);
    a_.push_back(coefficient(inside[k] / m + n_x, psi, psi_before, chi, chi_before));
    b_.push_back(coefficient(m * inside[k] + n_x, psi, psi_before, chi, chi_before));
  }
}

MieEfficiencies MieSphere::efficiencies() const {
  double extinction = 0, scattering = 0, mean_cosine = 0, sign = -1;
  Complex back = 0;
  for (std::size_t i = 0; i < a_.size(); ++i, sign = -sign) {
    const double n = static_cast<double>(i) + 1;
    const Complex a = a_[i], b = b_[i];
    extinction += (2 * n + 1) * (a + b).real();
    scattering += (2 * n + 1) * (std::norm(a) + std::norm(b));
    back += sign * (2 * n + 1) * (a - b);
    mean_cosine += (2 * n + 1) / (n * (n + 1)) * (a * std::conj(b)).real();
    if (i + 1 < a_.size())
      mean_cosine +=
          n * (n + 2) / (n + 1) * (a * std::conj(a_[i + 1]) + b * std::conj(b_[i + 1])).real();
  }
  const double scale = 2 / (size_ * size_);
  MieEfficiencies q;
  q.extinction = scale * extinction;
  q.scattering = scale * scattering;
  q.absorption = std::max(0.0, q.extinction - q.scattering);  // not a rounding below
  q.back = std::norm(back) / (size_ * size_);
  q.mean_cosine = 2 * mean_cosine / scattering;
  return q;
}

void MieSphere::amplitudes(std::span<const double> cosines, std::span<MieAmplitudes> out) const {
  expect(cosines.size() == out.size(), "there is room for the amplitudes of every angle");
  for (std::size_t first = 0; first < out.size(); first += abreast) {
    const std::size_t count = std::min(abreast, out.size() - first);
    Angles cosine{};
    for (std::size_t j = 0; j < count; ++j) cosine[j] = cosines[first + j];
    Sums sums;
    sum_orders(a_, b_, cosine, sums);
    for (std::size_t j = 0; j < count; ++j) out[first + j] = sums.at(j);
  }
}

MieAmplitudes MieSphere::amplitudes(double cosine) const {
  MieAmplitudes out;
  amplitudes({&cosine, 1}, {&out, 1});
  return out;
}

MieMueller mueller(const MieAmplitudes& s) {
  const Complex mixed = s.s1 * std::conj(s.s2);
  const double across = std::norm(s.s1), along = std::norm(s.s2);
  return {(along + across) / 2, (along - across) / 2, mixed.real(), mixed.imag()};
}

}  // namespace photic::optics
