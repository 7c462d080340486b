// Densities of slopes against values that were computed elsewhere, and whitecaps.
#include "optics/sea_slopes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/constants.hpp"
#include "optics/whitecaps.hpp"
#include "support/tables.hpp"

namespace photic::optics {
namespace {

const double ten_degrees = std::tan(10 * radian_per_degree);
const double twenty_degrees = std::tan(20 * radian_per_degree);

TEST(CoxMunkSlopes, HaveTheVariancesOfTheCleanSeaAndOfSlicks) {
  const auto clean = cox_munk_slopes(5, false, false);
  EXPECT_NEAR(clean.upwind_variance, 0.0158, 1e-15);
  EXPECT_NEAR(clean.crosswind_variance, 0.0126, 1e-15);
  const auto slick = cox_munk_slopes(5, true, false);
  EXPECT_NEAR(slick.upwind_variance, 0.0089, 1e-15);
  EXPECT_NEAR(slick.crosswind_variance, 0.0072, 1e-15);
  EXPECT_NE(slick.source.find("from memory"), std::string::npos);
}

TEST(PaperSlopes, AreAlongTheWindAloneAsPrinted) {
  const auto law = paper_slopes(5);
  EXPECT_NEAR(law.upwind_variance, 0.086, 1e-15);
  EXPECT_EQ(law.crosswind_variance, 0);
  EXPECT_TRUE(law.is_one_dimensional());
}

// The density per slope, along the wind and across it. With another sign of a skewness the two
// sides of the wind change places; seen red with that, and with each coefficient changed by 1 %.
TEST(CoxMunkSlopes, HaveTheDensityOfTheSeries) {
  const auto gauss = cox_munk_slopes(5, false, false), series = cox_munk_slopes(5, false, true);
  EXPECT_NEAR(gauss.density(0, 0), 11.2799, 1e-4);
  EXPECT_NEAR(series.density(0, 0), 12.5066, 1e-4);
  EXPECT_NEAR(series.density(ten_degrees, 0), 3.88119, 2e-5);
  EXPECT_NEAR(series.density(-ten_degrees, 0), 4.33082, 2e-5);
  EXPECT_NEAR(gauss.density(ten_degrees, 0), 4.21701, 2e-5);
  EXPECT_NEAR(series.density(0, ten_degrees), 2.92149, 2e-5);
  EXPECT_NEAR(series.density(twenty_degrees, 0), 0.226016, 2e-6);
  EXPECT_NEAR(series.density(-twenty_degrees, 0), 0.131563, 2e-6);
  EXPECT_NEAR(gauss.density(twenty_degrees, 0), 0.170469, 2e-6);
  const auto strong = cox_munk_slopes(10, false, true);
  EXPECT_NEAR(strong.density(0, 0) * strong.norm, 6.66245, 1e-5);
  EXPECT_NEAR(strong.density(ten_degrees, 0) * strong.norm, 3.29781, 2e-5);
  EXPECT_NEAR(strong.density(-ten_degrees, 0) * strong.norm, 4.28503, 2e-5);
}

// At nadir the series is 1.10875 at any wind. Its integral is 1, but for where it would be
// negative: nowhere within 8 standard deviations at 5 m/s.
TEST(CoxMunkSlopes, SeriesIsNowhereNegativeAndHasANorm) {
  for (const double wind : {1.0, 5.0, 10.0, 15.0}) {
    const auto law = cox_munk_slopes(wind, false, true);
    EXPECT_NEAR(law.series(0.0, 0.0), 1.10875, 1e-12) << wind;
    for (double up = -8; up <= 8; up += 0.25)
      for (double across = -8; across <= 8; across += 0.25) {
        const double density = law.density(up * std::sqrt(law.upwind_variance),
                                           across * std::sqrt(law.crosswind_variance));
        ASSERT_GE(density, 0) << wind;
        // From 1 to 5 m/s the series itself is above 0.
        ASSERT_TRUE(wind > 5 || law.series(across, up) > 0) << wind;
      }
  }
  EXPECT_NEAR(cox_munk_slopes(5, false, true).norm, 1, 1e-9);
  EXPECT_NEAR(cox_munk_slopes(10, false, true).norm, 1 + 8.4e-6, 1e-6);
  EXPECT_NEAR(cox_munk_slopes(15, false, true).norm, 1 + 6.1e-4, 1e-5);
}

TEST(Whitecaps, CoverTheSeaByTheWind) {
  EXPECT_NEAR(whitecap_fraction_monahan(5).value, 8.515e-4, 1e-7);
  EXPECT_NEAR(whitecap_fraction_monahan(10).value, 9.768e-3, 1e-6);
  EXPECT_NEAR(whitecap_fraction_monahan(15).value, 0.0407, 1e-4);
  EXPECT_EQ(whitecap_fraction_stramska(5).value, 0);
  EXPECT_NEAR(whitecap_fraction_stramska(10).value, 4.325e-3, 1e-6);
  EXPECT_NEAR(whitecap_fraction_stramska(15).value, 0.0570, 1e-4);
}

TEST(Whitecaps, ReflectByTheWavelength) {
  const Library& library = *test::tables();
  EXPECT_NEAR(whitecap_reflectance_koepke(library, 532).value, 0.22, 1e-12);
  EXPECT_NEAR(whitecap_reflectance_koepke(library, 850).value, 0.2125, 1e-12);
  EXPECT_NEAR(whitecap_reflectance_frouin(library, 532).value, 0.22, 1e-12);
  EXPECT_NEAR(whitecap_reflectance_frouin(library, 670).value, 0.22 * 0.889225, 1e-12);
  EXPECT_NE(whitecap_reflectance_koepke(library, 532).source.find("Koepke 1984"),
            std::string::npos);
}

}  // namespace
}  // namespace photic::optics
