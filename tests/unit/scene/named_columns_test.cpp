// Every key that takes a file takes what the file calls its columns, whatever separates them and
// wherever their names stand. And what is no such file is refused, and not quoted.
#include <fmt/format.h>
#include <sys/stat.h>

#include <cmath>
#include <functional>

#include "scene/bed_albedo.hpp"
#include "unit/scene/profile_scenes.hpp"

namespace photic::scene {
namespace {

/// A key of the scene that takes a table.
struct KeyOfATable {
  std::string name;
  std::vector<std::string> columns, keys;  ///< and what names each of them in a file
  std::vector<std::string> rows;           ///< between commas
  std::string more;                        ///< keys beside the file
  std::function<std::string(const std::string& value)> scene;
};

std::string with_lines(const std::string& text) { return edited({}) + text; }

/// [bottom], or another section that is made of lines.
std::string with_a_bed(const std::string& value) {
  return edited(
      {{25, 25, base_lines()[24] + "\nbottom_depth_m = 60\n[bottom]\nalbedo = " + value}});
}

const std::vector<KeyOfATable>& keys_of_tables() {
  static const std::vector<std::string> bed{"400,0.10", "500,0.14", "600,0.18"};
  static const std::vector<KeyOfATable> all{
      {"albedo", {"wavelength_nm", "albedo"}, {"wavelength", "albedo"}, bed, "", with_a_bed},
      {"albedo by angle",
       {"zenith_deg", "albedo"},
       {"zenith", "albedo"},
       {"0,0.1", "90,0.2"},
       "",
       with_a_bed},
      {"transmission_file",
       {"wavelength_nm", "transmission"},
       {"wavelength", "transmission"},
       {"520,0", "532,0.7", "540,0"},
       "",
       [](const std::string& value) {
         return edited({{16, 17, "name = \"f\"\ntransmission_file = " + value}});
       }},
      {"phytoplankton_file",
       {"wavelength_nm", "a_m2_per_mg", "b_m2_per_mg", "a_exciting_m2_per_mg"},
       {"wavelength", "a", "b", "a_exciting"},
       {"500,0.1,0.2,0.1", "600,1e-3,2,1e-4"},
       "",
       [](const std::string& value) {
         return edited(
             {{18, 18, "[optics]\nphytoplankton = \"table\"\nphytoplankton_file = " + value}});
       }},
      {"cdom_fluorescence_file",
       {"excitation_nm", "emission_nm", "yield_per_nm"},
       {"excitation", "emission", "yield"},
       {"500,550,1e-5", "500,600,2e-5"},
       "",
       [](const std::string& value) {
         return edited(
             {{18, 18,
               "[optics]\ncdom_fluorescence = \"table\"\ncdom_fluorescence_file = " + value}});
       }},
      {"file of a phase function",
       {"angle_deg", "phase_function_per_sr"},
       {"angle", "phase_function"},
       {"0,0.3", "30,0.1", "180,0.02"},
       "",
       [](const std::string& value) {
         return edited({{25, 25, "phase_function = { model = \"table\", file = " + value + " }"}});
       }},
      {"file of [oil]",
       {"wavelength_nm", "n", "a_per_m", "emission_per_nm"},
       {"wavelength", "n", "a", "emission"},
       {"300,1.5,1e5,0.5", "900,1.4,1e3,1"},
       "",
       [](const std::string& value) {
         return with_lines(
             "[oil]\nthickness_um = 1\nyield = 0.1\nlifetime_ns = 2\nfile = " + value + "\n");
       }},
      {"profile of [atmosphere]",
       {"z_km", "p_hpa", "t_k", "ozone_per_cm3"},
       {"z", "p", "t", "ozone"},
       {"0,1013,288.2,1e12", "5,540.5,255.7,5e11", "20,55.3,216.7,4e12"},
       "",
       [](const std::string& value) {
         return with_lines("[atmosphere]\nprofile = " + value + "\n");
       }},
      {"file of gases",
       {"wavelength_nm", "optical_depth"},
       {"wavelength", "optical_depth"},
       {"400,0.1", "700,0.3"},
       "",
       [](const std::string& value) {
         return with_lines(
             "[atmosphere]\nprofile = \"us-standard\"\n[[atmosphere.gases]]\ntop_km = "
             "2\nfile = " +
             value + "\n");
       }},
      {"iop_table",
       {"depth_m", "wavelength_nm", "a_per_m", "c_per_m", "a_cdom_per_m"},
       {"depth", "wavelength", "a", "c", "a_cdom"},
       {"0,500,0.05,0.2,0.01", "0,600,0.25,0.4,0.01", "10,500,0.04,0.1,0", "10,600,0.24,0.3,0"},
       ", phase_function = \"petzold\"",
       [](const std::string& value) {
         return edited({{19, 25, "[sea]\niop_table = " + value}});
       }},
      {"a profile",
       {"depth", "column"},
       {"depth", "column"},
       {"0,0.1", "10,0.5", "30,0.2"},
       "",
       [](const std::string& value) {
         return edited({{22, 22, "chlorophyll_mg_m3 = " + value}});
       }}};
  return all;
}

std::string put_between(std::string fields, const std::string& separator) {
  for (auto at = fields.find(','); at != std::string::npos;
       at = fields.find(',', at + separator.size()))
    fields.replace(at, 1, separator);
  return fields;
}

std::string text_of_table(const KeyOfATable& key, const std::vector<std::string>& names,
                          const std::string& head, const std::string& separator) {
  std::string text =
      names.empty() ? head : head + fmt::format("{}", fmt::join(names, separator)) + "\n";
  for (const std::string& row : key.rows) text += put_between(row, separator) + "\n";
  return text;
}

/// What names the file's columns: by "c1", "c2" …, or by 1, 2 …
std::string value_naming(const KeyOfATable& key, bool by_number) {
  std::string value = "{ file = 'f.dat'";
  for (std::size_t i = 0; i < key.keys.size(); ++i)
    value += by_number ? fmt::format(", {} = {}", key.keys[i], i + 1)
                       : fmt::format(", {} = 'c{}'", key.keys[i], i + 1);
  return value + key.more + " }";
}

class NamedColumns : public testing::Test {
 protected:
  WrittenFiles files_{"named_columns"};
};

// Seen red, each for itself: with the names left out by the reader of tables, by that of iop
// tables; with numbers from 0; with comments that are never names; with the header of SeaBASS read
// as rows.
TEST_F(NamedColumns, OfEveryKeyInEveryKindOfTable) {
  for (const KeyOfATable& key : keys_of_tables()) {
    SCOPED_TRACE(key.name);
    files_.write("f.dat", text_of_table(key, key.columns, "", ","));
    std::string plain = "{ file = 'f.dat'" + key.more + " }";
    if (key.name == "a profile") plain = "{ file = 'f.dat', depth = 'depth', column = 'column' }";
    const Scene expected = files_.read(key.scene(plain)).scene;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < key.columns.size(); ++i) names.push_back(fmt::format("c{}", i + 1));
    for (const auto& [separator, word] : std::vector<std::pair<std::string, std::string>>{
             {",", "comma"}, {";", "semicolon"}, {"\t", "tab"}, {"  ", "space"}}) {
      const std::string fields = fmt::format(
          "/begin_header\n/fields={}\n/delimiter={}\n/end_header\n", fmt::join(names, ","), word);
      for (const auto& [head, has_names] :
           std::vector<std::pair<std::string, bool>>{{"", true},
                                                     {"# ", true},
                                                     {"! somebody's\n! ", true},
                                                     {fields, false},
                                                     {"", false}}) {
        const bool named = has_names || !head.empty();
        files_.write("f.dat", text_of_table(key, has_names ? names : std::vector<std::string>{},
                                            head, separator));
        SCOPED_TRACE(
            text_of_table(key, has_names ? names : std::vector<std::string>{}, head, separator));
        EXPECT_EQ(files_.problems(key.scene(value_naming(key, true))), Texts{});
        EXPECT_TRUE(files_.read(key.scene(value_naming(key, true))).scene == expected);
        if (named) {
          EXPECT_TRUE(files_.read(key.scene(value_naming(key, false))).scene == expected);
        }
      }
    }
  }
}

// Values between blanks, worked out by hand: 0.14 + 32/100 x 0.04. Seen red: with
// mud for sand (numbers from 0).
TEST_F(NamedColumns, OfABedBetweenBlanks) {
  files_.write("bed.dat",
               "# albedo of a made-up sea bed\n#  nm    sand   mud\n  400   0.10   0.02\n"
               "  500   0.14   0.04\n  600   0.18   0.06\n");
  for (const char* value : {"{ file = 'bed.dat', wavelength = 1, albedo = 2 }",
                            "{ file = 'bed.dat', wavelength = 'nm', albedo = 'sand' }",
                            "{ file = 'bed.dat', wavelength = 1, albedo = 'sand' }"}) {
    const Scene scene = files_.read(with_a_bed(value)).scene;
    EXPECT_NEAR(albedo_of(*scene.bottom, 532, 0), 0.1528, 1e-15);
    EXPECT_TRUE(read_text(write_scene(scene)) == scene);
  }
}

// Seen red: with numbers from 0; with one column taken twice; with the names left out.
TEST_F(NamedColumns, WhatIsWrongIsReportedAtItsPlace) {
  files_.write("bed.dat", "# nm sand mud\n400 0.10 0.02\n500 0.14 0.04\n600 0.18 0.06\n");
  const auto problems = [&](const std::string& keys) {
    return files_.problems(with_a_bed("{ file = 'bed.dat'" + keys + " }"));
  };
  const std::string there_are = " (there are, between blanks: nm, sand, mud";
  EXPECT_EQ(problems(""), Texts{"bed.dat:1:1: no column \"albedo\"" + there_are +
                                "; the scene may name it: { file = …, albedo = … })"});
  EXPECT_EQ(problems(", albedo = 2"),
            Texts{"bed.dat:1:1: no column wavelength_nm or zenith_deg" + there_are +
                  "; the scene may name it: { file = …, wavelength = … })"});
  EXPECT_EQ(problems(", wavelength = 1, albedo = 4"),
            Texts{"bed.dat:1:1: no column 4" + there_are + ")"});
  EXPECT_EQ(problems(", wavelength = 1, albedo = 'snd'"),
            Texts{"bed.dat:1:1: no column \"snd\"" + there_are + ")"});
  EXPECT_EQ(problems(", wavelength = 2, albedo = 'sand'"),
            Texts{"bed.dat:1:1: column 2 is named as both wavelength_nm and albedo (each has a "
                  "column of its own)"});
  EXPECT_EQ(
      problems(", wavelength = 0, albedo = [1, 2]"),
      (Texts{"scene.toml:28:43: 'wavelength' must be the name of a column, or its number from "
             "1 on, not 0",
             "scene.toml:28:55: 'albedo' must be the name of a column, or its number from 1 "
             "on, not [1, 2]"}));
  EXPECT_EQ(problems(", wavelength_nm = 1, albedo = 2"),
            Texts{"scene.toml:28:30: unknown key 'wavelength_nm' in 'albedo' (did you mean "
                  "'wavelength'?)"});
  files_.write("bed.dat", "# nm sand\n400 0.1\n500 x\n600 0.2 0.3\n");
  EXPECT_EQ(problems(", wavelength = 1, albedo = 2"),
            Texts{"bed.dat:4:1: 3 fields where 2 columns are named (a text with a blank needs "
                  "double quotes)"});
  files_.write("bed.dat", "# nm sand\n400 0.1\n500 x\n600 NaN\n");
  EXPECT_EQ(problems(", wavelength = 1, albedo = 2"),
            (Texts{"bed.dat:3:5: \"x\" is not a finite number",
                   "bed.dat:4:5: \"NaN\" is not a finite number (fill the gap, or leave the row "
                   "out)"}));
}

// The header of a SeaBASS file, whose units are those of the key or of no kind that is known. Seen
// red, each for itself: with the units left unread; in tables, in profiles, in iop tables.
TEST_F(NamedColumns, AreInTheUnitsOfTheirKeys) {
  const auto with_units = [&](const std::string& units) {
    files_.write("f.dat", "/begin_header\n/fields=x,y\n/units=" + units +
                              "\n/delimiter=space\n/end_header\n400 0.1\n600 0.2\n");
  };
  const std::string bed = with_a_bed("{ file = 'f.dat', wavelength = 'x', albedo = 'y' }");
  const std::string profile =
      profiled("file = 'f.dat', depth = 'x', column = 'y', above = 'constant'");
  const std::string other = " (convert the column, and write its new units there)";
  for (const char* units : {"nm,unitless", "NM,1", "nm,%", "wl,none", "nm"}) {
    with_units(units);
    EXPECT_EQ(files_.problems(bed), Texts{}) << units;
  }
  with_units("um,1");
  EXPECT_EQ(
      files_.problems(bed),
      Texts{"f.dat:2:1: wavelength_nm is in \"um\" by the header of the file, not in nm" + other});
  for (const char* units : {"m,mg/m^3", "m,mg m^-3", "meters,ug/l"}) {
    with_units(units);
    EXPECT_EQ(files_.problems(profile), Texts{}) << units;
  }
  for (const auto& [units, said] : std::vector<std::pair<std::string, std::string>>{
           {"m,ug/ml", "column is in \"ug/ml\" by the header of the file, not in mg/m3"},
           {"dbar,mg/m^3", "depth is in \"dbar\" by the header of the file, not in m"},
           {"m,1/m", "column is in \"1/m\" by the header of the file, not in mg/m3"}}) {
    with_units(units);
    EXPECT_EQ(files_.problems(profile), Texts{"f.dat:2:1: " + said + other});
  }
  files_.write("f.dat", "/fields=z,l,a,b\n/units=m,nm,1/cm,1/m\n0 500 1 2\n");
  EXPECT_EQ(
      files_.problems(edited({{19, 25,
                               "[sea]\niop_table = { file = 'f.dat', depth = 1, "
                               "wavelength = 2, a = 3, b = 4, phase_function = "
                               "'petzold' }"}})),
      Texts{"f.dat:1:1: a_per_m is in \"1/cm\" by the header of the file, not in 1/m" + other});
}

// Seen red: with a number taken for the variable of depths; with the names left out.
TEST_F(NamedColumns, AreThoseOfTablesOfText) {
  write_float(files_);
  EXPECT_EQ(files_.problems(profiled("file = 'float.nc', depth = 1, variable = 'CHLA'")),
            Texts{"scene.toml:22:50: 'chlorophyll_mg_m3' has a number for the variable of depths "
                  "(variables of netCDF files are called by their names)"});
  files_.write("lib.nc", "");
  files_.netcdf.clear();
  files_.netcdf["z"] = {{"z"}, {2}, "m", {0, 10}};
  files_.netcdf["l"] = {{"l"}, {1}, "um", {0.5}};
  files_.netcdf["abs"] = {{"z", "l"}, {2, 1}, "cm-1", {1e-3, 2e-3}};
  files_.netcdf["b_per_m"] = {{"z", "l"}, {2, 1}, "", {0.1, 0.2}};
  const auto tabled = [](const std::string& keys) {
    return edited(
        {{19, 25,
          "[sea]\niop_table = { file = 'lib.nc', phase_function = 'petzold'" + keys + " }"}});
  };
  const Scene scene = files_.read(tabled(", depth = 'z', wavelength = 'l', a = 'abs'")).scene;
  ASSERT_EQ(scene.sea.layer.size(), 2U);
  EXPECT_EQ(scene.sea.layer[0].iop, (std::vector<IopEntry>{{500, 0.1, 0.1, 0, {}}}));
  EXPECT_EQ(
      files_.problems(tabled(", depth = 'z', wavelength = 2, a = 'abs'")),
      Texts{"scene.toml:20:22: lib.nc: wavelength_nm is named by a number (variables of netCDF "
            "files are called by their names)"});
  EXPECT_EQ(
      files_.problems(tabled(", depth = 'z', wavelength = 'l', a = 'absorption'")),
      Texts{"scene.toml:20:22: lib.nc: no variable \"absorption\" (there are: abs, b_per_m, l, "
            "z)"});
}

// A pipe would be waited for without end. Seen red: with folders alone refused.
TEST_F(NamedColumns, WhatIsNoRegularFileIsRefused) {
  const auto pipe = files_.path("f.dat");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink("f.dat", files_.path("link.dat"));
  std::filesystem::create_directory(files_.path("folder"));
  std::filesystem::create_symlink("link.dat", files_.path("float.nc"));
  for (const KeyOfATable& key : keys_of_tables()) {
    for (const std::string name : {"f.dat", "link.dat", "folder", "/dev/zero", "./f.dat"}) {
      SCOPED_TRACE(key.name + ": " + name);
      std::string value = value_naming(key, true);
      value.replace(value.find("f.dat"), 5, name);
      const Texts reported = files_.problems(key.scene(value));
      ASSERT_EQ(reported.size(), 1U);
      EXPECT_NE(reported[0].find("names no regular file: "), std::string::npos) << reported[0];
      EXPECT_NE(reported[0].find("(folders, pipes and devices are not read)"), std::string::npos);
    }
  }
  for (const std::string& text :
       {profiled(from_float), edited({{19, 25, "[sea]\niop_table = 'float.nc'"}})})
    EXPECT_NE(files_.problems(text).at(0).find("names no regular file: float.nc"),
              std::string::npos);
  EXPECT_THROW(optics::read_text(pipe), InputError);
}

// Seen red, each for itself: with all files quoted; with fields quoted; with names proposed of
// those that are no iop tables.
TEST_F(NamedColumns, NothingIsQuotedOfAFileThatIsNoTable) {
  for (const std::string text :
       {"my secret pass word\nand more of it\n", "my,secret\nof,words\n", "user:secret:0:0\n",
        "secret=1\n", "pass;secret;word\na;1;b\n", "my_depth_m,secret\nof,words\n", "secret\n",
        "{\n  \"secret\": 5\n}\n"}) {
    files_.write("f.dat", text);
    for (const KeyOfATable& key : keys_of_tables()) {
      SCOPED_TRACE(key.name + ": " + text);
      std::string plain = "{ file = 'f.dat'" + key.more + " }";
      if (key.name == "a profile") plain = "{ file = 'f.dat', depth = 'z', column = 'chl' }";
      for (const std::string& value : {plain, value_naming(key, true), value_naming(key, false)}) {
        const Texts reported = files_.problems(key.scene(value));
        ASSERT_FALSE(reported.empty());
        EXPECT_NE(reported[0].find("no table of numbers"), std::string::npos) << reported[0];
        for (const std::string& each : reported)
          for (const char* word : {"secret", "pass", "my"})
            EXPECT_EQ(each.find(word), std::string::npos) << each;
      }
    }
  }
}

}  // namespace
}  // namespace photic::scene
