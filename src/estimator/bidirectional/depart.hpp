// The departure of a walk that is to be connected from a vertex: it is scattered, or, coming from a
// telescope with converted light, becomes light of the laser's line.
#pragma once

#include "core/constants.hpp"
#include "core/random.hpp"
#include "core/turn.hpp"
#include "estimator/bidirectional/vertex.hpp"
#include "estimator/inverse_conversion.hpp"
#include "medium/medium.hpp"
#include "transport/scatter.hpp"

namespace photic::estimator {

/// c' of the laser's line over that of a line.
template <class T>
T walk_c_ratio(const geometry::Slabs& sea, const Index<T>& line, const Index<T>& layer) {
  return gather<T>(sea.walk_c.first, layer) * gather<T>(sea.walk_mean_path, sea.at(line, layer));
}

/// The ratio of a conversion's coefficient to the attenuation of the line it emits [both 1/m].
template <class T>
T conversion_per_emitted_c(const geometry::Slabs& sea, const Index<T>& line,
                           const Index<T>& layer) {
  const Index<T> here = sea.at(line, layer);
  return gather<T>(sea.conversion, here) * gather<T>(sea.c.first, layer) /
         gather<T>(sea.c.first, here);
}

template <class T>
struct DepartUniforms {
  T polar, azimuth, branch, mixture;
};

/// A walk that stood `before` on the bed leaves it.
template <class T>
void depart_from_bed(const geometry::Slabs& sea, const transport::Photon<T>& before,
                     const DepartUniforms<T>& u, bool from_telescope, transport::Photon<T>& photon,
                     Departure<T>& departure) {
  const Mask<T> bed = surface::on_bed<T>(sea, before.layer);
  if (!any(bed)) return;
  const auto [cosine, sine] = cos_sin_of_turns(u.azimuth);
  const Vec3<T> up{T(0), T(0), T(1)};
  const Vec3<T> fresh = turned(up, surface::lambert_one_minus_cos(u.polar), cosine, sine);
  const T albedo = surface::bed_albedo(sea, before.line, before.layer,
                                       from_telescope ? fresh.z : T(-before.direction.z));
  photon.direction = select(bed, fresh, photon.direction);
  photon.weight = select(bed, before.weight * albedo, photon.weight);
  photon.analog_weight = select(bed, before.analog_weight * albedo, photon.analog_weight);
  photon.line = select(bed, before.line, photon.line);
  photon.layer = sea.layer_of<T>(photon.layer);
  departure.p = select(bed, surface::lambert_density(fresh), departure.p);
  departure.chance = select(bed, T(1), departure.chance);
  departure.reverse_chance = select(bed, T(1), departure.reverse_chance);
}

/// Sends a walk on from the vertex it stands at. Its weight takes b / c, or for a conversion its
/// coefficient over c; that it was drawn with a chance is left to the connections, which know the
/// chances of all strategies. `from_telescope`: the walk, which else comes from the laser.
template <class T>
Departure<T> depart(const geometry::Slabs& sea, transport::Photon<T>& photon,
                    const estimator::InverseConversion<T>& inverse_conversion,
                    const DepartUniforms<T>& u, bool from_telescope) {
  const transport::Photon<T> before = photon;
  const Index<T> here = sea.at(photon.line, photon.layer);
  const T albedo = gather<T>(sea.albedo, here);
  const T chance = inverse_conversion.chance(sea, photon.line, photon.layer, photon.order);
  const Mask<T> converts = u.branch < chance;
  const Mask<T> inelastic = photon.line > Index<T>(0);
  Departure<T> departure;
  departure.chance = select(converts, chance, T(1) - chance);
  departure.c_ratio = select(
      inelastic, select(converts, walk_c_ratio<T>(sea, photon.line, photon.layer), T(0)), T(1));
  const Index<T> phase = select(converts, gather_index<T>(sea.conversion_phase, photon.line),
                                gather_index<T>(sea.elastic_phase, here));
  photon.weight =
      photon.weight *
      select(converts, conversion_per_emitted_c<T>(sea, photon.line, photon.layer), albedo);
  photon.analog_weight = photon.analog_weight * select(converts, T(1), albedo);
  photon.line = select(converts, Index<T>(0), photon.line);
  photon.order = photon.order + Index<T>(1);

  const Mask<T> scatters =
      from_telescope ? (inverse_conversion.scattered > T(0)) & !inelastic : Mask<T>(false);
  const Mask<T> scatters_to_beam = scatters & (u.polar < inverse_conversion.scattered);
  const T polar =
      any(scatters)
          ? select(scatters, left_of_choice(u.polar, inverse_conversion.scattered), u.polar)
          : u.polar;
  const Mask<T> to_beam = scatters_to_beam | (converts & (u.mixture < inverse_conversion.directed));
  const T drawn =
      sea.phases.template sample<T>(polar, select(to_beam, inverse_conversion.lobe, phase));
  const T x = select(converts & !to_beam, T(2) * polar, drawn);
  const auto [cosine, sine] = cos_sin_of_turns(u.azimuth);
  const Vec3<T> old = photon.direction;
  const Mask<T> about_beam = converts | to_beam;
  photon.direction = turned(select(about_beam, inverse_conversion.beam, old), x, cosine, sine);
  departure.p = sea.phases.template value<T>(
      select(about_beam, one_minus_cos(old, photon.direction), x), phase);
  if (any(converts)) {
    departure.chance =
        departure.chance *
        select(converts, inverse_conversion.over_phase(sea, photon.direction, departure.p), T(1));
  }
  if (from_telescope) {
    departure.chance =
        departure.chance * select(scatters,
                                  inverse_conversion.scattered_over_phase(
                                      sea, photon.layer, photon.direction, departure.p),
                                  T(1));
  } else {
    departure.reverse_chance =
        inverse_conversion.scattered_over_phase(sea, photon.layer, -old, departure.p);
  }
  if (sea.bed_angles > 0) depart_from_bed(sea, before, u, from_telescope, photon, departure);
  return departure;
}

}  // namespace photic::estimator
