#include "optics/emission.hpp"

#include "optics/fluorescence.hpp"
#include "optics/raman.hpp"
#include "optics/water_absorption.hpp"
#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

EmissionLine only_line(const Emission& emission) { return emission.line.value(); }

EmissionLine paper(double nm) { return only_line(raman(library(), "marshall-smith", nm)); }
EmissionLine bartlett(double nm) { return only_line(raman(library(), "bartlett", nm)); }

// Printed values of the formula, on the energy basis. Seen red: with wavenumbers in 1/m; with the
// resonance frequency against the Raman instead of the laser's wavenumber; with the photon factor
// upside down.
TEST(Raman, OfThePaperHasItsCoefficients) {
  EXPECT_NEAR(paper(488).coefficient * 488 / paper(488).wavelength_nm, 2.6000e-4, 5e-9);
  EXPECT_NEAR(paper(532).coefficient * 532 / paper(532).wavelength_nm, 1.6815e-4, 5e-9);
  EXPECT_NEAR(paper(355).coefficient * 355 / paper(355).wavelength_nm, 1.2733e-3, 5e-8);
  EXPECT_NEAR(paper(488).coefficient, 2.6000e-4 * 585.08 / 488, 1e-8);  // photons
}

TEST(Raman, OfThePaperHasItsWavelengths) {
  const double expected[][2] = {
      {488, 585.08}, {532, 649.48}, {355, 403.73}, {480, 573.61}, {337, 380.61}};
  for (const auto& [laser, line] : expected) EXPECT_NEAR(paper(laser).wavelength_nm, line, 5e-3);
}

