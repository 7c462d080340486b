// Variables of other programs' netCDF files: fill values, packing, and files that lie.
#include <gtest/gtest.h>
#include <netcdf.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
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

std::vector<std::string> names_in(const std::string& path) {
  std::vector<std::string> names;
  for (const auto& [name, header] : netcdf_contents(path).variable) names.push_back(name);
  return names;
}

// Seen red: with fill values kept.
TEST(NetcdfVariable, OfAFloatHasNaNForFillValues) {
  const TemporaryFolder folder;
  for (const int format : {0, NC_64BIT_OFFSET, NC_NETCDF4}) {
    SCOPED_TRACE(format);
    const std::string path = folder.file("float.nc");
    {
      FloatFile file(path, format);
      const int chla = file.define("CHLA", NC_FLOAT);
      file.text(chla, "units", "mg/m3");
      file.attribute(chla, "_FillValue", NC_FLOAT, 99999);
      file.put(chla, {0.5, 99999, 0.25, 1, 2, 99999});
    }
    EXPECT_EQ(names_in(path), std::vector<std::string>{"CHLA"});
    const auto chla = netcdf_variable(path, "CHLA");
    EXPECT_EQ(chla.dimension, (std::vector<std::string>{"N_PROF", "N_LEVELS"}));
    EXPECT_EQ(chla.length, (std::vector<std::size_t>{2, 3}));
    EXPECT_EQ(chla.units, "mg/m3");
    ASSERT_EQ(chla.value.size(), 6U);
    EXPECT_EQ(chla.value[0], 0.5);
    EXPECT_TRUE(std::isnan(chla.value[1]));
    EXPECT_EQ(chla.value[3], 1);
    EXPECT_TRUE(std::isnan(chla.value[5]));
  }
}

TEST(NetcdfVariable, WhatWasNeverWrittenIsMissingToo) {
  const TemporaryFolder folder;
  const std::string path = folder.file("float.nc");
  {
    FloatFile file(path, NC_NETCDF4);
    file.define("PRES", NC_FLOAT);
    file.define("TEMP", NC_DOUBLE);
  }
  for (const char* name : {"PRES", "TEMP"})
    for (const double x : netcdf_variable(path, name).value) EXPECT_TRUE(std::isnan(x)) << name;
  EXPECT_EQ(netcdf_variable(path, "PRES").units, "");
}

// Seen red: with the fill value looked for after unpacking.
TEST(NetcdfVariable, IsUnpacked) {
  const TemporaryFolder folder;
  const std::string path = folder.file("packed.nc");
  {
    FloatFile file(path, 0);
    const int pres = file.define("PRES", NC_SHORT);
    file.attribute(pres, "scale_factor", NC_DOUBLE, 0.1);
    file.attribute(pres, "add_offset", NC_DOUBLE, 100);
    file.attribute(pres, "missing_value", NC_SHORT, -7);
    file.put(pres, {0, 10, -7, 30, 40, 50});
  }
  const auto pres = netcdf_variable(path, "PRES").value;
  EXPECT_EQ(pres[0], 100);
  EXPECT_NEAR(pres[1], 101, 1e-12);
  EXPECT_TRUE(std::isnan(pres[2]));
}

/// Of values a variable has by its attributes, in the first row.
std::vector<double> row_of(const std::function<void(FloatFile&, int)>& attributes, nc_type type,
                           const std::vector<double>& stored) {
  const TemporaryFolder folder;
  const std::string path = folder.file("row.nc");
  {
    FloatFile file(path, NC_NETCDF4);
    const int variable = file.define("CHLA", type);
    attributes(file, variable);
    std::vector<double> all = stored;
    all.resize(6, stored.front());
    file.put(variable, all);
  }
  auto value = netcdf_variable(path, "CHLA").value;
  value.resize(stored.size());
  return value;
}

// Seen red: without the bounds; with bounds of doubles not made floats.
TEST(NetcdfVariable, OutsideItsValidRangeIsMissing) {
  const std::vector<double> stored{-0.1, 0, 0.1, 50, 50.1};
  expect_values(row_of(
                    [](FloatFile& file, int v) {
                      file.attribute(v, "valid_min", NC_FLOAT, 0);
                      file.attribute(v, "valid_max", NC_FLOAT, 50);
                    },
                    NC_FLOAT, stored),
                {missing, 0, 0.1, 50, missing});
  expect_values(
      row_of([](FloatFile& file, int v) { file.attribute(v, "valid_max", NC_DOUBLE, 0.1); },
             NC_FLOAT, stored),
      {-0.1, 0, 0.1, missing, missing});
  expect_values(row_of(
                    [](FloatFile& file, int v) {
                      const double range[2] = {0.1, 50};
                      must(nc_put_att_double(file.id(), v, "valid_range", NC_DOUBLE, 2, range));
                    },
                    NC_FLOAT, stored),
                {missing, missing, 0.1, 50, missing});
}

