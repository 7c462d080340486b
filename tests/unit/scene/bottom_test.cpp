// The sea bed: the forms of its albedo, what is wrong with them, and what they mean.
#include <fmt/format.h>

#include <cmath>

#include "scene/bed_albedo.hpp"
#include "scene/compare.hpp"
#include "unit/scene/written_files.hpp"

namespace photic::scene {
namespace {

/// The base scene with a bed at 60 m: [bottom] is line 27, and the value begins at 28:10.
std::string over_bed(const std::string& albedo, const std::string& depth = "60") {
  return edited(
      {{25, 25,
        base_lines()[24] + "\nbottom_depth_m = " + depth + "\n[bottom]\nalbedo = " + albedo}});
}

constexpr const char* spectrum =
    "{ wavelength_nm = [400, 532.1, 700], albedo = [0.1, 0.30000000000000004, 0.2] }";
constexpr const char* angles = "{ zenith_deg = [0, 30, 90], albedo = [0.1, 0.2, 0.4] }";
constexpr const char* both =
    "{ wavelength_nm = [500, 500, 600, 600], zenith_deg = [0, 90, 0, 90], "
    "albedo = [0.1, 0.2, 0.3, 0.8] }";

double albedo(const std::string& text, double nm, double deg) {
  return albedo_of(*read_text(over_bed(text)).bottom, nm, deg);
}

// Seen red, each for itself: with [bottom] left out of what is written; with a table written as a
// number; with beds that are all equal; with the section required.
TEST(Bottom, IsWrittenAsItIs) {
  EXPECT_FALSE(base_scene().bottom);
  EXPECT_EQ(write_scene(base_scene()).find("bottom]"), std::string::npos);
  for (const char* form : {"0", "0.1", "1", spectrum, angles, both}) {
    SCOPED_TRACE(form);
    const Scene scene = read_text(over_bed(form));
    ASSERT_TRUE(scene.bottom);
    const Scene again = read_text(write_scene(scene));
    EXPECT_TRUE(again == scene) << write_scene(scene);
    EXPECT_EQ(write_scene(again), write_scene(scene));
    EXPECT_EQ(differences(scene, again), std::vector<Difference>{});
  }
  EXPECT_NE(write_scene(read_text(over_bed(spectrum)))
                .find("\n[bottom]\nalbedo = { wavelength_nm = [400.0, 532.1, 700.0], albedo = "
                      "[0.1, 0.30000000000000004, 0.2] }\n"),
            std::string::npos);
  EXPECT_NE(write_scene_json(read_text(over_bed("0.1"))).find("\"bottom\": {"), std::string::npos);
  EXPECT_EQ(differences(read_text(over_bed("0.1")), read_text(over_bed("0.2"))),
            (std::vector<Difference>{{"bottom.albedo", "0.1", "0.2"}}));
  EXPECT_FALSE(read_text(over_bed("0.1")) == read_text(over_bed(angles)));
}

// Seen red, each for itself: with rows read by angle, then wavelength; with as many angles as rows;
// with the nearest row in place of the line between two.
TEST(Bottom, AlbedoIsLinearBetweenTheRows) {
  EXPECT_EQ(albedo("0.3", 1064, 90), 0.3);
  EXPECT_DOUBLE_EQ(albedo(spectrum, 532.1, 45), 0.1 + 0.2);
  EXPECT_DOUBLE_EQ(albedo(spectrum, 466.05, 0), 0.2);
  EXPECT_DOUBLE_EQ(albedo(spectrum, 700, 90), 0.2);
  EXPECT_DOUBLE_EQ(albedo(angles, 1064, 0), 0.1);
  EXPECT_DOUBLE_EQ(albedo(angles, 1064, 60), 0.3);
  EXPECT_DOUBLE_EQ(albedo(angles, 1064, 90), 0.4);
  EXPECT_DOUBLE_EQ(albedo(both, 500, 90), 0.2);
  EXPECT_DOUBLE_EQ(albedo(both, 600, 0), 0.3);
  EXPECT_DOUBLE_EQ(albedo(both, 550, 22.5), 0.75 * 0.2 + 0.25 * 0.5);
}

// Seen red, each for itself: with the end's value beyond the end; with the lower end let be.
TEST(Bottom, AlbedoOutsideASpectrumIsRefused) {
  for (const auto& [form, nm, text] :
       {std::tuple{spectrum, 399.9, "covers 400 to 700 nm, not 399.9 nm"},
        std::tuple{both, 600.5, "covers 500 to 600 nm, not 600.5 nm"}}) {
    try {
      static_cast<void>(albedo(form, nm, 0));
      ADD_FAILURE() << nm << " nm was not refused";
    } catch (const InputError& error) {
      EXPECT_EQ(error.diagnostics().front().reason, std::string("the sea bed's albedo ") + text);
    }
  }
}

// Seen red: with 0 and 90 degrees looked at alone.
TEST(Bottom, WhereOneBedReflectsAlone) {
  const auto bed = [](const char* text) { return read_text(over_bed(text)).bottom; };
  const auto dark_above_30 = bed("{ zenith_deg = [0, 30, 90], albedo = [0.1, 0, 0] }");
  const auto alone = angle_lit_by_one_alone;
  EXPECT_EQ(alone(bed("0.1"), bed("0.2"), 532), std::nullopt);
  EXPECT_EQ(alone(std::nullopt, bed("0.1"), 532), std::nullopt);
  EXPECT_EQ(alone(bed("0"), std::nullopt, 532), std::nullopt);
  EXPECT_EQ(alone(bed("0.1"), std::nullopt, 532), 0);
  EXPECT_EQ(alone(bed("0.1"), bed("0"), 532), 0);
  EXPECT_EQ(alone(bed(angles), dark_above_30, 532), 90);
  EXPECT_EQ(alone(dark_above_30, bed(angles), 532), std::nullopt);
  const auto dark_below_50 = bed("{ zenith_deg = [0, 50, 90], albedo = [0, 0, 0.1] }");
  EXPECT_EQ(alone(bed("{ zenith_deg = [0, 40, 90], albedo = [0, 0.1, 0] }"), dark_below_50, 532),
            40);
}

class BedOfAFile : public testing::Test {
 protected:
  [[nodiscard]] std::string sand(const std::string& text) const {
    files_.write("sand.csv", text);
    return over_bed("{ file = \"sand.csv\" }");
  }
  WrittenFiles files_{"sand"};
};

// Seen red, each for itself: with the source of a file that of a number; with a number written for
// the table.
TEST_F(BedOfAFile, IsTheTableInIt) {
  const Scene scene = files_
                          .read(sand("zenith_deg,albedo,wavelength_nm,note\n0,0.1,500,a\n"
                                     "90,0.2,500,b\n0,0.3,600,c\n90,0.8,600,d\n"))
                          .scene;
  EXPECT_TRUE(scene == read_text(over_bed(both)));
  EXPECT_TRUE(read_text(write_scene(scene)) == scene) << write_scene(scene);
  EXPECT_EQ(reported_albedo(*scene.bottom), "0.1 to 0.8, given in " + files_.path("sand.csv"));
  EXPECT_EQ(reported_albedo(*read_text(over_bed(both)).bottom), "0.1 to 0.8, given");
  EXPECT_EQ(reported_albedo(*read_text(over_bed("0.1")).bottom), "0.1, given");
  for (const char* rows :
       {"wavelength_nm,albedo\n500,0.1\n600,0.2\n", "zenith_deg,albedo\n0,0.1\n45,0.2\n90,0.3\n"}) {
    const Scene other = files_.read(sand(rows)).scene;
    EXPECT_TRUE(read_text(write_scene(other)) == other) << write_scene(other);
  }
}

// Seen red, each for itself: with a file of one column taken; with an angle missing at the end.
TEST_F(BedOfAFile, IsRefusedAtItsLine) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"wavelength_nm,albedo\n500,0.1\n600,1.2\n",
       "sand.csv:3:5: albedo 1.2 is above 1 (it is the share of the light that is reflected)"},
      {"zenith_deg,albedo\n0,0.1\n",
       "sand.csv:2:1: the angles end at 0 degrees, not at 90 (give the albedo from 0 to 90 "
       "degrees)"},
      {"wavelength_nm,zenith_deg,albedo\n500,0,0.1\n600,0,0.1\n",
       "sand.csv:3:1: wavelength_nm 500 has no row at every angle (give a row for each pair, "
       "sorted "
       "by wavelength, then angle)"},
      {"zenith_deg,albedo\n0,0.1\n90,-0.1\n", "sand.csv:3:4: albedo -0.1 is negative"},
      {"wavelength_nm,zenith_deg,albedo\n500,0,0.1\n500,90,0.1\n600,0,0.1\n",
       "sand.csv:4:5: every wavelength must have the same angles"},
      {"albedo\n0.1\n0.2\n",
       "sand.csv:1:1: no column wavelength_nm or zenith_deg (there are: albedo; the scene may name "
       "it: { file = …, wavelength = … })"},
      {"wavelength_nm,zenith_deg\n500,0\n600,1\n",
       "sand.csv:1:1: no column \"albedo\" (there are, between commas: wavelength_nm, zenith_deg; "
       "the scene may name it: { file = …, albedo = … })"}};
  for (const auto& [text, expected] : cases)
    EXPECT_EQ(files_.problems(sand(text)), Texts{expected});
  EXPECT_EQ(
      files_.problems(over_bed("{ file = \"no.csv\", zenith_deg = [0, 90] }")),
      (Texts{"scene.toml:28:19: 'file' names a file that cannot be read: no.csv (a relative "
             "path starts at the scene file)",
             "scene.toml:28:29: unknown key 'zenith_deg' in 'albedo' (did you mean 'zenith'?)"}));
}

