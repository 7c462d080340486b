#include "optics/opac.hpp"

#include "unit/optics/air_support.hpp"

namespace photic::optics {
namespace {

/// Over the sphere, degree by degree near 0 and 180, where it is steep.
double whole(const PhaseShape& shape) {
  double sum = shape.core_mass, from = PhaseView::x_core;
  for (double x = 2e-8; x < 1; x *= 2) sum += integral(shape.p, std::exchange(from, x), x);
  for (double back = 0.5; back > 1e-6; back /= 2)
    sum += integral(shape.p, std::exchange(from, 2 - back), 2 - back);
  return sum + integral(shape.p, from, 2);
}

constexpr double per_km_of_m2_per_cm3 = 1e9;  // one particle in a cm3

// Expected values: the optical data of OPAC 3.1 (Hess, Koepke & Schult 1998) for sulfate droplets
// at 99 % relative humidity, of which it gives sizes, indices and results. Seen red: with the
// spread's logarithm to the base of ten.
TEST(Opac, DropletsHaveTheOpticsThatItPublishes) {
  const LogNormal sizes{0.231e-6, 2.03, 0.0103e-6, 81.8e-6};
  struct Known {
    double um, n, k, extinction_per_km, scattering_per_km, g;
  };
  for (const Known& known : {Known{2.0, 1.308, 1.104e-3, 4.917e-4, 4.868e-4, 0.778},
                             Known{3.0, 1.369, 0.2672, 5.716e-4, 1.962e-4, 0.683}}) {
    const SpheresOptics optics = optics_of_spheres({known.um * 1e-6, known.n, known.k, sizes});
    EXPECT_NEAR(optics.extinction_m2 * per_km_of_m2_per_cm3 / known.extinction_per_km, 1, 1e-3);
    EXPECT_NEAR(optics.scattering_m2 * per_km_of_m2_per_cm3 / known.scattering_per_km, 1, 1e-3);
    EXPECT_NEAR(optics.mean_cosine, known.g, 1e-3);
  }
}

// Seen red: with a negative k in the data; with the index of the shorter wavelength; with the
// humidities of 80 and 90 % changed over.
TEST(Opac, KnowsSizesAndIndicesByHumidity) {
  const Spheres spheres = air_library().opac.spheres("waso-80", 550);
  EXPECT_EQ(spheres.wavelength_m, 550e-9);
  EXPECT_NEAR(spheres.index, 1.399, 1e-9);
  EXPECT_NEAR(spheres.absorption_index, 0.001995, 1e-9);
  // In the middle of 500 and 550 nm.
  const Spheres green = air_library().opac.spheres("waso-80", 525);
  EXPECT_NEAR(green.index, (1.4 + 1.399) / 2, 1e-12);
  EXPECT_NEAR(green.absorption_index, std::sqrt(0.001663 * 0.001995), 1e-12);
  const auto& sizes = std::get<LogNormal>(spheres.sizes);
  EXPECT_NEAR(sizes.mode_radius_m, 0.0306e-6, 1e-15);
  EXPECT_EQ(sizes.spread, 2.24);
  EXPECT_NEAR(sizes.min_radius_m, 0.0067e-6, 1e-15);
  const auto soot = std::get<LogNormal>(air_library().opac.spheres("soot-0", 550).sizes);
  EXPECT_LT(soot.max_radius_m, 2e-6);  // of 20 um
  const auto mineral = std::get<LogNormal>(air_library().opac.spheres("mitr-0", 550).sizes);
  EXPECT_NEAR(mineral.max_radius_m, 5e-6, 1e-15);
}

// At 2000 nm, where spheres of 20 um take no time. Seen red: with two s for six.
TEST(Opac, LosesNothingWithTheLargestSpheres) {
  Spheres spheres = air_library().opac.spheres("waso-0", 2000);
  const SpheresOptics cut = optics_of_spheres(spheres);
  std::get<LogNormal>(spheres.sizes).max_radius_m = 20e-6;
  const SpheresOptics whole = optics_of_spheres(spheres);
  EXPECT_NEAR(cut.extinction_m2 / whole.extinction_m2, 1, 1e-5);
  EXPECT_NEAR(cut.mean_cosine / whole.mean_cosine, 1, 1e-5);
  EXPECT_NEAR(cut.phase.at(2) / whole.phase.at(2), 1, 1e-5);
  EXPECT_NEAR(cut.phase.at(0) / whole.phase.at(0), 1, 1e-3);
}

// As above, in the visible, where Mie theory is sampled: OPAC gives three to four digits, and a
// volume phase function, here over its scattering coefficient. Straight back lies the glory.
TEST(Opac, DropletsHaveThePhaseFunctionThatItPublishes) {
  const SampledSpheres optics = sampled_spheres(air_library().opac.spheres("suso-99", 550));
  EXPECT_NEAR(optics.extinction_m2 * per_km_of_m2_per_cm3 / 1.209e-3, 1, 1e-3);
  EXPECT_NEAR(optics.mean_cosine, 0.797, 1e-3);
  EXPECT_NEAR(optics.phase.p(0) / (7.934e-3 / 1.209e-3), 1, 5e-3);
  EXPECT_NEAR(optics.phase.p(x_of(1)) / (7.483e-3 / 1.209e-3), 1, 5e-3);
  EXPECT_NEAR(optics.phase.p(x_of(178)) / (2.325e-5 / 1.209e-3), 1, 5e-2);
  EXPECT_NEAR(optics.phase.p(2) / (2.713e-5 / 1.209e-3), 1, 5e-2);
}

TEST(Opac, IsAnAerosolModel) {
  const AerosolOptics green = aerosol_optics(air_library(), "opac-soot-0", 550, 37);
  EXPECT_EQ(green.extinction, 1);
  EXPECT_NEAR(green.albedo(), 0.2088, 5e-4);
  expect_contains(green.source, "Hess, Koepke & Schult 1998");
  const AerosolOptics infrared = aerosol_optics(air_library(), "opac-soot-0", 1100, 37);
  EXPECT_LT(infrared.extinction, 0.5);
  EXPECT_LT(infrared.g, green.g);
  EXPECT_NEAR(whole(infrared.phase), 1, 1e-6);
  const auto sections = aerosol_optics(air_library(), "opac-soot-0", 1100, 37, Phases::left_out);
  EXPECT_DOUBLE_EQ(sections.extinction, infrared.extinction);
  EXPECT_DOUBLE_EQ(sections.absorption, infrared.absorption);
  EXPECT_FALSE(sections.phase.p);
}

// Every component and humidity of Hess et al. 1998, at the laser's wavelength where the largest
// take less than a second. Seen red: with a table of p itself, where glories are as narrow as a
// cell.
TEST(Opac, EveryComponentIsATableOfItsPhaseFunction) {
  int components = 0;
  for (const auto& [name, humidities] :
       std::map<std::string, std::vector<int>>{{"inso", {0}},
                                               {"waso", {0, 50, 70, 80, 90, 95, 98, 99}},
                                               {"soot", {0}},
                                               {"ssam", {0, 50, 70, 80, 90, 95, 98, 99}},
                                               {"sscm", {0, 50, 70, 80, 90, 95, 98, 99}},
                                               {"minm", {0}},
                                               {"miam", {0}},
                                               {"micm", {0}},
                                               {"mitr", {0}},
                                               {"suso", {0, 50, 70, 80, 90, 95, 98, 99}}}) {
    for (const int humidity : humidities) {
      const std::string model = "opac-" + name + "-" + std::to_string(humidity);
      SCOPED_TRACE(model);
      const AerosolOptics aerosol = aerosol_optics(air_library(), model, 1064, 0);
      EXPECT_GT(aerosol.extinction, 0);
      EXPECT_GE(aerosol.absorption, 0);
      EXPECT_NEAR(whole(aerosol.phase), 1, 1e-6);
      EXPECT_NEAR(table_integral(aerosol.phase), 1, 1e-4);
      EXPECT_NEAR(PhaseTable(aerosol.phase).mean_cosine(), aerosol.g, 1e-3);
      ++components;
    }
  }
  EXPECT_EQ(components, 38);
}

TEST(Opac, RefusesWhatItDoesNotKnow) {
  const auto at = [](const std::string& component, double nm) {
    return message<InputError>([&] { aerosol_optics(air_library(), component, nm, 0); });
  };
  expect_contains(at("opac-waso-85", 550), "no OPAC model \"waso-85\" (there are: inso-0, miam-0,");
  expect_contains(at("opac-waso-80", 249), "no OPAC data at 249 nm: Hess, Koepke & Schult 1998");
  expect_contains(at("opac-waso-80", 2001), "cover 250-2000 nm");
}

}  // namespace
}  // namespace photic::optics
