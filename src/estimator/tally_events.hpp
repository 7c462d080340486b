// Shows the tallies of a world beside echoes the events of its light, lane by lane. Only light of
// the source's wavelength counts: what is converted has been absorbed.
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/flatten.hpp"
#include "core/lanes.hpp"
#include "estimator/tallies/tallies.hpp"
#include "estimator/world.hpp"
#include "geometry/segment.hpp"
#include "surface/lambert.hpp"
#include "tally/batch_tally.hpp"
#include "transport/flight.hpp"
#include "transport/photon.hpp"
#include "transport/touched.hpp"

namespace photic::estimator {

template <class T>
Mask<T> of_source(const transport::Photon<T>& photon, const Mask<T>& mask) {
  return mask & (photon.line == Index<T>(0));
}

/// Photons lane by lane, in double.
template <class T>
class EachPhoton {
 public:
  explicit EachPhoton(const transport::Photon<T>& p)
      : x_(each_lane(p.position.x)),
        y_(each_lane(p.position.y)),
        z_(each_lane(p.position.z)),
        dx_(each_lane(p.direction.x)),
        dy_(each_lane(p.direction.y)),
        dz_(each_lane(p.direction.z)),
        weight_(each_lane(p.weight)),
        layer_(each_lane(p.layer)) {}

  [[nodiscard]] Vec3<double> position(std::size_t i) const { return {x_[i], y_[i], z_[i]}; }
  [[nodiscard]] Vec3<double> direction(std::size_t i) const { return {dx_[i], dy_[i], dz_[i]}; }
  [[nodiscard]] double weight(std::size_t i) const { return weight_[i]; }
  [[nodiscard]] std::int32_t layer(std::size_t i) const { return layer_[i]; }

 private:
  using Reals = decltype(each_lane(T()));
  using Integers = decltype(each_lane(Index<T>()));
  Reals x_, y_, z_, dx_, dy_, dz_, weight_;
  Integers layer_;
};

template <class T>
class TallyEvents {
 public:
  using Photon = transport::Photon<T>;
  TallyEvents(const World<T>& world, tally::BatchTally& tally)
      : world_(world), tallies_(*world.tallies), scores_(tally.tallies) {}

