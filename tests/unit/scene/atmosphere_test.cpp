// The air of a scene: what is filled in, and what is said of air that is amiss.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "unit/scene/air_scene.hpp"

namespace photic::scene {
namespace {

constexpr const char* one_layer =
    "[[atmosphere.layer]]\n"
    "bottom_height_m = 0\n"
    "top_height_m = 100\n"
    "iop = [{ wavelength_nm = 532, a_per_m = 0, b_per_m = 1e-4 }]";
constexpr const char* levels = "{ z_km = [0, 9], p_hpa = [1000, 300], t_k = [290, 230] }";

/// A file of levels in a folder of its own.
struct LevelsFile {
  std::string path;
  explicit LevelsFile(const std::string& name, const std::string& text)
      : path(::testing::TempDir() + name) {
    std::ofstream(path) << text;
  }
  [[nodiscard]] std::vector<Override> overrides() const {
    return {{"atmosphere={ profile = \"" + path + "\", top_km = 9 }"}};
  }
};

/// The base scene with this section before [gates], which is line 26.
Texts with_section(const std::string& section) {
  return diagnostics_of(edited({{25, 25, base_lines()[24] + "\n" + section}}));
}

// --- What is filled in ---------------------------------------------------------------------------

TEST(Atmosphere, IsAVacuumByItself) { EXPECT_FALSE(base_scene().atmosphere); }

// Seen red: with a visibility filled in beside aerosol = "none"; beside an optical depth.
TEST(Atmosphere, HasTheAirOfTheLandOnAClearDay) {
  const Atmosphere air = *base_scene({us_standard}).atmosphere;
  EXPECT_EQ(std::get<std::string>(air.profile), "us-standard");
  EXPECT_EQ(air.aerosol, "rural");
  EXPECT_EQ(air.visibility_km, 23);
  EXPECT_EQ(air.season, "spring-summer");
  EXPECT_FALSE(air.relative_humidity_percent);
  EXPECT_EQ(air.top_km, 100);
  EXPECT_TRUE(air.layer.empty());
  EXPECT_FALSE(base_scene({us_standard, {"atmosphere.aerosol=none"}}).atmosphere->visibility_km);
  const Atmosphere deep =
      *base_scene({us_standard, {"atmosphere.aerosol_optical_depth_550=0.2"}}).atmosphere;
  EXPECT_EQ(deep.aerosol_optical_depth_550, 0.2);
  EXPECT_FALSE(deep.visibility_km);
}

// Seen red: with LOWTRAN's visibility in place of the aerosols of the levels.
TEST(Atmosphere, OfLevelsWithAerosolsKeepsThem) {
  const auto visibility_km = [](const std::string& more) {
    const std::string all = std::string(levels).substr(0, std::string(levels).size() - 2) + more;
    return base_scene({{"atmosphere={ profile = " + all + " } }"}}).atmosphere->visibility_km;
  };
  EXPECT_EQ(visibility_km(""), 23);
  EXPECT_FALSE(visibility_km(", boundary_layer_per_km = [0.1, 0]"));
  EXPECT_FALSE(visibility_km(", upper_atmosphere_per_km = [0, 0]"));
}

// --- Written and read ----------------------------------------------------------------------------

void expect_written_as_read(const std::vector<Override>& overrides) {
  const Scene scene = base_scene(overrides);
  ASSERT_TRUE(scene.atmosphere);
  EXPECT_EQ(read_text(write_scene(scene)), scene);
  EXPECT_EQ(scene_alone(scene).atmosphere, scene.atmosphere);
}

// Seen red: with scene_alone without the air.
TEST(Atmosphere, IsWrittenAsItWasRead) {
  expect_written_as_read({us_standard});
  expect_written_as_read(
      {{"atmosphere={ profile = \"tropical\", aerosol = \"maritime\", visibility_km = 40, season = "
        "\"fall-winter\", relative_humidity_percent = 80, top_km = 60 }"}});
  expect_written_as_read({us_standard, {"atmosphere.aerosol_optical_depth_550=0.2"}});
  expect_written_as_read(
      {{"atmosphere={ layer = [{ bottom_height_m = 0, top_height_m = 30, iop = [{ wavelength_nm = "
        "532, a_per_m = 0, b_per_m = 1e-4 }], refractive_index = 1.0003, phase_function = { model "
        "= \"henyey-greenstein\", g = 0.7 } }, { name = \"fog\", bottom_height_m = 30, "
        "top_height_m = 50, iop = [{ wavelength_nm = 532, a_per_m = 0.1, b_per_m = 1 }] }] }"}});
  EXPECT_EQ(base_scene({{"atmosphere={ layer = [{ bottom_height_m = 0, top_height_m = 30, iop = "
                         "[{ wavelength_nm = 532, a_per_m = 0, b_per_m = 0 }] }] }"}})
                .atmosphere->layer[0]
                .name,
            "air0");
}

/// The numbers of a column.
std::vector<double> column_of(const Scene& scene, const std::string& name) {
  for (const auto& column : std::get<UserTable>(scene.atmosphere->profile).columns())
    if (column.name == name) return column.values;
  return {};
}

// The written scene needs no file.
TEST(Atmosphere, OfACsvKeepsItsNumbers) {
  const LevelsFile file("photic-air.csv",
                        "z_km,p_hpa,t_k,ozone_per_cm3\n0,1000,290,6e11\n9,300,230,9e11\n");
  expect_written_as_read(file.overrides());
  const Scene scene = base_scene(file.overrides());
  EXPECT_EQ(column_of(scene, "ozone_per_cm3"), (std::vector{6e11, 9e11}));
  EXPECT_EQ(column_of(scene, "water_vapour_per_cm3"), std::vector<double>{});
  EXPECT_EQ(scene.atmosphere->visibility_km, 23);
}

Texts remarks_of(const std::string& text, const std::vector<Override>& overrides = {}) {
  return read_scene_text(text, "scene.toml", "/", overrides).remarks;
}

// The written scene needs no gap. Seen red: without the remarks of a table.
TEST(Atmosphere, OfACsvFollowsAHumidityThatIsMissing) {
  const LevelsFile file("photic-gap.csv",
                        "z_km,p_hpa,t_k,relative_humidity_percent\n0,1000,290,80\n2,790,278,\n"
                        "4,615,265,40\n9,300,230,30\n");
  expect_written_as_read(file.overrides());
  EXPECT_EQ(column_of(base_scene(file.overrides()), "relative_humidity_percent"),
            (std::vector{80.0, 60.0, 40.0, 30.0}));
  EXPECT_EQ(remarks_of(edited({}), file.overrides()),
            Texts{"--set atmosphere: " + file.path +
                  ": relative_humidity_percent is missing at 1 of 4 levels, the first at 2 km: "
                  "there it follows from the levels beside it"});
}

// In the layout of LOWTRAN 7, with numbers of its own. Seen red: with air in molecules per m3.
TEST(Atmosphere, OfATape6HasItsLevelsAndAerosols) {
  const LevelsFile file(
      "photic-tape6",
      "1                    ***** LOWTRAN 7 *****\n"
      "  ATMOSPHERIC PROFILES\n\n"
      "   I     Z       P       T     MOL SCAT  O3 (UV)\n"
      "        (KM)    (MB)    (K)       (-)  (ATM CM/KM)\n\n"
      "   1      .00 1010.000  290.0  9.400E-01 2.500E-03\n"
      "   2    90.00     .000  187.0  2.600E-06 1.800E-07\n"
      "1\n"
      "  ATMOSPHERIC PROFILES\n\n"
      "   I     Z       P       T     AEROSOL 1 AEROSOL 2 AEROSOL 3 AEROSOL 4         RH\n"
      "        (KM)    (MB)    (K)       (-)       (-)       (-)       (-)      (PERCNT)\n\n"
      "   1      .00 1010.000  290.0  1.200E-01 0.000E+00 0.000E+00 0.000E+00 7.550E+01\n"
      "   2    90.00     .000  187.0  0.000E+00 2.100E-02 0.000E+00 0.000E+00          \n");
  expect_written_as_read(file.overrides());
  const Scene scene = base_scene(file.overrides());
  EXPECT_FALSE(scene.atmosphere->visibility_km);
  EXPECT_EQ(column_of(scene, "z_km"), (std::vector{0.0, 90.0}));
  EXPECT_EQ(column_of(scene, "p_hpa"), (std::vector{1010.0, 1e-12}));  // 0 is no pressure
  EXPECT_NEAR(column_of(scene, "air_per_cm3")[0], 0.94 * 2.6867801e19, 1e13);
  EXPECT_EQ(column_of(scene, "relative_humidity_percent"), (std::vector{75.5, 75.5}));
  EXPECT_EQ(column_of(scene, "boundary_layer_per_km"), (std::vector{0.12, 0.0}));
  EXPECT_EQ(column_of(scene, "troposphere_per_km"), (std::vector{0.0, 0.021}));
  EXPECT_EQ(remarks_of(edited({}), file.overrides()),
            Texts{"--set atmosphere: " + file.path +
                  ": RH is missing at 1 of 2 levels, the first at 90 km: there it follows from the "
                  "levels beside it"});
}

// A tape7 has the transmittance of all there is: molecules, ozone and aerosols are taken out.
// Where it prints 0, gases are as good as opaque. Seen red: with the aerosols left in.
TEST(Atmosphere, OfGasesHasWhatATape7AbsorbsBesides) {
  const std::string head =
      "T F 1    2    0    0    1    1    1    1    1    1    1    0    0   0.000   0.00\n"
      "    FREQ COMBIN    H2O     O3 MOLEC AER+CLD\n"
      "    CM-1  TRANS  TRANS  TRANS  SCAT   TRANS\n";
  const LevelsFile file("photic-tape7", head +
                                            "14000.00 0.0000 0.0000 0.9900 0.9900 0.9000\n"
                                            "16000.00 0.4000 0.6000 0.9900 0.9500 0.8000\n"
                                            "19000.00 0.7500 1.0000 0.9900 0.9000 0.8500\n"
                                            " -9999.\n");
  const std::vector<Override> overrides{
      {"atmosphere={ profile = \"us-standard\", gases = [{ top_km = 3, file = \"" + file.path +
       "\" }, { top_km = 9, file = { wavelength_nm = [500, 700], optical_depth = [0.1, 0.5] } }] "
       "}"}};
  expect_written_as_read(overrides);
  const auto gases = base_scene(overrides).atmosphere->gases;
  ASSERT_EQ(gases.size(), 2U);
  EXPECT_EQ(gases[1].top_km, 9);
  const auto nm = gases[0].depth.data().numbers("wavelength_nm"),
             depth = gases[0].depth.data().numbers("optical_depth");
  ASSERT_EQ(nm.size(), 3U);
  EXPECT_NEAR(nm[0], 1e7 / 19000, 1e-9);
  EXPECT_NEAR(depth[0], -std::log(0.75 / (0.99 * 0.9 * 0.85)), 1e-12);
  EXPECT_NEAR(depth[1], -std::log(0.4 / (0.99 * 0.95 * 0.8)), 1e-12);
  EXPECT_EQ(depth[2], 99);
}

// --- What is said of bad air ---------------------------------------------------------------------

struct AirCase {
  std::string section;
  Texts expected;
};

const std::vector<AirCase>& profile_cases() {
  const static std::string head = "[atmosphere]\n", us = head + "profile = \"us-standard\"\n";
  static const std::vector<AirCase> all{
      {head, {"scene.toml:26:1: [atmosphere] needs 'profile' or 'layer'"}},
      {us + one_layer,
       {"scene.toml:28:14: 'profile' and 'layer' exclude each other in [atmosphere] (keep one of "
        "them)"}},
      {head + "profile = \"us-standart\"",
       {"scene.toml:27:11: 'profile' must be \"us-standard\", \"tropical\", "
        "\"midlatitude-summer\", \"midlatitude-winter\", \"subarctic-summer\" or "
        "\"subarctic-winter\", not text \"us-standart\", and no file (did you mean "
        "'us-standard'?)"}},
      {head + "profile = \"/no/air.csv\"",
       {"scene.toml:27:11: 'profile' names a file that cannot be read: /no/air.csv (a relative "
        "path starts at the scene file)"}},
      {head + "profile = 3",
       {"scene.toml:27:11: 'profile' must be a word, a file or a table, not 3"}},
      {head + "profile = { z_km = [0, 9], p_hpa = [1000, 300] }",
       {"scene.toml:27:11: 't_k' is missing in 'profile' (add it: the temperature in K)"}},
      {head + "profile = { z_km = [0, 9], p_hpa = [1000, 300], t_k = [290, 230, 220] }",
       {"scene.toml:27:11: 'profile' has columns of different lengths: z_km 2, p_hpa 2, t_k 3 "
        "(give one number a row in each)"}},
      {us +
           "[[atmosphere.gases]]\ntop_km = 2\nfile = { wavelength_nm = [500, 700], optical_depth = "
           "[0, 0] }\n[[atmosphere.gases]]\ntop_km = 2\nfile = { wavelength_nm = [500, 700], "
           "optical_depth = [0, 0] }\n[[atmosphere.gases]]\ntop_km = 101\nfile = { wavelength_nm "
           "= [500, 700], optical_depth = [0, 0] }",
       {"scene.toml:32:10: 2 km is not above the 2 km before it (rungs go from the sea up)",
        "scene.toml:35:10: 101 km is above the top of the air at 100 km (leave it out, or write a "
        "higher top_km)"}},
      {us + "[[atmosphere.gases]]\ntop_km = 2",
       {"scene.toml:28:1: 'file' is missing in [[atmosphere.gases]] (add it: a tape7 of LOWTRAN 7 "
        "or MODTRAN with the transmittances of that way, a CSV file of wavelength_nm, "
        "optical_depth, or a table of these)"}},
      {us + "visibility_km = 0.1",
       {"scene.toml:28:17: 'visibility_km' must be a finite number, at least 0.2 and at most 300, "
        "not 0.1"}},
      {us + "visibility_km = 23000",
       {"scene.toml:28:17: 'visibility_km' must be a finite number, at least 0.2 and at most 300, "
        "not 23000 (did you mean 23? 23000 would be in m)"}},
      {us + "aerosol_optical_depth_550 = -0.1",
       {"scene.toml:28:29: 'aerosol_optical_depth_550' must be a finite number, at least 0 and at "
        "most 5, not -0.1"}},
      {us + "aerosol_optical_depth_550 = 5.1",
       {"scene.toml:28:29: 'aerosol_optical_depth_550' must be a finite number, at least 0 and at "
        "most 5, not 5.1"}},
      {us + "aerosol_optical_depth_550 = 0.2\nvisibility_km = 23",
       {"scene.toml:28:29: it takes the place of visibility_km, which is also given (leave one of "
        "them out)"}},
      {us + "aerosol = \"none\"\naerosol_optical_depth_550 = 0.2",
       {"scene.toml:29:29: aerosol = \"none\" says that there are no aerosols (leave one of them "
        "out)"}},
      {us + "aerosol_optical_depth = 0.2",
       {"scene.toml:28:1: unknown key 'aerosol_optical_depth' in [atmosphere] (did you mean "
        "'aerosol_optical_depth_550'?)"}},
      {us + "relative_humidity_percent = 101",
       {"scene.toml:28:29: 'relative_humidity_percent' must be a finite number, at least 0 and at "
        "most 100, not 101"}},
      {us + "relative_humidity_percent = -1",
       {"scene.toml:28:29: 'relative_humidity_percent' must be a finite number, at least 0 and at "
        "most 100, not -1"}},
      {us + "season = \"monsoon\"",
       {"scene.toml:28:10: 'season' must be \"spring-summer\" or \"fall-winter\", not text "
        "\"monsoon\" (choose from: spring-summer, fall-winter)"}},
      {us + "top_km = 0",
       {"scene.toml:28:10: 'top_km' must be a finite number, greater than 0, not 0"}},
      {us + "aerosol = \"none\"\nvisibility_km = 23",
       {"scene.toml:29:17: aerosol = \"none\" says that there are no aerosols (leave one of them "
        "out)"}},
      {us + "gases = true",
       {"scene.toml:28:9: 'gases' must be one or more tables, not true (write "
        "[[atmosphere.gases]])"}},
      {us + "refraction = 1", {"scene.toml:28:14: 'refraction' must be true or false, not 1"}},
  };
  return all;
}

// Seen red: without the second key in check_aerosols(); with a depth beside "none" passed over.
TEST(Atmosphere, EveryTextOfAProfileThatIsWrong) {
  for (const AirCase& c : profile_cases()) EXPECT_EQ(with_section(c.section), c.expected);
}

/// A layer between two heights.
std::string layer(const std::string& bottom, const std::string& top, const std::string& more = "") {
  return "[[atmosphere.layer]]\nbottom_height_m = " + bottom + "\ntop_height_m = " + top +
         "\niop = [{ wavelength_nm = 532, a_per_m = 0, b_per_m = 1e-4 }]\n" + more;
}

const std::vector<AirCase>& layer_cases() {
  static const std::vector<AirCase> all{
      {layer("0", "10") + layer("10", "20"), {}},
      {"[atmosphere]\nrefraction = true\n" + layer("0", "10", "refractive_index = 1.0005\n"), {}},
      {"[atmosphere]\nrefraction = true\n" + layer("0", "10", "refractive_index = 1.2\n"),
       {"scene.toml:32:20: air of such an index bends light too much: with refraction it can be "
        "1.001 at most (write a lower index, or leave atmosphere.refraction out)"}},
      {layer("1", "10"),
       {"scene.toml:27:19: the air begins at 1 m, not at the sea (write bottom_height_m = 0)"}},
      {layer("0", "10") + layer("11", "20"),
       {"scene.toml:31:19: there is a gap in the air from 10 to 11 m (write bottom_height_m = "
        "10)"}},
      {layer("0", "10") + layer("9", "20"),
       {"scene.toml:31:19: the layer begins at 9 m, below 10 m, where the one below it ends (write "
        "bottom_height_m = 10)"}},
      {layer("0", "10") + layer("10", "10"),
       {"scene.toml:32:16: the layer ends at 10 m, not above 10 m, where it begins (layers go from "
        "the sea up)"}},
      {layer("-1", "10"),
       {"scene.toml:27:19: 'bottom_height_m' must be a finite number, at least 0, not -1"}},
      {layer("0", "10", "refractive_index = 0.9997"),
       {"scene.toml:30:20: 'refractive_index' must be a finite number, at least 1 and at most 2, "
        "not 0.9997"}},
      {layer("0", "10", "phase_function = \"mie\""),
       {"scene.toml:30:18: the spheres of \"mie\" are in water, and not in air (take another "
        "model, or a table)"}},
      {"[[atmosphere.layer]]\nbottom_height_m = 0\ntop_height_m = 9\niop = [{ wavelength_nm = 532, "
       "a_per_m = -1e-4, b_per_m = -1 }]",
       {"scene.toml:29:41: 'a_per_m' must be a finite number, at least 0, not -0.0001",
        "scene.toml:29:58: 'b_per_m' must be a finite number, at least 0, not -1"}},
      {"[[atmosphere.layer]]\nbottom_height_m = 0\ntop_height_m = 9\niop = [{ wavelength_nm = 532, "
       "a_per_m = 0, b_per_m = 1 }, { wavelength_nm = 355, a_per_m = 0, b_per_m = 1 }]",
       {"scene.toml:29:77: 355 nm does not come after 532 nm (sort the iop by ascending "
        "wavelength, each once)"}},
      {"[[atmosphere.layer]]\nbottom_height_m = 0\ntop_height_m = 9",
       {"scene.toml:26:1: 'iop' is missing in [[atmosphere.layer]] (add it: absorption and "
        "scattering by ascending wavelength)"}},
  };
  return all;
}

// Seen red: without check_heights; with the gap and the overlap changed over.
TEST(Atmosphere, EveryTextOfLayersThatAreWrong) {
  for (const AirCase& c : layer_cases()) EXPECT_EQ(with_section(c.section), c.expected);
}

// Values that are possible, but more likely to be in another unit. Seen red: each, without the
// lines that find it.
TEST(Atmosphere, EveryRemarkOnUnits) {
  const auto remarks = [](const std::string& section) {
    return remarks_of(edited({{25, 25, base_lines()[24] + "\n" + section}}));
  };
  const std::string us = "[atmosphere]\nprofile = \"us-standard\"\n";
  EXPECT_EQ(remarks(us + "relative_humidity_percent = 0.8"),
            Texts{"scene.toml:28:29: 0.8 % is very dry: is it a fraction? 0.8 of saturation would "
                  "be 80"});
  EXPECT_EQ(remarks(us + "relative_humidity_percent = 1").size(), 1U);
  EXPECT_EQ(remarks(us + "relative_humidity_percent = 0"), Texts{});
  EXPECT_EQ(remarks(us + "relative_humidity_percent = 1.1"), Texts{});
  EXPECT_EQ(remarks(us + "visibility_km = 200"),
            Texts{"scene.toml:28:17: air of 200 km visibility is hardly ever seen: is it in m?"});
  EXPECT_EQ(remarks(us + "visibility_km = 100"), Texts{});
  EXPECT_EQ(remarks(layer("0", "10", "refractive_index = 2\n")),
            Texts{"scene.toml:30:20: no air has a refractive index of 2: at the sea it is 1.0003"});
  EXPECT_EQ(remarks(layer("0", "10", "refractive_index = 1.001\n")), Texts{});
  EXPECT_EQ(remarks("[atmosphere]\nrefraction = true\n" +
                    layer("0", "10", "refractive_index = 1.0003\n")),
            Texts{});
  const auto iop = [&](const std::string& b) {
    return remarks(
        "[[atmosphere.layer]]\nbottom_height_m = 0\ntop_height_m = 9\niop = [{ "
        "wavelength_nm = 500, a_per_m = 0, b_per_m = 0 }, { wavelength_nm = 600, "
        "a_per_m = 0.001, b_per_m = " +
        b + " }]");
  };
  EXPECT_EQ(iop("0.158"),
            Texts{"scene.toml:29:7: an extinction of 0.159 per m is that of the densest fog, of 25 "
                  "m visibility: is it in 1/km?"});
  EXPECT_EQ(iop("0.099"), Texts{});
}

TEST(Atmosphere, EveryTextOfWhatDoesNotGoWithIt) {
  const auto reported = [](const std::vector<Override>& more) {
    std::vector<Override> all{us_standard};
    all.insert(all.end(), more.begin(), more.end());
    return diagnostics_of(edited({}), all);
  };
  for (const std::string in_water :
       {"source.position_m=[0, 0, -1]", "telescope.0.position_m=[0, 0, -1]"})
    EXPECT_EQ(reported({{"gates={ start_ns = 0, stop_ns = 100, step_ns = 1 }"}, {in_water}}),
              Texts{});
  EXPECT_EQ(reported({{"oil={ class = \"light-refined\", thickness_um = 1 }"}}), Texts{});
  EXPECT_EQ(reported({{"simulation.tools.forced_collisions=2"}}), Texts{});
  EXPECT_EQ(reported({{"simulation.estimator=forward"}, {"simulation.reception=overlap"}}),
            Texts{"--set simulation.reception: light that [atmosphere] scatters close to the lens "
                  "lights it unevenly: the mean over the lens is not known (write reception = "
                  "\"ray\")"});
  EXPECT_EQ(reported({{"source.position_m=[0, 0, 7e5]"}, {"telescope.0.position_m=[0, 0, 7e5]"}}),
            Texts{});  // above the top
}

}  // namespace
}  // namespace photic::scene
