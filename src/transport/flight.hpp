// Free flight through the layers, and what may stand at its end: a collision, the surface, the sea
// bed.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/elementary.hpp"
#include "geometry/free_paths.hpp"
#include "geometry/segment.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

template <class T>
struct FlightEnd {
  Mask<T> surface;   ///< the photon stands at the surface, from below
  Mask<T> sea_bed;   ///< the photon has come to a black sea bed
  T length{};        ///< of the flight [m]
  T rest{};          ///< of the free path, of photons at the surface
  Index<T> layer{};  ///< the photon's; of one at the surface, where its free path ends if reflected
};  ///< neither surface nor black bed: it collides where it stands, in water or on the bed

/// The start of flights.
template <class T>
struct FlightStart {
  medium::Level<T> level;
  T walk_tau{};                  ///< the walk's optical depth from the surface straight down
  medium::Column<T> continuous;  ///< of absorption along the way
};
template <class T>
FlightStart<T> flight_start(const geometry::Slabs& sea, const Photon<T>& photon) {
  const auto level = geometry::level_of(sea, photon);
  return {level, sea.walk_optical_depth(photon.line, level),
          sea.continuous_column(photon.line, level)};
}
/// The start of photons at the surface.
template <class T>
FlightStart<T> flight_start_at_surface(const geometry::Slabs& sea, const Index<T>& line) {
  return {{}, {}, {gather<T>(sea.continuous_c.first, sea.at(line, Index<T>(0))), {}}};
}

/// A free path: an optical depth. It ends at so much of the walk's optical depth from the surface
/// straight down, negative if above it, and in that layer, as if reflected by the surface.
template <class T>
struct FreePath {
  T length{}, target{};
  Index<T> layer{};
};

/// Moves a photon in the water by a free path, across layers, or to the surface or the sea bed. The
/// weight takes the ratio of the true density of free paths to the drawn one, exp(-(tau - tau')),
/// and c / c' at a collision.
template <class T>
FlightEnd<T> fly(const geometry::Slabs& sea, Photon<T>& photon, const FlightStart<T>& from,
                 const FreePath<T>& path) {
  const T down = -photon.direction.z;
  const T& target = path.target;
  FlightEnd<T> end;
  end.surface = (target <= T(0)) & (down < T(0));
  end.layer = path.layer;
  const Index<T> layer = select(end.surface, Index<T>(0), path.layer);
  end.sea_bed = target > gather<T>(sea.by_walk_tau.end, photon.line);
  const Mask<T> stopped = end.surface | end.sea_bed;
  const Mask<T> stays = (layer == photon.layer) & !stopped;
  const Index<T> here = sea.at(photon.line, layer);
  const T mean_path = gather<T>(sea.walk_mean_path, here);

  // Within one layer the path is exact also for a horizontal flight; across edges it follows from
  // the depths.
  medium::Level<T> to{layer, {}, {}};
  T distance = path.length * mean_path;
  Vec3<T> there = photon.position + distance * photon.direction;
  if (!all(stays)) {
    const T to_top = gather<T>(sea.walk_c.second, here);  // the walk's optical depth
    const T inside = (target - to_top) * mean_path;
    const T top = gather<T>(sea.top, layer);
    to.depth = select(end.surface, T(0), select(end.sea_bed, T(sea.top[sea.layers]), top + inside));
    to.below_top = to.depth - top;
    distance = select(stays, distance, (to.depth - from.level.depth) / select(stays, T(1), down));
    there = photon.position + distance * photon.direction;
    there.z = select(stays, there.z, -to.depth);
    end.rest = select(end.surface, target / select(end.surface, down, T(1)), T(0));
  }
  const T absorbed_tau =
      sea.continuous_slant_optical_depth(photon.line, from.level, from.continuous, to, distance);
  end.length = distance;
  photon.position = there;
  photon.layer = layer;
  if (sea.bed_angles > 0) {
    photon.layer = select(end.sea_bed, Index<T>(sea.layers), layer);
    end.sea_bed = Mask<T>(false);
  }
  photon.path = photon.path + geometry::group_path(
                                  sea, geometry::Segment<T>{photon.line, from.level, to, distance});
  const T gain = gather<T>(sea.collision_gain, here);
  const T ratio = exp_minus(absorbed_tau) * select(stopped, T(1), gain);
  photon.weight = photon.weight * ratio;
  photon.analog_weight = photon.analog_weight * ratio;
  return end;
}

/// The same, by a free path given as an optical depth: -ln(u) of the medium's walk coefficient c',
/// which is less than c.
template <class T>
FlightEnd<T> fly(const geometry::Slabs& sea, Photon<T>& photon, const FlightStart<T>& from,
                 const T& free_path) {
  using std::abs;
  const T target = from.walk_tau - free_path * photon.direction.z;
  const auto layer = sea.by_walk_tau.layer_of(photon.line, photon.layer, T(abs(target)));
  return fly(sea, photon, from, FreePath<T>{free_path, target, layer});
}
template <class T>
FlightEnd<T> fly(const geometry::Slabs& sea, Photon<T>& photon, const T& free_path) {
  return fly(sea, photon, flight_start(sea, photon), free_path);
}

/// The layer of a depth; on an edge `from`, if that is one of the two, else the upper one.
template <class T>
Index<T> layer_at(const geometry::Slabs& sea, const Index<T>& from, const T& depth) {
  return sea.by_depth.layer_of(Index<T>(0), from, depth);
}

/// Moves a photon by a distance, whatever it passes. Returns whether it is still in the water.
template <class T>
Mask<T> advance(const geometry::Slabs& sea, Photon<T>& photon, const T& distance) {
  const auto from = geometry::level_of(sea, photon);
  photon.position = photon.position + distance * photon.direction;
  const T depth = -photon.position.z;
  photon.layer = layer_at(sea, photon.layer, depth);
  photon.path =
      photon.path +
      geometry::group_path(
          sea, geometry::Segment<T>{photon.line, from, geometry::level_of(sea, photon), distance});
  return (depth > T(0)) & (depth < T(sea.top[sea.layers]));
}

/// Has photons whose flight ended at the surface go on by what is left of their free path, which
/// has no memory: reflect(mask, photon) sends them back.
template <class T, class Reflect>
void fly_on(const geometry::Slabs& sea, Photon<T>& photon, FlightEnd<T>& end, Reflect reflect) {
  const Mask<T> reflected = end.surface;
  if (!any(reflected)) return;
  Photon<T> down = photon;
  reflect(reflected, down);
  const FreePath<T> rest{end.rest, T(0) - end.rest * down.direction.z, end.layer};
  const FlightEnd<T> onward = fly(sea, down, flight_start_at_surface<T>(sea, down.line), rest);
  photon.position = select<T>(reflected, down.position, photon.position);
  photon.direction.z = select(reflected, down.direction.z, photon.direction.z);
  photon.layer = select(reflected, down.layer, photon.layer);
  photon.path = select(reflected, down.path, photon.path);
  photon.weight = select(reflected, down.weight, photon.weight);
  photon.analog_weight = select(reflected, down.analog_weight, photon.analog_weight);
  end.surface = Mask<T>(false);
  end.sea_bed = (end.sea_bed & !reflected) | (onward.sea_bed & reflected);
  end.length = end.length + select(reflected, onward.length, T(0));
}

}  // namespace photic::transport