// Seen red, each for itself: with albedos above 1 taken; angles above 90; any order of rows; angles
// from 10 on; to 80; other angles at each wavelength; one wavelength alone; a bed under a sea
// without one; problems reported at the table.
TEST(Bottom, EveryTextOfWhatIsWrong) {
  const std::string reflected = " (it is the share of the light that is reflected)";
  const std::string whole = " (give the albedo from 0 to 90 degrees)";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"1.5", "10: 'albedo' must be a finite number, at least 0 and at most 1, not 1.5"},
      {"-0.1", "10: 'albedo' must be a finite number, at least 0 and at most 1, not -0.1"},
      {"\"sand.csv\"",
       "10: 'albedo' must be a finite number, at least 0 and at most 1, not text \"sand.csv\" "
       "(a file is named in a table: { file = \"sand.csv\" })"},
      {"[0.1, 0.2]",
       "10: 'albedo' must be a finite number, at least 0 and at most 1, not [0.1, 0.2]"},
      {"{ albedo = [0.1, 0.2] }", "10: 'albedo' needs wavelength_nm or zenith_deg"},
      {"{ wavelength_nm = [400, 500] }",
       "10: 'albedo' is missing in 'albedo' (add it: the albedo there, 0 to 1)"},
      {"{ wavelength_nm = [400, 500], albedo = [0.1, 0.2, 0.3] }",
       "10: 'albedo' has columns of different lengths: wavelength_nm 2, albedo 3 (give one number "
       "a row in each)"},
      {"{ wavelength_nm = [400, 500], albedo = [0.1, 1.1] }",
       "55: albedo 1.1 is above 1" + reflected},
      {"{ wavelength_nm = [400, 500], albedo = [-0.1, 0.1] }", "50: albedo -0.1 is negative"},
      {"{ wavelength_nm = [500, 400], albedo = [0.1, 0.1] }",
       "34: wavelength_nm 400 is not above the 500 before it (this column must ascend)"},
      {"{ wavelength_nm = [0, 400], albedo = [0.1, 0.1] }", "29: a wavelength is above 0"},
      {"{ zenith_deg = [0, 95], albedo = [0.1, 0.1] }",
       "29: zenith_deg 95 is above 90 (0 is straight down, 90 along the bed)"},
      {"{ zenith_deg = [-5, 90], albedo = [0.1, 0.1] }", "26: zenith_deg -5 is negative"},
      {"{ zenith_deg = [0, 60, 30, 90], albedo = [0.1, 0.1, 0.1, 0.1] }",
       "33: zenith_deg 30 is not above the 60 before it (angles ascend)"},
      {"{ zenith_deg = [10, 90], albedo = [0.1, 0.1] }",
       "26: the angles begin at 10 degrees, not at 0" + whole},
      {"{ zenith_deg = [0, 80], albedo = [0.1, 0.1] }",
       "29: the angles end at 80 degrees, not at 90" + whole},
      {"{ wavelength_nm = [500, 500], zenith_deg = [0, 90], albedo = [0.1, 0.1] }",
       "34: there is only one wavelength (add others, or leave wavelength_nm out if the albedo is "
       "the same at all)"},
      {"{ wavelength_nm = [450, 532, 650], zenith_deg = [0, 45, 90], albedo = [0.1, 0.2, 0.3] }",
       "34: wavelength_nm 450 has no row at every angle (give a row for each pair, sorted by "
       "wavelength, then angle)"},
      {"{ wavelength_nm = [450, 532], albedo = [0.1, 0.2], colour = 1 }",
       "61: unknown key 'colour' in 'albedo' (known here: wavelength_nm, zenith_deg, albedo)"},
      {"{ zenith = [0, 90], albedo = [0.1, 0.2] }",
       "12: unknown key 'zenith' in 'albedo' (did you mean 'zenith_deg'?)"},
      {"{ wavelength_nm = [500, 500, 400, 400], zenith_deg = [0, 90, 0, 90], albedo = [0, 0, 0, 0] "
       "}",
       "39: wavelength_nm 400 comes after 500 (wavelengths ascend, all angles of one together)"},
      {"{ wavelength_nm = [500, 500, 600, 600], zenith_deg = [0, 90, 0, 80], albedo = [0, 0, 0, 0] "
       "}",
       "74: every wavelength must have the same angles"}};
  for (const auto& [form, expected] : cases)
    EXPECT_EQ(diagnostics_of(over_bed(form)), Texts{"scene.toml:28:" + expected}) << form;
  EXPECT_EQ(diagnostics_of(edited({}), {"bottom.albedo={ zenith_deg = [0, 80], albedo = [0, 0] }",
                                        "sea.layer.1.bottom_depth_m=60"}),
            Texts{"--set bottom.albedo: the angles end at 80 degrees, not at 90" + whole});
  EXPECT_EQ(diagnostics_of("bottom = 0.1\n" + edited({})),
            Texts{"scene.toml:1:10: 'bottom' must be a table, not 0.1 (write [bottom])"});
  EXPECT_EQ(diagnostics_of(edited({{25, 25, base_lines()[24] + "\n[bottom]\nalbdo = 1"}})),
            (Texts{"scene.toml:26:1: 'albedo' is missing in [bottom] (add it: the share of the "
                   "light that the sea bed reflects, as a Lambert reflector: a number, a "
                   "table of wavelength_nm, zenith_deg or both, or { file = \"…\" })",
                   "scene.toml:27:1: unknown key 'albdo' in [bottom] (did you mean 'albedo'?)"}));
  EXPECT_EQ(
      diagnostics_of(edited({{25, 25, base_lines()[24] + "\n[bottom]\nalbedo = 1"}})),
      Texts{"scene.toml:26:1: the sea has no bed: its last layer is bottomless (give the last "
            "[[sea.layer]] its bottom_depth_m (a sea by iop_table has none), or leave [bottom] "
            "out)"});
  EXPECT_EQ(diagnostics_of(over_bed("0.1"), {"source.position_m=[0, 0, -60]"}).front(),
            "--set source.position_m: the source is 60 m deep and the sea bed 60 m (raise it, or "
            "lower the last layer's bottom_depth_m)");
}

