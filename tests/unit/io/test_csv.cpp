#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "io/csv.hpp"
#include "io/echo_rows.hpp"
#include "unit/io/sample_result.hpp"
#include "unit/io/temporary_folder.hpp"

namespace photic::io {
namespace {

using Record = std::vector<std::string>;

/// Lines that start with '#' apart, then RFC 4180.
struct Csv {
  std::vector<std::string> head;
  std::vector<Record> records;

  explicit Csv(const std::string& text) {
    std::size_t at = 0;
    while (at < text.size() && text[at] == '#') {
      const std::size_t end = text.find('\n', at);
      head.push_back(text.substr(at, end - at));
      at = end + 1;
    }
    Record record(1);
    bool quoted = false;
    for (; at < text.size(); ++at) {
      const char c = text[at];
      if (quoted && c == '"' && text[at + 1] == '"')
        record.back() += text[++at];
      else if (c == '"')
        quoted = !quoted;
      else if (!quoted && c == ',')
        record.emplace_back();
      else if (!quoted && c == '\n') {
        records.push_back(record);
        record = Record(1);
      } else
        record.back() += c;
    }
  }
};

double number(const std::string& text) {
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  EXPECT_TRUE(error == std::errc() && end == text.data() + text.size()) << text;
  return value;
}

TEST(Csv, ReadsBackToTheSameNumbers) {
  const tally::Result result = test::sample_result();
  const Csv csv(echo_csv(result));
  ASSERT_EQ(csv.records.size(), 1 + 2 * 3 * 100u);
  EXPECT_EQ(csv.records[0],
            (Record{"telescope", "channel", "gate", "time_start_ns", "time_end_ns", "depth_m",
                    "echo", "standard_error", "relative_error", "converged", "reasons"}));
  std::size_t line = 0;
  for (std::size_t t = 0; t < 2; ++t)
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < 100; ++k) {
        const std::size_t i = line++;
        const Record& record = csv.records[line];
        ASSERT_EQ(record.size(), 11u);
        EXPECT_EQ(record[0], result.telescope_name[t]);
        EXPECT_EQ(record[1], result.channel_name[c]);
        EXPECT_EQ(record[2], std::to_string(k));
        EXPECT_EQ(number(record[3]), result.gate_time_edge_ns[k]);
        EXPECT_EQ(number(record[4]), result.gate_time_edge_ns[k + 1]);
        const double* edge = &result.gate_depth_edge_m[101 * (3 * t + c) + k];
        EXPECT_EQ(number(record[5]), 0.5 * (edge[0] + edge[1]));
        const double echo = result.echo.mean[i], error = result.echo.standard_error[i];
        EXPECT_EQ(number(record[6]), echo);
        EXPECT_EQ(number(record[7]), error);
        if (echo > 0)
          EXPECT_EQ(number(record[8]), error / echo);
        else
          EXPECT_EQ(record[8], "nan");
        EXPECT_EQ(record[9], result.convergence_flags[i] == 0 ? "yes" : "no");
        std::string reasons;
        for (const auto name : flag_names(result.convergence_flags[i])) {
          if (!reasons.empty()) reasons += ' ';
          reasons += name;
        }
        EXPECT_EQ(record[10], reasons);
      }
}

TEST(Csv, ReasonsAreNamedLowestBitFirst) {
  using FlagNames = std::vector<std::string_view>;
  EXPECT_EQ(flag_names(0), FlagNames{});
  EXPECT_EQ(flag_names(tally::heavy_tail | tally::large_error),
            (FlagNames{"large_error", "heavy_tail"}));
}

TEST(Csv, HeadSaysWhatItIs) {
  tally::Result result = test::sample_result();
  result.title = "two\nlines";
  result.partial = true;
  const Csv csv(echo_csv(result));
  EXPECT_EQ(csv.head.at(0), "# two lines");
  EXPECT_EQ(csv.head.at(1),
            "# Photic 0.1.0, estimator forward, engine scalar, seed 1, photons 20000000 (partial: "
            "interrupted)");
  EXPECT_EQ(csv.head.at(2),
            "# photons of channels that met the target before others: wide raman 400000");
  EXPECT_EQ(csv.head.at(3), "# warning: " + result.warnings[0]);
  EXPECT_EQ(csv.head.at(4),
            "# echo: expected photons detected in the gate per photon emitted; standard_error: of "
            "the echo");
  EXPECT_NE(csv.head.at(5).find("depth_m: vertical"), std::string::npos);
  result.gate_depth_is_range = true;
  EXPECT_NE(Csv(echo_csv(result)).head.at(5).find("depth_m: range along the axis"),
            std::string::npos);
}

// Seen red: without the quotes the fields shift.
TEST(Csv, QuotesWhatNeedsIt) {
  tally::Result result = test::sample_result();
  result.channel_name = {"a,b", "say \"c\"", "d\ne #f"};
  const Csv csv(echo_csv(result));
  ASSERT_EQ(csv.records.size(), 601u);
  for (std::size_t c = 0; c < 3; ++c) {
    ASSERT_EQ(csv.records[1 + 100 * c].size(), 11u);
    EXPECT_EQ(csv.records[1 + 100 * c][1], result.channel_name[c]);
  }
}

// Seen red: with the rows of the first environment for the second; with the error of the echo in
// the place of the difference's; with the numbers of the first environment for the second.
TEST(Csv, EnvironmentsFollowTheScene) {
  const std::vector<std::string> names{"more algae", "a \"b\", c"};
  const tally::Result result = test::sample_result_in(names);
  const Csv csv(echo_csv(result)), scene(echo_csv(test::sample_result()));
  ASSERT_EQ(csv.records.size(), 1 + 3 * 600u);
  const Record more{"environment", "difference", "difference_standard_error",
                    "sea.layer.0.chlorophyll_mg_m3", "sea.layer.0.cdom_a440_per_m"};
  EXPECT_EQ(Record(csv.records[0].begin() + 11, csv.records[0].end()), more);
  for (std::size_t i = 1; i <= 600; ++i) {
    Record record = scene.records[i];
    record.insert(record.end(), {"", "nan", "nan", "", ""});
    EXPECT_EQ(csv.records[i], record);
  }
  for (std::size_t i = 0; i < 1200; ++i) {
    const Record& record = csv.records[601 + i];
    ASSERT_EQ(record.size(), 16u);
    EXPECT_EQ(Record(record.begin(), record.begin() + 6),
              Record(scene.records[1 + i % 600].begin(), scene.records[1 + i % 600].begin() + 6));
    EXPECT_EQ(number(record[6]), result.environment_echo.mean[i]);
    EXPECT_EQ(number(record[7]), result.environment_echo.standard_error[i]);
    EXPECT_EQ(record[9], result.environment_convergence_flags[i] == 0 ? "yes" : "no");
    EXPECT_EQ(record[11], names[i / 600]);
    EXPECT_EQ(number(record[12]), result.environment_difference.mean[i]);
    EXPECT_EQ(number(record[13]), result.environment_difference.standard_error[i]);
    EXPECT_EQ(number(record[14]), result.environment_value[2 * (i / 600)]);
    if (i < 600)
      EXPECT_EQ(record[15], "nan");
    else
      EXPECT_EQ(number(record[15]), result.environment_value[3]);
  }
}

// Seen red, each for itself: with the logarithmic derivative's error in the place of the other's;
// with the scene's flags.
TEST(Csv, ParametersFollowTheEnvironments) {
  const tally::Result result = test::sample_result_in({"more algae"}, {"sea.x", "sea.\"y\""});
  const Csv csv(echo_csv(result)), before(echo_csv(test::sample_result_in({"more algae"})));
  ASSERT_EQ(csv.records.size(), 1 + 4 * 600u);
  const Record more{"parameter", "sensitivity", "sensitivity_standard_error",
                    "logarithmic_sensitivity", "logarithmic_sensitivity_standard_error"};
  EXPECT_EQ(Record(csv.records[0].begin() + 16, csv.records[0].end()), more);
  for (std::size_t i = 1; i <= 1200; ++i) {
    Record record = before.records[i];
    record.insert(record.end(), {"", "nan", "nan", "nan", "nan"});
    EXPECT_EQ(csv.records[i], record);
  }
  for (std::size_t i = 0; i < 1200; ++i) {
    const Record& record = csv.records[1201 + i];
    ASSERT_EQ(record.size(), 21u);
    const Record& of_scene = before.records[1 + i % 600];
    EXPECT_EQ(Record(record.begin(), record.begin() + 9),
              Record(of_scene.begin(), of_scene.begin() + 9));
    EXPECT_EQ(record[9], result.sensitivity_convergence_flags[i] == 0 ? "yes" : "no");
    for (const std::size_t empty : {11, 14, 15}) EXPECT_EQ(record[empty], "");
    EXPECT_EQ(record[16], result.parameter_name[i / 600]);
    EXPECT_EQ(number(record[17]), result.sensitivity.mean[i]);
    EXPECT_EQ(number(record[18]), result.sensitivity.standard_error[i]);
    if (result.echo.mean[i % 600] == 0) {
      EXPECT_EQ(record[19], "nan");
      continue;
    }
    EXPECT_EQ(number(record[19]), result.logarithmic_sensitivity.mean[i]);
    EXPECT_EQ(number(record[20]), result.logarithmic_sensitivity.standard_error[i]);
  }
  const Csv alone(echo_csv(test::sample_result_in({}, {"sea.x"})));
  EXPECT_EQ(Record(alone.records[0].begin() + 11, alone.records[0].end()), more);
}

TEST(Csv, WritesTheFile) {
  const test::TemporaryFolder folder;
  const tally::Result result = test::sample_result();
  write_csv(result, folder.file("out.csv"));
  EXPECT_EQ(test::read_file(folder.file("out.csv")), echo_csv(result));
}

}  // namespace
}  // namespace photic::io
