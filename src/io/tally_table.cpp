#include "io/tally_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <vector>

#include "io/table_parts.hpp"
#include "io/tally_places.hpp"
#include "io/tally_rows.hpp"
#include "io/text_columns.hpp"
#include "scene/choices.hpp"

namespace photic::io {
namespace {

constexpr std::size_t before_column = 3;  // blanks

using TallyRows = std::vector<TallyRow>;

/// Quantities that are shown beside each other: on the same dimensions, in the same unit.
using Group = std::vector<TallyRows>;

std::string shown_unit(const tally::TallyGrid& grid) {
  return grid.by_strength ? grid.by_strength->units : unit_of(grid);
}

std::vector<Group> groups_of(const tally::Result& result) {
  std::vector<Group> groups;
  const auto key = [](const tally::TallyGrid& grid) {
    std::string out = shown_unit(grid);
    for (const tally::Dimension& dimension : grid.dimensions) out += '\n' + dimension.name;
    return out;
  };
  for (const tally::TallyEstimates& tally : result.tallies) {
    if (tally.grid.size() == 0) continue;
    const auto same = std::ranges::find_if(groups, [&](const Group& group) {
      return key(*group.front().front().grid) == key(tally.grid);
    });
    Group& group = same == groups.end() ? groups.emplace_back() : *same;
    group.push_back(tally_rows(tally));
  }
  return groups;
}

std::string cell(const TallyRow& row) {
  const double scale = row.grid->by_strength ? row.grid->by_strength->scale : 1;
  return estimate_cell(scale * row.value, row.relative_error, row.converged());
}

/// "Irradiance, per photon emitted"; of a quantity alone what it is.
std::string title(const Group& group) {
  const tally::TallyGrid& grid = *group.front().front().grid;
  std::string what = group.size() == 1 ? grid.long_name : scene::word_of(grid.kind);
  what.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(what.front())));
  return fmt::format("{}{}{}", what, grid.by_strength ? " [" : ", ",
                     shown_unit(grid) + (grid.by_strength ? "]" : ""));
}

/// The symbols of radiative transfer; "value" of other quantities.
std::string symbol(const std::string& name) {
  static const std::map<std::string, std::string> symbols{{"irradiance_down", "E_d"},
                                                          {"irradiance_up", "E_u"},
                                                          {"scalar_irradiance_down", "E_0d"},
                                                          {"scalar_irradiance_up", "E_0u"},
                                                          {"radiance", "L"}};
  const auto found = symbols.find(name);
  return found == symbols.end() ? "value" : found->second;
}

/// Columns below each other where they do not fit beside each other, each time with the places.
std::string in_blocks(const std::vector<TextColumn>& places, const std::vector<TextColumn>& columns,
                      std::size_t width) {
  std::size_t taken = 0;
  for (const TextColumn& place : places) taken += before_column + place_width_of(place);
  const std::size_t room = width > taken ? (width - taken) / (before_column + cell_width) : 0;
  const std::size_t abreast = std::max<std::size_t>(1, room);
  std::string out;
  for (std::size_t first = 0; first < columns.size(); first += abreast) {
    std::vector<TextColumn> block = places;
    for (std::size_t c = first; c < std::min(first + abreast, columns.size()); ++c)
      block.push_back(columns[c]);
    out += side_by_side(block, before_column) + '\n';
  }
  return out;
}

std::string thinned(std::size_t step) {
  return step > 1 ? fmt::format("Shown: 1 row of {}; --table full shows all\n", step) : "";
}

std::string not_shown(std::size_t dark) {
  return dark == 0 ? "" : fmt::format("Not shown: {} without light\n", dark);
}

/// Numbers without dimensions, those with light; as files call them where the terminal is narrow.
std::string list(const Group& group, std::size_t width) {
  TextColumn words{"", {}, true}, names{"", {}, true}, cells{estimate_heading("", "value"), {}};
  for (const TallyRows& rows : group) {
    if (!rows.front().scored()) continue;
    words.cells.push_back(rows.front().grid->long_name);
    names.cells.push_back(rows.front().grid->name);
    cells.cells.push_back(cell(rows.front()));
  }
  const bool fits = 2 * before_column + place_width_of(words) + cell_width <= width;
  return side_by_side({fits ? words : names, cells}, before_column) +
         not_shown(group.size() - cells.cells.size()) + '\n';
}

/// Quantities on one dimension: its cells down, quantities across.
std::string profiles(const Group& group, const TableLayout& layout, std::size_t width) {
  const tally::Dimension& dimension = group.front().front().grid->dimensions.front();
  const std::size_t step = layout.step(dimension.size);
  std::vector<TextColumn> columns;
  for (const TallyRows& rows : group) {
    const tally::TallyGrid& grid = *rows.front().grid;
    columns.push_back(
        {estimate_heading(group.size() > 1 ? grid.long_name : "", symbol(grid.name)), {}});
    for (std::size_t i = 0; i < rows.size(); i += step)
      columns.back().cells.push_back(cell(rows[i]));
  }
  return thinned(step) + in_blocks(place_columns(dimension, step), columns, width);
}

