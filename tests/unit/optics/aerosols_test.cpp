#include "optics/aerosols.hpp"

#include "optics/aerosol_profiles.hpp"
#include "unit/optics/air_support.hpp"

namespace photic::optics {
namespace {

AerosolOptics of(const std::string& model, double nm, double humidity_percent) {
  return aerosol_optics(air_library(), model, nm, humidity_percent);
}

struct Known {
  std::string model;
  double albedo_0, albedo_70, albedo_80, albedo_99, g_0, g_99;
};

// Expected values: Shettle & Fenn 1979, at 550 nm. Seen red: with the albedo as absorption over
// extinction; with the columns of 70 and 80 % changed over.
TEST(Aerosols, HaveTheAlbedosOfTheirTables) {
  const std::vector<Known> known{
      {"rural", 0.9407, 0.9462, 0.95918, 0.98658, 0.6479, 0.7717},
      {"maritime", 0.98203, 0.98703, 0.99354, 0.99861, 0.6756, 0.8196},
      {"urban", 0.63816, 0.70259, 0.78051, 0.94215, 0.6617, 0.7948},
      {"tropospheric", 0.95899, 0.96348, 0.97367, 0.99209, 0.6345, 0.7606}};
  for (const Known& k : known) {
    EXPECT_NEAR(of(k.model, 550, 0).albedo(), k.albedo_0, 1e-5) << k.model;
    EXPECT_NEAR(of(k.model, 550, 70).albedo(), k.albedo_70, 1e-5) << k.model;
    EXPECT_NEAR(of(k.model, 550, 80).albedo(), k.albedo_80, 1e-5) << k.model;
    EXPECT_NEAR(of(k.model, 550, 99).albedo(), k.albedo_99, 1e-5) << k.model;
    EXPECT_NEAR(of(k.model, 550, 0).g, k.g_0, 1e-12) << k.model;
    EXPECT_NEAR(of(k.model, 550, 99).g, k.g_99, 1e-12) << k.model;
    EXPECT_NEAR(of(k.model, 550, 37).extinction, 1, 1e-12) << k.model;
    expect_contains(of(k.model, 550, 0).source, "Shettle & Fenn 1979, AFGL-TR-79-0214");
  }
}

// Between 337.1 and 550 nm of the rural model by hand: extinction 1.605 and 1, absorption 0.08506
// and 0.0593. Seen red: with wavelengths not in logarithms; with coefficients not in logarithms.
TEST(Aerosols, GoAsPowersOfTheWavelength) {
  const double t = std::log(400 / 337.1) / std::log(550 / 337.1);
  const AerosolOptics rural = of("rural", 400, 0);
  EXPECT_NEAR(rural.extinction, std::pow(1.605, 1 - t), 1e-12);
  EXPECT_NEAR(rural.absorption, std::pow(0.08506, 1 - t) * std::pow(0.0593, t), 1e-12);
  EXPECT_EQ(of("rural", 200, 0).extinction, 2.09291);
  EXPECT_EQ(of("rural", 40000, 99).g, of("rural", 40000, 99.9).g);
}

// Between 80 and 99 % of the maritime model at 1060 nm: 0.87538 and 0.94791. Seen red: with linear
// humidities; with humidities up to 100 %.
TEST(Aerosols, GoWithTheLogarithmOfTheDryness) {
  const double t = std::log(20.0 / 10) / std::log(20.0 / 1);
  EXPECT_NEAR(of("maritime", 1060, 90).extinction, std::pow(0.87538, 1 - t) * std::pow(0.94791, t),
              1e-12);
  EXPECT_EQ(of("maritime", 1060, 100).extinction, 0.94791);
  EXPECT_EQ(of("maritime", 1060, 99.5).extinction, 0.94791);
}

TEST(Aerosols, OfLowtranDoNotDependOnHumidity) {
  EXPECT_EQ(of("stratospheric", 1060, 0).extinction, 0.3017);
  EXPECT_EQ(of("stratospheric", 1060, 90).extinction, 0.3017);
  EXPECT_NEAR(of("meteoric", 550, 50).albedo(), 0.99494, 1e-12);
  EXPECT_EQ(of("fog-advection", 550, 50).albedo(), 1);
  EXPECT_NEAR(of("fog-radiation", 1060, 50).absorption, 0.00013, 1e-15);
  // From 0.00013 at 200 nm to 0 at 300 nm by a straight line over ln(wavelength).
  EXPECT_NEAR(of("fog-advection", std::sqrt(200.0 * 300.0), 50).absorption, 0.000065, 1e-15);
}

// Seen red: with the phase function of 0.9 g.
TEST(Aerosols, HaveAPhaseFunctionOfTheirMeanCosine) {
  for (const char* model : {"rural", "maritime", "urban", "tropospheric", "fog-advection",
                            "fog-radiation", "stratospheric", "meteoric"}) {
    for (const double nm : {200.0, 532.0, 1064.0}) {
      const AerosolOptics aerosol = of(model, nm, 75);
      const double core = PhaseView::x_core;
      const double whole = integral(aerosol.phase.p, core, 2) + aerosol.phase.core_mass;
      EXPECT_NEAR(whole, 1, 1e-6) << model;
      const auto cosine = [&](double x) { return (1 - x) * aerosol.phase.p(x); };
      EXPECT_NEAR(integral(cosine, core, 2) + aerosol.phase.core_mass, aerosol.g, 1e-6) << model;
    }
  }
}

TEST(Aerosols, NameTheirModelsAndRange) {
  expect_contains(message<InputError>([] { of("smoke", 550, 0); }),
                  "no aerosol model \"smoke\" (there are: rural, maritime, urban,");
  expect_contains(message<InputError>([] { of("rural", 199, 0); }),
                  "no aerosol data at 199 nm: Shettle & Fenn 1979");
  expect_contains(message<InputError>([] { of("urban", 40001, 0); }), "cover 200-40000 nm");
}

AirProfile air_of(double visibility_km, const std::string& season) {
  return with_aerosols(air_library(), air_library().atmosphere("us-standard"), visibility_km,
                       season);
}

// Expected values: the vertical optical depths at 550 nm that LOWTRAN 7 prints for 5 km and spring
// or summer. Its levels are 5 km apart above 25 km, the profile's 2.5 km, which changes the highest
// two by 0.1 and 0.8 %. Seen red: with the stratosphere's extinction at 30 km in the upper
// atmosphere, too.
TEST(AerosolProfiles, HaveLowtransOpticalDepths) {
  const AirProfile air = air_of(5, "spring-summer");
  const auto depth = [&](AerosolRegion region) {
    return 1e-3 * column_per_m2(air, air.aerosols_per_km[region]);
  };
  EXPECT_NEAR(depth(boundary_layer), 1.082, 0.0005);
  EXPECT_NEAR(depth(troposphere), 0.08102, 0.00001);
  EXPECT_NEAR(depth(stratosphere) / 7.198e-3, 1, 0.0015);
  EXPECT_NEAR(depth(upper_atmosphere) / 1.591e-4, 1, 0.01);
  expect_contains(air.source, "Anderson et al. 1986");
  expect_contains(air.source, "aerosols LOWTRAN 7");
}

// Aerosols have levels of their own: those of a profile of three are as deep. Seen red: with the
// profile's alone, between which they go straight down to 10 km (0.79 for 0.23 in the lowest).
TEST(AerosolProfiles, AreTheSameInAnyAir) {
  const AirProfile coarse = air_profile(
      DataTable::parse("z_km,p_hpa,t_k\n0,1013,288\n10,265,223\n120,3e-5,360\n", "air.csv"));
  for (const double visibility_km : {5.0, 23.0, 40.0}) {
    const AirProfile air = with_aerosols(air_library(), coarse, visibility_km, "spring-summer");
    EXPECT_NEAR(aerosol_depth(air) / aerosol_depth(air_of(visibility_km, "spring-summer")), 1,
                1e-3);
    EXPECT_EQ(air.pressure_hpa, coarse.pressure_hpa);
  }
  const AirProfile low = with_aerosols(
      air_library(),
      air_profile(DataTable::parse("z_km,p_hpa,t_k\n0.3,978,286\n0.9,909,282\n", "air.csv")), 23,
      "spring-summer");
  EXPECT_EQ(low.aerosol_z_km, (std::vector{0.3, 0.9}));
}

// The tables' values are rounded to 0.0005 at 0.1, and their visibilities' law with them. Seen red:
// with visibilities interpolated linearly; with 3.0 for 3.912.
TEST(AerosolProfiles, KeepTheLawOfVisibility) {
  EXPECT_NEAR(aerosols_of_visibility_per_km(23), 0.158, 0.0006);
  for (const double km :
       {0.2, 0.5, 1.0, 2.0, 3.3, 5.0, 7.0, 10.0, 15.0, 23.0, 35.0, 50.0, 100.0, 250.0, 300.0}) {
    const double at_sea_level = air_of(km, "fall-winter").aerosols_per_km[boundary_layer][0];
    const double law = aerosols_of_visibility_per_km(km);
    EXPECT_NEAR(at_sea_level, law, 0.0006 + 0.004 * law) << km;
    EXPECT_GE(at_sea_level, 0) << km;
  }
}

// Expected values: LOWTRAN 7's tables at 3 km, which is above what a visibility below 23 km
// concerns. Seen red: with the seasons changed over.
TEST(AerosolProfiles, KnowSeasons) {
  const auto at_3_km = [](double visibility_km, const std::string& season) {
    return air_of(visibility_km, season).aerosols_per_km[troposphere][3];
  };
  EXPECT_NEAR(at_3_km(23, "spring-summer"), 0.0346, 1e-12);
  EXPECT_NEAR(at_3_km(5, "spring-summer"), 0.0346, 1e-12);
  EXPECT_NEAR(at_3_km(50, "spring-summer"), 0.0146, 1e-12);
  EXPECT_NEAR(at_3_km(23, "fall-winter"), 0.0272, 1e-12);
  EXPECT_EQ(air_of(23, "fall-winter").aerosols_per_km[stratosphere][20], 0.000423);
  EXPECT_EQ(air_of(23, "spring-summer").aerosols_per_km[stratosphere][20], 0.000589);
}

// Expected values: LOWTRAN 7's depths of the regions above, as it prints them. Seen red: with all
// regions scaled; with the depth of the boundary layer alone.
TEST(AerosolDepth, IsThatOfAllAerosolsAndScalesTheLowest) {
  const AirProfile air = air_of(5, "spring-summer");
  EXPECT_NEAR(aerosol_depth(air), 1.082 + 0.08102 + 7.198e-3 + 1.591e-4, 1e-3);
  for (const double depth : {0.0885, 0.2, 1.0, 5.0}) {
    const AirProfile scaled = with_aerosol_depth(air, depth);
    EXPECT_NEAR(aerosol_depth(scaled), depth, 1e-12);
    for (const auto region : {troposphere, stratosphere, upper_atmosphere})
      EXPECT_EQ(scaled.aerosols_per_km[region], air.aerosols_per_km[region]);
    const double factor =
        scaled.aerosols_per_km[boundary_layer][0] / air.aerosols_per_km[boundary_layer][0];
    EXPECT_NEAR(factor * 1.0824, depth - 0.08838, 1e-3);
    EXPECT_DOUBLE_EQ(scaled.aerosols_per_km[boundary_layer][1],
                     factor * air.aerosols_per_km[boundary_layer][1]);
  }
}

TEST(AerosolDepth, RefusesLessThanThereIsAbove) {
  const AirProfile air = air_of(23, "spring-summer");
  EXPECT_EQ(message<InputError>([&] { with_aerosol_depth(air, 0.05); }),
            "0.05 is less than the optical depth at 550 nm of the aerosols above the boundary "
            "layer alone, 0.08837 (write at least 0.0884, or aerosol = \"none\")");
  EXPECT_NEAR(aerosol_depth(with_aerosol_depth(air, 0.0884)), 0.0884, 1e-12);
  expect_contains(
      message<InputError>(
          [&] { with_aerosol_depth(air_library().atmosphere("us-standard"), 0.2); }),
      "the profile has no aerosols in the boundary layer, which an optical depth scales "
      "(give it a visibility, or aerosols)");
}

TEST(AerosolProfiles, RefuseWhatTheyDoNotKnow) {
  expect_contains(message<InputError>([] { air_of(0.1, "fall-winter"); }),
                  "a visibility of 0.1 km is outside 0.2 to 300 km");
  EXPECT_THROW(air_of(std::nan(""), "fall-winter"), InputError);
  expect_contains(message<InputError>([] { air_of(23, "autumn"); }),
                  "no season of aerosols model \"autumn\" (there are: spring-summer, fall-winter)");
}

}  // namespace
}  // namespace photic::optics
