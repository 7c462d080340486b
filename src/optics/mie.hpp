// Mie theory: how a homogeneous sphere scatters and absorbs light.
// Sources: Bohren & Huffman 1983, Absorption and Scattering of Light by Small Particles, ch. 4
// [verified]; Wiscombe 1980, Appl. Opt. 19, 1505 [verified], whose signs are used: m = n - ik.
#pragma once

#include <complex>
#include <span>
#include <vector>

namespace photic::optics {

/// Cross-sections over the sphere's geometrical one.
struct MieEfficiencies {
  double extinction = 0;
  double scattering = 0;
  double absorption = 0;
  double back = 0;         ///< 4 |S(180 degrees)|^2 / x^2, Bohren & Huffman's Q_back
  double mean_cosine = 0;  ///< g of what is scattered
};

/// S1: the electric field across the plane of scattering, S2: along it.
struct MieAmplitudes {
  std::complex<double> s1, s2;
};

/// The elements of a sphere's Mueller matrix: S11 = S22, S12 = S21, S33 = S44, S34 = -S43. The
/// scattered intensity at distance r is S11 / (k r)^2 of unpolarised light's.
struct MieMueller {
  double s11, s12, s33, s34;
};

/// The index for Mie theory in place of one so near 1 that the coefficients, differences of nearly
/// equal numbers, would lose their digits. The pattern of spheres fainter than that depends on
/// nothing but their size: scattering goes as |m^2 - 1|^2, absorption as the imaginary part of m^2
/// (Rayleigh-Gans theory: van de Hulst 1957, ch. 7; Bohren & Huffman 1983, sec. 6.1 [from memory]).
struct MieContrast {
  /// |m - 1|, where rounding and what is left out of Rayleigh-Gans theory are alike: 2e-6 of the
  /// scattering into any direction up to size parameters of 1000, 2e-5 at 10 000.
  static constexpr double faintest = 1e-8;

  explicit MieContrast(std::complex<double> relative_index);

  std::complex<double> index;             ///< that of the sphere if it is not too faint
  double scattering = 1, absorption = 1;  ///< factors of the efficiencies
};

class MieSphere {
 public:
  static constexpr double smallest_size = 1e-8, largest_size = 2e4;

  /// The size parameter is 2 pi radius / wavelength, the index that of the sphere; both of them
  /// relative to the medium around: its wavelength, its index. Throws ContractViolation for sizes
  /// outside the two above, n <= 0 or k < 0.
  MieSphere(double size_parameter, std::complex<double> relative_index);

  [[nodiscard]] MieEfficiencies efficiencies() const;

  /// As many as there are cosines of scattering angles.
  void amplitudes(std::span<const double> cosines, std::span<MieAmplitudes> out) const;
  [[nodiscard]] MieAmplitudes amplitudes(double cosine) const;

 private:
  double size_;
  std::vector<std::complex<double>> a_, b_;  ///< of order 1 and up
};

/// Bohren & Huffman 1983, eq. (4.77), with the sign of S34 that theirs has (they have m = n + ik).
MieMueller mueller(const MieAmplitudes& s);

/// The number of orders that are summed: Wiscombe's criterion for 8 < x < 4200, which is the
/// strictest.
int mie_orders(double size_parameter);

}  // namespace photic::optics