/// A quantity on two dimensions: the second one down, the first one across.
std::string crossed(const TallyRows& rows, const TableLayout& layout, std::size_t width) {
  const tally::TallyGrid& grid = *rows.front().grid;
  const tally::Dimension &across = grid.dimensions[0], &down = grid.dimensions[1];
  const std::size_t step = layout.step(down.size);
  std::vector<TextColumn> columns;
  for (std::size_t c = 0; c < across.size; ++c) {
    columns.push_back({estimate_heading(place_text(across, c), symbol(grid.name)), {}});
    for (std::size_t i = 0; i < down.size; i += step)
      columns.back().cells.push_back(cell(rows[c * down.size + i]));
  }
  return thinned(step) + in_blocks(place_columns(down, step), columns, width);
}

/// Cells that have names, those with light.
std::string named(const TallyRows& rows) {
  const tally::TallyGrid& grid = *rows.front().grid;
  std::vector<TextColumn> columns;
  for (const tally::Dimension& dimension : grid.dimensions)
    columns.push_back({dimension.name, {}, true});
  columns.push_back({estimate_heading("", symbol(grid.name)), {}});
  std::size_t dark = 0;
  for (const TallyRow& row : rows) {
    dark += row.scored() ? 0 : 1;
    if (!row.scored()) continue;
    for (std::size_t d = 0; d < row.index.size(); ++d)
      columns[d].cells.push_back(place_text(grid.dimensions[d], row.index[d]));
    columns.back().cells.push_back(cell(row));
  }
  return side_by_side(columns, before_column) + not_shown(dark) + '\n';
}

std::string converged_count(const TallyRows& rows) {
  const auto converged = std::ranges::count_if(rows, &TallyRow::converged);
  const auto dark =
      static_cast<std::ptrdiff_t>(rows.size()) - std::ranges::count_if(rows, &TallyRow::scored);
  return fmt::format("{} of {}{}", converged, rows.size(),
                     dark == 0 ? "" : fmt::format(" ({} without light)", dark));
}

/// A map is too large to be printed.
std::string summary(const TallyRows& rows, std::size_t width) {
  const tally::TallyGrid& grid = *rows.front().grid;
  std::vector<std::string> extents, at;
  const TallyRow& largest = *std::ranges::max_element(rows, {}, &TallyRow::value);
  for (std::size_t d = 0; d < grid.dimensions.size(); ++d) {
    extents.push_back(extent_text(grid.dimensions[d]));
    at.push_back(place_text(grid.dimensions[d], largest.index[d]));
  }
  const double scale = grid.by_strength ? grid.by_strength->scale : 1;
  std::string out = fmt::format("  {}, in {} cells", fmt::join(extents, ", "), rows.size());
  if (largest.value > 0)
    out += fmt::format("; largest {:.3e}, error {}, at {}", scale * largest.value,
                       relative_error_text(largest.relative_error), fmt::join(at, ", "));
  return paragraph(out + "; converged: " + converged_count(rows), width) + '\n';
}

bool has_names(const tally::Dimension& dimension) {
  return !dimension.coordinates.front().labels.empty();
}
bool has_edges(const tally::Dimension& dimension) {
  return std::ranges::any_of(dimension.coordinates,
                             [](const tally::Coordinate& c) { return !c.edges.empty(); });
}

std::string text_of(const Group& group, const TableLayout& layout, std::size_t width) {
  const auto& dimensions = group.front().front().grid->dimensions;
  if (dimensions.empty()) return list(group, width);
  if (std::ranges::any_of(dimensions, has_names)) return named(group.front());
  if (dimensions.size() == 1) return profiles(group, layout, width);
  const bool is_map = dimensions.size() > 2 || std::ranges::all_of(dimensions, has_edges);
  return is_map ? summary(group.front(), width) : crossed(group.front(), layout, width);
}

/// Quantities on more than one dimension, or on names, stand alone.
std::vector<Group> shown_groups(const tally::Result& result) {
  std::vector<Group> out;
  for (Group& group : groups_of(result)) {
    const auto& dimensions = group.front().front().grid->dimensions;
    const bool together = dimensions.size() < 2 && std::ranges::none_of(dimensions, has_names);
    if (together)
      out.push_back(std::move(group));
    else
      for (TallyRows& rows : group) out.push_back({std::move(rows)});
  }
  return out;
}

}  // namespace

std::string tally_table(const tally::Result& result, const TableLayout& layout) {
  const std::size_t width = std::max(layout.width, min_width);
  std::string out;
  std::vector<std::int32_t> flags;
  for (const Group& group : shown_groups(result)) {
    const std::string error = out.empty() ? "; error: standard error over value" : "";
    out += paragraph(title(group) + error, width) + text_of(group, layout, width);
    for (const TallyRows& rows : group)
      for (const TallyRow& row : rows) flags.push_back(row.flags);
  }
  const std::string why = legend(flags, "cell", width);
  return out + (why.empty() ? "" : why + '\n');
}

std::string converged_tallies(const tally::Result& result, std::size_t width) {
  std::vector<std::pair<std::string, TallyRows>> kinds;
  for (const tally::TallyEstimates& tally : result.tallies) {
    const std::string word = scene::word_of(tally.grid.kind);
    if (kinds.empty() || kinds.back().first != word) kinds.emplace_back(word, TallyRows{});
    const TallyRows rows = tally_rows(tally);
    kinds.back().second.insert(kinds.back().second.end(), rows.begin(), rows.end());
  }
  std::vector<std::string> counts;
  for (const auto& [word, rows] : kinds) counts.push_back(word + " " + converged_count(rows));
  if (counts.empty()) return "";
  return paragraph(fmt::format("converged tallies: {} cells", fmt::join(counts, ", ")), width);
}

}  // namespace photic::io
