// Free flight through the layers, and what may stand at its end: a collision, the surface, the sea
// bed.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/elementary.hpp"
#include "medium/medium.hpp"
#include "optics/fresnel.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

template <class T>
struct FlightEnd {
  Mask<T> surface;   ///< the photon stands at the surface, from below
  Mask<T> sea_bed;   ///< the photon stands on the sea bed
  T length{};        ///< of the flight [m]
  T rest{};          ///< of the free path, of photons at the surface
  Index<T> layer{};  ///< the photon's; of one at the surface, where its free path ends if reflected
};                   ///< neither surface nor sea bed: it collides where it stands

/// The layer in which a coordinate lies that grows with depth (the first or the last if in none),
/// as `top` has it of the layers' upper edges from entry `row` on, and of the sea bed; on an edge
/// it is `from`, if that is one of the two, else the upper one. By quarters, for among many lanes
/// one always has far to go; the three edges of a step do not wait for each other.
template <class T>
Index<T> layer_of(const medium::MediumView& sea, const ShortTable& top, const Index<T>& row,
                  const Index<T>& from, const T& coordinate) {
  if (sea.layers == 1) return from;
  const Index<T> last(sea.layers - 1);
  const Mask<T> not_above = (from == Index<T>(0)) | (coordinate >= gather<T>(top, row + from));
  const Mask<T> not_below =
      (from == last) | (coordinate <= gather<T>(top, row + from + Index<T>(1)));
  const Mask<T> stays = not_above & not_below;
  if (all(stays)) return from;
  Index<T> layer(0);
  std::int32_t step = 1;
  while (4 * step < sea.layers) step *= 4;
  for (; step > 0; step /= 4) {
    const Index<T> first = layer;
    for (std::int32_t k = 1; k < 4; ++k) {
      const Index<T> next = first + Index<T>(k * step);
      const Mask<T> exists = next <= last;
      const T upper_edge = gather<T>(top, row + select(exists, next, last));
      layer = select(exists & (coordinate > upper_edge), next, layer);
    }
  }
  return select(stays, from, layer);
}

/// Moves a photon in the water by a free path, given as an optical depth, across layers, or to the
/// surface or the sea bed. Free paths -ln(u) are drawn from the medium's walk coefficient c', which
/// is less than c; the weight takes the ratio of the true density of free paths to the drawn one,
/// exp(-(tau - tau')), and c / c' at a collision. `guess`: a layer in which that may well be.
template <class T>
FlightEnd<T> fly(const medium::MediumView& sea, Photon<T>& photon, const T& free_path,
                 const Index<T>& guess) {
  using std::abs;
  const T down = -photon.direction.z;
  const T depth = -photon.position.z;
  const T target = sea.walk_optical_depth<T>(photon.line, photon.layer, depth) + free_path * down;

  const Index<T> row = photon.line * Index<T>(sea.layers + 1);
  FlightEnd<T> end;
  end.surface = (target <= T(0)) & (down < T(0));
  Index<T> layer = photon.layer;
  if (sea.layers > 1) {
    // Whoever comes back from the surface has as much of the optical depth again below it.
    end.layer = layer_of(sea, sea.walk_depth_tau, row, guess, abs(target));
    layer = select(end.surface, Index<T>(0), end.layer);
  }
  end.sea_bed = target > gather<T>(sea.walk_depth_tau, row + Index<T>(sea.layers));
  const Mask<T> stopped = end.surface | end.sea_bed;
  const Mask<T> stays = (layer == photon.layer) & !stopped;
  const T mean_path = gather<T>(sea.walk_mean_path, sea.at(photon.line, layer));

  // Within one layer the path is exact also for a horizontal flight; across edges it follows from
  // the depths.
  T distance = free_path * mean_path;
  Vec3<T> there = photon.position + distance * photon.direction;
  if (!all(stays)) {
    const T inside = (target - gather<T>(sea.walk_depth_tau, row + layer)) * mean_path;
    const T bed = gather<T>(sea.top, Index<T>(sea.layers));
    const T depth_at_end =
        select(end.surface, T(0), select(end.sea_bed, bed, gather<T>(sea.top, layer) + inside));
    distance = select(stays, distance, (depth_at_end - depth) / select(stays, T(1), down));
    there = photon.position + distance * photon.direction;
    there.z = select(stays, there.z, -depth_at_end);
    end.rest = select(end.surface, target / select(end.surface, down, T(1)), T(0));
  }
  const T absorbed_tau = sea.continuous_slant_optical_depth<T>(photon.line, photon.layer, depth,
                                                               layer, -there.z, distance);
  end.length = distance;
  photon.position = there;
  photon.layer = layer;
  photon.path = photon.path + distance * gather<T>(sea.group_index, photon.line);
  const T gain = gather<T>(sea.collision_gain, sea.at(photon.line, layer));
  const T ratio = exp_minus(absorbed_tau) * select(stopped, T(1), gain);
  photon.weight = photon.weight * ratio;
  photon.analog_weight = photon.analog_weight * ratio;
  return end;
}

