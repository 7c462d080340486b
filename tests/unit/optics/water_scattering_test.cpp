#include "optics/water_scattering.hpp"

#include "optics/refractive_index.hpp"
#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

double zhang(double nm, double s, double t) {
  return water_scattering_per_m(library(), "zhang", nm, s, t).value;
}

// Expected values: an independent evaluation of the equations, printed to six digits; it took older
// values of Boltzmann's and Avogadro's constants, which is 2e-6 of the scattering.
TEST(WaterScattering, OfZhangHasKnownValues) {
  EXPECT_NEAR(zhang(355, 35, 20), 1.10882e-2, 5e-8);
  EXPECT_NEAR(zhang(500, 35, 20), 2.54734e-3, 1e-8);
  EXPECT_NEAR(zhang(532, 35, 20), 1.96231e-3, 5e-9);
  EXPECT_NEAR(zhang(500, 0, 20), 1.95751e-3, 5e-9);
  EXPECT_NEAR(zhang(500, 35, 5), 2.64748e-3, 5e-9);
}

// Seen red: with the salt's term left out; with 0.09 for the depolarisation; with T^4 of the
// density at -1.12e-5.
TEST(WaterScattering, OfZhangAgreesWithTheReferenceTable) {
  const DataTable table =
      DataTable::read(data_folder + "/reference/seawater_scattering_zhang2009.csv");
  const auto nm = table.numbers("wavelength_nm");
  const auto fresh = table.numbers("b_fresh_per_m"), sea = table.numbers("b_sea_per_m");
  const auto n_fresh = table.numbers("n_fresh"), n_sea = table.numbers("n_sea");
  ASSERT_EQ(nm.size(), 81U);
  for (std::size_t i = 0; i < nm.size(); ++i) {
    EXPECT_NEAR(zhang(nm[i], 0, 20) / fresh[i], 1, 5e-6) << nm[i];
    EXPECT_NEAR(zhang(nm[i], 35, 20) / sea[i], 1, 5e-6) << nm[i];
    // The table's indices are against vacuum: over air's, 1.00027 to 1.00033.
    EXPECT_NEAR(n_fresh[i] / refractive_index(nm[i], 0, 20), 1.0003, 4e-5) << nm[i];
    EXPECT_NEAR(n_sea[i] / refractive_index(nm[i], 35, 20), 1.0003, 4e-5) << nm[i];
  }
}

// Smith & Baker 1981, Table 1, have what Morel gives, to the digits they print, of sea water (37
// PSU) and of fresh water. Their 0.119 of the sea at 210 nm breaks the line of their own numbers on
// either side by 3 %. Above 550 nm they print too few digits, and some of them higher. Seen red:
// with the exponent 4.30; with 1.30 for 35 PSU; with 0.00218 at 500 nm.
TEST(WaterScattering, OfMorelIsWhatSmithAndBakerPrint) {
  const DataTable table = DataTable::read(data_folder + "/water_smith_baker_1981.csv");
  const auto nm = table.numbers("wavelength_nm");
  const auto sea = table.numbers("b_sea_per_m"), fresh = table.numbers("b_fresh_per_m");
  const auto morel = [](double at, double s) {
    return water_scattering_per_m(library(), "morel", at, s, 12).value;
  };
  for (std::size_t i = 0; i < nm.size() && nm[i] <= 550; ++i) {
    const double printed = nm[i] < 250 ? 0.01 * sea[i] : std::max(0.008 * sea[i], 1.2e-4);
    if (nm[i] != 210) {
      EXPECT_NEAR(morel(nm[i], 37), sea[i], printed) << nm[i];
    }
    EXPECT_NEAR(morel(nm[i], 0), fresh[i], std::max(0.008 * fresh[i], 1e-4)) << nm[i];
  }
  EXPECT_NEAR(morel(500, 37), 0.00288, 1e-5);
  EXPECT_EQ(morel(500, 0), 0.00222);
}

TEST(WaterScattering, OfSmithAndBakerIsThatOfSeaWater) {
  const Sourced b = water_scattering_per_m(library(), "smith-baker", 530, 0, 3);
  EXPECT_EQ(b.value, 0.0022);
  expect_contains(b.source, "Smith & Baker 1981");
}

TEST(WaterScattering, NamesItsRangeAndModels) {
  EXPECT_THROW(zhang(1101, 35, 20), InputError);
  expect_contains(
      message<InputError>([] { water_scattering_per_m(library(), "morel", 801, 35, 20); }),
      "no water scattering data at 801 nm: Morel 1974"
      ", in Optical Aspects of Oceanography, Academic Press [verified] cover 200-800 nm");
  expect_contains(
      message<InputError>([] { water_scattering_per_m(library(), "smith-baker", 850, 35, 20); }),
      "no water scattering data at 850 nm: Smith & Baker 1981");
  expect_contains(
      message<InputError>([] { water_scattering_per_m(library(), "mie", 532, 35, 20); }),
      "no water scattering model \"mie\" (there are: zhang, morel, smith-baker)");
}

}  // namespace
}  // namespace photic::optics
