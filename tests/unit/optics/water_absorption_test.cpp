#include "optics/water_absorption.hpp"

#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

double modern_absorption(double nm, double s = 0, double t = 20) {
  return water_absorption_per_m(library(), "mason-ioccg", nm, s, t).value;
}

TEST(WaterAbsorption, IsTheTablesForPureWaterAt20C) {
  EXPECT_EQ(modern_absorption(532), 0.04538);
  EXPECT_NEAR(modern_absorption(355), 0.000975,
              1e-12);  // between 0.00097 at 354 and 0.00098 at 356 nm
  EXPECT_EQ(modern_absorption(1000), 37.699);
}

// Seen red: with the sign of psi_t turned; with the 20 C it is relative to left out.
TEST(WaterAbsorption, ChangesWithSalinityAndTemperature) {
  EXPECT_NEAR(modern_absorption(532, 35, 20), 0.04538 + 35 * 1.63e-5, 1e-12);
  EXPECT_NEAR(modern_absorption(532, 0, 5), 0.04538 - 15 * 6e-6, 1e-12);
  EXPECT_EQ(modern_absorption(320, 35, 5), 0.00147);  // the table has no change there
}

TEST(WaterAbsorption, IsPositiveInAllNaturalWater) {
  for (double nm = 200; nm <= 1000; nm += 1) {
    for (const double s : {0.0, 42.0}) {
      for (const double t : {-2.0, 40.0})
        ASSERT_GT(modern_absorption(nm, s, t), 0) << nm << " " << s << " " << t;
    }
  }
}

TEST(WaterAbsorption, IsCutAtZeroAndSaysSo) {
  const Sourced a = water_absorption_per_m(library(), "mason-ioccg", 470, 0, 2000);
  EXPECT_EQ(a.value, 0.0);
  expect_contains(a.source, "set to 0");
}

// Seen red: with 300 nm itself taken from the ultraviolet set.
TEST(WaterAbsorption, StepsFromOneSetToTheOtherAt300Nm) {
  EXPECT_EQ(modern_absorption(300), 0.00467);
  EXPECT_NEAR(modern_absorption(299.999999), 0.0147, 1e-7);
  EXPECT_EQ(modern_absorption(250), 0.045);
  expect_contains(water_absorption_per_m(library(), "mason-ioccg", 300, 35, 20).source,
                  "Mason, Cone & Fry 2016");
  expect_contains(water_absorption_per_m(library(), "mason-ioccg", 299, 35, 20).source, "IOCCG");
}

TEST(WaterAbsorption, OfSmithAndBakerIgnoresSalinityAndTemperature) {
  const Sourced a = water_absorption_per_m(library(), "smith-baker", 532, 35, 3);
  EXPECT_NEAR(a.value, 0.8 * 0.0507 + 0.2 * 0.0558, 1e-12);
  EXPECT_EQ(a.source, "Smith & Baker 1981, Appl. Opt. 20, 177, Table 1 [verified]");
}

TEST(WaterAbsorption, NamesItsRange) {
  EXPECT_EQ(message<InputError>([] { modern_absorption(1203); }),
            "no water absorption data at 1203 nm: Mason 2016 / IOCCG 2018 cover 200-1000 nm "
            "(choose another wavelength, or give the layer's iop at this one)");
  EXPECT_THROW(modern_absorption(199.9), InputError);
  expect_contains(
      message<InputError>([] { water_absorption_per_m(library(), "smith-baker", 801, 0, 20); }),
      "no water absorption data at 801 nm: Smith & Baker 1981");
  EXPECT_EQ(message<InputError>([] { water_absorption_per_m(library(), "morel", 532, 0, 20); }),
            "no water absorption model \"morel\" (there are: mason-ioccg, smith-baker)");
}

}  // namespace
}  // namespace photic::optics