TEST(Bottom, IsRemarkedOnWhereGatesMissIt) {
  const auto remarks = [](const std::string& depth, double min, double max, double step) {
    return read_scene_text(
               over_bed("0.1", depth), "scene.toml", "/",
               {fmt::format("gates.depth_min_m={}", min), fmt::format("gates.depth_max_m={}", max),
                fmt::format("gates.depth_step_m={}", step)})
        .remarks;
  };
  EXPECT_EQ(remarks("60", 0.3, 61.3, 0.5), Texts{});
  EXPECT_EQ(remarks("60.3", 0, 62, 0.5), Texts{});
  EXPECT_EQ(
      remarks("60", 0, 60, 0.5),
      Texts{"--set gates.depth_max_m: the last gate ends before the light of the sea bed at 60 "
            "m arrives: end the gates below it to see it"});
  EXPECT_EQ(remarks("60", 61, 70, 0.5),
            Texts{"--set gates.depth_min_m: the gates begin below the sea bed at 60 m: of its "
                  "light they hold only what arrives late"});
  EXPECT_EQ(
      remarks("60", 0, 70, 0.5),
      Texts{"--set gates.depth_step_m: a gate begins at the sea bed at 60 m: rounding may put "
            "some of its light into the gate before; let no gate begin within 0.1 mm of the "
            "bed"});
}

