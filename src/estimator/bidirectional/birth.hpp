// Where the walks of the bidirectional estimator begin: the laser's light, and the way back of the
// light that falls on a telescope's detector.
#pragma once

#include "estimator/bidirectional/vertex.hpp"
#include "instrument/lens.hpp"
#include "transport/cross.hpp"
#include "transport/emit.hpp"

namespace photic::estimator {

/// A walk that stands in the water, and how its light has spread on the way there.
template <class T>
struct Birth {
  Mask<T> exists{};
  transport::Photon<T> photon;
  Spread<T> spread;
};

/// `before`: length from the point that the light spreads from to where the photon stands.
template <class T>
Birth<T> birth_in_water(const medium::MediumView& sea, const geometry::Region<T>& region,
                        const transport::Photon<T>& photon, const T& solid_angle, const T& before) {
  Birth<T> birth;
  birth.photon = photon;
  birth.exists = transport::enter_water(sea, region, birth.photon);
  birth.spread.solid_angle = solid_angle;
  birth.spread.before = before;
  if (!region.in_air) return birth;
  birth.spread.through_surface = true;
  birth.spread.before = before + (birth.photon.path - photon.path);
  birth.spread.cos_air = select(birth.exists, -photon.direction.z, T(1));
  return birth;
}

/// The solid angle of a laser's cone; 0 of one that no connection can meet [sr].
template <class T>
T connectable_solid_angle(const instrument::Laser<T>& laser) {
  return can_be_met(laser) ? T(2 * pi) * laser.one_minus_cos_divergence : T(0);
}

/// The laser's walk.
template <class T>
Birth<T> birth_at_laser(const medium::MediumView& sea, const instrument::Laser<T>& laser,
                        const geometry::Region<T>& region, const T& u_polar, const T& u_azimuth) {
  const auto photon = transport::emit(laser, region.layer, u_polar, u_azimuth);
  return birth_in_water(sea, region, photon, connectable_solid_angle(laser),
                        (laser.vertex_distance + laser.ahead) / dot(photon.direction, laser.axis));
}

/// A telescope's walk from a point of its lens by a slope outwards that its detector sees. It
/// carries étendue: the weight begins with that of all such rays, and takes T (n_i / n_t)^2 at the
/// surface. In the air its path is what it is longer than from the lens' centre to the origin.
template <class T>
Birth<T> birth_at_telescope(const medium::MediumView& sea,
                            const instrument::Telescope<T>& telescope,
                            const geometry::Region<T>& region, const Index<T>& line,
                            const instrument::PlanePoint<T>& lens,
                            const instrument::PlanePoint<T>& slope) {
  transport::Photon<T> photon;
  photon.position = telescope.start + in_plane(telescope, lens + telescope.ahead * slope);
  photon.direction = outward(telescope, slope);
  photon.line = line;
  photon.layer = region.layer;
  const T cos_off_axis = dot(photon.direction, telescope.axis);
  const T solid_angle = detector_solid_angle(telescope, cos_off_axis);
  photon.weight = telescope.area() * cos_off_axis * solid_angle;
  auto birth = birth_in_water(sea, region, photon, solid_angle, telescope.ahead / cos_off_axis);
  if (!region.in_air) return birth;
  const T inverse_n = gather<T>(sea.inverse_index, line);
  birth.photon.weight = birth.photon.weight * (inverse_n * inverse_n);
  birth.photon.path = longer_way(telescope, birth.photon.position, lens, birth.spread.before);
  return birth;
}

}  // namespace photic::estimator
