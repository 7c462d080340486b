// The table of a scene's optics: against what the layers' optics say, and against closed forms.
#include "medium/optical_table.hpp"

#include <cmath>

#include "medium/layer_optics.hpp"
#include "optics/phase_functions.hpp"
#include "unit/medium/scenes.hpp"

namespace photic::medium {
namespace {

scene::Layer water_layer(const std::string& name, double chlorophyll_mg_m3, double a440 = 0) {
  scene::Layer layer;
  layer.name = name;
  layer.chlorophyll_mg_m3 = chlorophyll_mg_m3;
  layer.cdom_a440_per_m = a440;
  return layer;
}

OpticalTable table_of(std::vector<scene::Layer> layers, const std::vector<double>& nm,
                      std::vector<scene::Channel> channels = {test::channel_of(Process::elastic)}) {
  return optical_table(scene_of(std::move(layers), std::move(channels)), library(), nm);
}

/// One layer that scatters with a phase function.
OpticalTable scattering_with(const scene::PhaseFunction& function) {
  auto layer = iop_layer();
  layer.phase_function = function;
  return table_of({layer}, {532});
}

scene::PhaseFunction called(scene::PhaseModel model) {
  scene::PhaseFunction function;
  function.model = model;
  return function;
}

std::size_t at_angle(const OpticalTable& table, double degree) {
  const auto nearest = std::ranges::min_element(
      table.angle_deg, {}, [&](double angle) { return std::abs(angle - degree); });
  EXPECT_NEAR(*nearest, degree, 1e-12 * degree);
  return static_cast<std::size_t>(nearest - table.angle_deg.begin());
}

// Seen red: with the last layer's phase function for all; with the first wavelength for all.
TEST(OpticalTable, HoldsWhatTheLayersOpticsSay) {
  auto top = water_layer("top", 0.5, 0.03);
  top.bottom_depth_m = 7;
  const auto scene = scene_of({top, water_layer("below", 2), iop_layer("bed")},
                              {test::channel_of(Process::elastic)});
  const std::vector<double> nm = {510, 532, 640.5};
  const OpticalTable table = optical_table(scene, library(), nm);
  EXPECT_EQ(table.layer_name, (std::vector<std::string>{"top", "below", "bed"}));
  EXPECT_EQ(table.last_m[0], 7);
  EXPECT_EQ(table.wavelength_nm, nm);
  ASSERT_EQ(table.a_per_m.size(), 9U);
  const LayerOptics optics_of(scene, library());
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t w = 0; w < 3; ++w) {
      const WaterOptics water = optics_of(scene.sea.layer[k], nm[w]);
      const optics::PhaseTable phase(optics_of.phase(scene.sea.layer[k], nm[w], water));
      const std::size_t i = 3 * k + w;
      EXPECT_EQ(table.a_per_m[i], water.a_per_m);
      EXPECT_EQ(table.b_per_m[i], water.b_per_m);
      EXPECT_EQ(table.a_exciting_per_m[i], water.a_exciting_per_m);
      EXPECT_EQ(table.c_per_m()[i], water.a_per_m + water.b_per_m);
      EXPECT_EQ(table.albedo()[i], water.b_per_m / (water.a_per_m + water.b_per_m));
      EXPECT_EQ(table.bb_per_m()[i], water.b_per_m * phase.backscatter_fraction());
      EXPECT_EQ(table.mean_cosine[i], phase.mean_cosine());
      for (const double degree : {0.1, 30.0, 90.0, 180.0}) {
        const double x = 1 - std::cos(degree * radian_per_degree);
        EXPECT_NEAR(table.phase_function_per_sr[i * table.angles() + at_angle(table, degree)] /
                        phase.view().value<double>(x),
                    1, 1e-9)
            << degree;
      }
    }
  }
}

