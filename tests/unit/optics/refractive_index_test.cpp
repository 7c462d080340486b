#include "optics/refractive_index.hpp"

#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

// Expected values: Quan & Fry's formula at 35 PSU and 20 C, printed to four decimals.
TEST(RefractiveIndex, HasQuanAndFrysValues) {
  EXPECT_NEAR(refractive_index(355, 35, 20), 1.3554, 5e-5);
  EXPECT_NEAR(refractive_index(488, 35, 20), 1.3436, 5e-5);
  EXPECT_NEAR(refractive_index(532, 35, 20), 1.3415, 5e-5);
  EXPECT_NEAR(refractive_index(685, 35, 20), 1.3368, 5e-5);
}

// Seen red: with the sign of the dispersion terms turned; with the index itself returned.
TEST(RefractiveIndex, HasTheGroupIndexOfItsDispersion) {
  EXPECT_NEAR(group_index(355, 35, 20), 1.4083, 5e-5);
  EXPECT_NEAR(group_index(488, 35, 20), 1.3695, 5e-5);
  EXPECT_NEAR(group_index(532, 35, 20), 1.3638, 5e-5);
  EXPECT_NEAR(group_index(685, 35, 20), 1.3525, 5e-5);
  for (const double nm : {205.0, 355.0, 532.0, 1000.0}) {
    const double slope =
        (refractive_index(nm + 0.01, 10, 5) - refractive_index(nm - 0.01, 10, 5)) / 0.02;
    EXPECT_NEAR(group_index(nm, 10, 5), refractive_index(nm, 10, 5) - nm * slope, 1e-7) << nm;
  }
}

// What depths would be off by, were light timed by the index that bends it.
TEST(RefractiveIndex, IsNoGroupIndex) {
  const auto off = [](double nm) {
    return group_index(nm, 35, 20) / refractive_index(nm, 35, 20) - 1;
  };
  EXPECT_NEAR(off(532), 0.017, 5e-4);
  EXPECT_NEAR(off(355), 0.039, 5e-4);
}

TEST(RefractiveIndex, HasItsDerivativeBySalinity) {
  const double difference = refractive_index(500, 36, 12) - refractive_index(500, 34, 12);
  EXPECT_NEAR(refractive_index_per_psu(500, 12), difference / 2, 1e-12);
}

TEST(RefractiveIndex, RefusesWavelengthsOutOfItsRange) {
  EXPECT_EQ(message<InputError>([] { refractive_index(1203, 35, 20); }),
            "no refractive index data at 1203 nm: Quan & Fry 1995, Appl. Opt. 34, 3477, eq. (3) "
            "[verified] cover "
            "200-1100 nm (choose another wavelength, or give refractive_index and group_index of "
            "the sea)");
  EXPECT_THROW(group_index(199, 35, 20), InputError);
  EXPECT_THROW(group_index(std::nan(""), 35, 20), InputError);
}

}  // namespace
}  // namespace photic::optics
