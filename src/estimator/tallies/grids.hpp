// The grids of a scene's tallies beside echoes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "medium/air.hpp"
#include "medium/medium.hpp"
#include "scene/scene.hpp"
#include "tally/tally_grid.hpp"

namespace photic::estimator {

/// The names of layers and constituents, of the water and then of the air.
struct AbsorberNames {
  std::vector<std::string> layer, constituent;
};
AbsorberNames absorber_names(const medium::Medium& medium, const std::optional<medium::Air>& air);

/// The strength of a source, by which quantities are multiplied: those that are shares of its
/// light, and those per irradiance across its beam.
struct Strength {
  std::string units;  ///< "W", "J", "1", "W m-2"
  double value = 0;
  double share_scale = 1;  ///< of the value, for shares of the light
};
/// None if the scene gives none.
std::optional<Strength> strength_of(const scene::Source& source);

/// `air`: above the medium.
std::vector<tally::TallyGrid> tally_grids(const scene::Scene& scene, const medium::Medium& medium,
                                          const std::optional<medium::Air>& air);

/// The first cell of a grid by its name; none if there is no such grid.
std::optional<std::size_t> first_cell(const std::vector<tally::TallyGrid>& grids,
                                      const std::string& name);

/// The edges of the angles of light that escapes, in degrees. By the sides of a row of columns it
/// also goes down: in one more bin.
std::vector<double> escape_edges(const scene::Tally& tally, const medium::Medium& medium);

/// "fluence", or "fluence_NAME".
std::string fluence_name(const scene::Tally& tally);

}  // namespace photic::estimator
