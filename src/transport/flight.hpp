// Free flight through the layers, and what may stand at its end: a collision, the surface, the sea
// bed.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

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
  Mask<T> sideways{};  ///< the photon has left a row of columns by a side
};                     ///< none of these: it collides where it stands, in water or on the bed

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

/// Moves a photon in a column of water by a free path, across layers, or to the surface or the sea
/// bed. The weight takes the ratio of the true density of free paths to the drawn one,
/// exp(-(tau - tau')), and c / c' at a collision.
template <class T>
FlightEnd<T> fly_in_column(const geometry::Slabs& sea, Photon<T>& photon,
                           const FlightStart<T>& from, const FreePath<T>& path) {
  const T down = -photon.direction.z;
  const T& target = path.target;
  FlightEnd<T> end;
  end.surface = (target <= T(0)) & (down < T(0));
  end.layer = path.layer;
  const Index<T> layer =
      select(end.surface, sea.row.template surface_layer<T>(path.layer), path.layer);
  end.sea_bed = target > gather<T>(sea.by_walk_tau.end,
                                   sea.row.template layering_row<T>(photon.line, photon.layer));
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
    photon.layer = select(end.sea_bed, sea.template bed_below<T>(layer), layer);
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
FlightEnd<T> fly_in_column(const geometry::Slabs& sea, Photon<T>& photon,
                           const FlightStart<T>& from, const T& free_path) {
  using std::abs;
  const T target = from.walk_tau - free_path * photon.direction.z;
  const auto layer = sea.row.layer_of(sea.by_walk_tau, photon.line, photon.layer, T(abs(target)));
  return fly_in_column(sea, photon, from, FreePath<T>{free_path, target, layer});
}

/// Moves photons along a ray to the end of a piece of it, without colliding. Returns how deep it
/// is, by the coefficient that free paths are drawn from.
template <class T>
T fly_through(const geometry::Slabs& sea, const FlightStart<T>& from, const geometry::Ray<T>& ray,
              const geometry::InColumn<T>& piece, Photon<T>& photon) {
  const T length = piece.to - piece.from;
  photon.position = ray.start + piece.to * ray.direction;
  photon.layer = sea.layer_at(photon.layer, geometry::depth_of(photon.position));
  const auto to = geometry::level_of(sea, photon);
  const T absorbed_tau =
      sea.continuous_slant_optical_depth(photon.line, from.level, from.continuous, to, length);
  const T ratio = exp_minus(absorbed_tau);
  photon.weight = photon.weight * ratio;
  photon.analog_weight = photon.analog_weight * ratio;
  const geometry::Segment<T> way{photon.line, from.level, to, length};
  photon.path = photon.path + geometry::group_path(sea, way);
  return geometry::depths_in_column(sea, way).walk;
}

/// The flight of photons through the columns of a row. They fly in one as if there were no other;
/// those that would end beyond a face go on from there by what is left of their free path.
template <class T>
PHOTIC_APART FlightEnd<T> fly_through_columns(const geometry::Slabs& sea, Photon<T>& photon,
                                              T free_path) {
  const geometry::Ray<T> ray{photon.position, photon.direction};
  const Index<T> first = sea.row.template column<T>(photon.layer);
  FlightEnd<T> out{Mask<T>(false), Mask<T>(false)};
  bool has_passed = false;
  const auto fly_in = [&](const geometry::InColumn<T>& piece) {
    Photon<T> there = photon;
    if (std::exchange(has_passed, true)) {
      const T depth = geometry::depth_of(there.position);
      there.layer = geometry::level_in(sea, piece.column, there.layer, depth).layer;
    }
    Photon<T> passing = there;
    const auto from = flight_start(sea, there);
    const FlightEnd<T> end = fly_in_column(sea, there, from, free_path);
    const Mask<T> passes = piece.on & (end.length > piece.to - piece.from);
    const Mask<T> ends = piece.on & !passes;
    out.surface = out.surface | (ends & end.surface);
    out.sea_bed = out.sea_bed | (ends & end.sea_bed);
    out.layer = select(ends, end.layer, out.layer);
    out.rest = select(ends, end.rest, out.rest);
    out.length = select(piece.on, select(passes, piece.to, piece.from + end.length), out.length);
    photon = select(ends, there, photon);
    if (!any(passes)) return passes;
    const T left = free_path - fly_through(sea, from, ray, piece, passing);
    free_path = select(passes & (left > T(0)), left, select(passes, T(0), free_path));
    photon = select(passes, passing, photon);
    return passes;
  };
  const T endless(medium::RowView::never);
  out.sideways = geometry::each_column(sea.row, ray, first, endless, Mask<T>(true), fly_in);
  return out;
}

/// The flight of a photon in the water by such a free path.
template <class T>
FlightEnd<T> fly(const geometry::Slabs& sea, Photon<T>& photon, const FlightStart<T>& from,
                 const T& free_path) {
  if (sea.row.has_faces) [[unlikely]]
    return fly_through_columns(sea, photon, free_path);
  return fly_in_column(sea, photon, from, free_path);
}
template <class T>
FlightEnd<T> fly(const geometry::Slabs& sea, Photon<T>& photon, const T& free_path) {
  return fly(sea, photon, flight_start(sea, photon), free_path);
}

/// Moves a photon by a distance, whatever it passes. Returns whether it is still in the water.
template <class T>
Mask<T> advance(const geometry::Slabs& sea, Photon<T>& photon, const T& distance) {
  const auto from = geometry::level_of(sea, photon);
  photon.position = photon.position + distance * photon.direction;
  const T depth = -photon.position.z;
  if (sea.row.has_faces) [[unlikely]] {
    const auto column = sea.row.column_at(photon.position.x);
    photon.layer = geometry::level_in(sea, column, photon.layer, depth).layer;
  }
  photon.layer = sea.layer_at(photon.layer, depth);
  photon.path =
      photon.path +
      geometry::group_path(
          sea, geometry::Segment<T>{photon.line, from, geometry::level_of(sea, photon), distance});
  const Mask<T> in_water = (depth > T(0)) & (depth < T(sea.top[sea.layers]));
  if (!sea.row.has_faces) [[likely]]
    return in_water;
  return in_water & sea.row.covers(photon.position.x, photon.position.y);
}

/// Has photons whose flight ended at the surface go on by what is left of their free path, which
/// has no memory: reflect(mask, photon) sends them back. Not in a row of columns.
template <class T, class Reflect>
void fly_on(const geometry::Slabs& sea, Photon<T>& photon, FlightEnd<T>& end, Reflect reflect) {
  const Mask<T> reflected = end.surface;
  if (!any(reflected)) return;
  Photon<T> down = photon;
  reflect(reflected, down);
  const FreePath<T> rest{end.rest, T(0) - end.rest * down.direction.z, end.layer};
  const auto from = flight_start_at_surface<T>(sea, down.line);
  const FlightEnd<T> onward = fly_in_column(sea, down, from, rest);
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
