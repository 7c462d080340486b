// What the optics find wrong with a scene: all of it, each with line and column.
#include "medium/check.hpp"

#include <random>

#include "unit/medium/checked_scenes.hpp"

namespace photic::medium {
namespace {

using scene::Case;

const std::string clear_layer = "chlorophyll_mg_m3 = 0";

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"LaserOutsideSingleIop",
       {{24, 24, "iop = [{ wavelength_nm = 533.5, a_per_m = 0.06, b_per_m = 0.1 }]"}},
       {R"(scene.toml:24:7: the iop of layer "layer1" covers 532.5 to 534.5 nm, not 532 nm; the source emits there (add an entry for it))"}},
      {"LaserOutsideIop",
       {{24, 24,
         "iop = [{ wavelength_nm = 400, a_per_m = 0.06, b_per_m = 0.1 }, { wavelength_nm = 531.9, "
         "a_per_m = 0.06, b_per_m = 0.1 }]"}},
       {R"(scene.toml:24:7: the iop of layer "layer1" covers 400 to 531.9 nm, not 532 nm; the source emits there (add an entry for it))"}},
      {"RamanOutsideIop",
       {{16, 17, raman_channel}},
       {R"(scene.toml:24:7: the iop of layer "layer1" covers 531 to 533 nm, not 648.793 nm; channel "r" counts raman light there (add an entry for it))"}},
      {"FilterOutsideIop",
       {{17, 17, "centre_nm = 685\nfwhm_nm = 10"}},
       {R"(scene.toml:25:7: the iop of layer "layer1" covers 531 to 533 nm, not 685 nm; channel "elastic" counts chlorophyll light there (add an entry for it))"}},
      {"LaserAndRamanOutsideTwoIops",
       {{16, 17, raman_channel},
        {22, 22,
         "iop = [{ wavelength_nm = 530, a_per_m = 0.06, b_per_m = 0.1 }]\nphase_function = "
         "\"petzold\""}},
       {R"(scene.toml:22:7: the iop of layer "layer0" covers 529 to 531 nm, not 532 nm; the source emits there (add an entry for it))",
        R"(scene.toml:22:7: the iop of layer "layer0" covers 529 to 531 nm, not 648.793 nm; channel "r" counts raman light there (add an entry for it))",
        R"(scene.toml:25:7: the iop of layer "layer1" covers 531 to 533 nm, not 648.793 nm; channel "r" counts raman light there (add an entry for it))"}},
      {"LaserWithoutWaterData",
       {{3, 3, "wavelength_nm = 730.0"},
        {18, 18, "[optics]\nwater_absorption = \"pope-fry\""},
        {22, 25, clear_layer + "\n[[sea.layer]]\n" + clear_layer}},
       {"scene.toml:3:17: no water absorption data at 730 nm: " + library().pope_fry_a.source +
        " cover 380-727.5 nm (choose another wavelength, or give the layer's iop at this one)"}},
      {"LaserWithoutPhytoplanktonData",
       {{3, 3, "wavelength_nm = 810.0"}, {23, 25, ""}},
       {"scene.toml:3:17: no phytoplankton absorption data at 810 nm: " +
        library().particles_a.source +
        " cover 300-800 nm (choose another wavelength, or give the layer's iop at this one)"}},
      {"LaserWithoutSmithBaker",
       {{3, 3, "wavelength_nm = 810.0"},
        {18, 18, "[optics]\nset = \"paper\""},
        {22, 25, clear_layer}},
       {"scene.toml:3:17: no water absorption data at 810 nm: " + library().smith_baker_a.source +
            " cover 200-800 nm (choose another wavelength, or give the layer's iop at this one)",
        "scene.toml:3:17: no water scattering data at 810 nm: " + library().smith_baker_b.source +
            " cover 200-800 nm (choose another wavelength, or give the layer's iop at this one)"}},
      {"SpheresWithoutIndex",
       {{3, 3, "wavelength_nm = 1200.0"},
        {22, 25,
         "iop = [{ wavelength_nm = 1200, a_per_m = 0.06, b_per_m = 0.1 }]\nphase_function = "
         "\"mie\""}},
       {"scene.toml:3:17: no refractive index data at 1200 nm: Quan & Fry 1995, Appl. Opt. 34, "
        "3477, eq. (3) [verified] cover 200-1100 nm (choose another wavelength, or give "
        "refractive_index and group_index of the sea)"}},
      {"SpheresTooLarge",
       {{25, 25,
         "phase_function = { model = \"mie\", relative_index = 1.5, absorption_index = 0, "
         "min_radius_um = 19.9, max_radius_um = 19.9001 }"}},
       {"scene.toml:25:18: the phase function of these spheres has detail that is too fine: as "
        "tabulated by the program it integrates to 1.00015, not 1; at 532 nm: the source emits "
        "there "
        "(take smaller spheres, or a wider range of sizes)"}},
      {"LaserWithoutAnything",
       {{3, 3, "wavelength_nm = 1200.0"}},
       {"scene.toml:3:17: no refractive index data at 1200 nm: Quan & Fry 1995, Appl. Opt. 34, "
        "3477, eq. (3) [verified] cover 200-1100 nm (choose another wavelength, or give "
        "refractive_index and group_index of the sea)",
        "scene.toml:3:17: no water absorption data at 1200 nm: Mason 2016 / IOCCG 2018 cover "
        "200-1100 nm (choose another wavelength, or give the layer's iop at this one)",
        "scene.toml:3:17: no water scattering data at 1200 nm: Zhang, Hu & He 2009, Opt. Express "
        "17, 5698 [verified] cover 200-1100 nm (choose another wavelength, or give the layer's iop "
        "at this one)",
        "scene.toml:3:17: no phytoplankton absorption data at 1200 nm: " +
            library().particles_a.source +
            " cover 300-800 nm (choose another wavelength, or give the layer's iop at this one)",
        "scene.toml:24:7: the iop of layer \"layer1\" covers 531 to 533 nm, not 1200 nm; the "
        "source "
        "emits there (add an entry for it)"}},
      {"RamanWithoutWaterData",
       {{3, 3, "wavelength_nm = 760.0"},
        {16, 17, raman_channel},
        {18, 18, "[optics]\nwater_absorption = \"ioccg\""},
        {22, 25, clear_layer}},
       {"scene.toml:17:11: no water absorption data at 1001.41 nm: " + library().ioccg_a.source +
        " cover 200-1000 nm; channel \"r\" counts raman light there (choose another wavelength, or "
        "give the layer's iop at this one)"}},
      {"FilteredRamanWithoutIndex",
       {{3, 3, "wavelength_nm = 880.0"},
        {17, 17, "centre_nm = 1253\nfwhm_nm = 10"},
        {20, 24,
         "[[sea.layer]]\niop = [{ wavelength_nm = 800, a_per_m = 2, b_per_m = 0.1 }, { "
         "wavelength_nm = 1300, a_per_m = 9, b_per_m = 0.1 }]"}},
       {R"(scene.toml:17:13: no refractive index data at 1253.15 nm: Quan & Fry 1995, Appl. Opt. 34, 3477, eq. (3) [verified] cover 200-1100 nm; channel "elastic" counts raman light there (choose another wavelength, or give refractive_index and group_index of the sea))"}},
      {"EmitsMoreThanItAbsorbs",
       {{16, 17, raman_channel},
        {20, 24,
         "[[sea.layer]]\niop = [{ wavelength_nm = 530, a_per_m = 0.0001, b_per_m = 0.1 }, { "
         "wavelength_nm = 660, a_per_m = 0.0001, b_per_m = 0.1 }]"}},
       {R"(scene.toml:21:7: layer "layer0" emits more Raman and fluorescence light (0.000171 1/m) than it absorbs (0.0001 1/m) (a is the total absorption, and includes the light that is emitted at other wavelengths))"}},
      {"WaterEmitsMoreThanItAbsorbs",
       {{3, 3, "wavelength_nm = 355.0"},
        {16, 17, raman_channel},
        {22, 25, clear_layer + "\n[[sea.layer]]\nchlorophyll_yield = 1"}},
       {R"(scene.toml:20:1: layer "layer0" emits more Raman and fluorescence light (0.00146 1/m) than it absorbs (0.000975 1/m) (choose other data in [optics], or give the layer's iop))",
        R"(scene.toml:24:21: layer "layer1" emits more Raman and fluorescence light (0.00146 1/m) than it absorbs (0.000975 1/m) (choose other data in [optics], or give the layer's iop))"}},
      {"LaserOutsideAJerlovType",
       {{3, 3, "wavelength_nm = 405.0"}, {22, 25, "jerlov = \"II\""}},
       {"scene.toml:22:10: no Jerlov water type data at 405 nm: " +
        library().jerlov.of_type.at("II").a.source +
        " cover 420-700 nm; the source emits there (choose another wavelength, or give the layer's "
        "iop at this one)"}},
      {"LaserOutsideWhitecaps",
       {{3, 3, "wavelength_nm = 355.0"},
        {19, 19,
         "[sea]\nsurface = { model = \"cox-munk\", wind_speed_m_s = 5, whitecap_reflectance = "
         "\"frouin1996\" }"},
        {22, 25, clear_layer}},
       {"scene.toml:20:76: no whitecap reflectance data at 355 nm: " +
        library().whitecaps_frouin.source +
        " cover 412-865 nm; the source emits there (write whitecap_reflectance = \"koepke1984\", "
        "or "
        "whitecaps = false)"}},
      {"RamanOutsideWhitecaps",
       {{3, 3, "wavelength_nm = 700.0"},
        {16, 17, raman_channel},
        {19, 19,
         "[sea]\nsurface = { model = \"paper\", wind_speed_m_s = 5, whitecaps = true, "
         "whitecap_reflectance = \"frouin1996\" }"},
        {22, 25, clear_layer}},
       {"scene.toml:20:91: no whitecap reflectance data at 877.954 nm: " +
        library().whitecaps_frouin.source +
        " cover 412-865 nm; channel \"r\" counts raman light there (write whitecap_reflectance = "
        "\"koepke1984\", or whitecaps = false)"}},
      {"LaserAndRamanOutsideWhitecaps",
       {{3, 3, "wavelength_nm = 355.0"},
        {16, 17, raman_channel},
        {18, 18, "[optics]\nemission = \"lines\""},
        {19, 19,
         "[sea]\nsurface = { model = \"gaussian\", upwind_slope_variance = 0.1, "
         "crosswind_slope_variance = 0, whitecap_fraction = 0.1, whitecap_reflectance = "
         "\"frouin1996\" }"},
        {22, 25, "chlorophyll_mg_m3 = 1"}},
       {"scene.toml:21:140: no whitecap reflectance data at 355 nm: " +
            library().whitecaps_frouin.source +
            " cover 412-865 nm; the source emits there (write whitecap_reflectance = "
            "\"koepke1984\", or whitecaps = false)",
        "scene.toml:21:140: no whitecap reflectance data at 403.466 nm: " +
            library().whitecaps_frouin.source +
            " cover 412-865 nm; channel \"r\" counts raman light there (write "
            "whitecap_reflectance = \"koepke1984\", or whitecaps = false)"}},
      {"MoreMineralsThanANumberCanSay",
       {{18, 18, "[optics]\nminerals_b_555_m2_per_g = 100"}, {22, 25, "minerals_g_m3 = 1e308"}},
       {R"(scene.toml:21:1: layer "layer0" attenuates 532 nm more than a number can hold; the source emits there (are the units right?))"}},
      {"BeyondAllNumbers",
       {{20, 25,
         "[[sea.layer]]\ncdom_a440_per_m = 1e308\ncdom_slope_per_nm = 0\nbottom_depth_m = "
         "20\n[[sea.layer]]\niop = [{ wavelength_nm = 532, a_per_m = 1e308, b_per_m = 1e308 "
         "}]\nphase_function = \"petzold\""}},
       {R"(scene.toml:25:7: layer "layer1" attenuates 532 nm more than a number can hold; the source emits there (are the units right?))"}},
  };
  return all;
}