TEST(Bottom, IsRemarkedOnWhereItsAnglesAreClose) {
  const std::string close = "{ zenith_deg = [0, 0.3, 90], albedo = [1, 0, 0] }";
  EXPECT_EQ(
      read_scene_text(over_bed(close, "45.3"), "scene.toml", "/").remarks,
      Texts{"scene.toml:28:10: the albedo is smoothed over 0.5 degrees: 0 and 0.3 are closer"});
}

// Seen red, each for itself: with paths of the bed refused; with the scene's bed in environments.
TEST(Bottom, MayDifferInEnvironments) {
  const std::string environments =
      "[[environment]]\nset = { \"bottom.albedo\" = 0.3 }\n[[environment]]\nset = {}\n"
      "[environment_grid]\n\"bottom.albedo\" = [0.05, 0.06]\n";
  const Scene scene = read_text(over_bed("0.1") + environments);
  ASSERT_EQ(scene.environment.size(), 4U);
  EXPECT_EQ(scene.environment[0].bottom, Bottom{0.3});
  EXPECT_EQ(scene.environment[1].bottom, Bottom{0.1});
  EXPECT_EQ(scene.environment[3].bottom, Bottom{0.06});
  EXPECT_EQ(scene.environment[3].name, "albedo = 0.06");
  EXPECT_EQ(scene_in(scene, scene.environment[0]), read_text(over_bed("0.3")));
  EXPECT_TRUE(read_text(write_scene(scene)) == scene);
  const std::string sandy =
      fmt::format("[[environment]]\nset = {{ \"bottom.albedo\" = {} }}\n", both);
  const Scene tables = read_text(over_bed(spectrum) + sandy);
  EXPECT_EQ(tables.environment[0].bottom, read_text(over_bed(both)).bottom);
  EXPECT_TRUE(read_text(write_scene(tables)) == tables);
}