TEST(Raman, OfBartlettFallsAsItsPowerFrom488Nm) {
  EXPECT_NEAR(bartlett(488).coefficient, 2.7e-4, 1e-18);
  EXPECT_NEAR(bartlett(532).coefficient, 2.7e-4 * std::pow(488.0 / 532, 5.3), 1e-18);
  expect_contains(raman(library(), "bartlett", 532).source, "from memory; 20 %]");
  // Published in-situ coefficients agree to 20 %.
  EXPECT_NEAR(bartlett(488).coefficient / paper(488).coefficient, 1, 0.2);
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

// Of what returns from 20 m: water's absorption is steep there. Against the paper's line. Seen red:
// with the line at the band's mean.
TEST(Raman, OfABandReturnsMoreThanOfALine) {
  const auto returned = [](double nm) {
    return std::exp(-20 * water_absorption_per_m(library(), "mason-ioccg", nm, 35, 20).value);
  };
  const auto band_over_line = [&](double laser_nm) {
    const EmissionSpectrum band = raman(library(), "bartlett", laser_nm).spectrum;
    return band.photons(band.min_nm(), band.max_nm(), returned) /
           band.photons(band.min_nm(), band.max_nm()) / returned(paper(laser_nm).wavelength_nm);
  };
  EXPECT_NEAR(band_over_line(488), 1.09, 0.005);
  EXPECT_NEAR(band_over_line(532), 1.02, 0.005);
}

// Light of 2955.3 nm has the 3383.75 1/cm of Walrafen's band, of 2941.2 nm the 3400 of the paper's.
TEST(Raman, NeedsMoreEnergyThanItsShift) {
  EXPECT_TRUE(raman(library(), "bartlett", 2955).line);
  EXPECT_FALSE(raman(library(), "bartlett", 2956).line);
  EXPECT_TRUE(raman(library(), "marshall-smith", 2941).line);
  EXPECT_FALSE(raman(library(), "marshall-smith", 2942).line);
}

TEST(Raman, RefusesAnUnknownModel) {
  expect_contains(message<InputError>([] { raman(library(), "walrafen", 532); }),
                  "no Raman model \"walrafen\" (there are: bartlett, marshall-smith)");
}

/// Of a spectrum, by its own integrals.
double mean_nm(const EmissionSpectrum& s) {
  return s.photons(0, 1e4, [](double nm) { return nm; }) / s.photons(0, 1e4);
}
/// Where a spectrum has its largest density.
double peak_nm(const EmissionSpectrum& s) {
  double best = 0, at = 0;
  for (double nm = s.min_nm(); nm < s.max_nm(); nm += 0.1) {
    const double here = s.photons(nm, nm + 0.1);
    if (here > best) best = here, at = nm + 0.05;
  }
  return at;
}

// Walrafen's band: mean 3384, peak 3417, full width at half maximum 402 1/cm, 14 nm at 585 nm. Seen
// red: per wavenumber where it is per wavelength; without the 4 ln 2.
TEST(Raman, HasWalrafensBandAsItsSpectrum) {
  const auto band = [](double k) { return library().raman_band.density_cm(k); };
  double sum = 0, mean = 0, peak = 0;
  for (double k = 2700; k < 4100; k += 0.5) {
    sum += 0.5 * band(k), mean += 0.5 * k * band(k);
    if (band(k) > band(peak)) peak = k;
  }
  EXPECT_NEAR(sum, 1, 1e-6);
  EXPECT_NEAR(mean, 3383.75, 0.05);
  EXPECT_NEAR(peak, 3417, 1);
  double low = 3000, high = 3800;
  while (band(low) < band(peak) / 2) low += 0.5;
  while (band(high) < band(peak) / 2) high -= 0.5;
  EXPECT_NEAR(high - low, 402, 1);

  for (const char* model : {"bartlett", "marshall-smith"}) {
    const auto emission = raman(library(), model, 488);
    EXPECT_NEAR(emission.spectrum.photons(0, 1e4) / emission.line->coefficient, 1, 2e-5) << model;
    EXPECT_NEAR(peak_nm(emission.spectrum), 1e7 / (1e7 / 488 - 3417), 0.2) << model;
    EXPECT_NEAR(mean_nm(emission.spectrum), 1e7 / (1e7 / 488 - 3383.75), 0.1) << model;
  }
}

Emission chlorophyll(double nm, double share_730 = 0) {
  return chlorophyll_fluorescence(library(), nm, share_730);
}

TEST(Chlorophyll, EmitsAt685Nm) {
  const EmissionLine line = only_line(chlorophyll(532));
  EXPECT_EQ(line.wavelength_nm, 685);
  EXPECT_NEAR(line.coefficient, 1, 1e-15);
  expect_contains(chlorophyll(532).source, "[from memory]");
}

TEST(Chlorophyll, IsExcitedFrom300To690Nm) {
  EXPECT_FALSE(chlorophyll(299.9).line);
  EXPECT_TRUE(chlorophyll(299.9).spectrum.empty());
  EXPECT_TRUE(chlorophyll(300).line);
  EXPECT_TRUE(chlorophyll(690).line);
  EXPECT_FALSE(chlorophyll(690.1).line);
}

// Half the Gaussian lies above its centre, 15.9 % above one sigma. Seen red: with the sign in erfc
// turned; with the spectrum from its start.
TEST(Chlorophyll, LosesWhatWouldBeShorterThanTheLaser) {
  const double above[][2] = {{532, 1}, {674.4, 0.8413447}, {685, 0.5}, {690, 0.318571}};
  for (const auto& [laser, share] : above) {
    EXPECT_NEAR(only_line(chlorophyll(laser)).coefficient, share, 3e-5) << laser;
    EXPECT_NEAR(chlorophyll(laser).spectrum.photons(0, 1e4), share, 3e-4) << laser;
  }
}

// Seen red: with the second band's photons on top of the first's.
TEST(Chlorophyll, MayHaveASecondBandAt730Nm) {
  const auto both = chlorophyll(532, 0.25);
  EXPECT_NEAR(both.spectrum.photons(0, 1e4), 1, 1e-4);
  EXPECT_NEAR(mean_nm(both.spectrum), 0.75 * 685 + 0.25 * 730, 0.05);
  EXPECT_NEAR(peak_nm(chlorophyll(532).spectrum), 685, 0.2);
  expect_contains(both.source, "730 nm");
}

// The yields that Hawes's function comes to, 0.9 % excited at 310 nm and 1.9 % at 450, and its
// peaks. Seen red: without the 0.6.
TEST(Cdom, FluorescesAsHawesSays) {
  const auto yield = [](double nm) {
    return cdom_fluorescence(library(), nm).spectrum.photons(0, 1e4);
  };
  EXPECT_NEAR(yield(310), 0.009, 5e-4);
  EXPECT_NEAR(yield(450), 0.019, 5e-4);
  EXPECT_NEAR(peak_nm(cdom_fluorescence(library(), 350).spectrum), 465, 0.5);
  EXPECT_NEAR(peak_nm(cdom_fluorescence(library(), 430).spectrum), 526, 0.5);
  EXPECT_NEAR(yield(355), 0.01363 + 0.25 * (0.01631 - 0.01363), 4e-5);  // between its rows
  expect_contains(cdom_fluorescence(library(), 355).source, "[verified]");
}

TEST(Cdom, IsExcitedFromTheUltravioletTo550Nm) {
  EXPECT_FALSE(cdom_fluorescence(library(), 532).spectrum.empty());
  EXPECT_TRUE(cdom_fluorescence(library(), 550).spectrum.empty());
  EXPECT_TRUE(cdom_fluorescence(library(), 600).spectrum.empty());
  // A0 is that of 310 nm below.
  EXPECT_EQ(cdom_fluorescence(library(), 450).spectrum.min_nm(), 450);
  EXPECT_GT(cdom_fluorescence(library(), 266).spectrum.photons(0, 1e4), 0.008);
}

DataTable matrix(const std::string& rows) {
  return DataTable::parse("excitation_nm,emission_nm,yield_per_nm\n" + rows, "eem.csv");
}

// Seen red: at the lower excitation; from the table's first emission on.
TEST(Cdom, MayFluoresceByAUsersTable) {
  const auto table =
      matrix("300,400,0\n300,500,2e-4\n300,600,0\n400,400,0\n400,500,4e-4\n400,600,0\n");
  const auto at = [&](double nm) { return cdom_fluorescence(table, nm).spectrum; };
  EXPECT_NEAR(at(300).photons(0, 1e4), 0.02, 1e-12);
  EXPECT_NEAR(at(325).photons(0, 1e4), 0.025, 1e-12);
  EXPECT_NEAR(at(400).photons(0, 1e4), 0.04, 1e-12);
  const auto wide = matrix("300,400,1e-4\n300,600,1e-4\n500,400,1e-4\n500,600,1e-4\n");
  EXPECT_NEAR(cdom_fluorescence(wide, 450).spectrum.photons(0, 1e4), 0.015, 1e-12);
}

TEST(Cdom, RefusesATableThatIsNone) {
  const auto refused = [](const std::string& rows, double nm = 355) {
    return message<InputError>([&] { cdom_fluorescence(matrix(rows), nm); });
  };
  const std::string good = "300,400,0\n300,500,2e-4\n400,400,0\n400,500,4e-4\n";
  expect_contains(refused(good, 290), "no CDOM fluorescence data at 290 nm: eem.csv cover 300-400");
  expect_contains(refused(good, 401), "cover 300-400 nm");
  expect_contains(refused("300,400,0\n300,500,-1\n"), "eem.csv:3:9: a yield is not negative");
  expect_contains(refused("300,400,0\n300,390,1\n"),
                  "eem.csv:3:5: the emissions of an excitation ascend");
  expect_contains(refused("300,400,0\n300,500,1\n290,400,1\n"), "eem.csv:4:1: excitations ascend");
  expect_contains(refused("300,400,0\n300,500,1\n400,400,1\n400,501,1\n"),
                  "eem.csv:5:5: every excitation has the same emissions");
  expect_contains(refused("300,400,0\n300,500,1\n400,400,1\n"),
                  "excitation 400 nm has 1 emissions");
}

}  // namespace
}  // namespace photic::optics
