#include "io/tally_places.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/utf8.hpp"

namespace photic::io {
namespace {

/// "depth" of "level_depth": the rest is in the table's title.
std::string short_name(const tally::Coordinate& coordinate) {
  return coordinate.name.substr(coordinate.name.rfind('_') + 1);
}

std::string number_at(const tally::Coordinate& coordinate, std::size_t cell) {
  if (!coordinate.labels.empty()) return coordinate.labels[cell];
  if (coordinate.edges.empty()) return fmt::format("{:.6g}", coordinate.values[cell]);
  return fmt::format("{:.6g} to {:.6g}", coordinate.edges[cell], coordinate.edges[cell + 1]);
}

std::string with_unit(const tally::Coordinate& coordinate, const std::string& numbers) {
  const std::string unit = coordinate.units == "1" ? "" : " " + coordinate.units;
  return short_name(coordinate) + ' ' + numbers + unit;
}

}  // namespace

std::vector<TextColumn> place_columns(const tally::Dimension& dimension, std::size_t step) {
  std::vector<TextColumn> out;
  for (const tally::Coordinate& coordinate : dimension.coordinates) {
    const std::string unit = coordinate.units == "1" ? "" : " [" + coordinate.units + "]";
    out.push_back({short_name(coordinate) + unit, {}});
    for (std::size_t i = 0; i < dimension.size; i += step)
      out.back().cells.push_back(number_at(coordinate, i));
  }
  return out;
}

std::size_t place_width_of(const TextColumn& column) {
  std::size_t width = letters(column.heading);
  for (const std::string& cell : column.cells) width = std::max(width, letters(cell));
  return width;
}

std::string place_text(const tally::Dimension& dimension, std::size_t cell) {
  std::vector<std::string> parts;
  for (const tally::Coordinate& each : dimension.coordinates)
    parts.push_back(each.labels.empty() ? with_unit(each, number_at(each, cell))
                                        : each.labels[cell]);
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string extent_text(const tally::Dimension& dimension) {
  std::vector<std::string> parts;
  for (const tally::Coordinate& each : dimension.coordinates)
    if (!each.edges.empty())
      parts.push_back(
          with_unit(each, fmt::format("{:.6g} to {:.6g}", each.edges.front(), each.edges.back())));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace photic::io
