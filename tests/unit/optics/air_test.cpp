#include "optics/air.hpp"

#include "optics/air_molecules.hpp"
#include "unit/optics/air_support.hpp"

namespace photic::optics {
namespace {

AirProfile hazy() {
  return with_aerosols(air_library(), air_library().atmosphere("us-standard"), 23, "fall-winter");
}

double depth(const AirOptics& air, double AirLayer::*per_m) {
  double sum = 0;
  for (const AirLayer& layer : air.layers)
    sum += layer.*per_m * 1e3 * (layer.top_km - layer.bottom_km);
  return sum;
}

// Seen red: with molecules counted per cm3; with the absorption of aerosols taken for their
// extinction.
TEST(Air, AddsUpToTheColumnsOfItsProfile) {
  const AirProfile profile = hazy();
  const AirOptics air = air_at(air_library(), profile, {}, 550);
  ASSERT_EQ(air.layers.size(), 49U);
  EXPECT_EQ(air.layers.front().bottom_km, 0);
  EXPECT_EQ(air.layers.back().top_km, 120);
  EXPECT_NEAR(depth(air, &AirLayer::molecules_b_per_m), 0.0971, 5e-5);
  // Rural aerosols below the troposphere's: extinction at 550 nm is the profile's own.
  double extinction = 0;
  for (const auto& region : profile.aerosols_per_km)
    extinction += 1e-3 * column_per_m2(profile, region);
  EXPECT_NEAR(depth(air, &AirLayer::aerosols_a_per_m) + depth(air, &AirLayer::aerosols_b_per_m),
              extinction, 1e-9);
  // The Chappuis band at 550 nm, 3.3e-21 cm2 (Serdyuchenko et al. 2014), of 344 DU.
  EXPECT_NEAR(depth(air, &AirLayer::ozone_a_per_m), 0.344 * 2.68678e19 * 3.3e-21, 0.001);
}

// Of the lowest layer by hand. Seen red: with the phase function of the molecules for all.
TEST(Air, MixesMoleculesAndAerosols) {
  const AirProfile profile = hazy();
  AerosolChoice choice;
  choice.model[boundary_layer] = "maritime";
  const AirLayer layer = air_at(air_library(), profile, choice, 532).layers.front();
  const double humidity =
      (profile.relative_humidity_percent[0] + profile.relative_humidity_percent[1]) / 2;
  const AerosolOptics maritime = aerosol_optics(air_library(), "maritime", 532, humidity);
  const double at_550 = 1e-3 * mean_between(profile.z_km, profile.aerosols_per_km[0], 0, 1);
  EXPECT_NEAR(layer.aerosols_b_per_m, at_550 * maritime.scattering(), 1e-12);
  EXPECT_NEAR(layer.aerosols_a_per_m, at_550 * maritime.absorption, 1e-12);
  EXPECT_NEAR(layer.aerosols_g, maritime.g, 1e-12);
  EXPECT_EQ(layer.b_per_m(), layer.molecules_b_per_m + layer.aerosols_b_per_m);
  EXPECT_EQ(layer.a_per_m(), layer.ozone_a_per_m + layer.aerosols_a_per_m);
  const double molecules = rayleigh(air_depolarisation(532)).p(0.7),
               aerosols = maritime.phase.p(0.7), share = layer.molecules_b_per_m / layer.b_per_m();
  EXPECT_NEAR(layer.phase.p(0.7), share * molecules + (1 - share) * aerosols, 1e-12);
  EXPECT_NEAR(layer.refractive_index - 1, 2.65e-4, 0.02e-4);
}

TEST(Air, HasAPhaseFunctionInEachLayer) {
  const double core = PhaseView::x_core;
  for (const AirLayer& layer : air_at(air_library(), hazy(), {}, 1064).layers)
    EXPECT_NEAR(integral(layer.phase.p, core, 2) + layer.phase.core_mass, 1, 1e-6)
        << layer.bottom_km;
}

TEST(Air, NamesItsSources) {
  const AirOptics air = air_at(air_library(), hazy(), {}, 300);
  expect_contains(air.profile_source, "Anderson et al. 1986");
  expect_contains(air.molecules_source, "Bodhaine et al. 1999");
  expect_contains(air.ozone_source, "Molina & Molina 1986");
  expect_contains(air.aerosols_source, "rural model, as in LOWTRAN 7");
  expect_contains(air.aerosols_source, "meteoric dust model");
  const AirProfile clear =
      air_profile(DataTable::parse("z_km,p_hpa,t_k\n0,1013,288\n5,540,255\n", "clear.csv"));
  const AirOptics molecules = air_at(air_library(), clear, {}, 1100);
  EXPECT_EQ(molecules.ozone_source, "no ozone");
  EXPECT_EQ(molecules.aerosols_source, "no aerosols");
  EXPECT_EQ(molecules.layers[0].a_per_m(), 0);
  EXPECT_EQ(molecules.layers[0].aerosols_g, 0);
}

TEST(Air, RefusesWavelengthsAndModelsWithoutData) {
  EXPECT_THROW(air_at(air_library(), hazy(), {}, 199), InputError);
  EXPECT_THROW(air_at(air_library(), hazy(), {}, 1101), InputError);
  AerosolChoice choice;
  choice.model[stratosphere] = "volcanic";
  expect_contains(message<InputError>([&] { air_at(air_library(), hazy(), choice, 532); }),
                  "no aerosol model \"volcanic\"");
}

}  // namespace
}  // namespace photic::optics
