// Free flight through spherical air, leg by leg from sphere to sphere, in double.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/elementary.hpp"
#include "geometry/free_paths.hpp"
#include "geometry/shells.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

/// A straight piece of a flight within a shell.
struct ShellLeg {
  geometry::ShellRay from, to;
  double length = 0;  ///< [m]
};

enum class ShellEnd {
  collision,
  top,     ///< it leaves the air
  ground,  ///< the photon stands on the ground
  lost     ///< it has crossed too many spheres
};

/// A flight through so many legs is lost, and counted: shells whose index falls with the height may
/// hold a ray for ever, and light in it meets nothing where the air is clear.
inline constexpr int max_legs = 10'000;

/// A flight through spherical air.
struct ShellFlight {
  ShellEnd end = ShellEnd::collision;
  double length = 0;  ///< [m]
};

/// Takes light from outside to the top of the air, where its straight line meets that: ahead, or
/// back from where it starts within the sphere. Returns whether it gets there.
inline bool come_to_shells(const medium::ShellsView& shells, Photon<double>& photon) {
  const auto at = geometry::place_in(shells, photon.position);
  const double rise = dot(at.from_centre, photon.direction);
  const double step = geometry::square_above(shells, at.height, shells.top_m());
  const double square = rise * rise - step;
  const bool leads_away = step >= 0 && rise >= 0;
  if (square < 0 || leads_away) return false;
  const double root = std::sqrt(square);
  const double way = step / (root - rise);
  photon.position = photon.position + way * photon.direction;
  photon.path += way;
  photon.layer = 0;
  if (!shells.bend()) return true;
  constexpr std::int32_t above_all = -1;
  geometry::ShellRay ray{shells.top_m(), shells.planet_m + shells.top_m(), -root, above_all};
  geometry::cross_sphere(shells, ray, 0);
  const auto plane =
      geometry::plane_of(geometry::place_in(shells, photon.position).from_centre, photon.direction);
  photon.direction = plane.direction({}, ray.cosine());
  return true;
}

/// Moves a photon to the end of its ray: straight so far, or where a turn in its plane leads.
inline void move_along(const medium::ShellsView& shells, const geometry::ShellRay& ray,
                       const geometry::Turn& turn, double flown, Photon<double>& photon) {
  if (!shells.bend()) {
    photon.position = photon.position + flown * photon.direction;
    return;
  }
  const auto plane =
      geometry::plane_of(geometry::place_in(shells, photon.position).from_centre, photon.direction);
  photon.position = ray.radius * plane.vertical(turn);
  photon.position.z -= shells.planet_m + shells.top_m();
  photon.direction = plane.direction(turn, ray.cosine());
}

/// On a ground that reflects, a photon's direction is that against the local vertical, with z
/// straight up, until leave_ground(): all that is known of beds is right there then.
inline void stand_on_ground(const medium::MediumView& air, Photon<double>& photon) {
  photon.layer = air.layers;
  const auto up = geometry::local_vertical(air.shells, photon.position);
  photon.direction = geometry::in_local_frame(up, photon.direction);
}

/// Moves a photon by a free path, an optical depth, or to the top of the air or the ground. Its
/// weight takes what fly() (transport/flight.hpp) has it take. `witness` is shown each leg.
template <class Witness>
ShellFlight fly_in_shells(const geometry::Slabs& air, Photon<double>& photon, double free_path,
                          Witness&& witness) {
  const medium::ShellsView& shells = air.shells;
  geometry::ShellRay ray = geometry::ray_in(shells, geometry::place_in(shells, photon.position),
                                            photon.direction, air.layer_of<double>(photon.layer));
  geometry::Turn turn;
  ShellFlight flight;
  double absorbed_tau = 0, gain = 1;
  flight.end = ShellEnd::lost;
  for (int legs = 0; legs < max_legs; ++legs) {
    const geometry::Leg ahead = geometry::leg_ahead(shells, ray);
    const std::int32_t here = air.at(photon.line, ray.shell);
    const double tau = gather<double>(air.walk_c.first, here) * ahead.length;
    const bool collides = free_path < tau;
    ShellLeg leg{ray, {}, ahead.length};
    if (collides) leg.length = free_path * gather<double>(air.walk_mean_path, here);
    leg.to = collides ? geometry::farther(ray, leg.length) : geometry::end_of(shells, ray, ahead);
    witness(leg);
    flight.length += leg.length;
    absorbed_tau += gather<double>(air.continuous_c.first, here) * leg.length;
    if (shells.bend()) turn = turn.by(geometry::turn_of(ray, leg.length, leg.to.radius));
    ray = leg.to;
    if (collides) {
      gain = gather<double>(air.collision_gain, here);
      flight.end = ShellEnd::collision;
      break;
    }
    free_path -= tau;
    if (ahead.sphere == shells.ground()) {
      flight.end = ShellEnd::ground;
      break;
    }
    geometry::cross_sphere(shells, ray, ahead.sphere);
    if (ray.shell < 0) {
      flight.end = ShellEnd::top;
      break;
    }
  }
  move_along(shells, ray, turn, flight.length, photon);
  photon.path += flight.length;
  photon.layer = ray.shell < 0 ? 0 : ray.shell;
  if (flight.end == ShellEnd::ground && air.bed_angles > 0) stand_on_ground(air, photon);
  gain *= exp_minus(absorbed_tau);
  photon.weight *= gain;
  photon.analog_weight *= gain;
  return flight;
}

}  // namespace photic::transport
