#include "estimator/tallies/shell_irradiance.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "core/constants.hpp"

namespace photic::estimator {

ShellIrradiance::ShellIrradiance(const medium::ShellsView& shells, const std::vector<Level>& levels,
                                 ContinuousAbsorption absorption, const Zones& zones,
                                 const Cells& cells)
    : shells_(shells), absorption_(std::move(absorption)), cells_(cells), axis_(zones.axis) {
  for (const double degrees : zones.edges_deg)
    cosines_.push_back(std::cos(degrees * radian_per_degree));
  slabs_.resize(shells.ground());
  // Light that leaves at the top of the air, or comes in there, is to pass a level there.
  constexpr double within_end = 1e-9;
  for (Level level : levels) {
    level.height = std::min(level.height, shells.top_m() * (1 - within_end));
    std::size_t shell = 0;
    while (level.height < shells.height[shell + 1]) ++shell;
    slabs_[shell].push_back({level,
                             std::max(level.height - level.slab_m / 2, shells.height[shell + 1]),
                             std::min(level.height + level.slab_m / 2, shells.height[shell])});
  }
}

/// Adds a leg to the levels of its shell. Along the leg the distance from the point nearest to the
/// centre grows: light first falls, up to that point, then rises.
class ShellIrradiance::Adder {
 public:
  Adder(const ShellIrradiance& tally, const transport::ShellLeg& leg, double weight,
        const WayOverZones& way, tally::TallyScores& scores)
      : tally_(tally),
        from_(leg.from),
        to_(leg.to),
        weight_(weight),
        way_(way),
        scores_(scores),
        shell_(static_cast<std::size_t>(leg.from.shell)) {}

  /// A level is just above its sphere: light that comes down to that passes it, and so does light
  /// that sets out upwards from there.
  void add(const Slab& slab) const {
    const double at = slab.level.height;
    const double square = square_at(at);
    const bool meets = square >= 0;
    const double root = std::sqrt(std::max(0.0, square));
    const Cells& cells = tally_.cells_;
    if (from_.rise < 0 && at < from_.height && (to_.rise <= 0 ? to_.height <= at : meets))
      cross(-root, cells.down + cell_of(slab), at);
    if (to_.rise > 0 && at < to_.height && (from_.rise >= 0 ? from_.height <= at : meets))
      cross(root, cells.up + cell_of(slab), at);
    const double inner = std::sqrt(std::max(0.0, square_at(slab.begin)));
    const double outer = std::sqrt(std::max(0.0, square_at(slab.end)));
    track(-outer, -inner, cells.scalar_down + cell_of(slab), slab);
    track(inner, outer, cells.scalar_up + cell_of(slab), slab);
  }

 private:
  /// The square of the distance from the nearest point at a height, below 0 if none is so low.
  [[nodiscard]] double square_at(double height) const {
    return from_.rise * from_.rise - geometry::square_above(tally_.shells_, from_.height, height);
  }
  [[nodiscard]] std::size_t zones() const {
    return tally_.has_zones() ? tally_.cosines_.size() - 1 : 1;
  }
  [[nodiscard]] std::size_t cell_of(const Slab& slab) const { return slab.level.index * zones(); }
  /// Adds a score to the zone of the leg's point at a length.
  void score(std::size_t first, double length, double height, double value) const {
    if (!tally_.has_zones()) return scores_.add(first, value);
    const double radius = tally_.shells_.planet_m + height;
    const double cosine = way_.cosine_after(geometry::turn_of(from_, length, radius));
    const auto& edges = tally_.cosines_;
    const auto beyond = std::upper_bound(edges.begin(), edges.end(), cosine, std::greater());
    if (beyond == edges.begin() || beyond == edges.end()) return;
    scores_.add(first + static_cast<std::size_t>(beyond - edges.begin()) - 1, value);
  }
  void cross(double rise, std::size_t cell, double height) const {
    const double length = rise - from_.rise;
    score(cell, length, height, weight_ * tally_.share_after(shell_, length));
  }
  /// The part of the leg between two distances from the nearest point, within a slab.
  void track(double first, double last, std::size_t cell, const Slab& slab) const {
    first = std::max(first, from_.rise);
    last = std::min(last, to_.rise);
    if (!(first < last)) return;
    const double before = first - from_.rise, length = last - first;
    const double weight = weight_ * tally_.share_after(shell_, before);
    const auto middle = geometry::farther(from_, before + length / 2);
    score(cell, before + length / 2, middle.height,
          tally_.absorption_.track(shell_, weight, length) / (slab.end - slab.begin));
  }

  const ShellIrradiance& tally_;
  const geometry::ShellRay &from_, &to_;
  double weight_;
  const WayOverZones& way_;
  tally::TallyScores& scores_;
  std::size_t shell_;
};

void ShellIrradiance::add(const transport::ShellLeg& leg, double weight, const WayOverZones& way,
                          tally::TallyScores& scores) const {
  const auto& here = slabs_[static_cast<std::size_t>(leg.from.shell)];
  if (here.empty()) return;
  const Adder adder(*this, leg, weight, way, scores);
  for (const Slab& slab : here) adder.add(slab);
}

}  // namespace photic::estimator
