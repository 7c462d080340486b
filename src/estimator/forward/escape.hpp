// The chance that a flight leaves the water, for flights that are not to: through the surface, onto
// a black sea bed, or by a side of a row of columns.
#pragma once

#include <cmath>

#include "core/elementary.hpp"
#include "geometry/segment.hpp"
#include "medium/medium.hpp"
#include "surface/flat.hpp"
#include "transport/photon.hpp"

namespace photic::estimator {

template <class T>
struct Escape {
  Mask<T> surface;   ///< the way out is through the surface,
  Mask<T> sideways;  ///< or by a side, or else onto the black sea bed
  T probability{};   ///< by the coefficient that free paths are drawn from
  T weight{};        ///< of the light that leaves
};

/// The straight way of a photon out of the water.
template <class T>
struct WayOut {
  Mask<T> exists{};    ///< of a level one there is none, unless by a side
  Mask<T> sideways{};  ///< by a side of a row of columns
  geometry::OpticalDepths<T> depths{};
};
template <class T>
WayOut<T> way_out(const geometry::Slabs& sea, const transport::Photon<T>& photon) {
  using std::abs;
  const T down = -photon.direction.z;
  const auto at = geometry::level_of(sea, photon);
  const auto above = geometry::optical_depths(
      sea, geometry::to_surface(photon.line, at, at.depth, geometry::Slant<T>{}));
  const Mask<T> level = down == T(0);
  const T slant = T(1) / select(level, T(1), abs(down));
  const auto along = [&](const T& to_surface, const T& to_bed) {
    return slant * select(down < T(0), to_surface, to_bed - to_surface);
  };
  return {!level,
          Mask<T>(false),
          {along(above.all, gather<T>(sea.bed_tau, photon.line)),
           along(above.walk, gather<T>(sea.by_walk_tau.end, photon.line))}};
}
/// The same through the columns of a row.
template <class T>
WayOut<T> way_out_of_row(const geometry::Slabs& sea, const transport::Photon<T>& photon) {
  const T deepest(medium::RowView::never);
  const T bottom = select(T(sea.top[sea.layers]) < deepest, T(sea.top[sea.layers]), deepest);
  const T rise = photon.direction.z;
  const auto at = geometry::level_of(sea, photon);
  const Mask<T> level = rise == T(0);
  const T to_end = select(rise > T(0), at.depth, at.depth - bottom) / select(level, T(1), rise);
  geometry::Segment<T> way{photon.line,
                           at,
                           {},
                           select(level, deepest, to_end),
                           geometry::Ray<T>{photon.position, photon.direction}};
  way.to.depth = select(level, at.depth, select(rise > T(0), T(0), bottom));
  WayOut<T> out;
  out.depths = {T(0), T(0)};
  const auto end =
      geometry::each_straight_piece(sea, way, [&](const Mask<T>& on, const auto& piece) {
        out.depths = select(on, out.depths + geometry::depths_in_column(sea, piece), out.depths);
      });
  out.sideways = end.sideways;
  out.exists = end.sideways | !level;
  return out;
}

/// The escape of a photon in the water on its next flight. Light that the surface reflects stays.
template <class T>
Escape<T> escape(const geometry::Slabs& sea, const transport::Photon<T>& photon) {
  const auto way = sea.row.has_faces ? way_out_of_row(sea, photon) : way_out(sea, photon);
  Escape<T> out;
  out.sideways = way.sideways;
  out.surface = (photon.direction.z > T(0)) & !way.sideways;
  const T rises = select(out.surface, photon.direction.z, T(1));
  const T reflectance = surface::flat_surface<T>(sea, photon.line).reflectance(rises);
  const T onto_bed(sea.bed_angles > 0 ? 0 : 1);
  const T by_end = select(out.surface, T(1) - reflectance, onto_bed);
  const T transmitted = select(way.exists, select(way.sideways, T(1), by_end), T(0));
  out.probability = transmitted * exp_minus(way.depths.walk);
  out.weight = photon.weight * transmitted * exp_minus(way.depths.all);
  return out;
}

}  // namespace photic::estimator
