#include "optics/jerlov.hpp"

#include "optics/water_scattering.hpp"
#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

const std::vector<std::string> from_clear_to_turbid{"IB", "II", "III", "1C", "3C", "5C"};

JerlovWater water_of(const std::string& type, double nm) {
  return jerlov_water(library(), type, nm);
}

// Rows of Williamson & Hollins 2022, Table 7. Seen red: with a and b exchanged.
TEST(Jerlov, IsThePublishedTable) {
  const std::vector<double> a_500{0.0398, 0.0529, 0.0835, 0.104, 0.144, 0.199};
  const std::vector<double> b_500{0.128, 0.185, 0.297, 0.44, 0.664, 1.23};
  const std::vector<double> a_700{0.573, 0.575, 0.581, 0.585, 0.598, 0.614};
  for (std::size_t i = 0; i < a_500.size(); ++i) {
    EXPECT_EQ(water_of(from_clear_to_turbid[i], 500).a_per_m, a_500[i]);
    EXPECT_EQ(water_of(from_clear_to_turbid[i], 500).b_per_m, b_500[i]);
    EXPECT_EQ(water_of(from_clear_to_turbid[i], 700).a_per_m, a_700[i]);
  }
  EXPECT_NEAR(water_of("II", 532).a_per_m, 0.8 * 0.0607 + 0.2 * 0.065, 1e-12);
  expect_contains(water_of("II", 532).source, "Williamson & Hollins 2022");
}

// From type to type there is more of both at every wavelength, and always more than in pure water.
TEST(Jerlov, TypesAreInOrder) {
  for (double nm = 420; nm <= 700; nm += 1) {
    double a = 0, b = water_scattering_per_m(library(), "zhang", nm, 35, 20).value;
    for (const std::string& type : from_clear_to_turbid) {
      const JerlovWater water = water_of(type, nm);
      ASSERT_GT(water.a_per_m, a) << type << " " << nm;
      ASSERT_GT(water.b_per_m, b) << type << " " << nm;
      a = water.a_per_m;
      b = water.b_per_m;
    }
  }
}

TEST(Jerlov, NamesItsRangeAndTypes) {
  expect_contains(message<InputError>([] { water_of("II", 355); }),
                  "no Jerlov water type data at 355 nm: Williamson & Hollins 2022");
  EXPECT_EQ(message<InputError>([] { water_of("9C", 500); }),
            "no Jerlov water type model \"9C\" (there are: IB, II, III, 1C, 3C, 5C)");
}

}  // namespace
}  // namespace photic::optics
