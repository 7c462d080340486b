// Scene -> TOML -> Scene, to the last bit; the look of what is written.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "unit/scene/base_scene.hpp"

namespace photic::scene {
namespace {

Scene read_back(const std::string& text) {
  return read_scene_text(text, "written.toml", "/").scene;
}

/// To the last bit: -0.0 equals 0.0, but is not written like it.
void expect_reads_back(const Scene& scene) {
  const std::string text = write_scene(scene);
  const Scene again = read_back(text);
  EXPECT_TRUE(again == scene) << text;
  EXPECT_EQ(write_scene(again), text);
}

/// Every optional key that can stand beside the others, with numbers that have no short decimal.
std::vector<Override> everything() {
  return {
      "title=With \"quotes\", \\ and ünïcode",
      "source.wavelength_nm=532.1000000000001",
      "source.direction=[1e-17, -0.0, -0.3333333333333333]",
      "source.half_divergence_mrad=4.9e-324",
      "telescope.0.detector_shift_m=-0.1",
      "telescope.0.obstruction_diameter_m=0.1",
      "optics={ set = \"paper\", phytoplankton_phase = \"petzold\", water_depolarisation = 0.1 }",
      "sea.salinity_psu=0.1",
      "sea.temperature_c=-1.7",
      "sea.refractive_index=1.334",
      "sea.group_index=1.3637999999999999",
      "sea.surface={ model = \"cox-munk\", wind_speed_m_s = 7.000000000000001, wind_direction_deg "
      "= "
      "-0.1, slick = true, gram_charlier = false, whitecaps = true, whitecap_fraction = 1e-300, "
      "whitecap_law = \"stramska2003\", whitecap_reflectance = \"frouin1996\" }",
      "sea.layer.0.name=top",
      "sea.layer.0.cdom_a440_per_m=0.30000000000000004",
      "sea.layer.0.cdom_slope_per_nm=1e-5",
      "sea.layer.0.chlorophyll_yield=0.02",
      "sea.layer.0.minerals_g_m3=0.7000000000000001",
      "optics.minerals_b_exponent=-0.30000000000000004",
      "sea.layer.1.iop=[{ wavelength_nm = 500, a_per_m = 1e-300, b_per_m = 1 }, { wavelength_nm "
      "= 700, a_per_m = 0.4, b_per_m = 0.1, a_phytoplankton_per_m = 0.1 }]",
      "sea.layer.1.phase_function={ model = \"mixture\", components = [{ fraction = 0.9, model = "
      "\"fournier-forand\", refractive_index = 1.1, slope = 3.5835 }, { fraction = 0.1, model = "
      "\"mixture\", components = [{ fraction = 0.7, model = \"rayleigh\", depolarisation = 0.039 "
      "}, { fraction = 0.3, model = \"mie\", absorption_index = 1e-9, max_radius_um = "
      "0.30000000000000004 }] }] }",
      "sea.layer.1.bottom_depth_m=60",
      "atmosphere={ profile = \"tropical\", aerosol = \"opac-sscm-80\", visibility_km = "
      "7.000000000000001, season = \"fall-winter\", relative_humidity_percent = 1e-300, top_km = "
      "30.000000000000004 }",
      "gates.depth_min_m=-0.7",
      "simulation.target_relative_error=0.01",
      "simulation.max_time_s=1e9",
      "simulation.max_order=50",
      "simulation.orders_kept=4",
      "simulation.seed=9223372036854775807",
      "simulation.directed_fraction=0",
      "simulation.conversion_probability=0.123456789012345678"};
}

// Seen red: numbers with 15 digits; optional keys not written.
TEST(Write, ReadsBackToTheLastBit) {
  expect_reads_back(base_scene(everything()));
  const Scene scene = read_back(write_scene(base_scene(everything())));
  EXPECT_EQ(scene.title, "With \"quotes\", \\ and ünïcode");
  EXPECT_EQ(scene.source.wavelength_nm, 532.1000000000001);
  EXPECT_EQ(scene.source.direction, (Vec3<double>{1e-17, -0.0, -0.3333333333333333}));
  EXPECT_EQ(scene.source.half_divergence_mrad, 4.9e-324);
  EXPECT_EQ(scene.sea.group_index, 1.3637999999999999);
  const Surface& surface = scene.sea.surface;
  EXPECT_EQ(surface.model, SurfaceModel::cox_munk);
  EXPECT_EQ(surface.wind_speed_m_s, 7.000000000000001);
  EXPECT_EQ(surface.wind_direction_deg, -0.1);
  EXPECT_TRUE(surface.slick);
  EXPECT_FALSE(surface.gram_charlier);
  EXPECT_EQ(surface.whitecap_fraction, 1e-300);
  EXPECT_EQ(surface.whitecap_law, WhitecapLaw::stramska2003);
  EXPECT_EQ(surface.whitecap_reflectance, WhitecapReflectance::frouin1996);
  EXPECT_EQ(scene.sea.layer[0].cdom_a440_per_m, 0.1 + 0.2);
  EXPECT_EQ(scene.sea.layer[1].iop[0].a_per_m, 1e-300);
  EXPECT_EQ(scene.sea.layer[1].phase_function->components[1].components[0].depolarisation, 0.039);
  const auto& spheres = scene.sea.layer[1].phase_function->components[1].components[1].particles;
  EXPECT_EQ(spheres.absorption_index, 1e-9);
  EXPECT_EQ(spheres.max_radius_um, 0.1 + 0.2);
  EXPECT_EQ(scene.simulation.seed, 9223372036854775807U);
  EXPECT_EQ(scene.simulation.conversion_probability, 0.123456789012345678);
}

TEST(Write, KeepsEveryScene) {
  std::size_t scenes = 0;
  for (const auto& file : std::filesystem::directory_iterator(PHOTIC_SOURCE_DIR "/scenes")) {
    if (file.path().extension() != ".toml") continue;
    SCOPED_TRACE(file.path());
    const Reading reading = read_scene(file.path().string());
    EXPECT_EQ(reading.remarks, std::vector<std::string>{});
    expect_reads_back(reading.scene);
    ++scenes;
  }
  EXPECT_GE(scenes, 14U);
}

TEST(Write, KeepsTheOtherWaysOfSayingThings) {
  for (const std::vector<Override>& overrides : std::vector<std::vector<Override>>{
           {"telescope=[{ position_m = [0, 0, 12], direction = [0, 0, -1], diameter_m = 0.4, "
            "focal_length_m = 2, half_field_of_view_mrad = 10 }]"},
           {"telescope.0.focus_m=12.100000000000001"},
           {"channel=[{ name = \"green\", centre_nm = 532, fwhm_nm = 3 }]"},
           {"gates={ range_min_m = 10, range_max_m = 20, range_step_m = 0.1 }"},
           {"gates={ start_ns = 90, stop_ns = 200, step_ns = 2 }"},
           {"sea.layer.1.phase_function=petzold"},
           {"sea.layer.1.phase_function={ model = \"table\", file = { angle_deg = [0, 180], "
            "phase_function_per_sr = [0.1, 0.06] } }"},
           {"simulation={ max_time_s = 5 }"},
           {"sea.surface={ model = \"gaussian\", upwind_slope_variance = 0.1, "
            "crosswind_slope_variance = 0 }"},
           {"sea.surface={ model = \"paper\", wind_speed_m_s = 5 }"},
           {"sea.layer.0={ jerlov = \"5C\", bottom_depth_m = 20 }"},
           {"optics.phytoplankton=table",
            "optics.phytoplankton_file={ wavelength_nm = [500, 600], a_m2_per_mg = [1, 2], "
            "b_m2_per_mg = [1, 2] }"},
           {"optics.set=paper", "sea.layer.0.chlorophyll_mg_m3=0"}}) {
    SCOPED_TRACE(overrides.front());
    EXPECT_FALSE(base_scene(overrides) == base_scene());
    expect_reads_back(base_scene(overrides));
  }
}

TEST(Write, TomlIsPleasantToRead) {
  EXPECT_EQ(write_scene(base_scene()), R"(title = "Base"

[source]
kind = "laser"
wavelength_nm = 532.0
position_m = [0.0, 0.0, 12.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.04
half_divergence_mrad = 5.0
profile = "disc"

[[telescope]]
name = "t"
position_m = [0.0, 0.0, 12.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.4
focal_length_m = 2.0
detector_diameter_m = 0.04
detector_shift_m = 0.0
obstruction_diameter_m = 0.0

[[channel]]
name = "elastic"
process = "elastic"

[optics]
set = "modern"
water_absorption = "mason-ioccg"
water_scattering = "zhang"
water_depolarisation = 0.039
phytoplankton = "bricaud"
phytoplankton_phase = "fournier-forand"
minerals = "power-law"
minerals_a_443_m2_per_g = 0.041
minerals_a_slope_per_nm = 0.0123
minerals_b_555_m2_per_g = 0.5
minerals_b_exponent = 0.5
minerals_phase = "fournier-forand"
raman = "bartlett"
emission = "lines"
chlorophyll_share_730 = 0.0
cdom_fluorescence = "hawes"
chlorophyll_lifetime_ns = 0.0
cdom_lifetime_ns = 0.0

[sea]
salinity_psu = 35.0
temperature_c = 20.0
surface = { model = "flat" }

[[sea.layer]]
name = "layer0"
bottom_depth_m = 20.0
chlorophyll_mg_m3 = 0.1
cdom_a440_per_m = 0.0
cdom_slope_per_nm = 0.017
minerals_g_m3 = 0.0
chlorophyll_yield = 0.01

[[sea.layer]]
name = "layer1"
iop = [{ wavelength_nm = 532.0, a_per_m = 0.06, b_per_m = 0.1, a_phytoplankton_per_m = 0.0, a_cdom_per_m = 0.0 }]
phase_function = { model = "henyey-greenstein", g = 0.9 }
chlorophyll_yield = 0.01

[gates]
depth_min_m = 0.0
depth_max_m = 50.0
depth_step_m = 1.0
depth_cells = 100

[simulation]
estimator = "auto"
photons = 1000000
orders_kept = 6
seed = 1
reception = "ray"
sampling = "quasi-random"
keep_groups = true

[simulation.tools]
forced_collisions = 0
local_forced_collisions = "conversions"
weight_threshold = 0.1
at_threshold = "roulette"
)");
}

TEST(Write, SeveralInlineTablesTakeALineEach) {
  const std::string text = write_scene(base_scene(
      {"sea.layer.1.iop=[{ wavelength_nm = 500, a_per_m = 0, b_per_m = 1 }, { wavelength_nm = 600, "
       "a_per_m = 0.5, b_per_m = 1, a_phytoplankton_per_m = 0.25 }]",
       "sea.layer.1.phase_function={ model = \"mixture\", components = [{ fraction = 1, model = "
       "\"petzold\" }] }"}));
  EXPECT_NE(text.find(R"(
iop = [
  { wavelength_nm = 500.0, a_per_m = 0.0, b_per_m = 1.0, a_phytoplankton_per_m = 0.0, a_cdom_per_m = 0.0 },
  { wavelength_nm = 600.0, a_per_m = 0.5, b_per_m = 1.0, a_phytoplankton_per_m = 0.25, a_cdom_per_m = 0.0 },
]
phase_function = { model = "mixture", components = [{ fraction = 1.0, model = "petzold" }] }
)"),
            std::string::npos)
      << text;
}

TEST(Write, JsonSaysTheSameInTheSameOrder) {
  const Scene scene =
      base_scene({"title=a \"b\" \\c é", "optics.set=paper", "optics.phytoplankton_phase=petzold"});
  const auto written = nlohmann::ordered_json::parse(write_scene_json(scene));
  EXPECT_EQ(written["title"], "a \"b\" \\c é");
  EXPECT_EQ(written["source"]["position_m"], nlohmann::ordered_json({0.0, 0.0, 12.0}));
  EXPECT_EQ(written["telescope"][0]["name"], "t");
  EXPECT_EQ(written["optics"]["raman"], "marshall-smith");
  EXPECT_EQ(written["sea"]["layer"][0]["chlorophyll_mg_m3"], 0.1);
  EXPECT_EQ(written["sea"]["layer"][1]["iop"][0]["b_per_m"], 0.1);
  EXPECT_EQ(written["simulation"]["photons"], 1'000'000);
  std::vector<std::string> sections;
  for (const auto& [key, value] : written.items()) sections.push_back(key);
  EXPECT_EQ(sections, (std::vector<std::string>{"title", "source", "telescope", "channel", "optics",
                                                "sea", "gates", "simulation"}));
}

}  // namespace
}  // namespace photic::scene