// Closed forms: the mean cosine of Henyey & Greenstein 1941 is g; their backscatter fraction is
// (1 - g) / (2 g) [(1 + g) / sqrt(1 + g^2) - 1]. Seen red: with angles taken from
// behind.
TEST(OpticalTable, HasTheMeanCosineAndBackscatteringOfHenyeyGreenstein) {
  for (const double g : {-0.3, 0.5, 0.924}) {
    const OpticalTable table = scattering_with(henyey_greenstein(g));
    EXPECT_NEAR(table.mean_cosine[0], g, 2e-5) << g;
    const double backwards = (1 - g) / (2 * g) * ((1 + g) / std::sqrt(1 + g * g) - 1);
    EXPECT_NEAR(table.backscatter_fraction[0], backwards, 2e-5) << g;
    const double forward = (1 - g * g) / (4 * pi * std::pow(1 - g, 3));
    EXPECT_NEAR(table.phase_function_per_sr[0] / forward, 1, 1e-4) << g;
  }
}

TEST(OpticalTable, HasHalfOfRayleighScatteringBackwards) {
  auto rayleigh = called(scene::PhaseModel::rayleigh);
  rayleigh.depolarisation = 0.039;
  const OpticalTable table = scattering_with(rayleigh);
  EXPECT_NEAR(table.backscatter_fraction[0], 0.5, 5e-6);  // straight lines between the nodes
  EXPECT_NEAR(table.mean_cosine[0], 0, 5e-6);
  EXPECT_NEAR(table.phase_function_per_sr.back(), 0.1171, 5e-5);
}

// Fournier & Jonasz 1999's backscatter fraction of n = 1.10, slope 3.5835, and Petzold's average
// (Mobley, Sundman & Boss 2002, Appl. Opt. 41, 1035): both 0.0183.
TEST(OpticalTable, HasTheBackscatterFractionsOfOceanicParticles) {
  auto ff = called(scene::PhaseModel::fournier_forand);
  ff.refractive_index = 1.10;
  ff.slope = 3.5835;
  EXPECT_NEAR(scattering_with(ff).backscatter_fraction[0], 0.0183, 5e-5);
  EXPECT_NEAR(scattering_with(ff).phase_function_per_sr.back(), 2.8578e-3, 5e-7);
  EXPECT_NEAR(scattering_with(called(scene::PhaseModel::petzold)).backscatter_fraction[0], 0.0183,
              5e-5);
}

// Seen red: with all of a layer as the part of each; with 0 in the iop layer; with the
// backscattered share of water for each.
TEST(OpticalTable, NamesTheConstituents) {
  const std::vector<double> nm = {510, 640};
  const OpticalTable table =
      table_of({water_layer("clear", 0), water_layer("green", 0.7, 0.1), iop_layer()}, nm);
  ASSERT_EQ(table.parts.size(), 3U);
  EXPECT_EQ(table.parts[0].name, "water");
  EXPECT_EQ(table.parts[1].name, "phytoplankton");
  EXPECT_EQ(table.parts[2].name, "CDOM");
  EXPECT_TRUE(table.parts[2].b_per_m.empty());  // which does not scatter
  EXPECT_TRUE(table.parts[2].bb_per_m.empty());
  for (std::size_t w = 0; w < 2; ++w) {
    EXPECT_EQ(table.parts[1].a_per_m[w], 0);
    EXPECT_NEAR(table.parts[2].a_per_m[2 + w], 0.1 * std::exp(-0.017 * (nm[w] - 440)), 1e-15);
    EXPECT_TRUE(std::isnan(table.parts[0].a_per_m[4 + w]));
    EXPECT_TRUE(std::isnan(table.parts[0].bb_per_m[4 + w]));
  }
  for (std::size_t i = 0; i < 4; ++i) {  // of the layers whose constituents are known
    double a = 0, b = 0, bb = 0;
    for (const auto& part : table.parts) {
      bb += part.bb_per_m.empty() ? 0 : part.bb_per_m[i];
      a += part.a_per_m[i];
      b += part.b_per_m.empty() ? 0 : part.b_per_m[i];
    }
    EXPECT_NEAR(a, table.a_per_m[i], 1e-15);
    EXPECT_NEAR(b, table.b_per_m[i], 1e-15);
    EXPECT_NEAR(bb / table.bb_per_m()[i], 1, 1e-4);  // but for the table of the mixture
    EXPECT_NEAR(table.parts[0].bb_per_m[i], table.parts[0].b_per_m[i] / 2, 1e-7);
  }
}

