// Prices against instructions that were counted, in benchmarks/prices.csv.
#include "run/prices.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "run/run.hpp"
#include "scene/read.hpp"
#include "support/tables.hpp"

namespace photic::run {
namespace {

using Row = std::map<std::string, std::string>;

/// A field of a line of CSV, perhaps in quotes.
std::string field(std::istream& line) {
  std::string out;
  if (line.peek() == '"') {
    line.get();
    std::getline(line, out, '"');
    line.get();
  } else {
    std::getline(line, out, ',');
  }
  return out;
}

std::vector<Row> rows() {
  std::ifstream file(PHOTIC_SOURCE_DIR "/benchmarks/prices.csv");
  std::vector<std::string> columns;
  std::vector<Row> out;
  for (std::string text; std::getline(file, text);) {
    std::istringstream line(text);
    const bool head = columns.empty();
    Row row;
    for (std::size_t k = 0; line.peek() != EOF; ++k) {
      if (head)
        columns.push_back(field(line));
      else
        row[columns.at(k)] = field(line);
    }
    if (!head) out.push_back(std::move(row));
  }
  return out;
}

std::uint64_t count(const Row& row, const std::string& name) { return std::stoull(row.at(name)); }

tally::TotalsState state_of(const Row& row) {
  tally::TotalsState out;
  out.photons = count(row, "photons");
  out.collisions = count(row, "collisions");
  out.scores = count(row, "scores");
  tally::Operations::each([&](const char* name, auto& number) { number = count(row, name); },
                          out.operations);
  return out;
}

const Prices& prices_of(const Row& row) {
  return row.at("way").starts_with("forward") ? forward_prices : bidirectional_prices;
}

// Seen red: with the price of a meeting doubled.
TEST(Prices, PredictTheInstructionsOfAllStarters) {
  const auto all = rows();
  ASSERT_GT(all.size(), 100U);
  for (const Row& row : all) {
    const double predicted = instructions(prices_of(row), state_of(row),
                                          {.layered = count(row, "layered") == 1,
                                           .film = count(row, "film") == 1,
                                           .environments = count(row, "environments")});
    const double ratio = predicted / static_cast<double>(count(row, "instructions"));
    EXPECT_GT(ratio, 0.8) << row.at("scene") << ", " << row.at("way");
    EXPECT_LT(ratio, 1.25) << row.at("scene") << ", " << row.at("way");
  }
}

/// The state of a starter's run, as benchmarks/prices.py has it run.
tally::TotalsState run_of(const std::string& starter, const std::string& way,
                          std::uint64_t photons) {
  scene::Scene scene = scene::read_scene(PHOTIC_SOURCE_DIR "/scenes/" + starter + ".toml").scene;
  scene::Simulation& s = scene.simulation;
  s.target_relative_error.reset();
  s.max_time_s.reset();
  s.photons = photons;
  s.batch_photons = 2000;
  s.estimator = way == "forward" ? scene::Estimator::forward : scene::Estimator::bidirectional;
  s.free_telescope_meetings = s.free_laser_meetings = 0;
  return run(scene, *test::tables()).state.value();
}

// The table is to be counted anew when an estimator's operations change. Seen red: with a table
// whose meetings are a tenth more.
TEST(Prices, AreOfTheOperationsThatTheEstimatorsHave) {
  for (const std::string way : {"forward", "bidirectional"}) {
    const std::uint64_t photons = way == "forward" ? 30000 : 2000;
    for (const Row& row : rows()) {
      if (row.at("scene") != "ship" || row.at("way") != way || row.at("environments") != "0")
        continue;
      const auto once = run_of("ship", way, photons), twice = run_of("ship", way, 2 * photons);
      const auto check = [&](const char* name, std::uint64_t more) {
        const auto counted = static_cast<double>(count(row, name));
        EXPECT_NEAR(static_cast<double>(more), counted, 0.02 * counted) << way << ", " << name;
      };
      check("collisions", twice.collisions - once.collisions);
      check("scores", twice.scores - once.scores);
      tally::Operations more = twice.operations;
      const auto& less = once.operations;
      check("local_estimates", more.local_estimates - less.local_estimates);
      check("vertex_pairs", more.vertex_pairs - less.vertex_pairs);
      check("ray_pairs", more.ray_pairs - less.ray_pairs);
      check("meetings", more.meetings - less.meetings);
    }
  }
}

}  // namespace
}  // namespace photic::run
