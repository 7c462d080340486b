#include "io/tally_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <variant>

#include "io/csv_field.hpp"
#include "io/echo_rows.hpp"
#include "io/table_parts.hpp"
#include "io/tally_rows.hpp"

namespace photic::io {
namespace {

const std::string quality_columns = "standard_error,relative_error,converged,reasons";

/// The names of the places of all tallies, each once.
std::vector<std::string> places(const tally::Result& result) {
  std::vector<std::string> out;
  for (const tally::TallyEstimates& tally : result.tallies)
    for (const PlaceField& field :
         place_of({&tally.grid, std::vector<std::size_t>(tally.grid.dimensions.size())}))
      if (std::ranges::find(out, field.first) == out.end()) out.push_back(field.first);
  return out;
}

std::string text_of(const PlaceField& field) {
  if (const auto* name = std::get_if<std::string>(&field.second)) return csv_field(*name);
  if (const auto* number = std::get_if<double>(&field.second)) return fmt::format("{}", *number);
  return fmt::format("{}", std::get<std::size_t>(field.second));
}

TallyLine line_of(const TallyRow& row, const std::vector<std::string>& places) {
  const std::vector<PlaceField> own = place_of(row);
  TallyLine out{fmt::format("{},{},{},{}", row.standard_error, row.relative_error,
                            row.converged() ? "yes" : "no", fmt::join(flag_names(row.flags), " ")),
                {csv_field(row.grid->name)}};
  for (const std::string& name : places) {
    const auto field = std::ranges::find(own, name, &PlaceField::first);
    out.fields.push_back(field == own.end() ? "" : text_of(*field));
  }
  out.fields.push_back(fmt::format("{}", row.value));
  out.fields.push_back(csv_field(row.grid->units));
  return out;
}

}  // namespace

std::string about_tallies(const tally::Result& result) {
  std::string out;
  for (const tally::TallyEstimates& tally : result.tallies) {
    const tally::TallyGrid& grid = tally.grid;
    out += fmt::format("# {}: {}, {}", grid.name, grid.long_name, unit_of(grid));
    if (grid.by_strength)
      out += fmt::format("; times {} in {}", grid.by_strength->scale, grid.by_strength->units);
    out += '\n';
  }
  return out;
}

std::vector<std::string> tally_columns(const tally::Result& result) {
  std::vector<std::string> out{"quantity"};
  for (const std::string& name : places(result)) out.push_back(csv_field(name));
  out.insert(out.end(), {"value", "units"});
  return out;
}

std::vector<TallyLine> tally_lines(const tally::Result& result) {
  const std::vector<std::string> names = places(result);
  std::vector<TallyLine> out;
  for (const tally::TallyEstimates& tally : result.tallies)
    for (const TallyRow& row : tally_rows(tally)) out.push_back(line_of(row, names));
  return out;
}

std::string tally_csv(const tally::Result& result) {
  // The value's error stands before its units.
  const auto joined = [](std::vector<std::string> fields, const std::string& quality) {
    fields.insert(fields.end() - 1, quality);
    return fmt::format("{}\n", fmt::join(fields, ","));
  };
  std::string out = about_tallies(result) + joined(tally_columns(result), quality_columns);
  for (const TallyLine& line : tally_lines(result)) out += joined(line.fields, line.quality);
  return out;
}

}  // namespace photic::io
