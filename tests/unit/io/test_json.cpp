#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "unit/io/sample_result.hpp"

namespace photic::io {
namespace {

using nlohmann::json;

TEST(EchoJson, ReadsBackToTheSameNumbers) {
  tally::Result result = test::sample_result();
  result.photons = 9223372036854788153u;
  const std::string text = echo_json(result);
  const json parsed = json::parse(text);
  EXPECT_EQ(text.back(), '\n');
  EXPECT_EQ(parsed["title"], result.title);
  EXPECT_EQ(parsed["photons"].get<std::uint64_t>(), 9223372036854788153u);
  EXPECT_EQ(parsed["wall_time_s"], 23.5);
  EXPECT_EQ(parsed["partial"], false);
  EXPECT_EQ(parsed["warnings"], json(result.warnings));
  EXPECT_EQ(parsed["ledger"]["cut_by_time"], 0.18);
  ASSERT_EQ(parsed["echoes"].size(), 600u);
  for (std::size_t i = 0; i < 600; ++i) {
    const json& echo = parsed["echoes"][i];
    EXPECT_EQ(echo["telescope"], result.telescope_name[i / 300]);
    EXPECT_EQ(echo["channel"], result.channel_name[i / 100 % 3]);
    EXPECT_EQ(echo["gate"], i % 100);
    EXPECT_EQ(echo["time_start_ns"], result.gate_time_edge_ns[i % 100]);
    EXPECT_EQ(echo["echo"], result.echo.mean[i]);
    EXPECT_EQ(echo["standard_error"], result.echo.standard_error[i]);
    EXPECT_EQ(echo["relative_error"].is_null(), result.echo.mean[i] == 0);
    EXPECT_EQ(echo["converged"], result.convergence_flags[i] == 0);
    EXPECT_EQ(echo["reasons"].empty(), result.convergence_flags[i] == 0);
  }
  EXPECT_EQ(parsed["echoes"][99]["reasons"], json({"no_score"}));
}

// Seen red: with the values of the first environment for all.
TEST(EchoJson, EnvironmentsIfThereAreAny) {
  const json alone = json::parse(echo_json(test::sample_result()));
  EXPECT_FALSE(alone.contains("environment_echoes") || alone.contains("environments"));
  const tally::Result result = test::sample_result_in({"more algae", "no CDOM"});
  const json parsed = json::parse(echo_json(result));
  EXPECT_EQ(parsed["echoes"].size(), 600u);
  const char* const chlorophyll = "sea.layer.0.chlorophyll_mg_m3";
  const char* const cdom = "sea.layer.0.cdom_a440_per_m";
  EXPECT_EQ(parsed["environments"],
            json({{{"name", "more algae"}, {"values", {{chlorophyll, 0.1}, {cdom, nullptr}}}},
                  {{"name", "no CDOM"}, {"values", {{chlorophyll, 0.2}, {cdom, 0.01}}}}}));
  ASSERT_EQ(parsed["environment_echoes"].size(), 1200u);
  for (std::size_t i = 0; i < 1200; ++i) {
    const json& echo = parsed["environment_echoes"][i];
    EXPECT_EQ(echo["environment"], result.environment_name[i / 600]);
    EXPECT_EQ(echo["channel"], result.channel_name[i / 100 % 3]);
    EXPECT_EQ(echo["echo"], result.environment_echo.mean[i]);
    EXPECT_EQ(echo["difference"], result.environment_difference.mean[i]);
    EXPECT_EQ(echo["difference_standard_error"], result.environment_difference.standard_error[i]);
    EXPECT_EQ(echo["converged"], result.environment_convergence_flags[i] == 0);
  }
}

// Seen red: with the first parameter's value for the second.
TEST(EchoJson, SensitivitiesIfThereAreAny) {
  EXPECT_FALSE(json::parse(echo_json(test::sample_result())).contains("sensitivities"));
  const tally::Result result = test::sample_result_in({}, {"sea.x", "sea.y"});
  const json parsed = json::parse(echo_json(result));
  ASSERT_EQ(parsed["sensitivities"].size(), 1200u);
  for (std::size_t i = 0; i < 1200; ++i) {
    const json& one = parsed["sensitivities"][i];
    EXPECT_EQ(one["parameter"], result.parameter_name[i / 600]);
    EXPECT_EQ(one["value"], result.parameter_value[i / 600]);
    EXPECT_EQ(one["channel"], result.channel_name[i / 100 % 3]);
    EXPECT_EQ(one["echo"], result.echo.mean[i % 600]);
    EXPECT_EQ(one["sensitivity"], result.sensitivity.mean[i]);
    EXPECT_EQ(one["sensitivity_standard_error"], result.sensitivity.standard_error[i]);
    EXPECT_EQ(one["converged"], result.sensitivity_convergence_flags[i] == 0);
    EXPECT_EQ(one["logarithmic_sensitivity"].is_null(), result.echo.mean[i % 600] == 0);
    if (one["logarithmic_sensitivity"].is_null()) continue;
    EXPECT_EQ(one["logarithmic_sensitivity"], result.logarithmic_sensitivity.mean[i]);
    EXPECT_EQ(one["logarithmic_sensitivity_standard_error"],
              result.logarithmic_sensitivity.standard_error[i]);
  }
}

TEST(EchoJson, AwkwardTextsAndNumbers) {
  tally::Result result = test::sample_result();
  result.title = "say \"häß\"\\\n\t\x01";
  result.channel_name[0] = "\xff no UTF-8";
  result.echo.mean[0] = std::numeric_limits<double>::quiet_NaN();
  result.echo.standard_error[0] = std::numeric_limits<double>::infinity();
  const json parsed = json::parse(echo_json(result));
  EXPECT_EQ(parsed["title"], result.title);
  EXPECT_EQ(parsed["echoes"][0]["channel"], "\xef\xbf\xbd no UTF-8");
  EXPECT_TRUE(parsed["echoes"][0]["echo"].is_null());
  EXPECT_TRUE(parsed["echoes"][0]["standard_error"].is_null());
}

}  // namespace
}  // namespace photic::io
