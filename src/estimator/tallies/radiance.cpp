#include "estimator/tallies/radiance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "transport/scatter.hpp"

namespace photic::estimator {

Radiance::Radiance(std::vector<RadianceWay> ways, const geometry::Slabs& slabs)
    : ways_(std::move(ways)), slabs_(slabs) {
  // A level at the bed is just above it, and light that the bed reflects comes there.
  constexpr double within_end = 1e-6;  // more than floats round off
  const double end = gather<double>(slabs_.top, slabs_.layers) * (1 - within_end);
  for (RadianceWay& way : ways_) {
    auto& depth = depth_.emplace_back();
    for (RadianceWay::Level& level : way.levels) {
      level.distance = std::min(level.distance, end);
      const auto layer = slabs_.by_depth.layer_of(0, 0, level.distance);
      const double slant = depth_at(level.distance, layer) / std::abs(way.direction.z);
      depth.push_back({slant, std::exp(-slant)});
    }
  }
}

double Radiance::depth_at(double distance, std::int32_t layer) const {
  return slabs_.optical_depth<double>(0, slabs_.level<double>(layer, distance));
}

namespace {

constexpr double largest_slant = 300;  // whose exponentials doubles hold

}  // namespace

void Radiance::scatter(const ScatteringLight& light, tally::TallyScores& scores) const {
  const std::int32_t line = 0;
  const double here = depth_at(light.distance, light.place);
  const double scattered = light.weight * transport::scattered_share<double>(
                                              slabs_, line, light.place, -light.direction.z);
  const std::int32_t phase =
      gather_index<double>(slabs_.elastic_phase, slabs_.at(line, light.place));
  for (std::size_t w = 0; w < ways_.size(); ++w) {
    const RadianceWay& way = ways_[w];
    const double cosine = std::abs(way.direction.z);
    const double sent = scattered / cosine *
                        transport::scattered_density<double>(slabs_, light.place, phase,
                                                             light.direction, way.direction);
    if (!(sent > 0)) continue;
    // In most waters one exponential does for all levels.
    const double slant = here / cosine;
    const bool shares = slant < largest_slant;
    const double falls = std::exp(-slant), rises = shares ? 1 / falls : 0;
    for (std::size_t i = 0; i < way.levels.size(); ++i) {
      const auto& [cell, distance, gain] = way.levels[i];
      const auto& [to_level, decay] = depth_[w][i];
      if (way.by_surface) {
        scores.add(cell, sent * gain * falls * decay);
        continue;
      }
      const bool ahead =
          way.direction.z > 0 ? distance < light.distance : distance > light.distance;
      if (!ahead) continue;
      const double between = !shares || to_level >= largest_slant
                                 ? std::exp(-std::abs(slant - to_level))
                                 : (way.direction.z > 0 ? falls / decay : rises * decay);
      scores.add(cell, sent * gain * between);
    }
  }
}

}  // namespace photic::estimator
