// Layers made of constituents: sums of what the optics say, phase functions weighted by scattering.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "optics/cdom.hpp"
#include "optics/fournier_forand.hpp"
#include "optics/minerals.hpp"
#include "optics/phase_functions.hpp"
#include "optics/phytoplankton.hpp"
#include "optics/refractive_index.hpp"
#include "optics/sea_particles.hpp"
#include "optics/spheres.hpp"
#include "optics/water_absorption.hpp"
#include "optics/water_scattering.hpp"
#include "unit/medium/scenes.hpp"

namespace photic::medium {
namespace {

scene::Layer algae_layer(double chlorophyll_mg_m3, double cdom_a440_per_m = 0) {
  scene::Layer layer;
  layer.name = "top";
  layer.chlorophyll_mg_m3 = chlorophyll_mg_m3;
  layer.cdom_a440_per_m = cdom_a440_per_m;
  return layer;
}

struct Parts {
  double a_water, b_water;
  optics::Phytoplankton algae;
};

Parts parts_at(double nm, double chlorophyll) {
  return {optics::water_absorption_per_m(library(), "mason-ioccg", nm, 35, 20).value,
          optics::water_scattering_per_m(library(), "zhang", nm, 35, 20).value,
          optics::phytoplankton(library(), "bricaud", chlorophyll, nm)};
}

// At both wavelengths. Seen red: without the CDOM; with the algae's scattering left out.
TEST(Constituents, AddUp) {
  const auto m = medium_of(scene_of({algae_layer(0.5, 0.03)}, {test::channel_of(Process::elastic),
                                                               test::channel_of(Process::raman)}));
  for (std::size_t l = 0; l < 2; ++l) {
    const double nm = m.line[l].wavelength_nm;
    const Parts parts = parts_at(nm, 0.5);
    const double a = parts.a_water + parts.algae.a_per_m + 0.03 * std::exp(-0.017 * (nm - 440));
    const double b = parts.b_water + parts.algae.b_per_m;
    EXPECT_NEAR(m.c[l], a + b, 1e-15) << nm;
    EXPECT_NEAR(m.albedo[l], b / (a + b), 1e-15) << nm;
  }
}

// A layer's own salinity and temperature: in what its water absorbs and scatters, not in where the
// light goes and when. Seen red: with the sea's temperature; with its salinity.
TEST(Constituents, AreInWaterOfTheLayersSalinityAndTemperature) {
  auto layer = algae_layer(0.5);
  auto scene = scene_of({layer, layer},
                        {test::channel_of(Process::elastic), test::channel_of(Process::raman)});
  scene.sea.layer[0].bottom_depth_m = 5;
  const auto plain = medium_of(scene);
  scene.sea.layer[0].salinity_psu = 10;
  scene.sea.layer[0].temperature_c = 2;
  const auto m = medium_of(scene);
  for (std::size_t l = 0; l < 2; ++l) {
    const double nm = m.line[l].wavelength_nm;
    const auto algae = optics::phytoplankton(library(), "bricaud", 0.5, nm);
    const double a = optics::water_absorption_per_m(library(), "mason-ioccg", nm, 10, 2).value;
    const double b = optics::water_scattering_per_m(library(), "zhang", nm, 10, 2).value;
    EXPECT_NEAR(m.c[2 * l], a + b + algae.a_per_m + algae.b_per_m, 1e-15);
    EXPECT_NEAR(m.albedo[2 * l] * m.c[2 * l], b + algae.b_per_m, 1e-15);
    EXPECT_GT(std::fabs(m.c[2 * l] - plain.c[2 * l]), 1e-4);
    EXPECT_EQ(m.c[2 * l + 1], plain.c[2 * l + 1]);
    EXPECT_EQ(m.line[l].refractive_index, plain.line[l].refractive_index);
    EXPECT_EQ(m.line[l].group_index, plain.line[l].group_index);
  }
}

// Seen red: with equal shares; with the shares swapped.
TEST(Constituents, ScatterWithPhaseFunctionsWeightedByTheirScattering) {
  const auto m = medium_of(scene_of({algae_layer(0.1)}, {test::channel_of(Process::elastic)}));
  const Parts parts = parts_at(532, 0.1);
  const optics::PhaseTable water(optics::rayleigh(0.039));
  const optics::PhaseTable algae(optics::fournier_forand(1.10, 3.5835));
  const double b = parts.b_water + parts.algae.b_per_m;
  for (const double x : {0.0, 1e-6, 0.01, 0.5, 1.0, 2.0}) {
    const double expected = (parts.b_water * water.view().value<double>(x) +
                             parts.algae.b_per_m * algae.view().value<double>(x)) /
                            b;
    EXPECT_NEAR(m.view().phases.value<double>(x, m.elastic_phase[0]) / expected, 1, 2e-5) << x;
  }
}

TEST(Constituents, OfPureWaterScatterAsMolecules) {
  auto scene = scene_of({algae_layer(0)}, {test::channel_of(Process::elastic)});
  const optics::PhaseTable molecules(optics::rayleigh(0.039));
  const auto m = medium_of(scene);
  EXPECT_EQ(m.view().phases.value<double>(2.0, m.elastic_phase[0]),
            molecules.view().value<double>(2.0));
  // The depolarisation shapes the function and leaves b alone.
  scene.optics.water_depolarisation = 0.17;
  const auto paper = medium_of(scene);
  EXPECT_EQ(paper.albedo[0], m.albedo[0]);
  EXPECT_NEAR(paper.view().phases.value<double>(2.0, paper.elastic_phase[0]), 0.1100, 5e-5);
  EXPECT_NEAR(m.view().phases.value<double>(2.0, m.elastic_phase[0]), 0.1171, 5e-5);
}

TEST(Constituents, FluoresceByWhatPhytoplanktonAbsorbs) {
  auto layer = algae_layer(0.5, 0.03);
  layer.chlorophyll_yield = 0.03;
  const auto m = medium_of(scene_of({layer}, all_channels));
  ASSERT_EQ(m.line.size(), 3U);
  const Parts parts = parts_at(532, 0.5);
  EXPECT_NEAR(m.conversion[2] * m.c[0], 0.03 * parts.algae.a_exciting_per_m, 1e-17);
  EXPECT_LT(parts.algae.a_exciting_per_m, parts.algae.a_per_m);
}

TEST(Constituents, ScatterAsPetzoldMeasuredIfAsked) {
  auto scene = scene_of({algae_layer(1)}, {test::channel_of(Process::elastic)});
  const double forward = medium_of(scene).view().phases.value<double>(2.0, 0);
  scene.optics.phytoplankton_phase = scene::ParticlePhase::petzold;
  const auto m = medium_of(scene);
  EXPECT_NE(m.view().phases.value<double>(2.0, m.elastic_phase[0]), forward);
}

// At the laser's wavelength and at Raman's, with the index that water has there. Seen red: with the
// paper's minerals; with the wavelength in air; with the laser's for both.
TEST(Constituents, ScatterAsThePapersSpheresIfAsked) {
  auto scene = scene_of({algae_layer(1)},
                        {test::channel_of(Process::elastic), test::channel_of(Process::raman)});
  scene.optics.phytoplankton_phase = scene::ParticlePhase::mie;
  const auto m = medium_of(scene);
  for (std::size_t l = 0; l < 2; ++l) {
    const double nm = m.line[l].wavelength_nm;
    const Parts parts = parts_at(nm, 1);
    const double share = parts.algae.b_per_m / (parts.b_water + parts.algae.b_per_m);
    const auto spheres = optics::optics_of_spheres(optics::spheres_in_water(
        optics::paper_phytoplankton, nm, optics::refractive_index(nm, 35, 20)));
    for (const double x : {0.001, 1.0, 2.0}) {
      const double expected =
          share * spheres.phase.at(x) + (1 - share) * optics::rayleigh(0.039).p(x);
      EXPECT_NEAR(m.view().phases.value<double>(x, m.elastic_phase[l]) / expected, 1, 1e-4)
          << l << " " << x;
    }
  }
}

scene::Layer mineral_layer(double minerals_g_m3, double chlorophyll_mg_m3 = 0) {
  scene::Layer layer = algae_layer(chlorophyll_mg_m3);
  layer.minerals_g_m3 = minerals_g_m3;
  return layer;
}

// Beside algae, at both wavelengths, by the scene's own power laws. Seen red: without the minerals'
// absorption; with their scattering given to the algae.
TEST(Constituents, AddMineralsUp) {
  auto scene = scene_of({mineral_layer(2, 0.1)},
                        {test::channel_of(Process::elastic), test::channel_of(Process::raman)});
  scene.optics.minerals_power_law = {0.03, 0.01, 0.6, 0.7};
  const auto m = medium_of(scene);
  const optics::PhaseTable water(optics::rayleigh(0.039));
  const optics::PhaseTable algae(optics::fournier_forand(1.10, 3.5835));
  const optics::PhaseTable minerals(optics::fournier_forand(1.15, 3.5));
  for (std::size_t l = 0; l < 2; ++l) {
    const double nm = m.line[l].wavelength_nm;
    const Parts parts = parts_at(nm, 0.1);
    const double a_minerals = 2 * 0.03 * std::exp(-0.01 * (nm - 443));
    const double b_minerals = 2 * 0.6 * std::pow(555 / nm, 0.7);
    const double b = parts.b_water + parts.algae.b_per_m + b_minerals;
    EXPECT_NEAR(m.c[l], parts.a_water + parts.algae.a_per_m + a_minerals + b, 1e-14) << nm;
    EXPECT_NEAR(m.albedo[l] * m.c[l], b, 1e-14) << nm;
    for (const double x : {1e-5, 0.1, 2.0}) {
      const double expected = (parts.b_water * water.view().value<double>(x) +
                               parts.algae.b_per_m * algae.view().value<double>(x) +
                               b_minerals * minerals.view().value<double>(x)) /
                              b;
      EXPECT_NEAR(m.view().phases.value<double>(x, m.elastic_phase[l]) / expected, 1, 2e-5) << x;
    }
  }
  const auto listed =
      std::ranges::find(m.sources, std::string("a and b of minerals"), &Source::quantity);
  ASSERT_NE(listed, m.sources.end());
  EXPECT_TRUE(listed->source.starts_with("a at 443 nm given in the scene")) << listed->source;
}

// Without algae. Seen red: with the algae's spheres; with the index of the laser's light for all.
TEST(Constituents, AreThePapersMineralsIfAsked) {
  auto scene = scene_of({mineral_layer(1.5)},
                        {test::channel_of(Process::elastic), test::channel_of(Process::raman)});
  scene.optics.minerals = scene::MineralOptics::mie;
  scene.optics.minerals_phase = scene::ParticlePhase::mie;
  const auto m = medium_of(scene);
  for (std::size_t l = 0; l < 2; ++l) {
    const double nm = m.line[l].wavelength_nm;
    const Parts parts = parts_at(nm, 0);
    const auto spheres = library().spheres(
        optics::spheres_in_water(optics::paper_minerals, nm, optics::refractive_index(nm, 35, 20)));
    const auto minerals = optics::minerals_of_spheres(
        {spheres->scattering_m2, spheres->absorption_m2, spheres->volume_m3}, 1.5);
    const double b = parts.b_water + minerals.b_per_m;
    EXPECT_NEAR(m.c[l] / (parts.a_water + minerals.a_per_m + b), 1, 1e-5) << nm;
    for (const double x : {0.001, 1.0}) {
      const double expected =
          (minerals.b_per_m * spheres->phase.at(x) + parts.b_water * optics::rayleigh(0.039).p(x)) /
          b;
      EXPECT_NEAR(m.view().phases.value<double>(x, m.elastic_phase[l]) / expected, 1, 2e-4) << x;
    }
  }
}

TEST(Constituents, OfMineralsScatterAsPetzoldMeasuredIfAsked) {
  auto scene = scene_of({mineral_layer(1000)}, {test::channel_of(Process::elastic)});
  scene.optics.minerals_phase = scene::ParticlePhase::petzold;
  const auto m = medium_of(scene);
  const optics::PhaseTable petzold(optics::petzold(library()));
  EXPECT_NEAR(
      m.view().phases.value<double>(0.01, m.elastic_phase[0]) / petzold.view().value<double>(0.01),
      1, 1e-4);
}

// What water does not scatter particles do. Seen red: with all scattering
// by particles.
TEST(Constituents, AreWaterAndParticlesInOneOfJerlovsTypes) {
  scene::Layer layer;
  layer.name = "top";
  layer.jerlov = "II";
  const auto m = medium_of(scene_of({layer}, all_channels));
  ASSERT_EQ(m.line.size(), 2U);  // nothing is said of what excites chlorophyll
  const double a = 0.8 * 0.0607 + 0.2 * 0.065, b = 0.8 * 0.18 + 0.2 * 0.178;
  EXPECT_NEAR(m.c[0], a + b, 1e-12);
  EXPECT_NEAR(m.albedo[0] * m.c[0], b, 1e-12);
  const double b_water = parts_at(532, 0).b_water;
  const optics::PhaseTable water(optics::rayleigh(0.039));
  const optics::PhaseTable particles(optics::fournier_forand(1.10, 3.5835));
  for (const double x : {1e-5, 0.1, 2.0}) {
    const double expected = (b_water * water.view().value<double>(x) +
                             (b - b_water) * particles.view().value<double>(x)) /
                            b;
    EXPECT_NEAR(m.view().phases.value<double>(x, m.elastic_phase[0]) / expected, 1, 2e-5) << x;
  }
}

scene::PhaseFunction function_of(scene::PhaseModel model) {
  scene::PhaseFunction function;
  function.model = model;
  return function;
}

/// The phase function of an iop layer that names one.
double value_of(const scene::PhaseFunction& function, double x) {
  auto layer = iop_layer();
  layer.phase_function = function;
  const auto m = medium_of(scene_of({layer}, {test::channel_of(Process::elastic)}));
  return m.view().phases.value<double>(x, m.elastic_phase[0]);
}

TEST(IopLayer, ScattersWithTheNamedPhaseFunction) {
  const auto at = [](const optics::PhaseShape& shape, double x) {
    return optics::PhaseTable(shape).view().value<double>(x);
  };
  auto ff = function_of(scene::PhaseModel::fournier_forand);
  ff.refractive_index = 1.08;
  ff.slope = 3.4;
  ff.fraction = 0.7;
  auto rayleigh = function_of(scene::PhaseModel::rayleigh);
  rayleigh.depolarisation = 0.09;
  rayleigh.fraction = 0.3;
  auto mixture = function_of(scene::PhaseModel::mixture);
  mixture.components = {ff, rayleigh};
  auto table = function_of(scene::PhaseModel::table);
  table.table = scene::UserTable(
      optics::DataTable::read(PHOTIC_SOURCE_DIR "/data/particles_petzold_average.csv"),
      {"angle_deg", "phase_function_per_sr"});
  auto mie = function_of(scene::PhaseModel::mie);
  mie.particles = {1.1, 0.002, 4.5, 0.2, 2};
  const auto spheres = optics::phase_of_spheres(library().spheres(
      optics::spheres_in_water(mie.particles, 532, optics::refractive_index(532, 35, 20))));
  for (const double x : {0.001, 0.3, 2.0}) {
    const double expected_ff = at(optics::fournier_forand(1.08, 3.4), x);
    const double expected_rayleigh = at(optics::rayleigh(0.09), x);
    EXPECT_EQ(value_of(henyey_greenstein(0.7), x), at(optics::henyey_greenstein(0.7), x));
    EXPECT_EQ(value_of(ff, x), expected_ff);
    EXPECT_EQ(value_of(rayleigh, x), expected_rayleigh);
    EXPECT_EQ(value_of(function_of(scene::PhaseModel::isotropic), x), at(optics::isotropic(), x));
    EXPECT_EQ(value_of(function_of(scene::PhaseModel::petzold), x),
              at(optics::petzold(library()), x));
    EXPECT_EQ(value_of(table, x), at(optics::petzold(library()), x));
    EXPECT_EQ(value_of(mie, x), at(spheres, x));
    EXPECT_NEAR(value_of(mixture, x) / (0.7 * expected_ff + 0.3 * expected_rayleigh), 1, 2e-5);
  }
}

// Of 0.333 + 0.333 + 0.333 each is a third. Seen red: with the fractions taken as they are.
TEST(IopLayer, ScalesTheFractionsOfAMixture) {
  auto part = function_of(scene::PhaseModel::isotropic);
  part.fraction = 0.3333333;
  auto mixture = function_of(scene::PhaseModel::mixture);
  mixture.components = {part, part, part};
  EXPECT_NEAR(value_of(mixture, 1.0) * 4 * pi, 1, 1e-12);
}

}  // namespace
}  // namespace photic::medium
