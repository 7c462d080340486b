// Irradiances in spherical air, against the local vertical: at spheres, in zones about the point
// under the source.
#pragma once

#include <cstddef>
#include <vector>

#include "core/vec3.hpp"
#include "estimator/tallies/continuous_absorption.hpp"
#include "geometry/shells.hpp"
#include "tally/tally_scores.hpp"
#include "transport/shell_flight.hpp"

namespace photic::estimator {

/// The plane of a flight's ray against the axis of the zones, and how far the flight has turned in
/// it.
struct WayOverZones {
  double up = 0, ahead = 0;  ///< cosines of the plane's axes to the zones' axis
  geometry::Turn turn;

  /// The cosine of the angle to the zones' axis, after a further turn.
  [[nodiscard]] double cosine_after(const geometry::Turn& further) const {
    const geometry::Turn all = turn.by(further);
    return all.cosine * up + all.sine * ahead;
  }
};

class ShellIrradiance {
 public:
  struct Level {
    std::size_t index = 0;  ///< among all levels of the tally
    double height = 0;      ///< [m]
    double slab_m = 0;      ///< thickness, before it is cut at the shell's edges
  };
  /// The first cells of its grids, [level][zone].
  struct Cells {
    std::size_t down = 0, up = 0, scalar_down = 0, scalar_up = 0;
  };
  /// Zones about an axis, a unit vector, by their edges; no edges: there is one zone, everywhere.
  struct Zones {
    Vec3<double> axis;
    std::vector<double> edges_deg;
  };
  ShellIrradiance(const medium::ShellsView& shells, const std::vector<Level>& levels,
                  ContinuousAbsorption absorption, const Zones& zones, const Cells& cells);

  [[nodiscard]] bool has_zones() const { return !cosines_.empty(); }
  [[nodiscard]] WayOverZones way_of(const geometry::PlaneOfRay& plane) const {
    return {dot(plane.up, axis_), dot(plane.ahead, axis_), {}};
  }
  /// A leg of light of a weight at its start. `way`: so far, if there are zones.
  void add(const transport::ShellLeg& leg, double weight, const WayOverZones& way,
           tally::TallyScores& scores) const;
  /// The share of light that is left after a length in a shell, as it is drawn.
  [[nodiscard]] double share_after(std::size_t shell, double length) const {
    return decay_over(absorption_.per_m(shell) * length).there;
  }

 private:
  struct Slab {
    Level level;
    double begin = 0, end = 0;  ///< heights
  };
  class Adder;

  medium::ShellsView shells_;
  ContinuousAbsorption absorption_;
  Cells cells_;
  Vec3<double> axis_;
  std::vector<double> cosines_;           ///< edges of the zones, descending
  std::vector<std::vector<Slab>> slabs_;  ///< [shell]
};

}  // namespace photic::estimator
