#include "tally/gates.hpp"

#include <algorithm>
#include <limits>

#include "core/constants.hpp"
#include "geometry/axis.hpp"

namespace photic::tally {
namespace {

/// Whether depth tells where first-order light turns: both look down steeply.
bool looks_down(const scene::Source& source, const scene::Telescope& telescope) {
  const double steep = std::cos(45.0 * radian_per_degree);
  return normalised(source.direction).z < -steep && normalised(telescope.direction).z < -steep;
}

/// Of a line, to an instrument: 0 is the laser.
double air_delay(const medium::Line& line, std::size_t instrument) {
  return line.air_delay_m.empty() ? 0 : line.air_delay_m[instrument];
}
/// Along the axis of an instrument, at a line.
template <class Instrument>
geometry::GroupPath group_path_of(const Instrument& instrument, std::size_t number,
                                  const medium::Line& line) {
  return geometry::group_path(instrument.position_m, normalised(instrument.direction),
                              line.refractive_index, line.group_index, air_delay(line, number));
}

/// The depths that a range along the axis of a telescope leads to.
double depth_of_range(double range, const scene::Telescope& telescope, double refractive_index) {
  const auto axis = normalised(telescope.direction);
  const double z = telescope.position_m.z;
  if (z < 0) return std::max(0.0, -(z + range * axis.z));
  if (axis.z >= 0) return 0.0;
  return std::max(0.0, (range - z / -axis.z) * geometry::cosine_in_water(axis.z, refractive_index));
}

}  // namespace

Gates::Gates(const scene::Scene& scene, const std::vector<medium::Line>& lines)
    : source_(scene.source), telescope_(scene.telescope), laser_(lines.front()) {
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
}

double Gates::edge_path(std::int32_t edge) const {
  return scale_.path(edge == count_ ? max_ : min_ + edge * step_);
}

/// Down along the axis of the source and up along that of the telescope, refracted
/// (docs/theory.md, eq. 35).
PathScale Gates::depth_scale(std::size_t telescope, const medium::Line& back) const {
  const auto out = group_path_of(source_, 0, laser_);
  const auto home = group_path_of(telescope_[telescope], telescope + 1, back);
  PathScale scale;
  scale.knee_path = out.to_surface + home.to_surface;
  scale.slope_before = out.per_depth_in_air + home.per_depth_in_air;
  scale.slope_after = out.per_depth_in_water + home.per_depth_in_water;
  return scale;
}

/// Out and back along the (refracted) axis of the telescope. The source counts as where it is along
/// that axis, before or behind the telescope and on its own side of the surface.
PathScale Gates::range_scale(std::size_t number, const medium::Line& back) const {
  const scene::Telescope& telescope = telescope_[number];
  const auto axis = normalised(telescope.direction);
  const double z = telescope.position_m.z;
  const double ahead = dot(source_.position_m - telescope.position_m, axis);
  const auto in_air = [&](const medium::Line& light) {
    return z > 0 ? 1 + air_delay(light, number + 1) / z : 1.0;
  };
  const auto before = [&](const medium::Line& light) {
    const bool in_water = axis.z > 0 || (axis.z == 0 && z < 0);
    return in_water ? light.group_index : in_air(light);
  };
  const auto after = [&](const medium::Line& light) {
    const bool in_water = axis.z < 0 || (axis.z == 0 && z < 0);
    return in_water ? light.group_index : in_air(light);
  };
  PathScale scale;
  scale.knee_coordinate = axis.z == 0 ? 0.0 : -z / axis.z;  // the surface
  // From a place on the axis to the surface; negative from behind it.
  const auto to_surface = [&](double place, const medium::Line& light) {
    const double way = scale.knee_coordinate - place;
    return way * (way > 0 ? before(light) : after(light));
  };
  scale.knee_path = to_surface(ahead, laser_) + to_surface(0, back);
  scale.slope_before = before(laser_) + before(back);
  scale.slope_after = after(laser_) + after(back);
  return scale;
}

double Gates::depth(double path, std::size_t telescope, const medium::Line& line) const {
  const auto scale = depth_is_range_ ? range_scale(telescope, line) : depth_scale(telescope, line);
  return scale.coordinate(path);
}

std::vector<double> Gates::depth_edges(std::int64_t cells) const {
  if (cells == 0) return {};
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
