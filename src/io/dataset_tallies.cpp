#include "io/dataset_tallies.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "io/dataset_bounds.hpp"
#include "io/dataset_flags.hpp"

namespace photic::io {
namespace {

/// Names are a variable apart from their dimension, as those of telescopes are.
std::string variable_of(const tally::Coordinate& coordinate) {
  const std::string end = "_name";
  return coordinate.labels.empty() || coordinate.name.ends_with(end) ? coordinate.name
                                                                     : coordinate.name + end;
}

void add_cells(Dataset& dataset, const std::string& dimension, const tally::Coordinate& coordinate,
               Attributes attributes) {
  const std::string name_of_bounds = coordinate.name + "_bounds";
  const std::vector<double> pairs = bounds(coordinate.edges);
  attributes.emplace_back("bounds", name_of_bounds);
  dataset.add_variable(coordinate.name, {dimension}, centres(pairs), attributes);
  dataset.add_variable(name_of_bounds, {dimension, "bnds"}, pairs,
                       {{"long_name", "ends of the interval"}});
}

void add_coordinate(Dataset& dataset, const std::string& dimension,
                    const tally::Coordinate& coordinate) {
  Attributes attributes{{"long_name", coordinate.long_name}};
  if (coordinate.labels.empty()) attributes.emplace_back("units", coordinate.units);
  for (const auto& [key, value] : coordinate.attributes) attributes.emplace_back(key, value);
  if (!coordinate.edges.empty()) return add_cells(dataset, dimension, coordinate, attributes);
  const Values values = coordinate.labels.empty() ? Values(std::span(coordinate.values))
                                                  : Values(std::span(coordinate.labels));
  dataset.add_variable(variable_of(coordinate), {dimension}, values, attributes);
}

bool same(const tally::Coordinate& a, const tally::Coordinate& b) {
  return a.name == b.name && a.units == b.units && a.values == b.values && a.edges == b.edges &&
         a.labels == b.labels;
}

/// Adds the dimensions of all tallies. Those that share one have the same coordinates on it.
void add_dimensions(Dataset& dataset, const std::vector<tally::TallyEstimates>& tallies) {
  std::map<std::string, const tally::Dimension*> known;
  for (const tally::TallyEstimates& tally : tallies)
    for (const tally::Dimension& dimension : tally.grid.dimensions) {
      const auto [at, is_new] = known.try_emplace(dimension.name, &dimension);
      expect(dimension.size == at->second->size &&
                 std::ranges::equal(dimension.coordinates, at->second->coordinates, same),
             "the same coordinates wherever tallies share a dimension");
      if (!is_new) continue;
      dataset.add_dimension(dimension.name, dimension.size);
      for (const tally::Coordinate& each : dimension.coordinates)
        add_coordinate(dataset, dimension.name, each);
    }
}

/// All but those that are axes, which programs find by their names (CF-1.10, section 5).
std::string coordinates_of(const tally::TallyGrid& grid) {
  std::vector<std::string> names;
  for (const tally::Dimension& dimension : grid.dimensions)
    for (const tally::Coordinate& each : dimension.coordinates)
      if (variable_of(each) != dimension.name) names.push_back(variable_of(each));
  return fmt::format("{}", fmt::join(names, " "));
}

Attributes attributes_of(const tally::TallyGrid& grid, const std::string& long_name,
                         const std::string& coordinates) {
  Attributes out{{"long_name", long_name},
                 {"units", grid.units},
                 {"normalisation", grid.normalisation},
                 {"_FillValue", nan}};
  if (!coordinates.empty()) out.emplace_back("coordinates", coordinates);
  if (grid.by_strength)
    out.insert(out.end(), {{"strength_scale", grid.by_strength->scale},
                           {"strength_units", grid.by_strength->units}});
  return out;
}

void add_tally(Dataset& dataset, const tally::TallyEstimates& tally) {
  const std::string& name = tally.grid.name;
  std::vector<std::string> dimensions;
  for (const tally::Dimension& dimension : tally.grid.dimensions)
    dimensions.push_back(dimension.name);
  const std::string coordinates = coordinates_of(tally.grid);
  Attributes attributes = attributes_of(tally.grid, tally.grid.long_name, coordinates);
  attributes.emplace_back(
      "ancillary_variables",
      fmt::format("{0}_standard_error {0}_converged {0}_convergence_flags", name));
  dataset.add_variable(name, dimensions, tally.mean, attributes);
  dataset.add_variable(name + "_standard_error", dimensions, tally.standard_error,
                       attributes_of(tally.grid, "standard error of " + name, coordinates));
  add_flags(dataset, {name + "_", tally.grid.long_name, dimensions, coordinates}, tally.flags);
}

}  // namespace

void add_tallies(Dataset& dataset, const tally::Result& result) {
  if (result.source_strength) {
    dataset.add_global("source_strength", *result.source_strength);
    dataset.add_global("source_strength_units", result.source_strength_units);
  }
  std::vector<tally::TallyEstimates>
      written;  // in air that absorbs nothing there is no constituent
  std::ranges::copy_if(result.tallies, std::back_inserter(written),
                       [](const tally::TallyEstimates& t) { return t.grid.size() > 0; });
  add_dimensions(dataset, written);
  for (const tally::TallyEstimates& tally : written) add_tally(dataset, tally);
}

}  // namespace photic::io
