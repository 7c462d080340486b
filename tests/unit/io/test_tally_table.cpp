// Quantities beside echoes as tables, in CSV and in JSON.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/csv.hpp"
#include "io/json.hpp"
#include "io/table.hpp"
#include "unit/io/sample_result.hpp"
#include "unit/io/sample_tallies.hpp"
#include "unit/io/temporary_folder.hpp"

namespace photic::io {
namespace {

using Texts = std::vector<std::string>;

Texts split(const std::string& text, char at) {
  std::istringstream in(text);
  Texts out;
  for (std::string part; std::getline(in, part, at);) out.push_back(part);
  if (text.ends_with(at) && at == ',') out.emplace_back();
  return out;
}

void expect_block(const std::string& table, const std::string& block) {
  EXPECT_NE(table.find(block), std::string::npos) << block << "\nis not in\n" << table;
}

tally::Result with_echoes() {
  tally::Result result = test::sample_result();
  test::add_sample_tallies(result);
  return result;
}

// Seen red: without the scale of the strength; with the asterisk where it has converged.
TEST(TallyTable, IrradianceAtLevels) {
  expect_block(echo_table(test::sample_tallies_alone()), R"(Sun over two layers of water
Irradiance [W m-2]; error: standard error over value
                                                           scalar irradiance     scalar irradiance
               downward plane        upward plane          of light on its way   of light on its way
               irradiance            irradiance            down                  up
   depth [m]         E_d   error           E_u   error          E_0d   error          E_0u   error
         -10   3.600e+01  0.40 %     2.880e+01  0.40 %     2.304e+01  0.40 %     1.843e+01  0.40 %
           0   2.537e+01  0.65 %     2.030e+01  0.65 %     1.624e+01  0.65 %     1.299e+01  0.65 %
)");
  expect_block(echo_table(test::sample_tallies_alone()), R"(
          60   3.107e+00    12 % *   2.485e+00    12 % *   1.988e+00    12 % *   1.591e+00    12 % *

)");
}

// Seen red: with cells without light listed; with layers and constituents exchanged.
TEST(TallyTable, BoundariesAsLists) {
  tally::Result result = test::sample_tallies_alone();
  result.tallies[10].mean[0] = 0;  // no ground
  result.tallies[10].flags[0] = tally::no_score;
  const std::string table = echo_table(result);
  expect_block(table, R"(
Light absorbed in a layer by a constituent [W m-2]
   layer   constituent       value   error
   upper   water         1.475e+01  0.40 %
   upper   chlorophyll   1.039e+01  0.65 %
   upper   cdom          7.322e+00   1.1 %
   lower   water         8.944e+00  0.81 %
   lower   chlorophyll   6.302e+00   1.3 %
   lower   cdom          4.441e+00   2.1 %
   haze    aerosol       1.898e+00   7.1 %
Not shown: 5 without light

)");
  expect_block(table, R"(
           0 to 10   1.180e+01  0.40 %
)");
  expect_block(table, R"(
   light absorbed by the film of oil               4.832e+00  0.40 %
   all light, by where it ends                     3.092e+00  0.40 %
Not shown: 1 without light
)");
}

// Seen red: with the cells of directions and levels exchanged; with the last cell for the largest.
TEST(TallyTable, RadianceAndFluence) {
  const std::string table = echo_table(test::sample_tallies_alone());
  expect_block(table, R"(
Radiance of scattered light [W m-2 sr-1]
               zenith 0 degree,      zenith 30 degree,     zenith 180 degree,
               azimuth 0 degree      azimuth 90 degree     azimuth 0 degree
   depth [m]           L   error             L   error             L   error
           0   2.474e+00  0.40 %     1.500e+00  0.81 %     9.101e-01   1.6 %
           5   1.743e+00  0.65 %     1.057e+00   1.3 %     6.413e-01   2.6 %
)");
  expect_block(table, R"(
Fluence about the source [W m-2 m-2]
  depth 0 to 20 m, radius 0 to 10 m, in 400 cells; largest 1.979e+00, error 0.40 %, at depth 0 to 1
  m, radius 0 to 0.5 m; converged: 21 of 400 (59 without light)
)");
}

TEST(TallyTable, WhyAndHowManyHaveConverged) {
  const std::string table = echo_table(test::sample_tallies_alone());
  expect_block(table, R"(
* not converged, because
  no_score, 64 cells: no light was ever scored there
  large_error, 405 cells: the standard error, with all that may be unseen, is above 10 % of the
    value

converged tallies: irradiance 28 of 32, boundaries 20 of 27 (5 without light), radiance 9 of 9,
  fluence 42 of 500 (59 without light) cells
2.00 M photons in 2 s on 2 threads)");
  EXPECT_EQ(table.find("Echo"), std::string::npos);
}

// Seen red: with the units without the normalisation.
TEST(TallyTable, WithoutAStrengthSaysTheNormalisation) {
  tally::Result result = test::sample_tallies_alone();
  for (tally::TallyEstimates& tally : result.tallies) tally.grid.by_strength.reset();
  const std::string table = echo_table(result);
  expect_block(table, "\nIrradiance, per unit irradiance across the beam; error");
  expect_block(table, "\n         -10   7.200e-01  0.40 %  ");
  expect_block(table, "\nRadiance of scattered light, sr-1 per unit irradiance across the beam\n");
}

// Seen red: with all columns beside each other.
TEST(TallyTable, FitsTheTerminalAndItsRows) {
  for (const std::size_t width : {60, 80, 100}) {
    for (const std::string& line :
         split(echo_table(test::sample_tallies_alone(), {.width = width}), '\n'))
      EXPECT_LE(line.size(), width) << line;
  }
  const std::string thinned = echo_table(test::sample_tallies_alone(), {.max_rows = 4});
  expect_block(thinned, "Shown: 1 row of 2; --table full shows all\n");
  EXPECT_EQ(thinned.find("\n          60   3.107e+00"), std::string::npos);
  const std::string full = echo_table(test::sample_tallies_alone(), {.max_rows = all_rows});
  EXPECT_EQ(full.find("Shown"), std::string::npos);
}

TEST(TallyTable, FollowsTheEchoes) {
  const std::string table = echo_table(with_echoes());
  EXPECT_LT(table.find("telescope wide"), table.find("Irradiance [W m-2]"));
  EXPECT_LT(table.find("converged\n"), table.find("converged tallies"));
}

// Seen red: with the place of the first cell for all; with the end of intervals for their start.
TEST(TallyCsv, OneRowForEachCell) {
  const tally::Result result = test::sample_tallies_alone();
  Texts lines = split(echo_csv(result), '\n');
  EXPECT_EQ(lines.at(2),
            "# irradiance_down: downward plane irradiance, per unit irradiance across the beam; "
            "times 50 in W m-2");
  std::erase_if(lines, [](const std::string& line) { return line.starts_with('#'); });
  EXPECT_EQ(lines.size(), 1 + tally::cells_of(test::sample_tally_grids()));
  EXPECT_TRUE(
      lines[0].starts_with("quantity,level,level_depth_m,layer,constituent,"
                           "escape_zenith_start_deg,escape_zenith_end_deg,direction,"
                           "direction_zenith_deg,direction_azimuth_deg,radiance_level,"
                           "radiance_level_depth_m,fluence_lamp_depth_start_m,"));
  EXPECT_TRUE(lines[0].ends_with(",value,standard_error,relative_error,converged,reasons,units"));
  for (const std::string& line : lines)
    EXPECT_EQ(split(line, ',').size(), split(lines[0], ',').size()) << line;
  const auto& e_d = result.tallies[0];
  EXPECT_EQ(lines[8],
            fmt::format("irradiance_down,7,60{:,>18}{},{},{},no,large_error,1", "", e_d.mean[7],
                        e_d.standard_error[7], e_d.standard_error[7] / e_d.mean[7]));
  EXPECT_TRUE(lines[33].starts_with("absorbed,,,upper,water,,")) << lines[33];
  EXPECT_TRUE(lines[46].starts_with("escaped,,,,,10,20,,")) << lines[46];
}

// Seen red: with the tallies' columns before those of echoes.
TEST(TallyCsv, FollowsTheEchoesWhoseColumnsStay) {
  const tally::Result result = with_echoes();
  Texts lines = split(echo_csv(result), '\n'),
        before = split(echo_csv(test::sample_result()), '\n');
  for (Texts* some : {&lines, &before})
    std::erase_if(*some, [](const std::string& line) { return line.starts_with('#'); });
  ASSERT_EQ(lines.size(), before.size() + tally::cells_of(test::sample_tally_grids()));
  const std::size_t columns = split(lines[0], ',').size(), more = columns - 11;
  EXPECT_TRUE(lines[0].starts_with(before[0] + ",quantity,level,level_depth_m,"));
  for (std::size_t i = 1; i < before.size(); ++i)
    EXPECT_EQ(lines[i], before[i] + std::string(more, ','));
  const Texts first = split(lines[before.size()], ',');
  ASSERT_EQ(first.size(), columns);
  EXPECT_EQ(Texts(first.begin(), first.begin() + 7), Texts(7));
  EXPECT_EQ(first[7], fmt::format("{}", result.tallies[0].standard_error[0]));
  EXPECT_EQ(first[11], "irradiance_down");
  EXPECT_EQ(first[columns - 2], fmt::format("{}", result.tallies[0].mean[0]));
}

// Seen red: without the columns of environments between them.
TEST(TallyCsv, HasAsManyColumnsBesideEnvironmentsAndParameters) {
  tally::Result result = test::sample_result_in({"bloom"}, {"sea.x"});
  test::add_sample_tallies(result);
  Texts lines = split(echo_csv(result), '\n');
  std::erase_if(lines, [](const std::string& line) { return line.starts_with('#'); });
  for (const std::string& line : lines)
    ASSERT_EQ(split(line, ',').size(), split(lines[0], ',').size()) << line;
}

// Seen red: with the first quantity for all.
TEST(TallyJson, QuantitiesWithTheirCells) {
  using nlohmann::json;
  const tally::Result result = test::sample_tallies_alone();
  const json parsed = json::parse(echo_json(result));
  EXPECT_TRUE(parsed["echoes"].empty());
  EXPECT_EQ(parsed["source_strength"], 50);
  EXPECT_EQ(parsed["source_strength_units"], "W m-2");
  ASSERT_EQ(parsed["tallies"].size(), result.tallies.size());
  for (std::size_t t = 0; t < result.tallies.size(); ++t) {
    const tally::TallyEstimates& tally = result.tallies[t];
    const json& one = parsed["tallies"][t];
    EXPECT_EQ(one["quantity"], tally.grid.name);
    EXPECT_EQ(one["normalisation"], tally.grid.normalisation);
    EXPECT_EQ(one["strength_units"], tally.grid.by_strength->units);
    ASSERT_EQ(one["cells"].size(), tally.mean.size());
    for (std::size_t i = 0; i < tally.mean.size(); ++i) {
      EXPECT_EQ(one["cells"][i]["value"], tally.mean[i]);
      EXPECT_EQ(one["cells"][i]["standard_error"], tally.standard_error[i]);
      EXPECT_EQ(one["cells"][i]["converged"], tally.flags[i] == 0);
    }
  }
  const json& radiance = parsed["tallies"][12]["cells"][5];
  EXPECT_EQ(radiance["direction"], 1);
  EXPECT_EQ(radiance["direction_azimuth_deg"], 90);
  EXPECT_EQ(radiance["radiance_level_depth_m"], 20);
  EXPECT_FALSE(json::parse(echo_json(test::sample_result())).contains("tallies"));
}

// Seen red: with as many rows as there are gates, "a table has at least one row".
TEST(TallyTable, IsWrittenAsAFileWithoutEchoes) {
  const test::TemporaryFolder folder;
  write_table(test::sample_tallies_alone(), folder.file("out.txt"));
  expect_block(test::read_file(folder.file("out.txt")), "Irradiance [W m-2]");
  write_csv(test::sample_tallies_alone(), folder.file("out.csv"));
  EXPECT_EQ(photons_in_text(folder.file("out.csv")), 2'000'000u);
}

}  // namespace
}  // namespace photic::io
