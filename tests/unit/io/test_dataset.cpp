// A result as a dataset: all that carry it are handed the same.
#include "io/dataset.hpp"

#include <gtest/gtest.h>
#include <netcdf.h>

#include <cmath>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "io/describe.hpp"
#include "unit/io/sample_result.hpp"
#include "unit/io/temporary_folder.hpp"

namespace photic::io {
namespace {

/// Keeps the sizes of dimensions, and of each variable its dimensions, its numbers of any kind as
/// doubles, its texts, and how many attributes it has.
class Recorded : public Dataset {
 public:
  struct Variable {
    std::vector<std::string> dimensions;
    std::vector<double> numbers;
    std::vector<std::string> texts;
    std::size_t attributes = 0;
  };

  void add_dimension(const std::string& name, std::size_t size) override {
    EXPECT_TRUE(dimension.emplace(name, size).second) << name << " twice";
    EXPECT_GT(size, 0U);
  }
  void add_global(const std::string& name, const AttributeValue&) override {
    EXPECT_TRUE(globals.insert({name, globals.size()}).second) << name << " twice";
  }
  void add_variable(const std::string& name, const std::vector<std::string>& dimensions,
                    Values values, const Attributes& attributes) override {
    Variable kept{dimensions, {}, {}, attributes.size()};
    std::visit(
        [&](auto span) {
          for (const auto& value : span)
            if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>)
              kept.numbers.push_back(static_cast<double>(value));
            else
              kept.texts.push_back(value);
        },
        values);
    std::size_t size = 1;
    for (const std::string& one : dimensions) size *= dimension.at(one);
    EXPECT_EQ(kept.numbers.size() + kept.texts.size(), size) << name;
    EXPECT_TRUE(variable.emplace(name, std::move(kept)).second) << name << " twice";
  }

  std::map<std::string, std::size_t> dimension, globals;
  std::map<std::string, Variable> variable;
};

// Seen red: with tallies left out of the description; with a variable that the file alone has.
TEST(Datasets, AreWhatFilesHold) {
  const test::TemporaryFolder folder;
  const tally::Result result = test::sample_result();
  const WriteInfo info{"then: photic run", "ship.toml"};
  Recorded recorded;
  describe(result, info, recorded);
  EXPECT_GE(recorded.variable.size(), 30U);

  const std::string path = folder.file("out.nc");
  write_netcdf(result, path, info);
  int file = 0, dimensions = 0, variables = 0, globals = 0;
  ASSERT_EQ(nc_open(path.c_str(), NC_NOWRITE, &file), NC_NOERR);
  ASSERT_EQ(nc_inq(file, &dimensions, &variables, &globals, nullptr), NC_NOERR);
  EXPECT_EQ(static_cast<std::size_t>(dimensions), recorded.dimension.size());
  EXPECT_EQ(static_cast<std::size_t>(variables), recorded.variable.size());
  EXPECT_EQ(static_cast<std::size_t>(globals), recorded.globals.size());
  for (const auto& [name, expected] : recorded.variable) {
    int id = 0, attributes = 0;
    ASSERT_EQ(nc_inq_varid(file, name.c_str(), &id), NC_NOERR) << name;
    ASSERT_EQ(nc_inq_varnatts(file, id, &attributes), NC_NOERR);
    EXPECT_EQ(static_cast<std::size_t>(attributes), expected.attributes) << name;
    if (!expected.texts.empty()) continue;
    std::vector<double> numbers(expected.numbers.size());
    ASSERT_EQ(nc_get_var_double(file, id, numbers.data()), NC_NOERR) << name;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (!(std::isnan(numbers[i]) && std::isnan(expected.numbers[i]))) {
        ASSERT_EQ(numbers[i], expected.numbers[i]) << name << " " << i;
      }
  }
  nc_close(file);
}

}  // namespace
}  // namespace photic::io
