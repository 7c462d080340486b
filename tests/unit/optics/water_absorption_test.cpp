#include "optics/water_absorption.hpp"

#include <fmt/format.h>

#include <tuple>

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
  EXPECT_EQ(modern_absorption(1064), 15.107);
}

// Seen red: with the sign of psi_t turned; with the 20 C it is relative to left out.
TEST(WaterAbsorption, ChangesWithSalinityAndTemperature) {
  EXPECT_NEAR(modern_absorption(532, 35, 20), 0.04538 + 35 * 1.63e-5, 1e-12);
  EXPECT_NEAR(modern_absorption(532, 0, 5), 0.04538 - 15 * 6e-6, 1e-12);
  EXPECT_EQ(modern_absorption(320, 35, 5), 0.00147);  // the table has no change there
}

TEST(WaterAbsorption, IsPositiveInAllNaturalWater) {
  for (double nm = 200; nm <= 1100; nm += 1) {
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

double table_absorption(const char* model, double nm) {
  return water_absorption_per_m(library(), model, nm, 35, 3).value;
}

// Rows of the published tables, which no salinity and no temperature changes. Seen red: with one
// table for the other.
TEST(WaterAbsorption, OfPopeAndFryAndOfTheIoccgIsTheirTables) {
  EXPECT_EQ(table_absorption("pope-fry", 380), 0.01137);
  EXPECT_EQ(table_absorption("pope-fry", 417.5), 0.00442);  // the least of all
  EXPECT_EQ(table_absorption("pope-fry", 532.5), 0.0447);
  EXPECT_EQ(table_absorption("pope-fry", 700), 0.624);
  EXPECT_EQ(table_absorption("pope-fry", 727.5), 1.678);
  EXPECT_EQ(table_absorption("ioccg", 200), 0.727);
  EXPECT_EQ(table_absorption("ioccg", 355), 0.0068);
  EXPECT_EQ(table_absorption("ioccg", 1000), 40.7);
  // Pope & Fry are what the IOCCG recommends where it has nothing newer.
  EXPECT_EQ(table_absorption("ioccg", 550), table_absorption("pope-fry", 550));
  expect_contains(water_absorption_per_m(library(), "pope-fry", 532, 35, 20).source,
                  "Pope & Fry 1997");
  expect_contains(water_absorption_per_m(library(), "ioccg", 532, 35, 20).source, "IOCCG");
}

// The factor of forty between the sets at 355 nm, which decides every profile excited there.
TEST(WaterAbsorption, SpreadsWidelyAt355Nm) {
  EXPECT_NEAR(modern_absorption(355), 0.00097, 6e-6);
  EXPECT_NEAR(table_absorption("ioccg", 355), 0.0068, 1e-12);
  EXPECT_NEAR(table_absorption("smith-baker", 355), 0.042, 6e-4);
}

TEST(WaterAbsorption, OfTablesNamesTheirRanges) {
  for (const auto& [model, low, high] :
       {std::tuple{"pope-fry", 380.0, 727.5}, std::tuple{"ioccg", 200.0, 1000.0},
        std::tuple{"smith-baker", 200.0, 800.0}}) {
    EXPECT_GT(table_absorption(model, low), 0);
    EXPECT_GT(table_absorption(model, high), 0);
    for (const double nm : {low - 0.1, high + 0.1})
      expect_contains(message<InputError>([&] { table_absorption(model, nm); }),
                      fmt::format("cover {:g}-{:g} nm", low, high));
  }
}

TEST(WaterAbsorption, NamesItsRange) {
  EXPECT_EQ(message<InputError>([] { modern_absorption(1203); }),
            "no water absorption data at 1203 nm: Mason 2016 / IOCCG 2018 cover 200-1100 nm "
            "(choose another wavelength, or give the layer's iop at this one)");
  EXPECT_THROW(modern_absorption(199.9), InputError);
  expect_contains(
      message<InputError>([] { water_absorption_per_m(library(), "smith-baker", 801, 0, 20); }),
      "no water absorption data at 801 nm: Smith & Baker 1981");
  EXPECT_EQ(message<InputError>([] { water_absorption_per_m(library(), "morel", 532, 0, 20); }),
            "no water absorption model \"morel\" (there are: mason-ioccg, ioccg, pope-fry, "
            "smith-baker)");
}

}  // namespace
}  // namespace photic::optics