TEST(CheckMedium, EveryTextWithLineAndColumn) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(problems(c.edits), c.expected);
  }
}

// Koepke's are known wherever water's optics are; of a wind of 0, of slicks and with whitecaps =
// false nobody asks.
TEST(CheckMedium, AsksForWhitecapsWhereThereAreAny) {
  const auto reported = [](const std::string& keys, const Texts& overrides = {}) {
    return problems({{3, 3, "wavelength_nm = 355.0"},
                     {19, 19, "[sea]\nsurface = { model = \"cox-munk\", " + keys + " }"},
                     {22, 25, clear_layer}},
                    overrides);
  };
  const std::string frouin = ", whitecap_reflectance = \"frouin1996\"";
  EXPECT_EQ(reported("wind_speed_m_s = 5"), Texts{});
  EXPECT_EQ(reported("wind_speed_m_s = 0" + frouin), Texts{});
  EXPECT_EQ(reported("wind_speed_m_s = 5, whitecaps = false" + frouin), Texts{});
  EXPECT_EQ(reported("wind_speed_m_s = 5, slick = true" + frouin), Texts{});
  EXPECT_EQ(reported("wind_speed_m_s = 6, whitecap_law = \"stramska2003\"" + frouin), Texts{});
  EXPECT_EQ(reported("wind_speed_m_s = 7, whitecap_law = \"stramska2003\"" + frouin).size(), 1U);
  const Texts of_set =
      reported("wind_speed_m_s = 5", {"sea.surface.whitecap_reflectance=frouin1996"});
  ASSERT_EQ(of_set.size(), 1U);
  EXPECT_TRUE(of_set[0].starts_with("--set sea.surface.whitecap_reflectance: no whitecap "))
      << of_set[0];
  // Once, with environments and derivatives too.
  EXPECT_EQ(
      problems(
          {{3, 3, "wavelength_nm = 355.0"},
           {19, 19, "[sea]\nsurface = { model = \"cox-munk\", wind_speed_m_s = 5" + frouin + " }"},
           {22, 25, clear_layer},
           {30, 30,
            "photons = 1\n[[environment]]\nset = { \"sea.layer.0.chlorophyll_mg_m3\" = "
            "1 }"}})
          .size(),
      1U);
}

