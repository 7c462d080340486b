// A new direction after a collision: from the phase function, or towards a telescope.
#pragma once

#include <array>
#include <cmath>
#include <type_traits>

#include "core/turn.hpp"
#include "geometry/shells.hpp"
#include "medium/medium.hpp"
#include "surface/lambert.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

/// The directions in which light is worth sending from a photon's place, and their weights. About
/// its direction a target has either a lobe of the shape of a phase function, or a cone filled
/// evenly.
template <class T, int capacity>
struct Targets {
  std::array<Vec3<T>, capacity> direction;
  std::array<T, capacity> cone;    ///< 1 - cos of the half angle; 0: a lobe
  std::array<T, capacity> weight;  ///< a target's probability is in proportion to it; may be 0
  int count = 0;
  T total_weight{};

  /// The share of directions that are drawn towards targets: `directed` where there are any.
  T share(const T& directed) const { return select(total_weight > T(0), directed, T(0)); }

  void clear() {
    count = 0;
    total_weight = T(0);
  }

  void add(const Vec3<T>& towards, const T& one_minus_cos_cone, const T& target_weight) {
    const auto i = static_cast<std::size_t>(count++);
    direction[i] = towards;
    cone[i] = one_minus_cos_cone;
    weight[i] = target_weight;
    total_weight = total_weight + target_weight;
  }
};

/// The share of light that is scattered where it comes to: b / c, or the bed's albedo for light
/// that comes down under a cosine to the vertical.
template <class T>
T scattered_share(const medium::MediumView& sea, const Index<T>& line, const Index<T>& layer,
                  const T& cosine) {
  const T albedo = gather<T>(sea.albedo, sea.at(line, layer));
  if (sea.bed_angles == 0) return albedo;
  const T of_bed = surface::bed_albedo(sea, line, layer, cosine);
  return select(surface::on_bed<T>(sea, layer), of_bed, albedo);
}
/// Density of the directions that it leaves in: a phase function, or Lambert's law [1/sr].
template <class T>
T scattered_density(const medium::MediumView& sea, const Index<T>& layer, const Index<T>& phase,
                    const Vec3<T>& old, const Vec3<T>& fresh) {
  const T p = sea.phases.template value<T>(one_minus_cos(old, fresh), phase);
  if (sea.bed_angles == 0) return p;
  return select(surface::on_bed<T>(sea, layer), surface::lambert_density(fresh), p);
}
/// Uniforms of one scattering.
template <class T>
struct ScatterUniforms {
  T polar, azimuth, mixture, target;
};

/// A new direction, about an axis.
template <class T>
struct Deflection {
  Vec3<T> axis;
  T one_minus_cos{}, cos_azimuth{}, sin_azimuth{};
};

/// Draws one from the mixture
///   q = (1 - e) p(old, new) + e weighted mean over targets of lobe or cone(target, new),
/// p and lobe being tables of the medium, p on the bed Lambert's law; e = `directed` where there
/// are targets and 0 elsewhere.
template <class T, int capacity>
Deflection<T> deflect(const medium::MediumView& sea, const Index<T>& layer, const Vec3<T>& old,
                      const Index<T>& phase, const Index<T>& lobe,
                      const Targets<T, capacity>& targets, const T& directed,
                      const ScatterUniforms<T>& u) {
  const auto [cos_azimuth, sin_azimuth] = cos_sin_of_turns(u.azimuth);
  Deflection<T> out{old, {}, cos_azimuth, sin_azimuth};
  const T share = targets.share(directed);
  const bool aims = any(share > T(0));
  const Mask<T> towards = u.mixture < share;
  T cone(0);
  if (aims) {
    T rest = u.target * targets.total_weight;
    for (int i = 0; i < targets.count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const Mask<T> taken = towards & (rest >= T(0)) & (rest < targets.weight[k]);
      out.axis = select(taken, targets.direction[k], out.axis);
      cone = select(taken, targets.cone[k], cone);
      rest = rest - targets.weight[k];
    }
  }
  out.one_minus_cos = sea.phases.sample<T>(u.polar, aims ? select(towards, lobe, phase) : phase);
  if (aims) out.one_minus_cos = select(cone > T(0), u.polar * cone, out.one_minus_cos);
  if (sea.bed_angles == 0) return out;
  const Mask<T> by_lambert = surface::on_bed<T>(sea, layer) & !towards;
  out.axis = select(by_lambert, Vec3<T>{T(0), T(0), T(1)}, out.axis);
  out.one_minus_cos =
      select(by_lambert, surface::lambert_one_minus_cos(u.polar), out.one_minus_cos);
  if constexpr (std::is_same_v<T, double>)
    if (by_lambert && sea.shells.mirrors)
      return {{old.x, old.y, -old.z}, 0, out.cos_azimuth, out.sin_azimuth};
  return out;
}

/// The direction that it leads to.
template <class T>
Vec3<T> turned(const Deflection<T>& by) {
  return turned(by.axis, by.one_minus_cos, by.cos_azimuth, by.sin_azimuth);
}

/// Turns the new direction of a photon that stands on the ground below spherical air out of the
/// frame that it has there (transport/shell_flight.hpp).
template <class T>
void leave_ground(const medium::MediumView& air, Photon<T>& photon) {
  if constexpr (std::is_same_v<T, double>) {
    if (!air.shells.exist() || photon.layer != air.layers) return;
    const auto up = geometry::local_vertical(air.shells, photon.position);
    photon.direction = geometry::from_local_frame(up, photon.direction);
  }
}

/// p / q <= 1 / (1 - e) of a new direction, both terms always in q (Veach & Guibas, SIGGRAPH 95,
/// balance heuristic); 1 where there are no targets.
template <class T, int capacity>
T true_over_drawn(const medium::MediumView& sea, const Index<T>& layer, const Vec3<T>& old,
                  const Vec3<T>& fresh, const Index<T>& phase, const Index<T>& lobe,
                  const Targets<T, capacity>& targets, const T& directed) {
  const T share = targets.share(directed);
  if (!any(share > T(0))) return T(1);
  const T p = scattered_density(sea, layer, phase, old, fresh);
  T towards_density(0);
  for (int i = 0; i < targets.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const T off = one_minus_cos(targets.direction[k], fresh);
    const Mask<T> is_cone = targets.cone[k] > T(0);
    T density = sea.phases.value<T>(off, lobe);
    if (any(is_cone)) {
      const T even = T(0.5 / pi) / select(is_cone, targets.cone[k], T(1));
      density = select(is_cone, select(off < targets.cone[k], even, T(0)), density);
    }
    towards_density = towards_density + targets.weight[k] * density;
  }
  const T weighted = p * select(targets.total_weight > T(0), targets.total_weight, T(1));
  return weighted / ((T(1) - share) * weighted + share * towards_density);
}

}  // namespace photic::transport
