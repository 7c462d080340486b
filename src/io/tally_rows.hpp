// The quantities tallied beside echoes as rows, one for each cell: what CSV, JSON and the
// terminal's tables have in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "tally/result.hpp"

namespace photic::io {

/// A part of a cell's place under the name of its column: a number from 0, a coordinate, a name.
using PlaceField = std::pair<std::string, std::variant<std::size_t, double, std::string>>;

struct TallyRow {
  const tally::TallyGrid* grid{};
  std::vector<std::size_t> index;  ///< [dimension], from 0
  double value{};                  ///< by the grid's normalisation
  double standard_error{};         ///< of the value
  double relative_error{};         ///< standard_error / value; NaN where the value is not above 0
  std::int32_t flags{};            ///< TallyEstimates::flags

  [[nodiscard]] bool converged() const { return flags == 0; }
  [[nodiscard]] bool scored() const { return (flags & tally::no_score) == 0; }
};

/// All cells, the last dimension fastest.
std::vector<TallyRow> tally_rows(const tally::TallyEstimates& tally);

/// The place of a row's cell. Each dimension has its name and the cell's number, from 0, unless its
/// cells have names, or a coordinate is called as it is. Coordinates have their units at the end of
/// their names ("level_depth_m"); intervals are a start and an end.
std::vector<PlaceField> place_of(const TallyRow& row);

/// "m-2 per photon emitted", "per unit irradiance across the beam".
std::string unit_of(const tally::TallyGrid& grid);

}  // namespace photic::io