TEST(CheckMedium, NamesTheSetThatAsksForIt) {
  EXPECT_EQ(
      problems({{22, 25, clear_layer}},
               {"optics.water_absorption=ioccg", "source.wavelength_nm=1064"}),
      Texts{"--set source.wavelength_nm: no water absorption data at 1064 nm: " +
            library().ioccg_a.source +
            " cover 200-1000 nm (choose another wavelength, or give the layer's iop at this one)"});
}

// Not what follows from it: Raman light of 1663 nm has no data either.
TEST(CheckMedium, ReportsAWrongLaserOnce) {
  EXPECT_EQ(problems({{3, 3, "wavelength_nm = 1064.0"},
                      {16, 17, raman_channel},
                      {18, 18, "[optics]\nwater_absorption = \"ioccg\""},
                      {22, 25, clear_layer}})
                .size(),
            1U);
}

// With all else that is wrong, in the order of the file.
TEST(CheckMedium, ReportsWithAllElse) {
  const Texts expected{
      R"(scene.toml:24:7: the iop of layer "layer1" covers 532.5 to 534.5 nm, not 532 nm; the source emits there (add an entry for it))",
      "scene.toml:28:16: 'depth_step_m' must be a finite number, greater than 0, not -1"};
  EXPECT_EQ(problems({{24, 24, "iop = [{ wavelength_nm = 533.5, a_per_m = 0.06, b_per_m = 0.1 }]"},
                      {28, 28, "depth_step_m = -1"}}),
            expected);
}

