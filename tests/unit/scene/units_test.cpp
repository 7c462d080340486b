// Units of the values and depths of netCDF files.
#include <gtest/gtest.h>

#include <cmath>

#include "optics/pressure.hpp"
#include "scene/profile.hpp"
#include "scene/units.hpp"
#include "unit/scene/profile_scenes.hpp"

namespace photic::scene {
namespace {

/// 1 in these units, in the key's; -1 if they are not understood.
double one(const std::string& key, const std::string& units, const std::string& name = "") {
  const auto convert = conversion_to(key, units, name);
  return convert ? (*convert)(1) : -1;
}

// Seen red: with exponents of what follows "/" not turned.
TEST(Units, OfMassPerVolume) {
  for (const char* units : {"mg m-3",
                            "mg/m3",
                            "mg m^-3",
                            "mg m**-3",
                            "mg.m-3",
                            "mg/m^3",
                            "mg m\u207b\u00b3",
                            "mg m-3 ",
                            "mg*m-3",
                            "mg / m3",
                            "mg/m\u00b3",
                            "mg\u00b7m-3",
                            "milligram m-3",
                            "milligram/m3",
                            "milligrams per m3",
                            "ug/l",
                            "ug L-1",
                            "\u00b5g/L",
                            "\u03bcg l-1",
                            "\xB5g/l",
                            "microgram/liter",
                            "micrograms per litre",
                            "ug dm-3",
                            "ng/ml",
                            "m-3 mg",
                            "1e-3 g m-3",
                            "0.001 g/m3",
                            "10^-3 g m-3",
                            "1e-6 kg m-3"}) {
    EXPECT_EQ(one("chlorophyll_mg_m3", units), 1) << units;
  }
  for (const char* units :
       {"g m-3", "g/m3", "mg/l", "mg L-1", "gram/meter^3", "ug/ml", "mg dm-3"}) {
    EXPECT_EQ(one("chlorophyll_mg_m3", units), 1e3) << units;
    EXPECT_EQ(one("minerals_g_m3", units), 1) << units;
  }
  for (const char* units : {"kg m-3", "kg/m^3", "kilogram m-3", "g/l", "kilograms per meter3"}) {
    EXPECT_EQ(one("chlorophyll_mg_m3", units), 1e6) << units;
    EXPECT_EQ(one("minerals_g_m3", units), 1e3) << units;
  }
  EXPECT_EQ(one("chlorophyll_mg_m3", "ng/l"), 1e-3);
  EXPECT_EQ((*conversion_to("chlorophyll_mg_m3", "kg m-3", ""))(1.5e-7), 1.5e-7 * 1e6);
}

// Seen red: with units whose kind is not compared.
TEST(Units, OfOtherKindsAreNotUnderstood) {
  for (const char* units :
       {"mg m-2",
        "mg",
        "m-3",
        "mmol m-3",
        "umol/kg",
        "ug/kg",
        "ppb",
        "1",
        "counts",
        "volts",
        "mg//m3",
        "mg/",
        "/",
        "mg m-33",
        "mg m-",
        "mg m^",
        "2 mg m-3",
        "Mg m-3",
        "MG/M3",
        "mg-m3",
        "mg m -3",
        "10-3 g m-3",
        "1e999 g m-3",
        "mg (m3)",
        "mg chl m-3",
        "percent",
        "mg m-3 mg m-3 mg m-3 mg m-3 mg m-3 mg m-3 mg m-3 mg m-3 mg m-3 mg m-3"})
    EXPECT_EQ(one("chlorophyll_mg_m3", units), -1) << units;
  EXPECT_EQ(one("minerals_g_m3", "m-1"), -1);  // backscattering
  EXPECT_EQ(one("cdom_a440_per_m", "ppb"), -1);
  EXPECT_EQ(one("temperature_c", "m"), -1);
  EXPECT_EQ(one("temperature_c", "degF"), -1);
}

TEST(Units, OfAbsorption) {
  for (const char* units :
       {"m-1", "1/m", "/m", "m^-1", "per m", "meter-1", "m\u207b\u00b9", "1/meter"})
    EXPECT_EQ(one("cdom_a440_per_m", units), 1) << units;
  EXPECT_EQ(one("a_per_m", "cm-1"), 100);
  EXPECT_EQ(one("a_per_m", "1/km"), 1e-3);
  EXPECT_EQ(one("a_per_m", "m"), -1);
  EXPECT_EQ(one("wavelength_nm", "nm"), 1);
  EXPECT_EQ(one("wavelength_nm", "nanometers"), 1);
  EXPECT_EQ(one("wavelength_nm", "um"), 1000);
  EXPECT_EQ(one("depth_m", "km"), 1000);
  EXPECT_EQ(one("depth_m", "cm"), 0.01);
}

// Seen red: with kelvins for degrees.
TEST(Units, OfTemperature) {
  for (const char* units :
       {"degree_Celsius", "degrees_Celsius", "degree_C", "degrees_C", "degC", "deg_C", "deg C",
        "Celsius", "celsius", "C", "\u00b0C", "\u00baC", "degrees Celsius",
        "\xB0"
        "C"})
    EXPECT_EQ(one("temperature_c", units), 1) << units;
  for (const char* units : {"K", "kelvin", "Kelvin", "degree_K", "degK"})
    EXPECT_NEAR((*conversion_to("temperature_c", units, ""))(283.15), 10, 1e-12) << units;
}

// S_A = 35.16504 g/kg where S_P = 35. Seen red: with absolute salinities taken for practical ones.
TEST(Units, OfSalinity) {
  for (const char* units : {"psu", "PSU", "1", "1e-3", "0.001", "PSS-78", "pss78", "\u2030", "ppt"})
    EXPECT_EQ(one("salinity_psu", units), 1) << units;
  const auto practical = [](double value, const std::string& units, const std::string& name = "") {
    return (*conversion_to("salinity_psu", units, name))(value);
  };
  for (const char* units : {"g/kg", "g kg-1", "gram/kilogram", "mg/g"})
    EXPECT_NEAR(practical(35.16504, units), 35, 1e-12) << units;
  EXPECT_NEAR(practical(0.03516504, "kg/kg"), 35, 1e-12);
  EXPECT_NEAR(practical(35.16504, "1e-3", "sea_water_absolute_salinity"), 35, 1e-12);
  EXPECT_EQ(one("salinity_psu", "psu", "sea_water_absolute_salinity"), -1);
  EXPECT_EQ(one("salinity_psu", "mS/cm"), -1);
}

// --- In scenes -----------------------------------------------------------------------------------

Texts plain(const WrittenFiles& files, const Texts& remarks) {
  Texts texts;
  for (const std::string& remark : remarks) texts.push_back(files.without_folder(remark));
  return texts;
}

// Seen red: with the values as they are.
TEST(UnitsOfAProfile, AreConverted) {
  WrittenFiles files("units_kg");
  write_depths(files, {0, 10, 20, 30}, {1e-7, 2e-7, 3e-7, 1e-7});
  files.netcdf["CHLA"].units = "kg m-3";
  const Reading reading = files.read(profiled(from_depths));
  EXPECT_EQ(reading.remarks, Texts{});
  EXPECT_NEAR(mean_chlorophyll(reading.scene), 0.2, 1e-14);
}

TEST(UnitsOfAProfile, ThatAreNotUnderstoodAreRefused) {
  WrittenFiles files("units_refused");
  write_depths(files, {0, 30}, {1, 2});
  files.netcdf["CHLA"].units = "mmol m-3";
  EXPECT_EQ(
      files.problems(profiled(from_depths)),
      (Texts{"scene.toml:22:30: float.nc: CHLA: is in units of \"mmol m-3\", not mg/m3 (units "
             "of mass per volume are understood, as \"mg m-3\" and \"ug/l\")"}));
}

TEST(UnitsOfAProfile, ThatAreMissingAreReported) {
  WrittenFiles files("units_missing");
  write_depths(files, {0, 20}, {1, 2});
  files.netcdf["CHLA"].units = "";
  EXPECT_EQ(plain(files, files.read(profiled(from_depths)).remarks),
            (Texts{"scene.toml:22:21: float.nc: CHLA has no attribute units: its values are taken "
                   "to be in mg/m3"}));
}

// Seen red: with pressures taken for lengths.
TEST(UnitsOfAProfile, OfDepthsAndPressures) {
  WrittenFiles files("units_depth");
  const std::vector<double> value{0.1, 0.4, 0.2};
  const auto mean = [&](const std::vector<double>& depth, const std::string& units) {
    write_depths(files, depth, value);
    files.netcdf["LATITUDE"] = {{}, {}, "degrees_north", {30}};
    files.netcdf["z"].units = units;
    return mean_chlorophyll(files.read(profiled(from_depths)).scene);
  };
  const double expected = (8 * 0.25 + 12 * 0.35) / 20;  // 0.3 at 20 m
  EXPECT_NEAR(mean({0, 8, 32}, "m"), expected, 1e-14);
  EXPECT_NEAR(mean({0, 800, 3200}, "cm"), expected, 1e-14);
  EXPECT_NEAR(mean({0, 0.008, 0.032}, "km"), expected, 1e-14);
  const double of_dbar = mean({0, 8, 32}, "dbar");
  EXPECT_GT(std::fabs(of_dbar - expected), 5e-5);
  EXPECT_NEAR(mean({0, 8, 32}, "decibars"), of_dbar, 1e-14);
  EXPECT_NEAR(mean({0, 8e4, 32e4}, "Pa"), of_dbar, 1e-14);
  EXPECT_NEAR(mean({0, 800, 3200}, "hPa"), of_dbar, 1e-14);
  EXPECT_NEAR(mean({0, 80, 320}, "kPa"), of_dbar, 1e-14);
  EXPECT_NEAR(mean({0, 0.8, 3.2}, "bar"), of_dbar, 1e-14);
  EXPECT_NEAR(mean({0, 800, 3200}, "mbar"), of_dbar, 1e-14);
}

// Heights above the sea level. Seen red: with the attribute not looked at.
TEST(UnitsOfAProfile, HeightsPointUp) {
  WrittenFiles files("units_up");
  const auto of_heights = [&](const std::string& positive, const std::string& name) {
    write_depths(files, {-32, -8, 0}, {0.2, 0.4, 0.1});
    files.netcdf["z"].positive = positive;
    files.netcdf["z"].standard_name = name;
    return profiled(from_depths);
  };
  const Reading reading = files.read(of_heights("up", ""));
  EXPECT_NEAR(mean_chlorophyll(reading.scene), (8 * 0.25 + 12 * 0.35) / 20, 1e-14);
  EXPECT_EQ(files.read(of_heights("Up", "depth")).scene, reading.scene);
  EXPECT_EQ(files.read(of_heights("", "altitude")).scene, reading.scene);
  for (const char* positive : {"", "down"})
    EXPECT_EQ(
        files.problems(of_heights(positive, "")),
        (Texts{"scene.toml:22:21: 'chlorophyll_mg_m3' is known from -32 to 0 m, above the sea "
               "(depths are positive below the surface; netCDF variables of heights have the "
               "attribute positive = \"up\")"}));
  EXPECT_EQ(
      files.problems(of_heights("left", "")),
      (Texts{"scene.toml:22:30: float.nc: z: its attribute positive is \"left\" (it is \"up\" "
             "or \"down\")"}));
}

// Seen red: with fractions of mass taken for PSU.
TEST(UnitsOfAProfile, SalinitiesThatAreNotPractical) {
  WrittenFiles files("units_salinity");
  const auto text = [&](const std::vector<double>& value, const std::string& units) {
    write_depths(files, {0, 30}, value);
    files.netcdf["CHLA"].units = units;
    return edited({{22, 22, "salinity_psu = { " + from_depths + " }"}});
  };
  const Reading absolute = files.read(text({35.16504, 35.16504}, "g kg-1"));
  EXPECT_NEAR(*absolute.scene.sea.layer[0].salinity_psu, 35, 1e-12);
  EXPECT_EQ(plain(files, absolute.remarks),
            (Texts{"scene.toml:22:16: float.nc: CHLA is an absolute salinity: practical ones are "
                   "35/35.16504 of it in g/kg"}));
  EXPECT_EQ(files.problems(text({0.035, 0.036}, "1")),
            (Texts{"scene.toml:22:25: float.nc: CHLA: salinities of 0.036 at most, in units of "
                   "\"1\", are fractions of mass and not practical salinities (give its units as "
                   "\"kg/kg\")"}));
  EXPECT_EQ(files.read(text({35, 35}, "1")).remarks, Texts{});
}

// --- Values that no water has --------------------------------------------------------------------

// Seen red: with a remark for each layer that a profile is cut into.
TEST(ValuesOfNoWater, GetARemark) {
  const auto remarks = [](const std::string& line) {
    return read_scene_text(edited({{22, 22, line}}), "scene.toml", "/").remarks;
  };
  EXPECT_EQ(remarks("chlorophyll_mg_m3 = 1e6"),
            (Texts{"scene.toml:22:21: 1000000 mg/m3 of 'chlorophyll_mg_m3' are more than water has "
                   "(lakes in bloom have hundreds): are the units right?"}));
  EXPECT_EQ(remarks("minerals_g_m3 = 1e5"),
            (Texts{"scene.toml:22:17: 100000 g/m3 of 'minerals_g_m3' are more than water has (what "
                   "has more is mud): are the units right?"}));
  EXPECT_EQ(remarks("cdom_a440_per_m = 200"),
            (Texts{"scene.toml:22:19: 200 1/m of 'cdom_a440_per_m' are more than water has (the "
                   "brownest rivers have tens): are the units right?"}));
  EXPECT_EQ(remarks("chlorophyll_mg_m3 = 1e3\nminerals_g_m3 = 1e4\ncdom_a440_per_m = 100"),
            Texts{});
  const Texts of_profile = remarks("chlorophyll_mg_m3 = { depth_m = [0, 20], value = [2e6, 1e6] }");
  ASSERT_EQ(of_profile.size(), 1U);
  EXPECT_EQ(of_profile[0].rfind("scene.toml:22:21: 19", 0), 0U) << of_profile[0];
}

TEST(ValuesOfNoWater, InFilesAndEnvironments) {
  WrittenFiles files("units_plenty");
  write_depths(files, {0, 20}, {2e6, 2e6});
  EXPECT_EQ(files.read(profiled(from_depths)).remarks.size(), 1U);
  const auto text = edited({}) + "[[environment]]\nset = { 'sea.layer.0.minerals_g_m3' = 1e5 }\n";
  EXPECT_EQ(read_scene_text(text, "scene.toml", "/").remarks.size(), 1U);
}

}  // namespace
}  // namespace photic::scene
