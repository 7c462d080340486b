#include "photic/data_folder.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "core/error.hpp"
#include "photic/program.hpp"

namespace photic::app {
namespace {

namespace fs = std::filesystem;

/// A file that every data folder holds.
constexpr const char* landmark = "water_mason_2016.csv";

bool holds_data(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_regular_file(folder / landmark, ignored);
}

}  // namespace

std::string find_data_folder() {
  if (const char* given = std::getenv("PHOTIC_DATA"); given != nullptr && *given != '\0') {
    if (holds_data(given)) return given;
    throw EnvironmentError(
        fmt::format("no data tables in {} (named by PHOTIC_DATA): it has no {}", given, landmark));
  }
  std::vector<fs::path> places;
  if (const fs::path prefix = program_prefix(); !prefix.empty())
    places.push_back(prefix / "share/photic/data");
  places.emplace_back(PHOTIC_SOURCE_DATA);
  std::string looked;
  for (const fs::path& place : places) {
    if (holds_data(place)) return place.string();
    looked += (looked.empty() ? "" : ", ") + place.string();
  }
  throw EnvironmentError(fmt::format(
      "no data tables: looked for {} in {} (PHOTIC_DATA names another folder)", landmark, looked));
}

}  // namespace photic::app