// Seen red: with all bounds taken for packed ones.
TEST(NetcdfVariable, BoundsOfPackedValuesArePackedUnlessOfAnotherType) {
  const auto packed = [](nc_type type, double greatest) {
    return row_of(
        [&](FloatFile& file, int v) {
          file.attribute(v, "scale_factor", NC_FLOAT, 0.5);
          file.attribute(v, "add_offset", NC_FLOAT, 1);
          file.attribute(v, "valid_max", type, greatest);
        },
        NC_SHORT, {0, 10, 20, 30});
  };
  expect_values(packed(NC_SHORT, 20), {1, 6, 11, missing});
  expect_values(packed(NC_FLOAT, 6), {1, 6, missing, missing});
}

// Seen red: with the sign bit for a sign.
TEST(NetcdfVariable, BytesMayBeUnsigned) {
  expect_values(row_of(
                    [](FloatFile& file, int v) {
                      file.text(v, "_Unsigned", "true");
                      file.attribute(v, "_FillValue", NC_BYTE, -1);
                      file.attribute(v, "valid_max", NC_BYTE, -6);
                    },
                    NC_BYTE, {0, 127, -128, -6, -5, -1}),
                {0, 127, 128, 250, missing, missing});
}

// Seen red: with the double -999.9 looked for among floats; with the first of two alone.
TEST(NetcdfVariable, MissingValuesMayBeSeveralAndOfAnotherType) {
  expect_values(row_of(
                    [](FloatFile& file, int v) {
                      const double absent[2] = {-999.9, 1e20};
                      must(nc_put_att_double(file.id(), v, "missing_value", NC_DOUBLE, 2, absent));
                    },
                    NC_FLOAT, {0.5, -999.9, 1e20, 2}),
                {0.5, missing, missing, 2});
}

TEST(NetcdfVariable, AttributesOfNoUse) {
  const auto refusal = [](const std::function<void(FloatFile&, int)>& attributes) {
    const std::string text = refusal_of([&] { row_of(attributes, NC_FLOAT, {1, 2}); });
    return text.substr(std::min(text.size(), text.find("CHLA: ")));
  };
  EXPECT_EQ(refusal([](FloatFile& f, int v) { f.attribute(v, "scale_factor", NC_FLOAT, 0); }),
            "CHLA: its attribute scale_factor is 0 (is it the file you mean?)");
  EXPECT_EQ(refusal([](FloatFile& f, int v) { f.attribute(v, "valid_range", NC_FLOAT, 0); }),
            "CHLA: its attribute valid_range is not two numbers (is it the file you mean?)");
  EXPECT_EQ(refusal([](FloatFile& f, int v) { f.text(v, "valid_min", "0"); }),
            "CHLA: its attribute valid_min is not a number (is it the file you mean?)");
  EXPECT_EQ(refusal([](FloatFile& f, int v) { f.attribute(v, "positive", NC_FLOAT, 1); }),
            "CHLA: its attribute positive is not a word (is it the file you mean?)");
}

TEST(NetcdfVariable, ShowsWhatItIsAndWhereItPoints) {
  const TemporaryFolder folder;
  const std::string path = folder.file("depth.nc");
  {
    FloatFile file(path, 0);
    const int z = file.define("z", NC_DOUBLE, 1);
    file.text(z, "standard_name", "altitude");
    file.text(z, "positive", "up");
    file.put(z, {0, -1});
  }
  EXPECT_EQ(netcdf_variable(path, "z").standard_name, "altitude");
  EXPECT_EQ(netcdf_variable(path, "z").positive, "up");
}

TEST(NetcdfVariable, UnitsMayBeStrings) {
  const TemporaryFolder folder;
  const std::string path = folder.file("strings.nc");
  {
    FloatFile file(path, NC_NETCDF4);
    const int pres = file.define("PRES", NC_DOUBLE, 1);
    const char* units = "decibar";
    must(nc_put_att_string(file.id(), pres, "units", 1, &units));
  }
  EXPECT_EQ(netcdf_variable(path, "PRES").units, "decibar");
}

