#include "tally/gates.hpp"

#include <algorithm>
#include <limits>

#include "core/constants.hpp"

namespace photic::tally {
namespace {

/// Whether vertical depth tells where first-order light turns: all instruments look down.
bool looks_down(const scene::Source& source, const scene::Telescope& telescope) {
  const double steep = std::cos(45.0 * radian_per_degree);
  return normalised(source.direction).z < -steep && normalised(telescope.direction).z < -steep;
}

}  // namespace

Gates::Gates(const scene::Scene& scene, const std::vector<medium::Line>& lines)
    : source_(scene.source),
      telescope_(scene.telescope.front()),
      refractive_index_(lines.front().refractive_index),
      laser_group_index_(lines.front().group_index) {
  const auto& interval = scene.gates.interval();
  by_depth_ = scene.gates.depth_m.has_value();
  const bool by_range = scene.gates.range_m.has_value();
  depth_is_range_ = by_range || (!by_depth_ && !looks_down(source_, telescope_));
  if (by_depth_) {
    scale_ = depth_scale(laser_group_index_);
  } else if (by_range) {
    scale_ = range_scale(laser_group_index_);
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
}

double Gates::edge_path(std::int32_t edge) const {
  return scale_.path(edge == count_ ? max_ : min_ + edge * step_);
}

/// Straight down from the source and straight up to telescope 0.
PathScale Gates::depth_scale(double group_index_back) const {
  const auto leg_to_surface = [](double z, double group_index) {
    return z > 0 ? z : z * group_index;
  };
  PathScale scale;
  scale.knee_path = leg_to_surface(source_.position_m.z, laser_group_index_) +
                    leg_to_surface(telescope_.position_m.z, group_index_back);
  scale.slope_before = 2.0;
  scale.slope_after = laser_group_index_ + group_index_back;
  return scale;
}

/// Out and back along the (refracted) axis of telescope 0; a source ahead of it by s has a way
/// shorter by s.
PathScale Gates::range_scale(double group_index_back) const {
  const auto axis = normalised(telescope_.direction);
  const bool submerged = telescope_.position_m.z < 0;
  const double in_water = laser_group_index_ + group_index_back;
  const double toward_surface = submerged ? axis.z : -axis.z;
  const double to_surface = toward_surface > 0 ? std::abs(telescope_.position_m.z) / toward_surface
                                               : std::numeric_limits<double>::max();
  const double ahead = dot(source_.position_m - telescope_.position_m, axis);
  const double offset = -ahead * (source_.position_m.z < 0 ? laser_group_index_ : 1.0);
  PathScale scale;
  scale.slope_before = submerged ? in_water : 2.0;
  scale.slope_after = submerged ? 2.0 : in_water;
  const bool reached = toward_surface > 0;
  scale.knee_coordinate = reached ? to_surface : 0.0;
  scale.knee_path = offset + (reached ? to_surface * scale.slope_before : 0.0);
  if (!reached) scale.slope_after = scale.slope_before;
  return scale;
}

double Gates::depth(double path, const medium::Line& line) const {
  return (depth_is_range_ ? range_scale(line.group_index) : depth_scale(line.group_index))
      .coordinate(path);
}

double Gates::vertical_depth(double range) const {
  const auto axis = normalised(telescope_.direction);
  const double z = telescope_.position_m.z;
  if (z < 0) return std::max(0.0, -(z + range * axis.z));
  if (axis.z >= 0) return 0.0;
  const double in_air = z / -axis.z;
  const double sine_squared = (1 - axis.z * axis.z) / (refractive_index_ * refractive_index_);
  return std::max(0.0, (range - in_air) * std::sqrt(1 - sine_squared));
}

std::vector<double> Gates::depth_edges() const {
  medium::Line laser;
  laser.group_index = laser_group_index_;
  double low = depth(edge_path(0), laser);
  double high = depth(last_path(), laser);
  if (depth_is_range_) {
    const double span = high - low;
    const double a = vertical_depth(low);
    const double b = vertical_depth(high);
    low = std::min(a, b);
    high = std::max(a, b);
    const double missing =
        std::max(0.0, span / 2 - (high - low));  // an instrument that looks sideways
    low = std::max(0.0, low - missing / 2);
    high += missing / 2;
  }
  std::vector<double> edges;
  for (std::int32_t i = 0; i <= count_; ++i) edges.push_back(low + (high - low) * i / count_);
  return edges;
}

}  // namespace photic::tally