// Seen red, each for itself: with paths of the bed refused; with the bed set as a whole; with any
// angle at the end.
TEST(Bottom, OfAnEnvironmentIsRefusedAtTheChange) {
  const std::string set = "[[environment]]\nset = { ";
  EXPECT_EQ(diagnostics_of(over_bed("0.1") + set + "\"bottom.albedo\" = 2 }"),
            Texts{"scene.toml:35:9: 'albedo' must be a finite number, at least 0 and at most 1, "
                  "not 2"});
  EXPECT_EQ(
      diagnostics_of(over_bed("0.1") + set +
                     "\"bottom.albedo\" = { zenith_deg = [0, 80], albedo = [0, 0] } }"),
      Texts{
          "scene.toml:35:9: the angles end at 80 degrees, not at 90 (give the albedo from 0 to 90 "
          "degrees)"});
  EXPECT_EQ(
      diagnostics_of(edited({}) + set + "\"bottom.albedo\" = 0.2 }"),
      Texts{"scene.toml:32:9: the sea has no bed: its last layer is bottomless (give the last "
            "[[sea.layer]] its bottom_depth_m (a sea by iop_table has none), or leave [bottom] "
            "out)"});
  EXPECT_EQ(diagnostics_of(over_bed("0.1") + set + "bottom.albedo = 0.2 }"),
            Texts{"scene.toml:35:9: 'bottom' cannot be set as a whole in an environment (quote the "
                  "whole path: \"sea.layer.0.chlorophyll_mg_m3\" = 0.5)"});
}

// Seen red, each for itself: with the scene's bed at both steps; with an albedo of 0 derived by;
// with derivatives of a bed that is refused.
TEST(Bottom, EchoesAreDerivedByIt) {
  const std::string derived = "sensitivity = [\"bottom.albedo\"]\n";
  const Scene scene = read_text(derived + over_bed("0.2"));
  const Sensitivity& by = scene.sensitivity.at(0);
  EXPECT_EQ(by.value, 0.2);
  EXPECT_DOUBLE_EQ(std::get<double>(by.below.bottom->albedo), 0.1998);
  EXPECT_DOUBLE_EQ(std::get<double>(by.above.bottom->albedo), 0.2002);
  EXPECT_TRUE(read_text(write_scene(scene)) == scene);
  const auto reported = [&](const char* albedo) {
    return diagnostics_of(derived + over_bed(albedo));
  };
  EXPECT_EQ(reported("0"),
            Texts{"scene.toml:1:16: 'bottom.albedo' is 0: the derivative may be infinite there, "
                  "and no step is small relative to it (give it a small value "
                  "instead)"});
  EXPECT_EQ(reported("1"),
            Texts{"scene.toml:1:16: no step of 'bottom.albedo' to 1.001 can be made: "
                  "'albedo' must be a finite number, at least 0 and at most 1, not "
                  "1.001"});
  EXPECT_EQ(reported(angles),
            Texts{"scene.toml:1:16: 'bottom.albedo' is a table, not a number (name "
                  "the path of a number)"});
  EXPECT_EQ(reported("5"),
            Texts{"scene.toml:29:10: 'albedo' must be a finite number, at least 0 and at "
                  "most 1, not 5"});
}

}  // namespace
}  // namespace photic::scene