/// The same, guessing that the flight ends in the layer where it begins.
template <class T>
FlightEnd<T> fly(const medium::MediumView& sea, Photon<T>& photon, const T& free_path) {
  return fly(sea, photon, free_path, photon.layer);
}

/// The layer of a depth; on an edge as layer_of() has it.
template <class T>
Index<T> layer_at(const medium::MediumView& sea, const Index<T>& from, const T& depth) {
  return layer_of(sea, sea.top, Index<T>(0), from, depth);
}

/// Moves a photon by a distance, whatever it passes. Tells whether it is still in the water.
template <class T>
Mask<T> advance(const medium::MediumView& sea, Photon<T>& photon, const T& distance) {
  photon.position = photon.position + distance * photon.direction;
  photon.path = photon.path + distance * gather<T>(sea.group_index, photon.line);
  const T depth = -photon.position.z;
  photon.layer = layer_at(sea, photon.layer, depth);
  return (depth > T(0)) & (depth < gather<T>(sea.top, Index<T>(sea.layers)));
}

/// Reflects a photon that stands at the surface back into the water, its weight times the Fresnel
/// reflectance (1 in total reflection). Returns the weight that leaves through the surface. Clear
/// air returns nothing. From photons that are `kept` that has been taken before.
template <class T>
T reflect_down(const medium::MediumView& sea, Photon<T>& photon,
               const Mask<T>& kept = Mask<T>(false)) {
  const T n = gather<T>(sea.index, photon.line);
  const T r = select(kept, T(1), optics::refract(n, T(1), photon.direction.z).reflectance);
  const T leaving = photon.weight * (T(1) - r);
  photon.weight = photon.weight * r;
  photon.analog_weight = photon.analog_weight * r;
  photon.direction.z = -photon.direction.z;
  return leaving;
}

/// Has photons whose flight ended at the surface go on by what is left of their free path, which
/// has no memory: reflect(mask, photon) sends them back.
template <class T, class Reflect>
void fly_on(const medium::MediumView& sea, Photon<T>& photon, FlightEnd<T>& end, Reflect reflect) {
  const Mask<T> turned = end.surface;
  if (!any(turned)) return;
  Photon<T> down = photon;
  reflect(turned, down);
  const FlightEnd<T> onward = fly(sea, down, end.rest, end.layer);
  photon.position = select<T>(turned, down.position, photon.position);
  photon.direction.z = select(turned, down.direction.z, photon.direction.z);
  photon.layer = select(turned, down.layer, photon.layer);
  photon.path = select(turned, down.path, photon.path);
  photon.weight = select(turned, down.weight, photon.weight);
  photon.analog_weight = select(turned, down.analog_weight, photon.analog_weight);
  end.surface = Mask<T>(false);
  end.sea_bed = (end.sea_bed & !turned) | (onward.sea_bed & turned);
  end.length = end.length + select(turned, onward.length, T(0));
}

}  // namespace photic::transport