// One finding each: nothing is concluded from what is refused. Seen red: with bad channels kept;
// with iop that do not ascend asked for; with phytoplankton of a bad file asked for.
TEST(CheckMedium, LooksOnlyAtGoodValues) {
  const std::vector<std::vector<scene::Edit>> each_wrong_once{
      {{3, 3, "wavelength_nm = -1"}},
      {{3, 3, ""}},
      {{17, 17, "process = \"ramam\""}},
      {{17, 17, ""}},
      {{17, 17, "centre_nm = 532"}},
      {{17, 17, "centre_nm = 532\nfwhm_nm = -1"}},
      {{17, 17, "process = \"raman\"\ncentre_nm = 649\nfwhm_nm = 5"}},
      {{18, 18, "[optics]\nset = \"old\""}},
      {{18, 18, "[optics]\nwater_absorption = \"none\""}},
      {{18, 18, "[optics]\nphytoplankton = \"table\""}},
      {{18, 18, "[optics]\nphytoplankton = \"table\"\nphytoplankton_file = \"/no/such.csv\""}},
      {{18, 18, "[optics]\nminerals = \"sand\""}},
      {{22, 22, "minerals_g_m3 = -1"}},
      {{22, 22, "jerlov = \"IV\""}},
      {{19, 19, "[sea]\nrefractive_index = 0"}},
      {{18, 25, "[sea]\nlayer = 3"}},
      {{20, 25, ""}},
      {{22, 22, "chlorophyll_mg_m3 = -1"}},
      {{22, 22, "chlorophyll_mg_m3 = 1\nchlorophyll_yield = 2"}},
      {{24, 24, "iop = []"}},
      {{24, 24,
        "iop = [{ wavelength_nm = 700, a_per_m = 1, b_per_m = 1 }, { wavelength_nm = 600, "
        "a_per_m = 1, b_per_m = 1 }]"}},
      {{25, 25, "phase_function = { model = \"table\", file = \"/no/such.csv\" }"}},
      {{25, 25, "phase_function = { model = \"henyey-greenstein\", g = 2 }"}},
  };
  for (const auto& edits : each_wrong_once)
    EXPECT_EQ(problems(edits).size(), 1U)
        << edited(edits) << ::testing::PrintToString(problems(edits));
}

