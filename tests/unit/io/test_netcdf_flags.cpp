// Quality flags in other programs' netCDF files, in all the ways these write them.
#include <gtest/gtest.h>
#include <netcdf.h>

#include <cmath>
#include <map>

#include "core/error.hpp"
#include "io/netcdf_variable.hpp"
#include "unit/io/float_file.hpp"
#include "unit/io/temporary_folder.hpp"

namespace photic::io {
namespace {

using test::expect_values;
using test::FloatFile;
using test::missing;
using test::must;
using test::refusal_of;
using test::TemporaryFolder;

// Characters as floats write them, and bytes as others do. Seen red: with the codes of characters.
TEST(NetcdfVariable, FlagsAreDigits) {
  const TemporaryFolder folder;
  for (const int format : {0, NC_NETCDF4}) {
    const std::string path = folder.file("flags.nc");
    {
      FloatFile file(path, format);
      const int characters = file.define("CHLA_QC", NC_CHAR);
      const int bytes = file.define("TEMP_QC", NC_BYTE);
      file.text(characters, "_FillValue", " ");
      file.put(bytes, {1, 2, 3, 4, 8, 9});
      must(nc_put_var_text(file.id(), characters, "14 9A0"));
    }
    const auto flags = netcdf_flags(path, "CHLA_QC", 2);
    EXPECT_EQ(flags.length, (std::vector<std::size_t>{2, 3}));
    EXPECT_EQ(flags.value[0], 1);
    EXPECT_EQ(flags.value[1], 4);
    EXPECT_TRUE(std::isnan(flags.value[2]));
    EXPECT_EQ(flags.value[3], 9);
    EXPECT_TRUE(std::isnan(flags.value[4]));
    EXPECT_EQ(flags.value[5], 0);
    EXPECT_EQ(netcdf_flags(path, "TEMP_QC", 2).value, (std::vector<double>{1, 2, 3, 4, 8, 9}));
  }
}

// Seen red: with their first character whatever follows.
TEST(NetcdfVariable, FlagsMayBeTextsOrDoubles) {
  const TemporaryFolder folder;
  const std::string path = folder.file("texts.nc");
  {
    FloatFile file(path, NC_NETCDF4);
    const int texts = file.define("CHLA_QC", NC_STRING);
    const char* flags[] = {"1", "4.0", "", " 9", "A", "nan"};
    must(nc_put_var_string(file.id(), texts, flags));
    const int longer = file.define("TEMP_QC", NC_STRING, 1);
    const char* words[] = {"1", "bad"};
    must(nc_put_var_string(file.id(), longer, words));
    const int doubles = file.define("PSAL_QC", NC_DOUBLE);
    file.attribute(doubles, "_FillValue", NC_DOUBLE, missing);
    file.put(doubles, {1, missing, 3, 4, 9, missing});
  }
  expect_values(netcdf_flags(path, "CHLA_QC", 2).value, {1, 4, missing, 9, missing, missing});
  expect_values(netcdf_flags(path, "PSAL_QC", 2).value, {1, missing, 3, 4, 9, missing});
  EXPECT_EQ(refusal_of([&] { netcdf_flags(path, "TEMP_QC", 1); }),
            path + ": TEMP_QC: \"bad\" is no flag (is it the file you mean?)");
}

// As xarray saves them: of one character, and of as many as the longest text has. Seen red: with
// each character for a flag.
TEST(NetcdfVariable, FlagsMayBeCharactersWithADimensionMore) {
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
      const auto flags = netcdf_flags(path, "CHLA_QC", 2);
      EXPECT_EQ(flags.dimension, (std::vector<std::string>{"N_PROF", "N_LEVELS"}));
      EXPECT_EQ(flags.length, (std::vector<std::size_t>{2, 3}));
      expect_values(flags.value, {1, 4, missing, 9, missing, 0});
    }
}

// Seen red: with the meanings one word on.
TEST(NetcdfVariable, FlagsTellWhatTheyMean) {
  const TemporaryFolder folder;
  const std::string path = folder.file("meanings.nc");
  {
    FloatFile file(path, NC_NETCDF4);
    const int bytes = file.define("CHLA_QC", NC_BYTE);
    const signed char values[] = {0, 1, 4};
    must(nc_put_att_schar(file.id(), bytes, "flag_values", NC_BYTE, 3, values));
    file.text(bytes, "flag_meanings", "no_qc good  bad");
    const int characters = file.define("PRES_QC", NC_CHAR);
    file.text(characters, "flag_values", "0, 1, 4");
    file.text(characters, "flag_meanings", "no_qc good bad");
    const int fewer = file.define("TEMP_QC", NC_BYTE);
    must(nc_put_att_schar(file.id(), fewer, "flag_values", NC_BYTE, 3, values));
    file.text(fewer, "flag_meanings", "good bad");
    const int bits = file.define("PSAL_QC", NC_BYTE);
    file.attribute(bits, "flag_masks", NC_BYTE, 1);
    file.put(bytes, {0, 1, 4, 1, 1, 1});
  }
  const std::map<double, std::string> expected{{0, "no_qc"}, {1, "good"}, {4, "bad"}};
  EXPECT_EQ(netcdf_flags(path, "CHLA_QC", 2).meaning, expected);
  EXPECT_EQ(netcdf_flags(path, "PRES_QC", 2).meaning, expected);
  EXPECT_EQ(refusal_of([&] { netcdf_flags(path, "TEMP_QC", 2); }),
            path + ": TEMP_QC: has 3 flag_values and 2 flag_meanings (is it the file you mean?)");
  EXPECT_EQ(refusal_of([&] { netcdf_flags(path, "PSAL_QC", 2); }),
            path +
                ": PSAL_QC: its flags are single bits (flag_masks), which are not understood (is "
                "it the file you mean?)");
}

}  // namespace
}  // namespace photic::io
