// Radiance at levels in directions, of scattered light: at each collision the expected value of the
// light that goes there, straight or by way of the flat surface (docs/theory.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec3.hpp"
#include "geometry/free_paths.hpp"
#include "tally/tally_scores.hpp"

namespace photic::estimator {

/// Light of the source at a collision, before it is scattered.
struct ScatteringLight {
  Vec3<double> direction;
  double distance = 0;     ///< from the surface [m]
  std::int32_t place = 0;  ///< a layer, or a bed that reflects
  double weight = 0;
};

/// A direction of the tally as light has it in the medium where it is scattered.
struct RadianceWay {
  struct Level {
    std::size_t cell = 0;
    double distance = 0;  ///< from the surface, of the end of the way in this medium [m]
    double gain = 1;      ///< of the radiance from there on
  };
  Vec3<double> direction;   ///< a unit vector
  bool by_surface = false;  ///< reflected there, or through it
  std::vector<Level> levels;
};

class Radiance {
 public:
  Radiance(std::vector<RadianceWay> ways, const geometry::Slabs& slabs);

  void scatter(const ScatteringLight& light, tally::TallyScores& scores) const;
  [[nodiscard]] const std::vector<RadianceWay>& ways() const { return ways_; }

 private:
  [[nodiscard]] double depth_at(double distance, std::int32_t layer) const;

  std::vector<RadianceWay> ways_;
  geometry::Slabs slabs_;
  /// The optical depth from the surface to a level, over the way's cosine, and the decay along it.
  struct Depth {
    double slant = 0, decay = 0;
  };
  std::vector<std::vector<Depth>> depth_;  ///< [way][level]
};

}  // namespace photic::estimator
