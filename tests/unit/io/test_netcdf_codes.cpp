// Flags and names of casts in other programs' netCDF files, in all the ways these write them.
#include <gtest/gtest.h>
#include <netcdf.h>

#include "io/netcdf_variable.hpp"
#include "unit/io/float_file.hpp"
#include "unit/io/temporary_folder.hpp"

namespace photic::io {
namespace {

using scene::NetcdfCodes;
using test::FloatFile;
using test::missing;
using test::must;
using test::refusal_of;
using test::TemporaryFolder;

using Words = std::vector<std::string>;

/// Of each value the code; "" where there is none.
Words words_of(const NetcdfCodes& codes) {
  Words words;
  for (const std::size_t i : codes.value)
    words.push_back(i == NetcdfCodes::none ? "" : codes.code(i));
  return words;
}

Words words_in(const std::string& path, const std::string& name) {
  return words_of(netcdf_codes(path, name));
}

// Characters as floats write them, and bytes as others do. Seen red: with texts that are numbers
// left as texts.
TEST(NetcdfCodes, AreDigitsOrNumbers) {
  const TemporaryFolder folder;
  for (const int format : {0, NC_NETCDF4}) {
    const std::string path = folder.file("flags.nc");
    {
      FloatFile file(path, format);
      const int characters = file.define("CHLA_QC", NC_CHAR);
      const int bytes = file.define("TEMP_QC", NC_BYTE);
      const int letters = file.define("PSAL_QC", NC_CHAR);
      file.text(characters, "_FillValue", " ");
      file.put(bytes, {10, 2, 3, 4, 8, 9});
      must(nc_put_var_text(file.id(), characters, "14 940"));
      must(nc_put_var_text(file.id(), letters, "14 9A0"));
    }
    const auto flags = netcdf_codes(path, "CHLA_QC");
    EXPECT_EQ(flags.length, (std::vector<std::size_t>{2, 3}));
    EXPECT_EQ(words_of(flags), (Words{"1", "4", "", "9", "4", "0"}));
    EXPECT_EQ(flags.number, (std::vector<double>{0, 1, 4, 9}));
    EXPECT_EQ(words_in(path, "PSAL_QC"), (Words{"1", "4", "", "9", "A", "0"}));
    EXPECT_EQ(netcdf_codes(path, "PSAL_QC").text, (Words{"0", "1", "4", "9", "A"}));
    EXPECT_EQ(words_in(path, "TEMP_QC"), (Words{"10", "2", "3", "4", "8", "9"}));
    EXPECT_EQ(netcdf_codes(path, "TEMP_QC").number, (std::vector<double>{2, 3, 4, 8, 9, 10}));
  }
}

// Seen red: with their first character whatever follows.
TEST(NetcdfCodes, MayBeTextsOrDoubles) {
  const TemporaryFolder folder;
  const std::string path = folder.file("texts.nc");
  {
    FloatFile file(path, NC_NETCDF4);
    const int texts = file.define("CHLA_QC", NC_STRING);
    const char* flags[] = {"1", "4.0", "", " 9", "10", "nan"};
    must(nc_put_var_string(file.id(), texts, flags));
    const int longer = file.define("TEMP_QC", NC_STRING, 1);
    const char* words[] = {"1", "bad"};
    must(nc_put_var_string(file.id(), longer, words));
    const int doubles = file.define("PSAL_QC", NC_DOUBLE);
    file.attribute(doubles, "_FillValue", NC_DOUBLE, missing);
    file.put(doubles, {1, missing, 3, 4, 9, missing});
  }
  EXPECT_EQ(words_in(path, "CHLA_QC"), (Words{"1", "4", "", "9", "10", ""}));
  EXPECT_EQ(netcdf_codes(path, "CHLA_QC").number, (std::vector<double>{1, 4, 9, 10}));
  EXPECT_EQ(words_in(path, "TEMP_QC"), (Words{"1", "bad"}));
  EXPECT_EQ(words_in(path, "PSAL_QC"), (Words{"1", "", "3", "4", "9", ""}));
}

// As xarray saves them: of one character, and of as many as the longest text has. Seen red: with
// each character for a flag.
TEST(NetcdfCodes, MayBeCharactersWithADimensionMore) {
  const TemporaryFolder folder;
  for (const int format : {0, NC_NETCDF4})
    for (const std::size_t length : {1, 3}) {
      const std::string path = folder.file("string.nc");
      {
        FloatFile file(path, format);
        int dimensions[3] = {0, 1, 0}, variable = 0;
        must(nc_def_dim(file.id(), "string", length, &dimensions[2]));
        must(nc_def_var(file.id(), "CHLA_QC", NC_CHAR, 3, dimensions, &variable));
        nc_enddef(file.id());
        std::string text;
        for (const std::string word : {"1", "4", " ", "9", "A", "0"})
          text += word + std::string(length - 1, length == 1 ? ' ' : '\0');
        must(nc_put_var_text(file.id(), variable, text.data()));
      }
      const auto flags = netcdf_codes(path, "CHLA_QC");
      EXPECT_EQ(flags.dimension, (Words{"N_PROF", "N_LEVELS"}));
      EXPECT_EQ(flags.length, (std::vector<std::size_t>{2, 3}));
      EXPECT_EQ(words_of(flags), (Words{"1", "4", "", "9", "A", "0"}));
      EXPECT_EQ(netcdf_contents(path).variable.at("CHLA_QC").dimension, flags.dimension);
    }
}

// Seen red: with flags that have the fill value dropped; with flag_values cut into characters.
TEST(NetcdfCodes, HaveTheAttributesOfFlags) {
  const TemporaryFolder folder;
  const std::string path = folder.file("meanings.nc");
  {
    FloatFile file(path, NC_NETCDF4);
    const int bytes = file.define("CHLA_QC", NC_BYTE);
    const signed char values[] = {0, 1, 9};
    must(nc_put_att_schar(file.id(), bytes, "flag_values", NC_BYTE, 3, values));
    file.attribute(bytes, "_FillValue", NC_BYTE, 9);
    file.text(bytes, "flag_meanings", "no_qc good missing");
    file.text(file.define("PRES_QC", NC_CHAR), "flag_values", "0, 1, 4");
    file.text(file.define("TEMP_QC", NC_CHAR), "flag_values", "014");
    file.text(file.define("PSAL_QC", NC_INT), "flag_values", "0b 10b 128b");
    const int texts = file.define("DOXY_QC", NC_BYTE);
    const char* meanings[] = {"no QC", "good data"};
    must(nc_put_att_string(file.id(), texts, "flag_meanings", 2, meanings));
    file.put(bytes, {0, 1, 9, 1, 1, -1});
  }
  const auto chla = netcdf_codes(path, "CHLA_QC");
  EXPECT_EQ(chla.flag_values, (Words{"0", "1", "9"}));
  EXPECT_EQ(chla.flag_meanings, Words{"no_qc good missing"});
  EXPECT_EQ(words_of(chla), (Words{"0", "1", "9", "1", "1", "-1"}));
  EXPECT_EQ(netcdf_codes(path, "PRES_QC").flag_values, (Words{"0", "1", "4"}));
  EXPECT_EQ(netcdf_codes(path, "TEMP_QC").flag_values, (Words{"0", "1", "4"}));
  EXPECT_EQ(netcdf_codes(path, "PSAL_QC").flag_values, (Words{"0", "10", "128"}));
  EXPECT_EQ(netcdf_codes(path, "DOXY_QC").flag_meanings, (Words{"no QC", "good data"}));
  const auto header = netcdf_contents(path).variable.at("DOXY_QC");
  EXPECT_TRUE(header.has_flags);
  EXPECT_EQ(header.text("flag_meanings"), "no QC good data");
}

// Seen red: with the sign bit for a sign.
TEST(NetcdfCodes, BitsHaveNoSign) {
  const TemporaryFolder folder;
  const std::string path = folder.file("bits.nc");
  {
    FloatFile file(path, NC_NETCDF4);
    const int bits = file.define("CHLA_QC", NC_BYTE);
    const signed char masks[] = {1, -128};
    must(nc_put_att_schar(file.id(), bits, "flag_masks", NC_BYTE, 2, masks));
    file.text(bits, "_Unsigned", "true");
    file.put(bits, {0, 1, -128, -127, 0, 0});
    const int texts = file.define("TEMP_QC", NC_CHAR);
    must(nc_put_att_schar(file.id(), texts, "flag_masks", NC_BYTE, 2, masks));
  }
  const auto bits = netcdf_codes(path, "CHLA_QC");
  EXPECT_EQ(bits.flag_masks, (std::vector<double>{1, 128}));
  EXPECT_EQ(bits.number, (std::vector<double>{0, 1, 128, 129}));
  EXPECT_EQ(refusal_of([&] { netcdf_codes(path, "TEMP_QC"); }),
            path + ": TEMP_QC: has flag_masks, but holds no numbers (is it the file you mean?)");
}

// Seen red: with attributes of numbers refused.
TEST(NetcdfCodes, ContentsAreWhatMattersToProfiles) {
  const TemporaryFolder folder;
  const std::string path = folder.file("contents.nc");
  {
    FloatFile file(path, NC_NETCDF4);
    const int chla = file.define("CHLA", NC_FLOAT);
    const char* flags[] = {"CHLA_QC", "other_qc"};
    must(nc_put_att_string(file.id(), chla, "ancillary_variables", 2, flags));
    file.attribute(chla, "standard_name", NC_FLOAT, 1);
    file.text(file.define("rowSize", NC_INT, 1), "sample_dimension", "N_LEVELS");
    int group = 0;
    must(nc_def_grp(file.id(), "more", &group));
  }
  const auto contents = netcdf_contents(path);
  EXPECT_EQ(contents.dimension,
            (std::map<std::string, std::size_t>{{"N_LEVELS", 3}, {"N_PROF", 2}}));
  const scene::NetcdfHeader& chla = contents.variable.at("CHLA");
  EXPECT_EQ(chla.length, (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(chla.text("ancillary_variables"), "CHLA_QC other_qc");
  EXPECT_EQ(chla.text("standard_name"), "");
  EXPECT_EQ(contents.variable.at("rowSize").text("sample_dimension"), "N_LEVELS");
}

}  // namespace
}  // namespace photic::io
