#include "estimator/tallies/radiance_ways.hpp"

#include <cmath>
#include <utility>

#include "core/constants.hpp"
#include "estimator/tallies/levels.hpp"
#include "surface/flat.hpp"

namespace photic::estimator {
namespace {

Vec3<double> direction_of(const scene::TravelDirection& of) {
  const double zenith = of.zenith_deg * radian_per_degree;
  const double azimuth = of.azimuth_deg * radian_per_degree;
  return {std::sin(zenith) * std::cos(azimuth), std::sin(zenith) * std::sin(azimuth),
          std::cos(zenith)};
}

/// The ways to the levels of one direction.
class WaysOfDirection {
 public:
  WaysOfDirection(const Model& model, const geometry::Slabs& slabs)
      : model_(model), surface_(surface::flat_surface<double>(slabs, 0)) {
    const double index = gather<double>(slabs.index, 0);
    per_index_squared_ = 1 / (index * index);
  }

  /// `direction`: in the medium's coordinates. `here`: of a level in this medium.
  void add(const Vec3<double>& direction, bool here, const TallyLevel& level, std::size_t number,
           std::size_t cell) {
    if (!here) return add_through(direction, model_.level_depth[number], cell);
    const double distance = model_.from_surface(level);
    straight_.direction = direction;
    straight_.levels.push_back({cell, distance, 1});
    if (direction.z > 0) return;
    const Vec3<double> up{direction.x, direction.y, -direction.z};
    reflected_.direction = up;
    add_by_surface(reflected_, {cell, distance, surface_.from_below(up).reflectance});
  }
  void take(std::vector<RadianceWay>& ways) {
    for (RadianceWay* way : {&straight_, &reflected_, &through_})
      if (!way->levels.empty()) ways.push_back(std::move(*way));
  }

 private:
  static void add_by_surface(RadianceWay& way, const RadianceWay::Level& level) {
    way.by_surface = true;
    if (level.gain > 0) way.levels.push_back(level);
  }
  /// To a level so deep, optically, on the other side, which light comes to under `direction`.
  void add_through(const Vec3<double>& direction, double depth, std::size_t cell) {
    if (!(direction.z > 0)) return;
    const auto back = surface_.from_above({-direction.x, -direction.y, -direction.z});
    through_.direction = -back.transmitted;
    const double gain = back.transmittance * per_index_squared_ * std::exp(-depth / direction.z);
    if (through_.direction.z > 0) add_by_surface(through_, {cell, 0, gain});
  }

  const Model& model_;
  surface::Flat<double> surface_;
  double per_index_squared_ = 1;
  RadianceWay straight_, reflected_, through_;
};

}  // namespace

std::vector<RadianceWay> radiance_ways(const scene::Tally& tally, const Model& model,
                                       const geometry::Slabs& slabs, std::size_t first_cell) {
  const bool upside_down = model.medium.kind == medium::MediumKind::air;
  const auto levels = levels_of(tally);
  std::vector<RadianceWay> out;
  std::size_t cell = first_cell;
  for (const auto& of : tally.direction_deg) {
    Vec3<double> direction = direction_of(of);
    if (upside_down) direction.z = -direction.z;
    WaysOfDirection ways(model, slabs);
    for (std::size_t i = 0; i < levels.size(); ++i, ++cell) {
      const bool here = model.is_air_alone() || levels[i].in_air == upside_down;
      ways.add(direction, here, levels[i], i, cell);
    }
    ways.take(out);
  }
  return out;
}

}  // namespace photic::estimator
