#include "optics/mie.hpp"

#include "optics/legendre.hpp"
#include "unit/optics/support.hpp"
#include "unit/optics/wiscombe_spheres.hpp"

namespace photic::optics {
namespace {

using Complex = std::complex<double>;

// Wiscombe's answers have seven digits; S is measured by the larger amplitude of the angle, since
// at 90 degrees one of them vanishes in a small sphere. Case 11 is summed to one order less there,
// whose resonance is 4e-6 of S(180 degrees). Seen red: without the terms above x; with m D_n in
// place of D_n / m; with tau's sign turned; with the recurrence of D_n started at 0.
TEST(Mie, AgreesWithWiscombesSpheres) {
  for (const WiscombeSphere& w : wiscombe_spheres()) {
    SCOPED_TRACE(w.number);
    const MieSphere sphere(w.size, w.index);
    const MieEfficiencies q = sphere.efficiencies();
    EXPECT_NEAR(q.extinction / w.extinction, 1, 6e-7);
    EXPECT_NEAR(q.scattering / w.scattering, 1, 6e-7);
    EXPECT_NEAR(q.mean_cosine, w.g_scattering / w.scattering, 1e-6);
    for (std::size_t i = 0; i < w.s1.size(); ++i) {
      const MieAmplitudes s = sphere.amplitudes(cosine_of(30 * static_cast<double>(i)));
      const double tolerance = w.number == 11 && i == 6 ? 5e-6 : 1e-6;
      const double scale = std::max(std::abs(w.s1[i]), std::abs(w.s2[i]));
      EXPECT_LT(std::abs(s.s1 - w.s1[i]) / scale, tolerance) << i;
      EXPECT_LT(std::abs(s.s2 - w.s2[i]) / scale, tolerance) << i;
    }
  }
}

// Wiscombe 1979, NCAR TN-140+STR, test cases of the first edition: m = 1.5, four to five digits;
// S(180 degrees), or its square where that is all there is. Seen red: with pi + tau and pi - tau
// swapped.
TEST(Mie, AgreesWithWiscombesFirstEdition) {
  struct Case {
    double size, scattering;
    double back_squared;
  };
  for (const Case& c : {Case{10, 2.8820, std::norm(Complex(4.322, 4.868))},
                        {100, 2.0944, std::norm(Complex(40.77, 51.75))},
                        {1000, 2.0139, 2.576e6},
                        {5000, 2.0086, 2.378e8}}) {
    const MieSphere sphere(c.size, 1.5);
    EXPECT_NEAR(sphere.efficiencies().scattering, c.scattering, 6e-5) << c.size;
    EXPECT_NEAR(std::norm(sphere.amplitudes(-1).s1) / c.back_squared, 1, 3e-4) << c.size;
  }
}

// The sphere of Bohren & Huffman 1983, appendix A, p. 482: radius 0.525 um, wavelength 0.6328 um,
// m = 1.55; every line of its output, to half a unit of its sixth digit. Seen red:
// with the sign of S12, of S34 or of S2 turned; with Q_back's sum not alternating.
TEST(Mie, AgreesWithBohrenAndHuffman) {
  struct Line {
    double degrees, s11, polarisation, s33, s34;
  };
  const std::vector<Line> lines{{0, 1.00000, 0, 1, 0},
                                {9, 0.785390, -0.459811e-2, 0.999400, 0.343261e-1},
                                {18, 0.356897, -0.458541e-1, 0.986022, 0.160184},
                                {27, 0.766119e-1, -0.364744, 0.843603, 0.394076},
                                {36, 0.355355e-1, -0.534997, 0.686967, -0.491787},
                                {45, 0.701845e-1, 0.959953e-2, 0.959825, -0.280434},
                                {54, 0.574313e-1, 0.477927e-1, 0.985371, 0.163584},
                                {63, 0.219660e-1, -0.440604, 0.648043, 0.621216},
                                {72, 0.125959e-1, -0.831996, 0.203255, -0.516208},
                                {81, 0.173750e-1, 0.341670e-1, 0.795354, -0.605182},
                                {90, 0.124601e-1, 0.230462, 0.937497, 0.260742},
                                {99, 0.679093e-2, -0.713472, -0.717397e-2, 0.700647},
                                {108, 0.954239e-2, -0.756255, -0.394748e-1, -0.653085},
                                {117, 0.863419e-2, -0.281215, 0.536251, -0.795835},
                                {126, 0.227421e-2, -0.239612, 0.967602, 0.795798e-1},
                                {135, 0.543998e-2, -0.850804, 0.187531, -0.490882},
                                {144, 0.160243e-1, -0.706334, 0.495254, -0.505781},
                                {153, 0.188852e-1, -0.891081, 0.453277, -0.226817e-1},
                                {162, 0.195254e-1, -0.783319, -0.391613, 0.482752},
                                {171, 0.301676e-1, -0.196194, -0.962069, 0.189556},
                                {180, 0.383189e-1, 0, -1, 0}};
  const MieSphere sphere(2 * pi * 0.525 / 0.6328, 1.55);
  const MieEfficiencies q = sphere.efficiencies();
  EXPECT_NEAR(q.extinction, 3.10543, 5e-6);
  EXPECT_NEAR(q.scattering, 3.10543, 5e-6);
  EXPECT_NEAR(q.back, 2.92534, 5e-6);
  const double forward = mueller(sphere.amplitudes(1)).s11;
  for (const Line& line : lines) {
    SCOPED_TRACE(line.degrees);
    const MieMueller m = mueller(sphere.amplitudes(cosine_of(line.degrees)));
    EXPECT_NEAR(m.s11 / forward / line.s11, 1, 5e-6);
    EXPECT_NEAR(-m.s12 / m.s11, line.polarisation, 1e-6);
    EXPECT_NEAR(m.s33 / m.s11, line.s33, 1e-6);
    EXPECT_NEAR(m.s34 / m.s11, line.s34, 1e-6);
    EXPECT_NEAR(m.s11 * m.s11, m.s12 * m.s12 + m.s33 * m.s33 + m.s34 * m.s34,
                1e-12 * m.s11 * m.s11);
  }
}

struct Sphere {
  double size;
  Complex index;
};
const std::vector<Sphere>& all_spheres() {
  static const std::vector<Sphere> all{
      {1e-3, {1.5, 0}},    {0.5, {1.05, -0.01}}, {4, {1.15, -0.001}}, {30, {1.05, -0.01}},
      {pi * 7, {1.33, 0}}, {150, {1.5, -0.5}},   {700, {0.75, 0}},    {2000, {10, -10}}};
  return all;
}

// The light scattered into all angles against the sums of coefficients. Seen red: with n (n + 1) /
// (n + 2) in the sum for g; without its complex conjugate.
TEST(Mie, ScattersAsMuchIntoAllAnglesAsItsEfficiencySays) {
  for (const auto& [size, index] : all_spheres()) {
    const MieSphere sphere(size, index);
    const MieEfficiencies q = sphere.efficiencies();
    const GaussRule rule(2 * mie_orders(size) + 2);
    double sum = 0, along = 0;
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      const double s11 = mueller(sphere.amplitudes(rule.node[i])).s11;
      sum += rule.weight[i] * s11;
      along += rule.weight[i] * s11 * rule.node[i];
    }
    EXPECT_NEAR(2 / (size * size) * sum / q.scattering, 1, 1e-10) << size;
    EXPECT_NEAR(along / sum, q.mean_cosine, 1e-10) << size;
  }
}

// Seen red: with 2 n - 1 for 2 n + 1 in the extinction.
TEST(Mie, TakesFromTheBeamWhatItScattersAndAbsorbs) {
  for (const auto& [size, index] : all_spheres()) {
    const MieEfficiencies q = MieSphere(size, index).efficiencies();
    EXPECT_NEAR(q.extinction, q.scattering + q.absorption, 1e-12 * q.extinction) << size;
    if (index.imag() == 0) {
      EXPECT_NEAR(q.extinction, q.scattering, 1e-11 * q.extinction) << size;
    } else {
      EXPECT_GT(q.absorption, 0) << size;
    }
  }
}

// Extinction from the field straight ahead, and Q_back from that straight back. Seen red: as above.
TEST(Mie, ObeysTheOpticalTheorem) {
  for (const auto& [size, index] : all_spheres()) {
    const MieSphere sphere(size, index);
    const MieEfficiencies q = sphere.efficiencies();
    const MieAmplitudes forward = sphere.amplitudes(1), back = sphere.amplitudes(-1);
    EXPECT_NEAR(4 / (size * size) * forward.s1.real() / q.extinction, 1, 1e-10) << size;
    EXPECT_EQ(forward.s1, forward.s2) << size;
    EXPECT_EQ(back.s1, -back.s2) << size;
    EXPECT_NEAR(4 / (size * size) * std::norm(back.s1) / q.back, 1, 1e-8) << size;
  }
}

// Bohren & Huffman 1983, eqs. (5.8), (5.11): what is left out goes as x^2. Seen red:
// with psi_n recurred upwards above n = x.
TEST(Mie, IsRayleighsInTheLimitOfSmallSpheres) {
  for (const double size : {1e-2, 1e-4, 1e-6, MieSphere::smallest_size}) {
    for (const Complex m : {Complex(1.5, 0), Complex(1.05, -0.01), Complex(3, -2)}) {
      const Complex polarisability = (m * m - 1.0) / (m * m + 2.0);
      const MieSphere sphere(size, m);
      const MieEfficiencies q = sphere.efficiencies();
      const double tolerance = std::max(10 * size * size, 1e-9);
      EXPECT_NEAR(q.scattering / (8.0 / 3 * std::pow(size, 4) * std::norm(polarisability)), 1,
                  tolerance);
      if (m.imag() != 0) {
        EXPECT_NEAR(q.absorption / (-4 * size * polarisability.imag()), 1, tolerance);
      }
      const MieMueller right_angle = mueller(sphere.amplitudes(0));
      EXPECT_NEAR(-right_angle.s12 / right_angle.s11, 1, tolerance);
    }
  }
}

// van de Hulst 1957, Light Scattering by Small Particles, sec. 11.22: anomalous diffraction, the
// limit of m -> 1 and x -> infinity.
TEST(Mie, IsAnomalousDiffractionForLargeSpheresOfTheMediumsIndex) {
  for (const double phase : {1.0, 4.0, 7.6, 20.0}) {
    const double size = 4000, index = 1 + phase / (2 * size);
    const double q = 2 - 4 / phase * std::sin(phase) + 4 / (phase * phase) * (1 - std::cos(phase));
    EXPECT_NEAR(MieSphere(size, index).efficiencies().extinction, q, 5e-3) << phase;
  }
}

// Nussenzveig & Wiscombe 1980, Phys. Rev. Lett. 45, 1490: Q_ext = 2 + 1.9923861 x^(-2/3) + ….
TEST(Mie, TakesTwiceItsAreaInTheLimitOfLargeSpheres) {
  for (const double size : {1e3, 1e4, MieSphere::largest_size}) {
    const double edge = 1.9923861 * std::pow(size, -2.0 / 3);
    EXPECT_NEAR(MieSphere(size, {1.5, -0.5}).efficiencies().extinction, 2 + edge, 1e-1 * edge)
        << size;
  }
}

// Seen red: with every fifth angle left out.
TEST(Mie, GivesManyAnglesAsItGivesOne) {
  const MieSphere sphere(20, {1.2, -0.01});
  const std::vector<double> cosines{1, 0.9, 0.3, 0, -0.5, -1, -0.99};
  std::vector<MieAmplitudes> all(cosines.size());
  sphere.amplitudes(cosines, all);
  for (std::size_t i = 0; i < cosines.size(); ++i) {
    EXPECT_EQ(all[i].s1, sphere.amplitudes(cosines[i]).s1) << i;
    EXPECT_EQ(all[i].s2, sphere.amplitudes(cosines[i]).s2) << i;
  }
}

// Seen red: with k < 0 let through.
TEST(Mie, RefusesWhatItCannotDo) {
  for (const auto& [size, index] : {Sphere{0, {1.5, 0}},
                                    {-1, {1.5, 0}},
                                    {3e4, {1.5, 0}},
                                    {std::nan(""), {1.5, 0}},
                                    {1, {0, 0}},
                                    {1, {1.5, 0.1}}})
    EXPECT_THROW(MieSphere(size, index), ContractViolation) << size << " " << index;
}

}  // namespace
}  // namespace photic::optics
