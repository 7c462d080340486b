#include "optics/emission.hpp"

#include "optics/fluorescence.hpp"
#include "optics/raman.hpp"
#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

EmissionLine only_line(const Emission& emission) {
  EXPECT_EQ(emission.lines.size(), 1U);
  return emission.lines.at(0);
}

EmissionLine paper(double nm) { return only_line(raman(library(), "marshall-smith", nm)); }
EmissionLine bartlett(double nm) { return only_line(raman(library(), "bartlett", nm)); }

// Printed values of the formula, on the energy basis. Seen red: with wavenumbers in 1/m; with the
// resonance frequency against the Raman instead of the laser's wavenumber; with the photon factor
// upside down.
TEST(Raman, OfThePaperHasItsCoefficients) {
  EXPECT_NEAR(paper(488).coefficient_per_m * 488 / paper(488).wavelength_nm, 2.6000e-4, 5e-9);
  EXPECT_NEAR(paper(532).coefficient_per_m * 532 / paper(532).wavelength_nm, 1.6815e-4, 5e-9);
  EXPECT_NEAR(paper(355).coefficient_per_m * 355 / paper(355).wavelength_nm, 1.2733e-3, 5e-8);
  EXPECT_NEAR(paper(488).coefficient_per_m, 2.6000e-4 * 585.08 / 488, 1e-8);  // photons
}

TEST(Raman, OfThePaperHasItsWavelengths) {
  const double expected[][2] = {
      {488, 585.08}, {532, 649.48}, {355, 403.73}, {480, 573.61}, {337, 380.61}};
  for (const auto& [laser, line] : expected) EXPECT_NEAR(paper(laser).wavelength_nm, line, 5e-3);
}

TEST(Raman, OfBartlettFallsAsItsPowerFrom488Nm) {
  EXPECT_NEAR(bartlett(488).coefficient_per_m, 2.7e-4, 1e-18);
  EXPECT_NEAR(bartlett(532).coefficient_per_m, 2.7e-4 * std::pow(488.0 / 532, 5.3), 1e-18);
  expect_contains(raman(library(), "bartlett", 532).source, "from memory; 20 %]");
  // Published in-situ coefficients agree to 20 %.
  EXPECT_NEAR(bartlett(488).coefficient_per_m / paper(488).coefficient_per_m, 1, 0.2);
}

TEST(Raman, OfBartlettIsAtTheMeanOfWalrafensBand) {
  EXPECT_NEAR(library().raman_band.mean_per_cm(), 3384, 0.5);
  EXPECT_NEAR(1e7 / 532 - 1e7 / bartlett(532).wavelength_nm, 3383.75, 1e-6);
}

// Walrafen's band from the table's four Gaussians.
TEST(Raman, HasAPeakAndAWidthOfItsBand) {
  const GaussianBand& band = library().raman_band;
  const auto f = [&](double per_cm) {
    double sum = 0;
    for (std::size_t j = 0; j < band.weight.size(); ++j)
      sum += band.weight[j] / band.fwhm_per_cm[j] *
             std::exp(-4 * std::log(2.0) *
                      std::pow((per_cm - band.centre_per_cm[j]) / band.fwhm_per_cm[j], 2));
    return sum;
  };
  double peak = 3000;
  for (double k = 3000; k < 4000; k += 0.5)
    if (f(k) > f(peak)) peak = k;
  EXPECT_NEAR(peak, 3417, 1);
  double low = peak, high = peak;
  while (f(low) > f(peak) / 2) low -= 0.5;
  while (f(high) > f(peak) / 2) high += 0.5;
  EXPECT_NEAR(high - low, 402, 1.5);
  const double width_nm = 1e7 / (1e7 / 488 - high) - 1e7 / (1e7 / 488 - low);
  EXPECT_NEAR(width_nm, 14, 0.5);
}

// Light of 2955.3 nm has the 3383.75 1/cm of Walrafen's band, of 2941.2 nm the 3400 of the paper's.
TEST(Raman, NeedsMoreEnergyThanItsShift) {
  EXPECT_EQ(raman(library(), "bartlett", 2955).lines.size(), 1U);
  EXPECT_TRUE(raman(library(), "bartlett", 2956).lines.empty());
  EXPECT_EQ(raman(library(), "marshall-smith", 2941).lines.size(), 1U);
  EXPECT_TRUE(raman(library(), "marshall-smith", 2942).lines.empty());
}

TEST(Raman, RefusesAnUnknownModel) {
  expect_contains(message<InputError>([] { raman(library(), "walrafen", 532); }),
                  "no Raman model \"walrafen\" (there are: bartlett, marshall-smith)");
}

Emission chlorophyll(double nm) { return chlorophyll_fluorescence(library(), nm, 0.02, 0.01); }

TEST(Chlorophyll, GivesItsYieldAt685Nm) {
  const EmissionLine line = only_line(chlorophyll(532));
  EXPECT_EQ(line.wavelength_nm, 685);
  EXPECT_NEAR(line.coefficient_per_m, 2e-4, 1e-18);
  expect_contains(chlorophyll(532).source, "[from memory]");
}

TEST(Chlorophyll, IsExcitedFrom300To690Nm) {
  EXPECT_TRUE(chlorophyll(299.9).lines.empty());
  EXPECT_EQ(chlorophyll(300).lines.size(), 1U);
  EXPECT_EQ(chlorophyll(690).lines.size(), 1U);
  EXPECT_TRUE(chlorophyll(690.1).lines.empty());
}

// Half the Gaussian lies above its centre, 15.9 % above one sigma. Seen red: with the sign in erfc
// turned.
TEST(Chlorophyll, LosesWhatWouldBeShorterThanTheLaser) {
  EXPECT_NEAR(only_line(chlorophyll(685)).coefficient_per_m, 1e-4, 1e-18);
  EXPECT_NEAR(only_line(chlorophyll(674.4)).coefficient_per_m, 2e-4 * 0.8413447, 1e-10);
  EXPECT_LT(only_line(chlorophyll(690)).coefficient_per_m, 0.7e-4);
}

TEST(Chlorophyll, EmitsNothingWithoutAbsorptionOrYield) {
  EXPECT_TRUE(chlorophyll_fluorescence(library(), 532, 0, 0.01).lines.empty());
  EXPECT_TRUE(chlorophyll_fluorescence(library(), 532, 0.02, 0).lines.empty());
}

}  // namespace
}  // namespace photic::optics
