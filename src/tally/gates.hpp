// Range gates: intervals of group path between the laser's disc and the aperture, one grid for all
// channels and telescopes, and the depth or range that each stands for in each of them.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/lanes.hpp"
#include "geometry/axis.hpp"
#include "medium/medium.hpp"
#include "scene/scene.hpp"

namespace photic::tally {

/// A coordinate (depth, range or time) against group path: two straight lines that meet where the
/// path passes the surface, one of them with a bend at each edge of the air's layers. NaN
/// throughout where an instrument has no such coordinate.
struct PathScale {
  /// Slopes are metres of group path per unit of the coordinate.
  struct Bend {
    double coordinate, path;
    double beyond;  ///< slope on the side that leads away from the surface
  };
  double knee_path = 0;  ///< [m]
  double knee_coordinate = 0;
  double slope_before = 1;
  double slope_after = 1;
  std::vector<Bend> bends = {};  ///< all before the knee or all after it, from there on

  [[nodiscard]] double coordinate(double path) const;
  [[nodiscard]] double path(double coordinate) const;
};

/// The whole number below `place`, or -1 where that is none of 0 … count - 1.
template <class Double>
auto cell_below(const Double& place, std::int32_t count) {
  const Double within = smaller(larger(place + Double(1), Double(0)), Double(count + 1));
  auto cell = floor_index(within);
  using Index = decltype(cell);
  return select(cell == Index(count + 1), Index(0), cell) - Index(1);
}

class Gates {
 public:
  /// The gates of a scene whose light travels in the lines of a medium; none without telescopes.
  Gates(const scene::Scene& scene, const std::vector<medium::Line>& lines,
        geometry::ApparentPath apparent_path = {});

  [[nodiscard]] std::int32_t count() const { return count_; }

  /// The gate that a group path [m] falls into, or -1. Double: one, or one in each lane.
  template <class Double>
  [[nodiscard]] auto find(const Double& path) const {
    const Double rest = path - Double(scale_.knee_path);
    Double gate = Double(knee_gate_) + (smaller(rest, Double(0)) * Double(per_metre_before_) +
                                        larger(rest, Double(0)) * Double(per_metre_after_));
    for (const Bend& bend : bends_) {
      const Double beyond = rest - Double(bend.rest);
      gate = gate + Double(bend.more_per_metre) *
                        (bend.rest < 0 ? smaller(beyond, Double(0)) : larger(beyond, Double(0)));
    }
    return cell_below(gate, count_);
  }

  [[nodiscard]] double edge_path(std::int32_t edge) const;  ///< [m], edge 0 … count
  [[nodiscard]] double last_path() const { return edge_path(count_); }

  /// Depth (or range) [m] of first-order light along the axes of laser and telescope that returns
  /// at a line's wavelength with a given group path; NaN where a telescope has none: a depth needs
  /// one that looks down.
  [[nodiscard]] double depth(double path, std::size_t telescope, const medium::Line& line) const;
  /// The same of an edge, and its time after the light left the source [ns], as results have them:
  /// without the digits that rounding of paths leaves, so that 0 is 0.
  [[nodiscard]] double edge_depth(std::int32_t edge, std::size_t telescope,
                                  const medium::Line& line) const;
  [[nodiscard]] double edge_time_ns(std::int32_t edge) const;
  /// True for all telescopes: ranges are along the axis of each.
  [[nodiscard]] bool depth_is_range() const { return depth_is_range_; }

  /// Edges of the grid on which the depth of the last scattering is tallied [m]: the depths in the
  /// water that the gates stand for in any telescope, in so many cells; empty for none.
  [[nodiscard]] std::vector<double> depth_edges(std::int64_t cells) const;

 private:
  /// The scale of a telescope: by range or by depth, as its gates are.
  [[nodiscard]] PathScale scale_of(std::size_t telescope, const medium::Line& back) const;
  /// The longest path that edges are made of [m].
  [[nodiscard]] double longest_path() const;
  [[nodiscard]] PathScale depth_scale(std::size_t telescope, const medium::Line& back) const;
  [[nodiscard]] PathScale range_scale(std::size_t telescope, const medium::Line& back) const;

  scene::Source source_;
  std::vector<scene::Telescope> telescope_;
  medium::Line laser_;  ///< its light
  geometry::ApparentPath too_long_;
  bool depth_is_range_ = false;
  PathScale scale_;
  double min_ = 0, step_ = 1, max_ = 1;
  // The knee and slopes of scale_, in gates:
  double knee_gate_ = 0, per_metre_before_ = 1, per_metre_after_ = 1;
  struct Bend {
    double rest;            ///< path there less the knee's [m]
    double more_per_metre;  ///< beyond it than before
  };
  std::vector<Bend> bends_;  ///< none where gates do not come to them
  std::int32_t count_ = 0;
};

}  // namespace photic::tally
