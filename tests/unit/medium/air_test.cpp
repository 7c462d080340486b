// The air above the sea: its layers against closed forms and the profile they are made of.
#include "medium/air.hpp"
#include "medium/air_profile.hpp"

#include <cmath>

#include "medium/outside_column.hpp"
#include "optics/air_library.hpp"
#include "optics/air_molecules.hpp"
#include "unit/medium/scenes.hpp"

namespace photic::medium {
namespace {

/// A profile without aerosols.
scene::Atmosphere clear_air(const std::string& profile = "us-standard") {
  scene::Atmosphere air;
  air.profile = profile;
  air.aerosol = "none";
  return air;
}

scene::Atmosphere hazy_air(const std::string& aerosol, double visibility_km) {
  scene::Atmosphere air = clear_air();
  air.aerosol = aerosol;
  air.visibility_km = visibility_km;
  return air;
}

Air air_of(const scene::Atmosphere& atmosphere, const std::vector<double>& wavelengths_nm) {
  scene::Scene scene = test::ship_scene();
  scene.atmosphere = atmosphere;
  std::vector<Line> lines;
  for (const double nm : wavelengths_nm) {
    lines.emplace_back();
    lines.back().wavelength_nm = nm;
  }
  return build_air(scene, library(), lines).value();
}

/// From the sea up to a height.
double depth_to(const Air& air, double height_m) {
  double depth = 0;
  for (std::size_t k = 0; k < air.layers(); ++k) {
    const double top = std::min(height_m, air.height_m[k + 1]);
    if (top > air.height_m[k]) depth += (air.a[k] + air.b[k]) * (top - air.height_m[k]);
  }
  return depth;
}

TEST(Air, IsNoneWithoutAnAtmosphere) {
  EXPECT_FALSE(build_air(test::ship_scene(), library(), {Line{}}));
}

// Bodhaine et al. 1999 at 1013.25 hPa, as in docs/theory.md; the profile begins at 1013 hPa and has
// 0.02 % more, and the numbers have four digits: 0.1 %. Seen red: with heights in km; with lines
// and layers changed over.
TEST(Air, OfMoleculesHasTheirOpticalDepth) {
  const std::vector<std::pair<double, double>> expected{
      {355, 0.5937}, {400, 0.3602}, {532, 0.1112}, {550, 0.0971}};
  const Air air = air_of(clear_air(), {355, 400, 532, 550});
  ASSERT_EQ(air.b.size(), 4 * air.layers());
  EXPECT_EQ(air.height_m.front(), 0);
  EXPECT_EQ(air.height_m.back(), 100e3);
  for (std::size_t l = 0; l < expected.size(); ++l) {
    double depth = 0;
    for (std::size_t k = 0; k < air.layers(); ++k)
      depth += air.b[l * air.layers() + k] * (air.height_m[k + 1] - air.height_m[k]);
    EXPECT_NEAR(depth / expected[l].second, 1, 1e-3) << expected[l].first;
  }
  EXPECT_NEAR(air.depths->molecules / 0.5937, 1, 1e-3);
  EXPECT_NEAR(air.depths->molecules + air.depths->ozone + air.depths->aerosols,
              air.optical_depth(0), 1e-12);
  EXPECT_EQ(air.depths->aerosols, 0);
}

// Koschmieder 1924: 3.912 / V at 550 nm at the sea. In thick air the extinction is even up to 1 km;
// else it is exponential, and two layers belong to their lower end. LOWTRAN's tables obey it within
// 0.4 %. Seen red: with the visibility of 23 km for all.
TEST(Air, HasTheExtinctionOfItsVisibilityAtTheSea) {
  for (const double visibility_km : {5.0, 12.0, 23.0, 50.0}) {
    const Air air = air_of(hazy_air("maritime", visibility_km), {550});
    const double h0 = air.height_m[1] / 2, h1 = (air.height_m[1] + air.height_m[2]) / 2;
    const double first = air.a[0] + air.b[0], second = air.a[1] + air.b[1];
    const bool even = air.height_m[1] >= 1000;
    const double at_sea = even ? first : first * std::pow(first / second, h0 / (h1 - h0));
    EXPECT_NEAR(1e3 * at_sea / (3.912 / visibility_km), 1, 0.01) << visibility_km;
  }
}

/// Of the aerosols, from layers at 550 nm; the builder halves them for the laser's light.
double aerosol_depth_of(const scene::Atmosphere& atmosphere, double laser_nm) {
  scene::Scene scene = test::ship_scene();
  scene.atmosphere = atmosphere;
  std::vector<Line> lines(1);
  lines[0].wavelength_nm = laser_nm;
  double depth = 0;
  for (const auto& layer :
       AirBuilder(scene, library(), lines).at(scene, 550, optics::Phases::left_out).layers)
    depth +=
        (layer.aerosols_a_per_m + layer.aerosols_b_per_m) * 1e3 * (layer.top_km - layer.bottom_km);
  return depth;
}

/// Levels with aerosols of their own, of depth 0.27 below and 0.02 above.
scene::UserTable hazy_levels() {
  return {optics::DataTable::parse("z_km,p_hpa,t_k,boundary_layer_per_km,troposphere_per_km\n"
                                   "0,1013,288,0.2,0\n1,899,282,0.14,0\n2,795,275,0.06,0.02\n"
                                   "3,701,269,0,0.01\n9,308,230,0,0\n",
                                   "levels"),
          {"z_km", "p_hpa", "t_k", "boundary_layer_per_km", "troposphere_per_km"}};
}

// Whatever the layers are. Seen red: with the profile as its visibility has it; with all of it
// scaled and then cut at the top; with LOWTRAN's aerosols for those of the levels.
TEST(Air, HasTheAerosolOpticalDepthThatIsGiven) {
  for (const double laser_nm : {355.0, 532.0, 1064.0})
    for (const char* aerosol : {"rural", "maritime", "opac-ssam-80"})
      for (const double depth : {0.09, 0.2, 1.3}) {
        scene::Atmosphere air = clear_air("tropical");
        air.aerosol = aerosol;
        air.aerosol_optical_depth_550 = depth;
        EXPECT_NEAR(aerosol_depth_of(air, laser_nm) / depth, 1, 1e-9) << aerosol << laser_nm;
        EXPECT_NEAR(air_of(air, {laser_nm}).depths->aerosols_550 / depth, 1, 1e-9);
      }
  scene::Atmosphere low = clear_air();
  low.aerosol = "maritime";
  low.aerosol_optical_depth_550 = 0.2;
  low.top_km = 1.6;
  EXPECT_NEAR(aerosol_depth_of(low, 532), 0.2, 1e-9);
  scene::Atmosphere own = low;
  own.profile = hazy_levels();
  own.top_km = 9;
  EXPECT_NEAR(aerosol_depth_of(own, 532), 0.2, 1e-9);
  const optics::AirLibrary& tables = library().air();
  const auto scaled = as_deep_as_given(own, profile_to_top(own, whole_profile(own, tables)));
  EXPECT_EQ(scaled.aerosols_per_km[optics::troposphere][2], 0.02);
  EXPECT_LT(scaled.aerosols_per_km[optics::boundary_layer][1], 0.14);
}

// Layers are halved for the laser's light, and hold what the profile holds: at its edges aerosols
// go to 0 on straight lines. Seen red: with levels in the place of edges, exponential between them
// (1.169 of 1.170).
TEST(Air, HasAllTheAerosolsOfItsProfile) {
  for (const double visibility_km : {5.0, 23.0, 40.0})
    for (const double laser_nm : {355.0, 1064.0}) {
      const scene::Atmosphere air = hazy_air("maritime", visibility_km);
      const double whole =
          optics::aerosol_depth(profile_to_top(air, whole_profile(air, library().air())));
      EXPECT_NEAR(aerosol_depth_of(air, laser_nm) / whole, 1, 1e-9);
      EXPECT_NEAR(air_of(air, {laser_nm}).depths->aerosols_550 / whole, 1, 1e-9);
    }
}

// The same aerosols, of the visibility that is as deep. Seen red: with 50 km for the visibility
// whose aerosols are scaled.
TEST(Air, OfAnOpticalDepthIsThatOfItsVisibility) {
  const Air clear = air_of(hazy_air("maritime", 23), {532, 355});
  scene::Atmosphere deep = clear_air();
  deep.aerosol = "maritime";
  deep.aerosol_optical_depth_550 = clear.depths->aerosols_550;
  const Air air = air_of(deep, {532, 355});
  ASSERT_EQ(air.height_m, clear.height_m);
  for (std::size_t i = 0; i < air.b.size(); ++i) {
    EXPECT_NEAR(air.b[i] / clear.b[i], 1, 1e-12);
    EXPECT_NEAR(air.a[i], clear.a[i], 1e-12 * clear.b[i]);
  }
}

// What photic show says. Seen red: with four digits.
TEST(Air, ReportsItsAerosolsAt550Nm) {
  scene::Scene scene = test::ship_scene();
  scene.atmosphere = clear_air();
  scene.atmosphere->aerosol = "maritime";
  scene.atmosphere->aerosol_optical_depth_550 = 0.1234567;
  const auto air = build_air(scene, library(), {Line{.wavelength_nm = 532}}).value();
  const auto reported = reported_air(scene, air);
  EXPECT_EQ(std::ranges::count(reported, "optical depth of the aerosols at 550 nm: 0.1234567"), 1);
}

/// Levels at each km up to 20 km, in dry air.
scene::UserTable dry_levels() {
  std::string text = "z_km,p_hpa,t_k\n";
  for (int z = 0; z <= 20; ++z)
    text += std::to_string(z) + "," + std::to_string(1013 * std::exp(-z / 8.0)) + "," +
            std::to_string(288 - 3 * z) + "\n";
  return {optics::DataTable::parse(text, "levels"), {"z_km", "p_hpa", "t_k"}};
}

// Up to a height inside any layer, against the same profile in 64 parts of each. Aerosols would
// swell otherwise at other levels: the air is dry. Seen red: with the profile's own levels, which
// are 0.13 off.
TEST(Air, HasLayersThatAreThinEnough) {
  scene::Atmosphere hazy = hazy_air("rural", 5);
  hazy.profile = dry_levels();
  hazy.top_km = 20;
  const Air air = air_of(hazy, {355});
  const optics::AirLibrary& tables = library().air();
  optics::AirProfile fine = profile_to_top(hazy, whole_profile(hazy, tables));
  for (int halvings = 0; halvings < 6; ++halvings) {
    std::vector<double> middles;
    for (std::size_t i = 1; i < fine.edges_km.size(); ++i)
      middles.push_back((fine.edges_km[i - 1] + fine.edges_km[i]) / 2);
    fine = optics::with_edges(fine, middles);
  }
  double depth = 0, worst = 0;
  for (const auto& layer : optics::air_at(tables, fine, aerosols_of(hazy), 355).layers) {
    depth += (layer.a_per_m() + layer.b_per_m()) * 1e3 * (layer.top_km - layer.bottom_km);
    worst = std::max(worst, std::abs(depth_to(air, 1e3 * layer.top_km) - depth));
  }
  EXPECT_LT(worst, 1.1 * air_depth_tolerance);
  EXPECT_GT(worst, 0.1 * air_depth_tolerance);
}

// Seen red: with all layers that begin below the top.
TEST(Air, EndsAtItsTop) {
  scene::Atmosphere low = clear_air();
  low.top_km = 7.3;
  const Air air = air_of(low, {532});
  const optics::AirProfile whole = library().air().atmosphere("us-standard");
  EXPECT_DOUBLE_EQ(air.height_m.back(), 7300);
  const double column = optics::mean_between(whole.z_km, whole.air_per_m3, 0, 7.3) * 7300;
  EXPECT_NEAR(air.depths->molecules / (column * optics::air_scattering_m2(532)), 1, 1e-12);
}

/// What is scattered at a height in the laser's light.
double scattering_at(const Air& air, double height_m) {
  std::size_t k = 0;
  while (air.height_m[k + 1] <= height_m) ++k;
  return air.b[k];
}

// Tropospheric aerosols swell, too. Seen red: with rural aerosols for all; with the humidity at all
// levels.
TEST(Air, HasTheAerosolsAndTheHumidityOfTheBoundaryLayer) {
  const Air rural = air_of(hazy_air("rural", 23), {355});
  const Air maritime = air_of(hazy_air("maritime", 23), {355});
  EXPECT_GT(rural.a[0], 2 * maritime.a[0]);  // soot
  EXPECT_EQ(scattering_at(rural, 5500), scattering_at(maritime, 5500));
  scene::Atmosphere moist = hazy_air("maritime", 23);
  moist.relative_humidity_percent = 95;
  const Air swollen = air_of(moist, {355});
  EXPECT_GT(swollen.phase(0, 0)->mean_cosine(), maritime.phase(0, 0)->mean_cosine() + 0.01);
  EXPECT_EQ(scattering_at(swollen, 5500), scattering_at(maritime, 5500));
}

// n - 1 in proportion to the density: 2.78e-4 at 532 nm at the sea (Ciddor 1996), less by what is
// missing halfway up the lowest layer. Seen red: with the laser's light at all lines.
TEST(Air, BendsLightByItsDensity) {
  const Air air = air_of(clear_air(), {532, 355});
  const double fall = std::exp(-air.height_m[1] / 2 / 10.4e3);  // of the density, to 1 km
  EXPECT_NEAR((air.refractive_index[0] - 1) / (2.7821e-4 * fall), 1, 2e-3);
  EXPECT_NEAR((air.refractive_index[air.layers()] - 1) / (2.8571e-4 * fall), 1, 2e-3);
  EXPECT_LT(air.refractive_index[air.layers() - 1] - 1, 1e-9);
}

TEST(Air, NamesItsSourcesOnce) {
  const Air air = air_of(hazy_air("maritime", 23), {532, 650});
  std::vector<std::string> quantities;
  for (const Source& source : air.sources) {
    quantities.push_back(source.quantity);
    EXPECT_EQ(source.first_nm, 532);
    EXPECT_EQ(source.last_nm, 650);
  }
  EXPECT_EQ(quantities,
            (std::vector<std::string>{"profile of the air", "b of the air's molecules",
                                      "a of ozone", "a of other gases", "a and b of aerosols",
                                      "refractive index of the air"}));
}

scene::AirLayer own_layer(double bottom_m, double top_m, double b_per_m) {
  scene::AirLayer layer;
  layer.bottom_height_m = bottom_m;
  layer.top_height_m = top_m;
  layer.iop = {{500, 0.25 * b_per_m, b_per_m}, {600, 0.75 * b_per_m, 0.5 * b_per_m}};
  return layer;
}

// Seen red: with the lowest layer's values for all.
TEST(Air, OfOwnLayersIsWhatTheSceneSays) {
  scene::Atmosphere own;
  own.layer = {own_layer(0, 100, 1e-3), own_layer(100, 900, 2e-3)};
  own.layer[1].refractive_index = 1.5;
  own.layer[1].phase_function = henyey_greenstein(0.7);
  const Air air = air_of(own, {500, 550});
  EXPECT_EQ(air.height_m, (std::vector{0.0, 100.0, 900.0}));
  const std::vector<double> a{0.25e-3, 0.5e-3, 0.5e-3, 1e-3}, b{1e-3, 2e-3, 0.75e-3, 1.5e-3};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(air.a[i], a[i], 1e-15);
    EXPECT_NEAR(air.b[i], b[i], 1e-15);
  }
  EXPECT_EQ(air.refractive_index, (std::vector{1.0, 1.5, 1.0, 1.5}));
  ASSERT_EQ(air.phases.front().scatterers.size(), 2U);
  EXPECT_NEAR(air.phase(0, 0)->mean_cosine(), 0, 1e-4);  // molecules
  EXPECT_NEAR(air.phase(0, 1)->mean_cosine(), 0.7, 1e-3);
  EXPECT_NEAR(air.optical_depth(0), 1.25e-3 * 100 + 2.5e-3 * 800, 1e-12);
  EXPECT_FALSE(air.depths);
}

/// The laser's light and lines of chlorophyll's.
std::vector<Line> lines_of_chlorophyll(const std::vector<double>& emitted_nm) {
  std::vector<Line> lines(1);
  lines.front().wavelength_nm = 355;
  for (const double nm : emitted_nm)
    lines.push_back({.process = Process::chlorophyll, .wavelength_nm = nm});
  return lines;
}

// Lines that are not 25 nm apart share those halfway between them. Seen red: with the laser's phase
// functions for all lines; with those of the first line for all that share.
TEST(Air, ScattersEachLineByItsOwnPhaseFunctions) {
  const auto lines = lines_of_chlorophyll({640, 660, 700});
  for (const scene::Atmosphere& of : {hazy_air("rural", 5), clear_air()}) {
    scene::Scene scene = test::ship_scene();
    scene.atmosphere = of;
    const AirBuilder build(scene, library(), lines);
    const Air air = build(scene);
    EXPECT_EQ(air.phases_of, (std::vector<std::size_t>{0, 1, 1, 2}));
    ASSERT_EQ(air.phases.size(), 3U);
    const std::vector<double> nm{355, 650, 700};
    for (std::size_t i = 0; i < nm.size(); ++i) {
      const optics::PhaseTable own(build.at(scene, nm[i], optics::Phases::wanted).layers[0].phase);
      for (const double x : {0.01, 0.5, 1.5})
        EXPECT_DOUBLE_EQ(air.phase(i, 0)->view().value(x), own.view().value(x)) << nm[i];
    }
  }
}

// Seen red: with phase functions of their own for all lines.
TEST(Air, OfLayersGivenWithPhaseFunctionsHasThemForAllLines) {
  scene::Scene scene = test::ship_scene();
  scene.atmosphere = scene::Atmosphere{};
  auto& layers = scene.atmosphere->layer = {own_layer(0, 100, 1e-3)};
  const auto phases = [&] {
    const auto lines = lines_of_chlorophyll({540, 580});
    return AirBuilder(scene, library(), lines)(scene).phases.size();
  };
  layers[0].iop[0].wavelength_nm = 300;
  EXPECT_EQ(phases(), 3U);  // of molecules
  layers[0].phase_function = henyey_greenstein(0.7);
  EXPECT_EQ(phases(), 1U);
}

/// A rung of a ladder of gases.
scene::AirGases rung(double top_km, const std::string& depths) {
  return {top_km,
          {optics::DataTable::parse("wavelength_nm,optical_depth\n" + depths, "gases.csv"),
           {"wavelength_nm", "optical_depth"}}};
}

// Up to each rung, which is an edge of layers, and evenly between; above the last nothing more.
// Seen red: with rungs that are no edges; with each rung's depth from the one below it on.
TEST(Air, HasTheGasesOfItsLadder) {
  scene::Atmosphere dry = hazy_air("rural", 23), damp = dry;
  damp.gases = {rung(1.7, "500,0.1\n700,0.3\n"), rung(5.2, "500,0.2\n700,0.3\n")};
  const Air without = air_of(dry, {532, 650}), air = air_of(damp, {532, 650});
  const auto gases_up_to = [&](double height_m, std::size_t line) {
    return column_to(air, height_m).optical_depth[line] -
           column_to(without, height_m).optical_depth[line];
  };
  // Aerosols swell by the humidity halfway up each layer, and there are two more edges.
  constexpr double by_layers = 2e-3;
  EXPECT_NEAR(gases_up_to(1700, 0), 0.1 + 0.2 * 32 / 200, by_layers);
  EXPECT_NEAR(gases_up_to(850, 0), (0.1 + 0.2 * 32 / 200) / 2, by_layers);
  EXPECT_NEAR(gases_up_to(5200, 0), 0.2 + 0.1 * 32 / 200, by_layers);
  EXPECT_NEAR(gases_up_to(90e3, 0), 0.2 + 0.1 * 32 / 200, by_layers);
  EXPECT_NEAR(gases_up_to(1700, 1), 0.25, by_layers);
  EXPECT_NEAR(gases_up_to(5200, 1), 0.275, by_layers);
  EXPECT_NEAR(air.depths->gases, 0.2 + 0.1 * 32 / 200, 1e-12);
  for (const double edge : {1700.0, 5200.0})
    EXPECT_EQ(std::ranges::count(air.height_m, edge), 1) << edge;
}

}  // namespace
}  // namespace photic::medium
