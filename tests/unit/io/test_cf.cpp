// Every variable of a result file against the CF conventions, version 1.10
// (https://cfconventions.org/Data/cf-conventions/cf-conventions-1.10/cf-conventions.html); sections
// are named.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "io/netcdf.hpp"
#include "unit/io/netcdf_file.hpp"
#include "unit/io/sample_result.hpp"
#include "unit/io/sample_tallies.hpp"
#include "unit/io/temporary_folder.hpp"

namespace photic::io {
namespace {

using Names = std::vector<std::string>;
using Set = std::set<std::string>;

Set as_set(const Names& names) { return {names.begin(), names.end()}; }

Names words(const std::string& text) {
  std::istringstream in(text);
  Names out;
  for (std::string word; in >> word;) out.push_back(word);
  return out;
}

/// Section 2.3: a letter, then letters, digits and underscores.
bool is_name(const std::string& text) {
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0 &&
         std::all_of(text.begin(), text.end(), allowed);
}

bool contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

const Names with_errors{"echo",          "echo_by_process",        "echo_by_order",
                        "echo_by_depth", "environment_echo",       "environment_difference",
                        "sensitivity",   "logarithmic_sensitivity"};

class Cf : public testing::Test {
 protected:
  static std::string written(const test::TemporaryFolder& folder) {
    tally::Result result = test::sample_result_in({"more algae", "no CDOM"}, {"sea.x", "sea.y"});
    test::add_sample_tallies(result);
    write_netcdf(result, folder.file("out.nc"), {history_line("a test")});
    return folder.file("out.nc");
  }
  Cf() : file_(written(folder_)) {
    for (const auto& name : file_.variables())
      if (has(name, "bounds")) bounds_.insert(text(name, "bounds"));
  }

  [[nodiscard]] bool has(const std::string& variable, const std::string& attribute) const {
    return file_.has_attribute(file_.variable(variable), attribute);
  }
  [[nodiscard]] std::string text(const std::string& variable, const std::string& attribute) const {
    return file_.text(file_.variable(variable), attribute);
  }
  [[nodiscard]] nc_type type(const std::string& variable) const {
    return file_.type(file_.variable(variable));
  }
  [[nodiscard]] Names dimensions(const std::string& variable) const {
    return file_.dimensions(file_.variable(variable));
  }
  [[nodiscard]] bool is_flags(const std::string& name) const {
    return has(name, "flag_values") || has(name, "flag_masks");
  }
  [[nodiscard]] bool is_bounds(const std::string& name) const { return bounds_.count(name) > 0; }
  [[nodiscard]] bool is_axis(const std::string& name) const {
    return dimensions(name) == Names{name};
  }
  void expect_dimensions_within(const std::string& inner, const std::string& outer) const {
    for (const auto& dimension : dimensions(inner))
      EXPECT_TRUE(contains(dimensions(outer), dimension))
          << inner << " for " << outer << ": " << dimension;
  }