TEST(CheckMedium, RemarksOnChannelsThatCountNothing) {
  EXPECT_EQ(remarks({}), Texts{});
  EXPECT_EQ(remarks({{16, 17, "name = \"c\"\nprocess = \"chlorophyll\""}, {22, 25, clear_layer}}),
            Texts{"scene.toml:17:11: channel \"c\" will count nothing: no layer emits chlorophyll "
                  "light"});
  EXPECT_EQ(remarks({{16, 17, "name = \"c\"\nprocess = \"chlorophyll\""}, {23, 25, ""}}), Texts{});
}

// Missing tables of Photic do not hide what is wrong with the scene.
TEST(CheckMedium, ComesAfterTheSceneWhereTheDataAreMissing) {
  const scene::Check no_data = [](const scene::Scene&, scene::Findings&, scene::Asked) {
    throw EnvironmentError("no data");
  };
  EXPECT_EQ(scene::diagnostics_of(edited({{28, 28, "depth_step_m = -1"}}), {}, no_data).size(), 1U);
  EXPECT_THROW(scene::diagnostics_of(edited({}), {}, no_data), EnvironmentError);
}

/// Lines of a scene drawn from what is often at the border of the data.
std::string random_scene(std::mt19937& random) {
  const auto pick = [&](const std::vector<std::string>& from) {
    return from[random() % from.size()];
  };
  const auto iop = [&] {
    const std::string nm = pick({"399", "500", "532", "640"});
    return "iop = [{ wavelength_nm = " + nm + ", a_per_m = " + pick({"1e-4", "0.1"}) +
           ", b_per_m = 0.1, a_phytoplankton_per_m = " + pick({"0", "1e-4"}) + " }" +
           pick({"", ", { wavelength_nm = 660, a_per_m = 0.4, b_per_m = 0.1 }",
                 ", { wavelength_nm = 1300, a_per_m = 4, b_per_m = 0.1 }"}) +
           "]\nphase_function = " +
           pick({"\"petzold\"", "{ model = \"henyey-greenstein\", g = 0.9999 }",
                 "{ model = \"henyey-greenstein\", g = -0.4 }",
                 "{ model = \"fournier-forand\", refractive_index = 1.005, slope = 4.999 }",
                 "\"mie\"",
                 "{ model = \"mixture\", components = [{ fraction = 0.3333333, model = "
                 "\"isotropic\" }, { fraction = 0.6666666, model = \"petzold\" }] }"});
  };
  const auto layer = [&]() -> std::string {
    if (random() % 8 == 0) return "[[sea.layer]]\njerlov = " + pick({"\"IB\"", "\"5C\""});
    return "[[sea.layer]]\n" + (random() % 2 == 0
                                    ? iop()
                                    : "chlorophyll_mg_m3 = " + pick({"0", "0.1", "30"}) +
                                          "\nminerals_g_m3 = " + pick({"0", "2"}) +
                                          "\nchlorophyll_yield = " + pick({"0", "0.01", "1"}));
  };
  const std::string surface =
      "surface = { model = \"cox-munk\", wind_speed_m_s = 9, gram_charlier = false, "
      "whitecap_reflectance = \"";
  const std::string channel =
      pick({"process = \"elastic\"", "process = \"raman\"", "process = \"chlorophyll\"",
            "centre_nm = 660\nfwhm_nm = 60", "centre_nm = 1000\nfwhm_nm = 700"});
  return edited({{3, 3,
                  "wavelength_nm = " + pick({"199", "299", "301", "400", "532", "640", "700", "760",
                                             "810", "950", "1064", "1101", "3000"})},
                 {17, 17, channel},
                 {18, 19,
                  "[optics]\nset = " + pick({"\"modern\"", "\"paper\""}) +
                      pick({"", "\nwater_absorption = \"ioccg\"",
                            "\nwater_absorption = \"pope-fry\"\nwater_scattering = \"morel\""}) +
                      "\nminerals = \"power-law\"\nminerals_phase = \"petzold\"" +
                      "\nphytoplankton_phase = " + pick({"\"petzold\"", "\"mie\""}) + "\n[sea]\n" +
                      pick({"", "refractive_index = 1.33\ngroup_index = 1.35"}) + "\n" +
                      pick({"", "", surface + "koepke1984\" }", surface + "frouin1996\" }"})},
                 {20, 25, layer() + "\nbottom_depth_m = 20\n" + layer()}});
}

// What the check accepts can be built, and what it refuses cannot. Seen red: without the check of
// the indices; of the emitted lines; of the balance; of whitecaps.
TEST(CheckMedium, AgreesWithTheBuild) {
  std::mt19937 random(7);
  int accepted = 0, refused = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::string text = random_scene(random);
    const bool good = scene::diagnostics_of(text, {}, check).empty();
    const auto scene = scene::read_scene_text(text, "scene.toml", "/").scene;
    good ? ++accepted : ++refused;
    if (good)
      EXPECT_NO_THROW(medium_of(scene)) << text;
    else
      EXPECT_THROW(medium_of(scene), InputError) << text;
  }
  EXPECT_GT(accepted, 100);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace photic::medium
