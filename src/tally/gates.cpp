#include "tally/gates.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/constants.hpp"

namespace photic::tally {
namespace {

/// Returns whether depth is where first-order light turns: both look down steeply.
bool looks_down(const scene::Source& source, const scene::Telescope& telescope) {
  const double steep = std::cos(45.0 * radian_per_degree);
  return normalised(source.direction).z < -steep && normalised(telescope.direction).z < -steep;
}

/// Along the axis of an instrument, at a line.
template <class Instrument>
geometry::GroupPath group_path_of(const Instrument& instrument, const medium::Line& line) {
  const Vec3<double>& position = instrument.position_m;
  const auto axis = normalised(instrument.direction);
  auto path = geometry::group_path(position, axis, line.refractive_index, line.group_index);
  if (position.z > 0) path.to_surface += line.air_delay.to(position.z) / -axis.z;
  return path;
}

/// Ways out and back along axes in the air.
struct WaysInAir {
  const medium::AirDelay &out, &back;  ///< of the light on them
  double secant_out, secant_back;      ///< 1 over the cosine to the vertical
  double rise;                         ///< coordinate per metre of height; below 0 before the knee

  [[nodiscard]] double delay(double height) const {
    return out.to(height) * secant_out + back.to(height) * secant_back;
  }
};
/// Bends a scale at the edges of the air's layers, from the sea up.
void add_air(const WaysInAir& ways, PathScale& scale) {
  if (!ways.out.exists() && !ways.back.exists()) return;
  const double side = ways.rise < 0 ? -1 : 1;
  double& beside_surface = ways.rise < 0 ? scale.slope_before : scale.slope_after;
  const double in_vacuum = beside_surface;
  double* slope = &beside_surface;
  const auto& edges = (ways.out.exists() ? ways.out : ways.back).height_m;
  scale.bends.reserve(edges.size());
  for (std::size_t k = 1; k < edges.size(); ++k) {
    const double thickness = edges[k] - edges[k - 1];
    const double delay = ways.delay(edges[k]) - ways.delay(edges[k - 1]);
    *slope = in_vacuum + delay / (thickness * std::abs(ways.rise));
    const double from_knee = edges[k] * ways.rise;
    scale.bends.push_back({scale.knee_coordinate + from_knee,
                           scale.knee_path + from_knee * in_vacuum + side * ways.delay(edges[k]),
                           in_vacuum});
    slope = &scale.bends.back().beyond;
  }
}

/// The depths that a range along the axis of a telescope leads to.
double depth_of_range(double range, const scene::Telescope& telescope, double refractive_index) {
  const auto axis = normalised(telescope.direction);
  const double z = telescope.position_m.z;
  if (z < 0) return std::max(0.0, -(z + range * axis.z));
  if (axis.z >= 0) return 0.0;
  return std::max(0.0, (range - z / -axis.z) * geometry::cosine_in_water(axis.z, refractive_index));
}

/// Returns whether a place on a scale is farther from its knee than a bend, on the same side.
bool is_beyond(double place, double bend, double knee) {
  return bend < knee ? place < bend : place > bend;
}

/// A number made of others, the largest of which is given, to as many decimals as their rounding
/// leaves it. Never -0.
double without_rounding(double number, double largest) {
  constexpr double error = 16 * std::numeric_limits<double>::epsilon();
  const double per_unit = std::pow(10.0, std::floor(-std::log10(error * largest)));
  return std::round(number * per_unit) / per_unit + 0.0;
}

}  // namespace

double PathScale::coordinate(double path) const {
  const double rest = path - knee_path;
  double found = knee_coordinate + rest / (rest < 0 ? slope_before : slope_after);
  for (const Bend& bend : bends)
    if (is_beyond(path, bend.path, knee_path))
      found = bend.coordinate + (path - bend.path) / bend.beyond;
  return found;
}

double PathScale::path(double coordinate) const {
  const double rest = coordinate - knee_coordinate;
  double found = knee_path + rest * (rest < 0 ? slope_before : slope_after);
  for (const Bend& bend : bends)
    if (is_beyond(coordinate, bend.coordinate, knee_coordinate))
      found = bend.path + (coordinate - bend.coordinate) * bend.beyond;
  return found;
}

Gates::Gates(const scene::Scene& scene, const std::vector<medium::Line>& lines,
             geometry::ApparentPath apparent_path)
    : source_(scene.source),
      telescope_(scene.telescope),
      laser_(lines.front()),
      too_long_(std::move(apparent_path)) {
  if (!scene.gates.are_given()) return;
  const auto& interval = scene.gates.interval();
  const bool by_depth = scene.gates.depth_m.has_value();
  const bool by_range = scene.gates.range_m.has_value();
  depth_is_range_ = by_range || (!by_depth && !looks_down(source_, telescope_.front()));
  if (by_depth) {
    scale_ = depth_scale(0, laser_);
  } else if (by_range) {
    scale_ = range_scale(0, laser_);
  } else {
    scale_ = {0.0, 0.0, metre_per_nanosecond, metre_per_nanosecond};
  }
  count_ = static_cast<std::int32_t>(scene.gates.count());
  min_ = interval.min;
  max_ = interval.max;
  step_ = (max_ - min_) / count_;
  knee_gate_ = (scale_.knee_coordinate - min_) / step_;
  per_metre_before_ = 1 / (scale_.slope_before * step_);
  per_metre_after_ = 1 / (scale_.slope_after * step_);
  double per_metre = per_metre_before_;
  for (const PathScale::Bend& bend : scale_.bends) {
    const bool before = bend.path < scale_.knee_path;
    if (!before && bends_.empty()) per_metre = per_metre_after_;
    if (before ? bend.coordinate < min_ : bend.coordinate > max_) break;
    const double beyond = 1 / (bend.beyond * step_);
    bends_.push_back({bend.path - scale_.knee_path, beyond - per_metre});
    per_metre = beyond;
  }
}

double Gates::edge_path(std::int32_t edge) const {
  return scale_.path(edge == count_ ? max_ : min_ + edge * step_);
}

/// Down along the axis of the source and up along that of the telescope, refracted
/// (docs/theory.md, eq. 35).
PathScale Gates::depth_scale(std::size_t telescope, const medium::Line& back) const {
  const scene::Telescope& lens = telescope_[telescope];
  const auto out = group_path_of(source_, laser_);
  const auto home = group_path_of(lens, back);
  PathScale scale;
  scale.knee_path = out.to_surface + home.to_surface - too_long_.both_paths(telescope);
  scale.slope_before = out.per_depth_in_air + home.per_depth_in_air;
  scale.slope_after = out.per_depth_in_water + home.per_depth_in_water;
  const medium::AirDelay none;  // the axis of an instrument in the water does not come there
  const auto of = [&](const auto& instrument, const medium::Line& line) -> const medium::AirDelay& {
    return geometry::stands_in_water(instrument.position_m) ? none : line.air_delay;
  };
  add_air({of(source_, laser_), of(lens, back), -1 / normalised(source_.direction).z,
           -1 / normalised(lens.direction).z, -1},
          scale);
  return scale;
}

/// Out and back along the (refracted) axis of the telescope. The source counts as where it is along
/// that axis, before or behind the telescope and on its own side of the surface.
PathScale Gates::range_scale(std::size_t number, const medium::Line& back) const {
  const scene::Telescope& telescope = telescope_[number];
  const auto axis = normalised(telescope.direction);
  const double z = telescope.position_m.z;
  const double ahead = dot(source_.position_m - telescope.position_m, axis);
  const bool level = axis.z == 0;
  // In the air all along a level axis, of layers that other axes come through as if in a vacuum.
  const auto in_air = [&](const medium::Line& light) {
    return level ? 1 + light.air_delay.per_metre(std::max(0.0, z)) : 1.0;
  };
  const bool water_before = axis.z > 0 || (level && z < 0);
  const bool water_after = axis.z < 0 || (level && z < 0);
  const auto before = [&](const medium::Line& light) {
    return water_before ? light.group_index : in_air(light);
  };
  const auto after = [&](const medium::Line& light) {
    return water_after ? light.group_index : in_air(light);
  };
  PathScale scale;
  const double surface = level ? 0.0 : -z / axis.z;
  scale.knee_coordinate = surface - too_long_.range(number);
  const double secant = level ? 0.0 : 1 / std::abs(axis.z);
  // From a place on the axis to the surface; negative from behind it.
  const auto to_surface = [&](double place, const medium::Line& light) {
    const double way = surface - place;
    const double height = way * -axis.z;  // below 0 in the water
    const double delay = height > 0 ? light.air_delay.to(height) * secant : 0.0;
    return way * (way > 0 ? before(light) : after(light)) + std::copysign(delay, way);
  };
  scale.knee_path = to_surface(ahead, laser_) + to_surface(0, back) - too_long_.both_paths(number);
  scale.slope_before = before(laser_) + before(back);
  scale.slope_after = after(laser_) + after(back);
  if (!level) add_air({laser_.air_delay, back.air_delay, secant, secant, 1 / axis.z}, scale);
  return scale;
}

PathScale Gates::scale_of(std::size_t telescope, const medium::Line& back) const {
  return depth_is_range_ ? range_scale(telescope, back) : depth_scale(telescope, back);
}

double Gates::depth(double path, std::size_t telescope, const medium::Line& line) const {
  return scale_of(telescope, line).coordinate(path);
}

double Gates::longest_path() const {
  return std::max({std::abs(edge_path(0)), std::abs(last_path()), std::abs(scale_.knee_path)});
}

double Gates::edge_depth(std::int32_t edge, std::size_t telescope, const medium::Line& line) const {
  const PathScale scale = scale_of(telescope, line);
  return without_rounding(scale.coordinate(edge_path(edge)),
                          std::max(longest_path(), std::abs(scale.knee_path)));
}

double Gates::edge_time_ns(std::int32_t edge) const {
  return without_rounding(edge_path(edge) / metre_per_nanosecond,
                          longest_path() / metre_per_nanosecond);
}

std::vector<double> Gates::depth_edges(std::int64_t cells) const {
  if (cells == 0 || count_ == 0) return {};
  double low = std::numeric_limits<double>::max();
  double high = 0;
  for (std::size_t t = 0; t < telescope_.size(); ++t) {
    double from = depth(edge_path(0), t, laser_);
    double to = depth(last_path(), t, laser_);
    if (depth_is_range_) {
      // One that looks sideways sees light from above and below, too.
      const double beside = std::max(0.0, (to - from) / 2);
      from = depth_of_range(from, telescope_[t], laser_.refractive_index);
      to = depth_of_range(to, telescope_[t], laser_.refractive_index);
      if (from > to) std::swap(from, to);
      const double missing = std::max(0.0, beside - (to - from));
      from -= missing / 2;
      to += missing / 2;
    }
    if (!std::isfinite(from)) continue;
    low = std::min(low, from);
    high = std::max(high, to);
  }
  low = std::clamp(low, 0.0, high);
  // Gates that end before an axis gets into the water may still see light beside it.
  if (!(high > low)) high = low + (last_path() - edge_path(0)) / 2;
  std::vector<double> edges;
  const auto count = static_cast<double>(cells);
  for (std::int64_t i = 0; i <= cells; ++i)
    edges.push_back(low + (high - low) * static_cast<double>(i) / count);
  return edges;
}

}  // namespace photic::tally