  test::TemporaryFolder folder_;
  test::NetcdfFile file_;
  Set bounds_;
};

/// Those of tallies beside echoes, with their errors and flags, and of their dimensions.
Set of_tallies() {
  Set out =
      as_set(words("level_depth radiance_level_depth direction_zenith direction_azimuth layer_name "
                   "constituent_name escape_zenith escape_zenith_bounds fluence_lamp_depth "
                   "fluence_lamp_depth_bounds fluence_lamp_radius fluence_lamp_radius_bounds "
                   "fluence_across_depth fluence_across_depth_bounds fluence_across_x "
                   "fluence_across_x_bounds"));
  for (const std::string& name :
       words("irradiance_down irradiance_up scalar_irradiance_down scalar_irradiance_up absorbed "
             "escaped reflected_by_surface left_water absorbed_by_bottom absorbed_by_film "
             "absorbed_by_ground balance radiance fluence_lamp fluence_across"))
    for (const char* end : {"", "_standard_error", "_converged", "_convergence_flags"})
      out.insert(name + end);
  return out;
}

TEST_F(Cf, TheVariablesOfTheFormat) {
  Set of_echoes = as_set(file_.variables());
  for (const std::string& name : of_tallies())
    EXPECT_EQ(of_echoes.erase(name), 1u) << "has no " << name;
  EXPECT_EQ(
      of_echoes,
      as_set(words(
          "channel_photons batch_group group_photons echo_by_group environment_echo_by_group "
          "echo echo_standard_error echo_by_process echo_by_process_standard_error "
          "echo_by_process_converged echo_by_process_convergence_flags "
          "echo_by_order echo_by_order_standard_error echo_by_order_converged "
          "echo_by_order_convergence_flags echo_by_depth "
          "echo_by_depth_standard_error converged convergence_flags largest_score_share "
          "variance_of_variance error_growth order_cut_share gate_time gate_time_bounds gate_depth "
          "gate_depth_bounds depth depth_bounds order telescope_name channel_name "
          "channel_wavelength process_name environment_name environment_path_name "
          "environment_value environment_echo "
          "environment_echo_standard_error environment_difference "
          "environment_difference_standard_error environment_converged "
          "environment_convergence_flags parameter_name parameter_value sensitivity "
          "sensitivity_standard_error logarithmic_sensitivity "
          "logarithmic_sensitivity_standard_error sensitivity_converged "
          "sensitivity_convergence_flags")));
}

TEST_F(Cf, Names_2_3) {
  for (const auto& name : file_.variables()) {
    EXPECT_TRUE(is_name(name)) << name;
    for (const auto& dimension : dimensions(name)) EXPECT_TRUE(is_name(dimension)) << dimension;
  }
  const auto check_attributes = [&](int variable, int count) {
    for (int i = 0; i < count; ++i) {
      char name[NC_MAX_NAME + 1] = {};
      ASSERT_EQ(nc_inq_attname(file_.id(), variable, i, name), NC_NOERR);
      EXPECT_TRUE(is_name(name) || std::string(name) == "_FillValue") << name;
    }
  };
  int count = 0;
  ASSERT_EQ(nc_inq_natts(file_.id(), &count), NC_NOERR);
  check_attributes(NC_GLOBAL, count);
  for (const auto& name : file_.variables()) {
    ASSERT_EQ(nc_inq_varnatts(file_.id(), file_.variable(name), &count), NC_NOERR);
    check_attributes(file_.variable(name), count);
  }
}

TEST_F(Cf, TypesAndDimensions_2_2_2_4) {
  for (const auto& name : file_.variables()) {
    EXPECT_TRUE(
        (std::set<nc_type>{NC_DOUBLE, NC_FLOAT, NC_INT, NC_BYTE, NC_STRING}.count(type(name))))
        << name;
    EXPECT_EQ(as_set(dimensions(name)).size(), dimensions(name).size())
        << name << ": repeated dimension";
  }
}

// Seen red: _FillValue on `depth`.
TEST_F(Cf, MissingData_2_5_1) {
  for (const auto& name : file_.variables()) {
    if (has(name, "_FillValue")) {
      EXPECT_EQ(file_.attribute_type(file_.variable(name), "_FillValue"), type(name)) << name;
      EXPECT_FALSE(is_axis(name)) << name << ": a coordinate variable may have no missing data";
    } else if (type(name) == NC_DOUBLE && !is_bounds(name)) {
      for (const double value : file_.numbers(name)) ASSERT_FALSE(std::isnan(value)) << name;
    }
  }
}

TEST_F(Cf, GlobalAttributes_2_6) {
  EXPECT_EQ(file_.text("Conventions"), "CF-1.10");
  for (const char* name : {"title", "history", "source", "references"})
    EXPECT_FALSE(file_.text(name).empty()) << name;
}

// Seen red: gate_time without units.
TEST_F(Cf, Units_3_1) {
  const Set known{"1", "m", "ns", "nm", "degree", "m-1", "m-2", "sr-1"};  // valid in UDUNITS
  for (const auto& name : file_.variables()) {
    if (type(name) == NC_STRING || is_flags(name) || is_bounds(name))
      EXPECT_FALSE(has(name, "units")) << name << ": has no units, or those of its parent";
    else
      EXPECT_TRUE(has(name, "units") && known.count(text(name, "units"))) << name;
  }
}

TEST_F(Cf, LongNames_3_2) {
  for (const auto& name : file_.variables()) {
    ASSERT_TRUE(has(name, "long_name")) << name;
    EXPECT_GT(text(name, "long_name").size(), 10u) << name;
  }
}

TEST_F(Cf, StandardNames_3_3) {
  const std::map<std::string, std::string> table{{"depth", "m"}, {"radiation_wavelength", "nm"}};
  std::size_t count = 0;
  for (const auto& name : file_.variables()) {
    if (!has(name, "standard_name")) continue;
    ASSERT_TRUE(table.count(text(name, "standard_name"))) << name;
    EXPECT_EQ(text(name, "units"), table.at(text(name, "standard_name"))) << name;
    ++count;
  }
  EXPECT_EQ(count, 3u);  // depth, gate_depth, channel_wavelength
}

// Seen red: with a misspelt name among those of environment_echo.
TEST_F(Cf, AncillaryVariables_3_4) {
  for (const std::string& name : with_errors) {
    ASSERT_TRUE(has(name, "ancillary_variables")) << name;
    EXPECT_TRUE(contains(words(text(name, "ancillary_variables")), name + "_standard_error"));
    for (const auto& ancillary : words(text(name, "ancillary_variables"))) {
      ASSERT_TRUE(file_.has_variable(ancillary)) << name << ": " << ancillary;
      expect_dimensions_within(ancillary, name);
    }
  }
  EXPECT_EQ(as_set(words(text("echo", "ancillary_variables"))),
            (Set{"echo_standard_error", "converged", "convergence_flags", "largest_score_share",
                 "variance_of_variance", "error_growth", "order_cut_share"}));
  EXPECT_EQ(as_set(words(text("environment_echo", "ancillary_variables"))),
            (Set{"environment_echo_standard_error", "environment_converged",
                 "environment_convergence_flags"}));
  EXPECT_EQ(as_set(words(text("logarithmic_sensitivity", "ancillary_variables"))),
            (Set{"logarithmic_sensitivity_standard_error", "sensitivity_converged",
                 "sensitivity_convergence_flags"}));
}

// Seen red: flag_masks written as bytes for the variable of ints.
TEST_F(Cf, Flags_3_5) {
  std::size_t count = 0;
  for (const auto& name : file_.variables()) {
    if (!is_flags(name)) continue;
    ++count;
    const int v = file_.variable(name);
    const bool masks = has(name, "flag_masks");
    const std::string attribute = masks ? "flag_masks" : "flag_values";
    EXPECT_EQ(file_.attribute_type(v, attribute), type(name)) << name;
    std::set<std::int64_t> values;
    if (type(name) == NC_BYTE)
      for (const auto value : file_.attribute<std::int8_t>(v, attribute)) values.insert(value);
    else
      for (const auto value : file_.attribute<std::int32_t>(v, attribute)) values.insert(value);
    const Names meanings = words(text(name, "flag_meanings"));
    EXPECT_EQ(values.size(), meanings.size()) << name;
    for (const auto& meaning : meanings) EXPECT_TRUE(is_name(meaning)) << meaning;
    std::int64_t all = 0;
    for (const auto value : values) all |= value;
    EXPECT_FALSE(masks && values.count(0) > 0) << name;
    for (const double value : file_.numbers(name)) {
      const auto flags = static_cast<std::int64_t>(value);
      EXPECT_TRUE(masks ? (flags & ~all) == 0 : values.count(flags) > 0) << name << ": " << value;
    }
  }
  // Of the scene, of processes, orders, environments and parameters; of 15 tallies.
  EXPECT_EQ(count, 10u + 30u);
}

TEST_F(Cf, CoordinateVariables_4_5) {
  std::size_t count = 0;
  for (const auto& name : file_.variables()) {
    if (!is_axis(name)) continue;
    ++count;
    const auto values = file_.numbers(name);
    for (std::size_t i = 1; i < values.size(); ++i) EXPECT_LT(values[i - 1], values[i]) << name;
  }
  EXPECT_EQ(count, 8u);  // depth, order, batch_group, escape_zenith and two of each fluence
  EXPECT_EQ(text("depth", "positive"), "down");
  EXPECT_EQ(text("depth", "axis"), "Z");
  EXPECT_EQ(text("gate_depth", "positive"), "down");
}

// Seen red: a misspelt name in `coordinates`.
TEST_F(Cf, AuxiliaryCoordinates_5) {
  for (const auto& name : file_.variables()) {
    if (!has(name, "coordinates")) continue;
    for (const auto& coordinate : words(text(name, "coordinates"))) {
      ASSERT_TRUE(file_.has_variable(coordinate)) << name << ": " << coordinate;
      EXPECT_FALSE(is_axis(coordinate)) << name << ": axes are found by their names alone";
      EXPECT_NE(coordinate, name);
      expect_dimensions_within(coordinate, name);
    }
  }
  // Section 5: every dimension of data that has no axis of its own has a coordinate that describes
  // it.
  for (const auto& name : file_.variables()) {
    if (dimensions(name).size() < 2 || is_bounds(name)) continue;
    for (const auto& dimension : dimensions(name)) {
      if (file_.has_variable(dimension)) continue;
      ASSERT_TRUE(has(name, "coordinates")) << name;
      const Names coordinates = words(text(name, "coordinates"));
      EXPECT_TRUE(std::any_of(coordinates.begin(), coordinates.end(),
                              [&](const std::string& coordinate) {
                                return dimensions(coordinate) == Names{dimension};
                              }))
          << name << ": " << dimension;
    }
  }
}

// Seen red: centres that are no means of their bounds.
TEST_F(Cf, Bounds_7_1) {
  EXPECT_EQ(bounds_,
            (Set{"gate_time_bounds", "gate_depth_bounds", "depth_bounds", "escape_zenith_bounds",
                 "fluence_lamp_depth_bounds", "fluence_lamp_radius_bounds",
                 "fluence_across_depth_bounds", "fluence_across_x_bounds"}));
  for (const auto& name : file_.variables()) {
    if (!has(name, "bounds")) continue;
    const std::string bounds = text(name, "bounds");
    ASSERT_TRUE(file_.has_variable(bounds)) << name;
    Names expected = dimensions(name);
    expected.emplace_back("bnds");
    EXPECT_EQ(dimensions(bounds), expected);
    EXPECT_EQ(type(bounds), type(name));
    for (const char* forbidden :
         {"units", "standard_name", "axis", "positive", "_FillValue", "missing_value"})
      EXPECT_FALSE(has(bounds, forbidden)) << bounds << ": " << forbidden;
    const auto centre = file_.numbers(name), pair = file_.numbers(bounds);
    for (std::size_t i = 0; i < centre.size(); ++i) {
      EXPECT_LT(pair[2 * i], centre[i]) << name;
      EXPECT_LT(centre[i], pair[2 * i + 1]) << name;
    }
  }
}

TEST_F(Cf, CellMethods_7_3) {
  for (const std::string& name : with_errors) {
    if (name == "logarithmic_sensitivity") {
      EXPECT_FALSE(has(name, "cell_methods"));  // a ratio of sums
      continue;
    }
    const Names methods = words(text(name, "cell_methods"));
    ASSERT_FALSE(methods.empty() || methods.size() % 2 != 0) << name;
    for (std::size_t i = 0; i < methods.size(); i += 2) {
      ASSERT_EQ(methods[i].back(), ':') << name;
      EXPECT_TRUE(contains(dimensions(name), methods[i].substr(0, methods[i].size() - 1))) << name;
      EXPECT_EQ(methods[i + 1], "sum") << name;
    }
  }
}

}  // namespace
}  // namespace photic::io