TEST(OpticalTable, OfLayersWithGivenOpticsHasNoConstituents) {
  const OpticalTable table = table_of({iop_layer()}, {532});
  EXPECT_TRUE(table.parts.empty());
  ASSERT_EQ(table.sources.size(), 1U);
  EXPECT_EQ(table.sources[0].quantity, "a and b");
  EXPECT_EQ(table.sources[0].source, "given in the scene");
}

// Below 300 nm absorption comes from another set. Seen red: with the range of the first for both.
TEST(OpticalTable, ListsForWhichWavelengthsASourceServed) {
  const OpticalTable table = table_of({water_layer("pure", 0)}, {250, 290, 310, 532, 700});
  std::vector<std::string> listed;
  for (const auto& [quantity, first, last, source] : table.sources)
    listed.push_back(fmt::format("{} {} {} {}", quantity, first, last, source.substr(0, 5)));
  EXPECT_EQ(listed,
            (std::vector<std::string>{"a of water 250 290 IOCCG", "b of water 250 700 Zhang",
                                      "a of water 310 700 Mason"}));
}

// Whether or not a channel counts the light. Seen red: with what is absorbed at another wavelength
// than the laser's.
TEST(OpticalTable, ListsWhatLayersEmit) {
  auto scene = scene_of({water_layer("clear", 0), water_layer("green", 0.5)},
                        {test::channel_of(Process::elastic)});
  scene.source.wavelength_nm = 488;
  scene.sea.layer[1].chlorophyll_yield = 0.02;
  const OpticalTable table = optical_table(scene, library(), {600});
  EXPECT_EQ(table.excitation_nm, 488);
  ASSERT_EQ(table.emission.size(), 3U);
  const auto& raman = table.emission[0];
  EXPECT_EQ(raman.process, "raman");
  EXPECT_EQ(raman.coefficient_per_m.size(), 2U);
  EXPECT_NEAR(raman.coefficient_per_m[1], 2.7e-4, 1e-9);  // Bartlett et al. 1998
  const auto& chlorophyll = table.emission[1];
  EXPECT_EQ(chlorophyll.process, "chlorophyll");
  ASSERT_EQ(chlorophyll.wavelength_nm, (std::vector<double>{685}));
  const LayerOptics optics_of(scene, library());
  const double exciting = optics_of(scene.sea.layer[1], 488).a_exciting_per_m;
  EXPECT_EQ(chlorophyll.coefficient_per_m[0], 0);
  EXPECT_NEAR(chlorophyll.coefficient_per_m[1], 0.02 * exciting, 1e-12);
  EXPECT_EQ(chlorophyll.line_per_m, chlorophyll.coefficient_per_m);
  EXPECT_EQ(chlorophyll.sources.size(), 1U);
}

TEST(OpticalTable, KnowsTheWavelengthsOfLight) {
  const auto scene = scene_of({iop_layer()}, all_channels);
  const auto nm = wavelengths_of_light(scene, library());
  ASSERT_EQ(nm.size(), 3U);
  EXPECT_EQ(nm[0], 532);
  EXPECT_NEAR(nm[1], 648.79, 5e-3);
  EXPECT_EQ(nm[2], 685);
  EXPECT_EQ(wavelengths_of_light(scene_of({iop_layer()}, {test::channel_of(Process::elastic)}),
                                 library()),
            (std::vector<double>{532}));
}

TEST(OpticalTable, RefusesWavelengthsWithoutData) {
  try {
    table_of({water_layer("pure", 0)}, {532, 1200});
    ADD_FAILURE() << "nothing was refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no water absorption data at 1200 nm"),
              std::string::npos);
  }
}

TEST(OpticalTable, ListsPhaseFunctionsFromForwardToBackward) {
  const auto angles = table_angles_deg();
  EXPECT_EQ(angles.size(), 66U);
  EXPECT_EQ(angles.front(), 0);
  EXPECT_EQ(angles.back(), 180);
  EXPECT_TRUE(std::ranges::is_sorted(angles, std::less_equal{}));
  EXPECT_NEAR(angles[1], 0.01, 1e-15);
}

}  // namespace
}  // namespace photic::medium
