// The tallies of a world beside echoes, which its light is shown to. Each kind is a file of its
// own; make_tallies() chooses them, and their cells.
#pragma once

#include <optional>
#include <vector>

#include "estimator/tallies/boundaries.hpp"
#include "estimator/tallies/fluence.hpp"
#include "estimator/tallies/irradiance.hpp"
#include "estimator/tallies/radiance.hpp"
#include "estimator/tallies/shell_irradiance.hpp"

namespace photic::estimator {

/// The tallies of flights on one side of the surface, or in a column of a row.
struct FlightTallies {
  ContinuousAbsorption absorption;
  std::optional<Irradiance> irradiance;
  std::vector<Fluence> fluence;

  [[nodiscard]] bool exist() const { return irradiance || !fluence.empty(); }
  void fly(const Flight& flight, tally::TallyScores& scores) const {
    if (irradiance) irradiance->add(flight, scores);
    for (const Fluence& grid : fluence) grid.add(flight, scores);
  }
};

struct Tallies {
  std::vector<FlightTallies> inside;  ///< of the world's medium, [column]
  FlightTallies outside;  ///< of the clear air that light comes from and goes to; else none
  std::optional<Boundaries> boundaries;
  std::optional<Radiance> radiance;
  std::optional<ShellIrradiance> in_shells;  ///< of spherical air
  /// Light that goes through the surface escapes: there is clear air beyond.
  bool escapes_at_surface = false;
  /// Light that comes to the end of the medium escapes: it is the top of the air.
  bool escapes_at_end = false;
  bool begins_in_water = false;  ///< the source stands there
  double source_height_m = 0;    ///< above the surface, of one outside
};

}  // namespace photic::estimator
