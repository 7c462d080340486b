#include "optics/air_molecules.hpp"

#include "core/constants.hpp"
#include "unit/optics/air_support.hpp"

namespace photic::optics {
namespace {

/// Molecules above 1 m^2 at the sea level, as Bodhaine et al. 1999 have them for their eq. (30): p
/// N_A / (m_a g) with 1013.25 hPa, the mean mass of dry air with 360 ppm CO2, and gravity at 45
/// degrees at 5517.56 m, where half of the mass is.
double standard_column_per_m2() {
  constexpr double kg_per_mol = 28.9649e-3, gravity_m_s2 = 9.78916;
  return 101325 * avogadro_per_mol / (kg_per_mol * gravity_m_s2);
}

// Expected values: Bodhaine et al. 1999, to four decimals. Seen red: with 0.027059889 for
// 0.0027059889; with 1e-27 for 1e-28.
TEST(AirScattering, HasTheOpticalDepthsOfBodhaine) {
  const double n = standard_column_per_m2();
  EXPECT_NEAR(n * air_scattering_m2(355), 0.5937, 5e-5);
  EXPECT_NEAR(n * air_scattering_m2(400), 0.3602, 5e-5);
  EXPECT_NEAR(n * air_scattering_m2(532), 0.1112, 5e-5);
  EXPECT_NEAR(n * air_scattering_m2(550), 0.0971, 5e-5);
}

// The fit against the theory it was fitted to, made of the index and the King factor, which are
// (6 + 3 rho) / (6 - 7 rho). Seen red: without argon in the divisor of the King
// factor; with the two resonances of the index changed over.
TEST(AirScattering, IsThatOfItsIndexAndDepolarisation) {
  const double per_m3 = 101325 / (boltzmann_j_k * 288.15);
  for (double nm = 200; nm <= 1100; nm += 10) {
    const double n2 = std::pow(standard_air_index(nm), 2), rho = air_depolarisation(nm);
    const double polarisable = (n2 - 1) / ((n2 + 2) * per_m3);
    const double theory = 24 * std::pow(pi, 3) * std::pow(nm * 1e-9, -4) * polarisable *
                          polarisable * (6 + 3 * rho) / (6 - 7 * rho);
    const bool fitted = nm >= 230 && nm <= 850;
    EXPECT_NEAR(air_scattering_m2(nm) / theory, 1, fitted ? 2.5e-4 : 2e-3) << nm;
  }
}

TEST(AirScattering, NamesItsRange) {
  EXPECT_EQ(message<InputError>([] { air_scattering_m2(1101); }),
            "no air scattering data at 1101 nm: Bodhaine et al. 1999, J. Atmos. Ocean. Technol. "
            "16, 1854, eq. (29) [verified] cover 200-1100 nm (choose another wavelength)");
  EXPECT_THROW(air_scattering_m2(199), InputError);
  EXPECT_THROW(air_scattering_m2(std::nan("")), InputError);
}

// Seen red: with 1.034 of nitrogen for oxygen.
TEST(AirDepolarisation, IsThatOfNaturalLight) {
  EXPECT_NEAR(air_depolarisation(532), 0.0284, 5e-5);
  for (double nm = 390; nm <= 600; nm += 30) {
    EXPECT_GT(air_depolarisation(nm), 0.028) << nm;
    EXPECT_LT(air_depolarisation(nm), 0.030) << nm;
  }
  EXPECT_NEAR(integral(rayleigh(air_depolarisation(532)).p, 1e-7, 2), 1, 1e-6);
}

// Expected values: the dispersion that Bodhaine et al. 1999 take, eqs. (4) and (19), from Peck &
// Reeder 1972, J. Opt. Soc. Am. 62, 958, here with Ciddor's 450 ppm of carbon dioxide. Seen red:
// with the two resonances changed over.
TEST(AirIndex, GoesWithDensity) {
  for (double nm = 230; nm <= 1100; nm += 10) {
    const double k2 = 1e6 / (nm * nm);
    const double peck_reeder = (5791817 / (238.0185 - k2) + 167909 / (57.362 - k2)) * 1e-8 *
                               (1 + 0.54 * (450e-6 - 300e-6));
    EXPECT_NEAR((standard_air_index(nm) - 1) / peck_reeder, 1, 5e-5) << nm;
  }
  const double standard_per_m3 = 101325 / (boltzmann_j_k * 288.15);
  EXPECT_NEAR(air_index(532, standard_per_m3), standard_air_index(532), 1e-15);
  EXPECT_NEAR(air_index(532, standard_per_m3 / 4) - 1, (standard_air_index(532) - 1) / 4, 1e-15);
}

double ozone(double nm, double temperature_k) {
  return ozone_absorption_m2(air_library(), nm, temperature_k).value;
}

// Expected values: Hearn 1961, Proc. Phys. Soc. 78, 932, at the line of mercury; the peak of the
// Chappuis band in Serdyuchenko et al. 2014. Seen red: with cm2 taken for m2.
TEST(OzoneAbsorption, HasKnownValues) {
  EXPECT_NEAR(ozone(253.65, 295), 1.147e-21, 0.02e-21);
  EXPECT_NEAR(ozone(603, 220), 5.1e-25, 0.05e-25);
  expect_contains(ozone_absorption_m2(air_library(), 350, 293).source, "Molina & Molina 1986");
  expect_contains(ozone_absorption_m2(air_library(), 350.1, 293).source,
                  "Serdyuchenko et al. 2014");
}

// Two measurements. Seen red: with the temperature's sign turned; with 263 K.
TEST(OzoneAbsorption, OfBothTablesAgrees) {
  const DataTable table = DataTable::read(data_folder + "/ozone_serdyuchenko_2014.csv");
  const auto nm = table.numbers("wavelength_nm"), cm2 = table.numbers("cross_section_cm2");
  for (std::size_t i = 0; i < nm.size() && nm[i] < 310; ++i)
    EXPECT_NEAR(1e-4 * cm2[i] / ozone(nm[i], 293), 1, 0.035) << nm[i];
}

// Molina & Molina's coefficients at 320 nm by hand. Seen red: with 273.13 K left out;
// without the ends of the measurements.
TEST(OzoneAbsorption, GoesWithTemperatureWhereItWasMeasured) {
  const DataTable table = DataTable::read(data_folder + "/ozone_molina_1986.csv");
  const auto nm = table.numbers("wavelength_nm");
  const auto row = std::find(nm.begin(), nm.end(), 320.0) - nm.begin();
  const double c0 = table.numbers("c0")[row], c1 = table.numbers("c1")[row],
               c2 = table.numbers("c2")[row];
  const double t = 240 - 273.13;
  EXPECT_NEAR(ozone(320, 240), 1e-24 * (c0 + c1 * t + c2 * t * t), 1e-36);
  EXPECT_LT(ozone(320, 240), 0.95 * ozone(320, 298));
  EXPECT_EQ(ozone(320, 180), ozone(320, 226));
  EXPECT_EQ(ozone(320, 320), ozone(320, 298));
  EXPECT_EQ(ozone(500, 220), ozone(500, 298));
}

TEST(OzoneAbsorption, NamesItsRange) {
  expect_contains(message<InputError>([] { ozone(199, 293); }),
                  "no ozone absorption data at 199 nm: Molina & Molina 1986");
  expect_contains(
      message<InputError>([] { ozone(1100, 293); }),
      "no ozone absorption data at 1100 nm: Serdyuchenko et al. 2014, Atmos. Meas. Tech. "
      "7, 625 [verified] cover 230.04-1099.3 nm (choose another wavelength)");
}

}  // namespace
}  // namespace photic::optics
