// What the check of a scene says of its air.
#include <cmath>
#include <fstream>

#include "optics/air_molecules.hpp"
#include "unit/medium/checked_scenes.hpp"

namespace photic::medium {
namespace {

/// The base scene with this section from line 26 on.
Texts of_section(const std::string& section, const Texts& overrides = {}) {
  return problems({{25, 25, scene::base_lines()[24] + "\n" + section}}, overrides);
}

const std::string us_standard = "[atmosphere]\nprofile = \"us-standard\"\n";
const std::string own_air =
    "[[atmosphere.layer]]\nbottom_height_m = 0\ntop_height_m = 9\niop = [{ wavelength_nm = 532, "
    "a_per_m = 0, b_per_m = 1 }]\n";

/// A profile of two levels.
std::string levels(const std::string& z_km, const std::string& more = "") {
  return "[atmosphere]\nprofile = { z_km = " + z_km + ", p_hpa = [1000, 300], t_k = [290, 230]" +
         more + " }\n";
}

// Seen red: with an air that is not looked at in the check.
TEST(CheckOfAir, EveryTextWithLineAndColumn) {
  EXPECT_EQ(of_section(us_standard), Texts{});
  const std::string gases = us_standard + "[[atmosphere.gases]]\ntop_km = 2\nfile = ",
                    on = "\n[[atmosphere.gases]]\ntop_km = 3\nfile = ",
                    deep = "{ wavelength_nm = [400, 800], optical_depth = [0.3, 0.3] }",
                    thin = "{ wavelength_nm = [400, 800], optical_depth = [0.2, 0.2] }";
  EXPECT_EQ(of_section(gases + thin + on + deep), Texts{});
  EXPECT_EQ(of_section(gases + deep + on + thin),
            Texts{"scene.toml:28:1: gases have an optical depth of 0.2 at 532 nm up to 3 km, and "
                  "of 0.3 up to the rung "
                  "below it; the source emits there (all rungs begin at the sea)"});
  EXPECT_EQ(of_section(gases + "{ wavelength_nm = [600, 800], optical_depth = [0, 0] }"),
            Texts{"scene.toml:28:1: no gas data at 532 nm: scene.toml cover 600-800 nm; the source "
                  "emits there (add it to the table, or choose another wavelength)"});
  EXPECT_EQ(of_section(own_air), Texts{});
  EXPECT_EQ(of_section(us_standard + "aerosol = \"martian\""),
            Texts{"scene.toml:28:11: no aerosol model \"martian\" (there are: rural, maritime, "
                  "urban, tropospheric, fog-advection, fog-radiation, stratospheric, meteoric, "
                  "opac-waso-80 and so on)"});
  EXPECT_EQ(of_section(us_standard + "aerosol_optical_depth_550 = 0.05"),
            Texts{"scene.toml:28:29: 0.05 is less than the optical depth at 550 nm of the aerosols "
                  "above the boundary layer alone, 0.08837 (write at least 0.0884, or aerosol = "
                  "\"none\")"});
  EXPECT_EQ(of_section(us_standard + "aerosol_optical_depth_550 = 0.0884"), Texts{});
  EXPECT_EQ(of_section(levels("[0, 9]", ", troposphere_per_km = [0.1, 0]") +
                       "top_km = 9\naerosol_optical_depth_550 = 2"),
            Texts{"scene.toml:29:29: the profile has no aerosols in the boundary layer, which an "
                  "optical depth scales (give it a visibility, or aerosols)"});
  EXPECT_EQ(of_section(us_standard + "top_km = 12000"),
            Texts{"scene.toml:28:10: the profile ends at 120 km, below the top of the air at 12000 "
                  "km (did you mean 12? 12000 would be in m)"});
  EXPECT_EQ(of_section(levels("[0, 9000]")),
            Texts{"scene.toml:27:24: the pressure falls from 1000 to 300 hPa between 0 and 9000 "
                  "km: in hydrostatic air of 260 K that takes 9.16 km (are the altitudes in m, and "
                  "not in km?)"});
  EXPECT_EQ(of_section(us_standard + "top_km = 121"),
            Texts{"scene.toml:28:10: the profile ends at 120 km, below the top of the air at 121 "
                  "km (write top_km = 120, or add levels)"});
  EXPECT_EQ(of_section(levels("[0, 9]")),
            Texts{"scene.toml:26:1: the profile ends at 9 km, below the top of the air at 100 km "
                  "(write top_km = 9, or add levels)"});
  EXPECT_EQ(of_section(levels("[1, 9]") + "top_km = 9"),
            Texts{"scene.toml:27:11: the profile begins at 1 km, not at the sea (add a level at "
                  "0)"});
  std::string km = "z_km,p_hpa,t_k\n";
  for (int z = 0; z <= 1000; ++z)
    km += std::to_string(z / 10.0) + "," + std::to_string(1000 * std::exp(-z / 80.0)) + ",280\n";
  const std::string path = ::testing::TempDir() + "photic-long-air.csv";
  std::ofstream(path) << km;
  EXPECT_EQ(of_section("[atmosphere]\nprofile = \"" + path + "\""),
            Texts{"scene.toml:27:11: the profile has 1001 levels (at most 1000 are possible: leave "
                  "some out)"});
  EXPECT_EQ(of_section(levels("[0, 9]", ", air_per_cm3 = [1e19, -1]") + "top_km = 9"),
            Texts{"scene.toml:27:88: air_per_cm3 -1 is below 1"});
  EXPECT_EQ(of_section(own_air, {"channel.0.process=raman"}),
            (Texts{"scene.toml:24:7: the iop of layer \"layer1\" covers 531 to 533 nm, not 648.793 "
                   "nm; channel \"elastic\" counts raman light there (add an entry for it)",
                   "scene.toml:29:7: the iop of layer \"air0\" covers 531 to 533 nm, not 648.793 "
                   "nm; channel \"elastic\" counts raman light there (add an entry for it)"}));
}

// Of a file the line and column of it.
TEST(CheckOfAir, OfAFileNamesItsLine) {
  const std::string path = ::testing::TempDir() + "photic-bad-air.csv";
  std::ofstream(path) << "z_km,p_hpa,t_k\n0,1000,290\n9,300,3\n";
  EXPECT_EQ(of_section("[atmosphere]\nprofile = \"" + path + "\"\ntop_km = 9"),
            Texts{path + ":3:7: t_k 3 is below 50 (is it in degrees Celsius, and not in K?)"});
}

// Of the profile as it is given. Seen red: without the doubts.
TEST(CheckOfAir, RemarksOnUnitsOfItsProfile) {
  const auto reported = [](const std::string& section) {
    return remarks({{25, 25, scene::base_lines()[24] + "\n" + section}});
  };
  EXPECT_EQ(reported(us_standard), Texts{});
  EXPECT_EQ(reported(levels("[0, 9]", ", relative_humidity_percent = [0.8, 0.3]") + "top_km = 9"),
            Texts{"scene.toml:27:11: the relative humidity is 0.8 % at most: is it a fraction?"});
  EXPECT_EQ(reported(levels("[0, 9]", ", relative_humidity_percent = [80, 30]") +
                     "top_km = 9\nrelative_humidity_percent = 0.7"),
            Texts{"scene.toml:29:29: 0.7 % is very dry: is it a fraction? 0.7 of saturation would "
                  "be 70"});
}

// At the laser's wavelength and at those of all lines: there are no data of molecules above 1100
// nm. Seen red: with the laser's alone.
TEST(CheckOfAir, AsksForEveryWavelength) {
  const std::string iop =
      "[{ wavelength_nm = 900, a_per_m = 1, b_per_m = 1 }, { wavelength_nm = 2000, a_per_m = 1, "
      "b_per_m = 1 }]";
  const Texts sea{
      "sea.refractive_index=1.33", "sea.group_index=1.33", "sea.layer.1.iop=" + iop,
      "sea.layer.0={ bottom_depth_m = 20, phase_function = \"petzold\", iop = " + iop + " }"};
  const auto reported = [&](const Texts& more) {
    Texts all = sea;
    all.insert(all.end(), more.begin(), more.end());
    return of_section(us_standard, all);
  };
  const std::string none = ": no air scattering data at ";
  const std::string known =
      std::string(" nm: ") + optics::air_scattering_source + " cover 200-1100 nm";
  EXPECT_EQ(reported({"source.wavelength_nm=1090"}), Texts{});
  EXPECT_EQ(
      reported({"source.wavelength_nm=1150"}),
      Texts{"--set source.wavelength_nm" + none + "1150" + known + " (choose another wavelength)"});
  EXPECT_EQ(reported({"source.wavelength_nm=1064", "channel.0.process=raman"}),
            Texts{"--set channel.0.process" + none + "1662.58" + known +
                  "; channel \"elastic\" counts raman light there (choose another wavelength)"});
}

}  // namespace
}  // namespace photic::medium
