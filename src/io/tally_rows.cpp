#include "io/tally_rows.hpp"

#include <algorithm>
#include <cctype>
#include <limits>

#include "core/error.hpp"

namespace photic::io {
namespace {

/// "_m", "_deg"; nothing of what has no unit.
std::string ending(const std::string& units) {
  if (units == "1" || units.empty()) return "";
  if (units == "degree") return "_deg";
  std::string out = "_" + units;
  std::ranges::replace_if(
      out, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return out;
}

void add_coordinate(const tally::Coordinate& coordinate, std::size_t i,
                    std::vector<PlaceField>& out) {
  const std::string unit = ending(coordinate.units);
  if (!coordinate.edges.empty()) {
    out.emplace_back(coordinate.name + "_start" + unit, coordinate.edges[i]);
    out.emplace_back(coordinate.name + "_end" + unit, coordinate.edges[i + 1]);
  } else if (coordinate.labels.empty()) {
    out.emplace_back(coordinate.name + unit, coordinate.values[i]);
  }
}

void add_dimension(const tally::Dimension& dimension, std::size_t i, std::vector<PlaceField>& out) {
  const auto& all = dimension.coordinates;
  const auto named = std::ranges::find_if(all, [](const auto& c) { return !c.labels.empty(); });
  if (named != all.end())
    out.emplace_back(dimension.name, named->labels[i]);
  else if (std::ranges::find(all, dimension.name, &tally::Coordinate::name) == all.end())
    out.emplace_back(dimension.name, i);
  for (const tally::Coordinate& coordinate : all) add_coordinate(coordinate, i, out);
}

}  // namespace

std::vector<TallyRow> tally_rows(const tally::TallyEstimates& tally) {
  const std::size_t count = tally.grid.size();
  expect(tally.mean.size() == count && tally.standard_error.size() == count &&
             tally.flags.size() == count,
         "a value, its error and its flags for every cell");
  std::vector<TallyRow> rows(count);
  for (std::size_t i = 0; i < count; ++i) {
    TallyRow& row = rows[i];
    row.grid = &tally.grid;
    row.value = tally.mean[i];
    row.standard_error = tally.standard_error[i];
    row.relative_error =
        row.value > 0 ? row.standard_error / row.value : std::numeric_limits<double>::quiet_NaN();
    row.flags = tally.flags[i];
    std::size_t left = i;
    row.index.resize(tally.grid.dimensions.size());
    for (std::size_t d = row.index.size(); d-- > 0; left /= tally.grid.dimensions[d].size)
      row.index[d] = left % tally.grid.dimensions[d].size;
  }
  return rows;
}

std::vector<PlaceField> place_of(const TallyRow& row) {
  std::vector<PlaceField> out;
  for (std::size_t d = 0; d < row.index.size(); ++d)
    add_dimension(row.grid->dimensions[d], row.index[d], out);
  return out;
}

std::string unit_of(const tally::TallyGrid& grid) {
  return grid.units == "1" ? grid.normalisation : grid.units + " " + grid.normalisation;
}

}  // namespace photic::io