  /// Photons of a mask have flown in the medium, and stand at the end of their flight.
  void flown(const Photon& before, const Photon& after, const transport::FlightEnd<T>& end,
             const Mask<T>& mask) const {
    const Mask<T> light = of_source(before, mask);
    if (!any(light)) return;
    const EachPhoton<T> from(before);
    const auto z = each_lane(after.position.z), lengths = each_lane(end.length);
    for_each_lane(light, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      const Flight flight{from.position(i),
                          from.direction(i),
                          std::max(0.0, -from.position(i).z),
                          std::max(0.0, -static_cast<double>(z[i])),
                          lengths[i],
                          from.weight(i),
                          layer_of(from.layer(i))};
      if (world_.slabs.row.has_faces) [[unlikely]]
        fly_through_columns(flight);
      else
        fly_in_column(flight, 0);
    });
    escape(light & end.sideways, after.direction.z, after.weight, Mask<T>(true));
    if (tallies_.escapes_at_end) return;  // what comes there has escaped before
    at_bottom(after, light & end.sea_bed, T(1));
  }
  /// Photons of a mask are about to be scattered where they stand, or reflected by the bed.
  void collide(const Photon& photon, const Mask<T>& mask) const {
    const Mask<T> light = of_source(photon, mask);
    if (!any(light)) return;
    const Mask<T> bed = surface::on_bed<T>(world_.slabs, photon.layer);
    if (world_.slabs.bed_angles > 0)
      at_bottom(photon, light & bed,
                T(1) - surface::bed_albedo(world_.slabs, photon.line, photon.layer,
                                           T(T(0) - photon.direction.z)));
    radiate(photon, light);
    if (!tallies_.boundaries) return;
    const auto places = each_lane(photon.layer);
    const auto weights = each_lane(photon.weight);
    for_each_lane(light & !bed, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      tallies_.boundaries->collide(static_cast<std::size_t>(places[i]), weights[i], scores_);
    });
  }
  /// Light of a mask is scattered where it stands, or reflected by the bed, as far as it may be.
  void radiate(const Photon& photon, const Mask<T>& mask) const {
    const Mask<T> light = of_source(photon, mask);
    if (!tallies_.radiance || !any(light)) return;
    const EachPhoton<T> at(photon);
    for_each_lane(light, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      tallies_.radiance->scatter(
          {at.direction(i), std::max(0.0, -at.position(i).z), at.layer(i), at.weight(i)}, scores_);
    });
  }
  /// Photons of a mask that have ended where they stand, in the medium or on the bed.
  void absorbed(const Photon& photon, const Mask<T>& mask) const {
    const Mask<T> light = of_source(photon, mask);
    if (!tallies_.boundaries || !any(light)) return;
    const Mask<T> bed = surface::on_bed<T>(world_.slabs, photon.layer);
    at_bottom(photon, light & bed, T(1));
    const EachPhoton<T> at(photon);
    for_each_lane(light & !bed, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      tallies_.boundaries->absorb(layer_of(at.layer(i)), at.weight(i), scores_);
    });
  }
  /// A film absorbs so much of light of a mask.
  void absorbed_in_film(const Mask<T>& mask, const T& weight) const {
    if (!tallies_.boundaries || !any(mask)) return;
    const auto weights = each_lane(weight);
    for_each_lane(mask, [&](int lane) {
      tallies_.boundaries->absorb_in_film(weights[static_cast<std::size_t>(lane)], scores_);
    });
  }
  /// Returns which light above the sea has been in the water, by what it has touched.
  [[nodiscard]] Mask<T> were_in_water(const Index<T>& touched) const {
    const auto only = [&](transport::Touched place) {
      return touched == Index<T>(static_cast<std::int32_t>(place));
    };
    const Mask<T> never = only(transport::Touched::air) | only(transport::Touched::surface);
    return Mask<T>(tallies_.begins_in_water) | !never;
  }
  /// Light of a mask goes away for good, so much of it; `up`: cosine to straight up.
  void escape(const Mask<T>& mask, const T& up, const T& weight,
              const Mask<T>& was_in_water) const {
    if (!tallies_.boundaries) return;
    const auto cosines = each_lane(up), weights = each_lane(weight);
    const auto water = each_lane(select(was_in_water, Index<T>(1), Index<T>(0)));
    for_each_lane(mask, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      tallies_.boundaries->escape(cosines[i], weights[i], water[i] == 1, scores_);
    });
  }
  /// Light of a mask flies on in clear air: from the surface, away for good.
  void rise_in_clear_air(const Mask<T>& mask, const Photon& photon, const Vec3<T>& direction,
                         const T& weight) const {
    if (!tallies_.outside.exist()) return;
    Photon rising = photon;
    rising.direction = direction;
    rising.weight = weight;
    const EachPhoton<T> from(rising);
    // Of light that is reflected in total nothing rises, but for what floats round off.
    for_each_lane(mask & (direction.z > T(0)), [&](int lane) {
      fly_in_clear_air(from, static_cast<std::size_t>(lane), 0, far_away);
    });
  }
  /// Light of a mask has left the source in clear air: it stands at the surface, where it comes
  /// there, or where it set out if it rises. Beside a row of columns there is no surface.
  void leave_source(const Photon& photon, const Mask<T>& mask, const Mask<T>& comes) const {
    escape(mask & !comes, photon.direction.z, photon.weight, Mask<T>(false));
    if (!tallies_.outside.exist()) return;
    const EachPhoton<T> from(photon);
    for_each_lane(mask, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      const bool falls = from.direction(i).z < 0;
      fly_in_clear_air(from, i, tallies_.source_height_m, falls ? 0 : far_away);
    });
  }

 private:
  void fly_in_column(const Flight& flight, std::size_t column) const {
    const FlightTallies& tallies = tallies_.inside[column];
    tallies.fly(flight, scores_);
    if (tallies_.boundaries) tallies_.boundaries->fly(flight, tallies.absorption, scores_);
  }
  /// `flight`: its layer is among all of the medium's.
  PHOTIC_APART void fly_through_columns(const Flight& flight) const {
    const medium::RowView& row = world_.slabs.row;
    const auto first = row.column<double>(static_cast<std::int32_t>(flight.layer));
    const geometry::Ray<double> ray{flight.start, flight.direction};
    Flight piece = flight;
    geometry::each_column<double>(
        row, ray, first, flight.length, true, [&](const geometry::InColumn<double>& in) {
          const auto column = static_cast<std::size_t>(in.column);
          const ContinuousAbsorption& absorption = tallies_.inside[column].absorption;
          const auto depth_at = [&](double length) {
            const double depth = flight.from - flight.direction.z * length;
            return length < flight.length ? std::max(0.0, depth) : flight.to;
          };
          piece.start = flight.start + in.from * flight.direction;
          piece.from = in.from > 0 ? depth_at(in.from) : flight.from;
          piece.to = flight.to == flight.from ? piece.from : depth_at(in.to);
          piece.length = in.to - in.from;
          piece.layer = in.column == first ? flight.layer - absorption.first_layer()
                                           : absorption.layer_of(piece.from);
          fly_in_column(piece, column);
          piece.weight = absorption.weight_at_end(piece);
          return true;
        });
  }

  static constexpr double far_away = 1e9;  // m; beyond all levels

  [[nodiscard]] std::size_t layer_of(std::int32_t place) const {
    return static_cast<std::size_t>(std::min(place, world_.slabs.layers - 1));
  }
  void at_bottom(const Photon& photon, const Mask<T>& mask, const T& share) const {
    if (!tallies_.boundaries || !any(mask)) return;
    const auto weights = each_lane(T(photon.weight * share));
    for_each_lane(mask, [&](int lane) {
      tallies_.boundaries->absorb_at_bottom(weights[static_cast<std::size_t>(lane)], scores_);
    });
  }
  /// Along a photon's ray, between two heights.
  void fly_in_clear_air(const EachPhoton<T>& at, std::size_t i, double from, double to) const {
    const Vec3<double> direction = at.direction(i);
    const Vec3<double> there = at.position(i);
    if (direction.z == 0)
      return tallies_.outside.fly({there, direction, from, from, far_away, at.weight(i), 0},
                                  scores_);
    const double per_height = 1 / direction.z;
    const Vec3<double> start = there + (from - there.z) * per_height * direction;
    tallies_.outside.fly({start, direction, from, to, (to - from) * per_height, at.weight(i), 0},
                         scores_);
  }

  const World<T>& world_;
  const Tallies& tallies_;
  tally::TallyScores& scores_;
};

}  // namespace photic::estimator
