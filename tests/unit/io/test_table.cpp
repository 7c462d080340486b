#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/error.hpp"
#include "io/columns_table.hpp"
#include "io/table.hpp"
#include "io/table_parts.hpp"
#include "unit/io/sample_result.hpp"

namespace photic::io {
namespace {

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> out(1);
  for (const char c : text) {
    if (c == '\n')
      out.emplace_back();
    else
      out.back() += c;
  }
  return out;
}

bool has_line(const std::string& text, const std::string& line) {
  for (const auto& each : lines(text))
    if (each == line) return true;
  return false;
}

/// One telescope, one channel, five gates with all that a cell can show.
tally::Result small_result() {
  tally::Result result;
  result.telescope_name = {"ship"};
  result.channel_name = {"raman"};
  result.gate_time_edge_ns = {80, 90, 100, 110, 120, 130};
  result.gate_depth_edge_m = {0, 1, 2, 3, 4, 5};
  result.echo.mean = {1.23456e-8, 9.9996e-9, 5e-10, 1e-12, 0};
  result.echo.standard_error = {1.23456e-11, 1.5e-10, 6e-11, 2e-11, 0};
  result.convergence_flags = {0, 0, tally::large_error | tally::heavy_tail, tally::large_error,
                              tally::no_score};
  result.photons = 1'234'567;
  result.channel_photons = {400'000};
  result.wall_time_s = 2;
  result.collisions = 9'000'000;
  result.threads = 1;
  result.estimator = "forward";
  result.estimator_reason = "it is quicker";
  result.seed = 7;
  result.engine = "scalar";
  result.stopped_by = "interrupt";
  result.partial = true;
  result.warnings = {"first warning", "second warning"};
  return result;
}

// Seen red: the relative error not in per cent; the mark on gates that have converged.
TEST(EchoTable, AllOfASmallOne) {
  EXPECT_EQ(
      echo_table(small_result()),
      R"(Echo: photons detected in the gate per photon emitted; error: standard error over echo

telescope ship
               raman
   depth [m]        echo   error
        0.50   1.235e-08  0.10 %
        1.50   1.000e-08   1.5 %
        2.50   5.000e-10    12 % *
        3.50   1.000e-12 > 999 % *
        4.50           0       - *

* not converged, because
  no_score, 1 gate: no light was ever scored there
  large_error, 2 gates: the standard error, with all that may be unseen, is above 10 % of the value
  heavy_tail, 1 gate: scores too rare to have been seen may add up to more than the error

converged: raman 2 of 5 gates
1.23 M photons in 2 s on 1 thread: 617 k photons/s, 4.50 M collisions/s
estimator: forward (auto: it is quicker); seed: 7; engine: scalar
photons of channels that met the target before others: raman 400000
stopped by: interrupt; this is a partial result
warning: first warning
warning: second warning
)");
}

TEST(EchoTable, NumbersThatAreNone) {
  tally::Result result = small_result();
  result.echo.mean[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(has_line(echo_table(result), "        0.50         nan       -"));
}

// Seen red: without the comparison with half a centimetre, "-0.00".
TEST(EchoTable, DepthsJustAboveTheSurface) {
  tally::Result result = small_result();
  result.gate_depth_edge_m = {-0.008, -0.005, -0.002, 0.001, 0.004, 0.007};
  const std::string table = echo_table(result);
  EXPECT_EQ(table.find("-0.00"), std::string::npos);
  EXPECT_TRUE(has_line(table, "       -0.01   1.235e-08  0.10 %"));
  EXPECT_TRUE(has_line(table, "        0.00   1.000e-08   1.5 %"));
}

// A telescope that looks up has no depths: its gates are listed by time.
TEST(EchoTable, DepthsThatAreNone) {
  tally::Result result = small_result();
  result.gate_depth_edge_m.assign(6, std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(has_line(echo_table(result), "   time [ns]        echo   error"));
  EXPECT_TRUE(has_line(echo_table(result), "       85.00   1.235e-08  0.10 %"));
}

TEST(EchoTable, ThinnedToTheRowsAskedFor) {
  const std::string table = echo_table(test::sample_result(), {.max_rows = 10});
  EXPECT_NE(table.find("\nShown: 1 gate of 10; --table full shows all\n"), std::string::npos);
  std::size_t rows = 0;
  for (const auto& line : lines(table.substr(0, table.find("* not"))))
    rows += line.find(" %") != std::string::npos;
  EXPECT_EQ(rows, 2 * 10u);
  EXPECT_EQ(echo_table(test::sample_result(), {.max_rows = 100}).find("Shown"), std::string::npos);
  EXPECT_THROW(echo_table(test::sample_result(), {.max_rows = 0}), ContractViolation);
}

TEST(EchoTable, EachTelescopeItsOwn) {
  const std::string table = echo_table(test::sample_result());
  EXPECT_EQ(lines(table)[0], "Table 1 ship lidar over case-1 water");
  EXPECT_TRUE(has_line(table, "telescope narrow"));
  EXPECT_TRUE(has_line(table, "telescope wide"));
  EXPECT_TRUE(
      has_line(table, "  wide: elastic 45 of 100, raman 94 of 100, chlorophyll 91 of 100 gates"));
}

TEST(EchoTable, FitsATerminalOf100Columns) {
  tally::Result result = small_result();
  for (int extra = 0; extra < 5; ++extra) {
    result.channel_name.push_back(fmt::format("a channel of a long name {}", extra));
    for (std::size_t k = 0; k < 6; ++k) result.gate_depth_edge_m.push_back(static_cast<double>(k));
    for (std::size_t k = 0; k < 5; ++k) {
      result.echo.mean.push_back(1e-8);
      result.echo.standard_error.push_back(1e-10);
      result.convergence_flags.push_back(0);
    }
  }
  const std::string table = echo_table(result);
  std::size_t heads = 0;
  for (const auto& line : lines(table.substr(0, table.find("converged")))) {
    EXPECT_LE(line.size(), 100u) << line;
    heads += line.rfind("   depth [m]", 0) == 0;
  }
  EXPECT_EQ(heads, 2u);  // four channels abreast, then two
}

TEST(EchoTable, RangeIsCalledRange) {
  tally::Result result = small_result();
  result.gate_depth_is_range = true;
  EXPECT_NE(echo_table(result).find(" range [m]"), std::string::npos);
  EXPECT_EQ(echo_table(result).find("depth [m]"), std::string::npos);
}

TEST(EchoTable, ConvergedHasNoLegend) {
  tally::Result result = small_result();
  result.convergence_flags.assign(5, 0);
  const std::string table = echo_table(result);
  EXPECT_EQ(table.find('*'), std::string::npos);
  EXPECT_TRUE(has_line(table, "converged: raman 5 of 5 gates"));
}

/// The small result in other water.
tally::Result small_result_in(const std::vector<std::string>& names) {
  tally::Result result = small_result();
  result.environment_name = names;
  for (const std::string& name : names)
    result.environment_changes.push_back(name.starts_with("many") ? "sea.x = 2" : "");
  for (std::size_t e = 0; e < names.size(); ++e)
    for (std::size_t i = 0; i < 5; ++i) {
      const double echo = result.echo.mean[i];
      const double ratios[] = {0.8, 0.5, 12, 5000, 1}, errors[] = {1e-6, 0.0012, 0.3, 20, 0};
      result.environment_echo.mean.push_back(ratios[i] * echo);
      result.environment_echo.standard_error.push_back(0.1 * echo);
      result.environment_difference.mean.push_back((ratios[i] - 1) * echo);
      result.environment_difference.standard_error.push_back(errors[i] * echo);
      result.environment_convergence_flags.push_back(i == 1 || i == 4 ? tally::uncertain_variance
                                                                      : 0);
    }
  return result;
}

std::string section_of_environments(const tally::Result& result) {
  const std::string table = echo_table(result);
  const std::size_t begin = table.find("\nEnvironments"), end = table.find("\nconverged: ");
  return begin == std::string::npos ? "none" : table.substr(begin, end - begin);
}

// Seen red: with the error of the echo; with only the environment's flags; with the ratio's error
// relative to itself.
TEST(EchoTable, EnvironmentsOverTheScene) {
  EXPECT_EQ(section_of_environments(small_result_in({"no CDOM", "many more algae of this kind"})),
            R"(
Environments: echo over that of the scene, with its standard error
  A no CDOM (3 of 5 gates converged)
  B many more algae of this kind: sea.x = 2 (3 of 5 gates converged)

telescope ship, channel raman
 depth [m]              A               B
      0.50  0.8000±0.0001   0.8000±0.0001
      1.50  0.5000±0.0012*  0.5000±0.0012*
      2.50     12.00±0.30*     12.00±0.30*
      3.50        >999±20*        >999±20*
      4.50              -*              -*

* not converged, because
  uncertain_variance, 4 gates: one batch carries much of the variance
)");
  EXPECT_EQ(section_of_environments(small_result()), "none");
}

/// The small result with derivatives.
tally::Result small_result_to(const std::vector<std::string>& parameters) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  tally::Result result = small_result();
  result.parameter_name = parameters;
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    result.parameter_value.push_back(0.1);
    for (std::size_t i = 0; i < 5; ++i) {
      const double logarithmic[] = {-0.8, 0.5, -12, -5000, nan},
                   errors[] = {1e-6, 0.0012, 0.3, 20, nan};
      result.logarithmic_sensitivity.mean.push_back(logarithmic[i]);
      result.logarithmic_sensitivity.standard_error.push_back(errors[i]);
      result.sensitivity.mean.push_back(0);
      result.sensitivity.standard_error.push_back(0);
      result.sensitivity_convergence_flags.push_back(i == 1 || i == 4 ? tally::uncertain_variance
                                                                      : 0);
    }
  }
  return result;
}

// Seen red, each for itself: with the scene's flags; with large negative numbers taken as large.
TEST(EchoTable, Sensitivities) {
  const std::string table = echo_table(small_result_to({"sea.layer.0.chlorophyll_mg_m3", "sea.x"}));
  const std::size_t begin = table.find("\nSensitivities"), end = table.find("\nconverged: ");
  ASSERT_NE(begin, std::string::npos);
  EXPECT_EQ(table.substr(begin, end - begin), R"(
Sensitivities: change of the echo in per cent for 1 % of each parameter, with the standard error
  A sea.layer.0.chlorophyll_mg_m3, 0.1 in the scene (3 of 5 gates converged)
  B sea.x, 0.1 in the scene (3 of 5 gates converged)

telescope ship, channel raman
 depth [m]              A               B
      0.50 -0.8000±0.0001  -0.8000±0.0001
      1.50  0.5000±0.0012*  0.5000±0.0012*
      2.50    -12.00±0.30*    -12.00±0.30*
      3.50       <-999±20*       <-999±20*
      4.50              -*              -*

* not converged, because
  uncertain_variance, 4 gates: one batch carries much of the variance
)");
  EXPECT_EQ(echo_table(small_result()).find("Sensitivities"), std::string::npos);
}

std::size_t letters(const std::string& line) {  // ± takes two bytes
  return static_cast<std::size_t>(
      std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

// Seen red: with columns for a width of 100 whatever the width.
TEST(EchoTable, FitsTheTerminal) {
  const std::vector<std::string> names{
      "a", "chlorophyll_mg_m3 = 0.05, cdom_a440_per_m = 0.01, minerals_g_m3 = 12.5",
      "c", "d",
      "e", "f",
      "g", "many more algae"};
  for (const std::size_t width : {60, 80, 100, 200}) {
    const std::string table = echo_table(small_result_in(names), {.width = width});
    std::size_t widest = 0;
    for (const auto& line : lines(table)) widest = std::max(widest, letters(line));
    EXPECT_LE(widest, width);
    EXPECT_GT(widest, std::min<std::size_t>(width, 130) - 17) << "uses the room";
    const std::size_t abreast = std::min<std::size_t>(8, (width - 10) / 16);
    EXPECT_EQ(table.find(fmt::format("{} more are in the file", 8 - abreast)) != std::string::npos,
              abreast < 8);
  }
}

// Seen red: with the columns that fit alone.
TEST(EchoTable, AllColumnsStandBelowEachOther) {
  const std::vector<std::string> names{"a", "b", "c", "d", "e", "f", "g", "h"};
  const std::string table = echo_table(small_result_in(names), {.width = 60, .all_columns = true});
  EXPECT_TRUE(has_line(table, " depth [m]              A               B               C"));
  EXPECT_TRUE(has_line(table, " depth [m]              G               H"));
  EXPECT_EQ(table.find("in the file"), std::string::npos);
}

TEST(EchoTable, ColumnsAreCalledAsInSpreadsheets) {
  EXPECT_EQ(column_letters(0), "A");
  EXPECT_EQ(column_letters(25), "Z");
  EXPECT_EQ(column_letters(26), "AA");
  EXPECT_EQ(column_letters(26 * 27), "AAA");
}

TEST(WithPrefix, ThreeDigits) {
  EXPECT_EQ(with_prefix(0), "0");
  EXPECT_EQ(with_prefix(999), "999");
  EXPECT_EQ(with_prefix(999.6), "1.00 k");
  EXPECT_EQ(with_prefix(91234), "91.2 k");
  EXPECT_EQ(with_prefix(9.996e6), "10.0 M");
  EXPECT_EQ(with_prefix(99.96e6), "100 M");
  EXPECT_EQ(with_prefix(4e9), "4.00 G");
  EXPECT_EQ(with_prefix(9.22e18), "9220 P");
}

TEST(EchoTable, EnvironmentsOfEachTelescopeAndChannel) {
  const std::string table = echo_table(test::sample_result_in({"more algae"}));
  for (const char* telescope : {"narrow", "wide"})
    for (const char* channel : {"elastic", "raman", "chlorophyll"})
      EXPECT_TRUE(has_line(table, fmt::format("telescope {}, channel {}", telescope, channel)));
}

}  // namespace
}  // namespace photic::io