TEST(NetcdfVariable, FilesOfNoUse) {
  const TemporaryFolder folder;
  const std::string path = folder.file("float.nc");
  const std::string wanted = " (is it the file you mean?)";
  EXPECT_EQ(refusal_of([&] { netcdf_contents(path); }), path + ": there is no such file" + wanted);
  test::write_file(path, "these are notes");
  EXPECT_EQ(refusal_of([&] { netcdf_contents(path); }), path + ": not a netCDF file" + wanted);
  {
    FloatFile file(path, NC_NETCDF4);
    file.define("PLATFORM", NC_CHAR);
    file.define("WMO", NC_STRING, 1);
    file.text(file.define("PRES", NC_DOUBLE), "_FillValue_", "none");
    const int chla = file.define("CHLA", NC_DOUBLE);
    file.text(chla, "missing_value", "none");
    const int packed = file.define("TEMP", NC_DOUBLE);
    file.text(packed, "units", std::string(2000, 'x'));
  }
  const auto refusal = [&](const char* name) {
    return refusal_of([&] { netcdf_variable(path, name); });
  };
  EXPECT_EQ(refusal("PLATFORM"), path + ": PLATFORM: does not hold numbers" + wanted);
  EXPECT_EQ(refusal("WMO"), path + ": WMO: does not hold numbers" + wanted);
  EXPECT_EQ(refusal("CHLA"), path + ": CHLA: its attribute missing_value is not a number" + wanted);
  EXPECT_EQ(refusal("TEMP"), path + ": TEMP: its attribute units is not a word" + wanted);
  EXPECT_EQ(refusal("NONE").rfind(path + ": NONE: cannot be read: ", 0), 0U) << refusal("NONE");
}

// A few bytes that promise 10^18 numbers. Seen red: with the product of the lengths not bounded.
TEST(NetcdfVariable, HugeDimensionsAreRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.file("huge.nc");
  int id = 0, dimensions[2] = {}, variable = 0;
  must(nc_create(path.c_str(), NC_CLOBBER | NC_NETCDF4, &id));
  must(nc_def_dim(id, "x", 1'000'000'000, &dimensions[0]));
  must(nc_def_dim(id, "y", 1'000'000'000, &dimensions[1]));
  must(nc_def_var(id, "CHLA", NC_DOUBLE, 2, dimensions, &variable));
  const std::size_t chunk[2] = {1000, 1000};
  must(nc_def_var_chunking(id, variable, NC_CHUNKED, chunk));
  must(nc_close(id));
  EXPECT_EQ(refusal_of([&] { netcdf_variable(path, "CHLA"); }),
            path + ": CHLA: has more than 10000000 values (is it the file you mean?)");
}

// A dimension's name that no program would write, in a classic file of a few bytes. Seen red: with
// a buffer of the longest name that the library allows.
TEST(NetcdfVariable, LongNamesAreNoHarm) {
  const TemporaryFolder folder;
  const std::string path = folder.file("name.nc");
  const auto number = [](std::size_t x) {
    return std::string{static_cast<char>(x >> 24U), static_cast<char>(x >> 16U),
                       static_cast<char>(x >> 8U), static_cast<char>(x)};
  };
  const std::string name(5000, 'n');
  const std::string nothing = number(0) + number(0);
  test::write_file(path, "CDF\x01" + number(0) + number(10) + number(1) + number(name.size()) +
                             name + number(4) + nothing + nothing);
  EXPECT_EQ(netcdf_contents(path).dimension, (std::map<std::string, std::size_t>{{name, 4}}));
}

/// Cut off anywhere, a file is refused or read, but nothing else happens.
TEST(NetcdfVariable, TornFiles) {
  const TemporaryFolder folder;
  for (const int format : {0, NC_NETCDF4}) {
    const std::string path = folder.file("whole.nc");
    {
      FloatFile file(path, format);
      file.put(file.define("CHLA", NC_DOUBLE), {1, 2, 3, 4, 5, 6});
    }
    const std::string whole = test::read_file(path);
    int refused = 0;
    for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 200) {
      test::write_file(folder.file("torn.nc"), whole.substr(0, size));
      try {
        netcdf_variable(folder.file("torn.nc"), "CHLA");
      } catch (const InputError&) {
        ++refused;
      }
    }
    EXPECT_GT(refused, 20);
  }
}

}  // namespace
}  // namespace photic::io
