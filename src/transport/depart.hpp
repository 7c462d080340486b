// What a walk that is to be connected does at a vertex: it is scattered, or, coming from a
// telescope with converted light, becomes light of the laser's line.
#pragma once

#include "core/turn.hpp"
#include "medium/medium.hpp"
#include "transport/vertex.hpp"

namespace photic::transport {

/// The chance that a walk from a telescope which detects `line` turns conversion back in a layer:
/// 0 for the laser's line and where that line is not emitted.
template <class T>
T conversion_chance(const medium::MediumView& sea, const Index<T>& line, const Index<T>& layer,
                    const T& probability) {
  const T emitted = gather<T>(sea.conversion, sea.at(line, layer));
  return select((line > Index<T>(0)) & (emitted > T(0)), probability, T(0));
}

/// c' of the laser's line over that of a line.
template <class T>
T walk_c_ratio(const medium::MediumView& sea, const Index<T>& line, const Index<T>& layer) {
  return gather<T>(sea.walk_c, layer) / gather<T>(sea.walk_c, sea.at(line, layer));
}

/// What a conversion's coefficient is to the attenuation of the line it emits [both 1/m].
template <class T>
T conversion_per_emitted_c(const medium::MediumView& sea, const Index<T>& line,
                           const Index<T>& layer) {
  const Index<T> here = sea.at(line, layer);
  return gather<T>(sea.conversion, here) * gather<T>(sea.c, layer) / gather<T>(sea.c, here);
}

template <class T>
struct DepartUniforms {
  T polar, azimuth, branch;
};

/// Sends a walk on from the vertex it stands at. Its weight takes b / c, or for a conversion its
/// coefficient over c; that it was drawn with a chance is left to the connections, which know the
/// chances of all strategies.
template <class T>
Departure<T> depart(const medium::MediumView& sea, Photon<T>& photon, const T& probability,
                    const DepartUniforms<T>& u) {
  const Index<T> here = sea.at(photon.line, photon.layer);
  const T albedo = gather<T>(sea.albedo, here);
  const T chance = conversion_chance<T>(sea, photon.line, photon.layer, probability);
  const Mask<T> converts = u.branch < chance;
  const Mask<T> inelastic = photon.line > Index<T>(0);
  Departure<T> departure;
  departure.chance = select(converts, chance, T(1) - chance);
  departure.density = select(
      inelastic, select(converts, walk_c_ratio<T>(sea, photon.line, photon.layer), T(0)), T(1));
  const Index<T> phase = select(converts, gather_index<T>(sea.conversion_phase, photon.line),
                                gather_index<T>(sea.elastic_phase, here));
  photon.weight =
      photon.weight *
      select(converts, conversion_per_emitted_c<T>(sea, photon.line, photon.layer), albedo);
  photon.analog_weight = photon.analog_weight * select(converts, T(1), albedo);
  photon.line = select(converts, Index<T>(0), photon.line);
  photon.order = photon.order + Index<T>(1);

  const T x = sea.phases.template sample<T>(u.polar, phase);
  departure.p = sea.phases.template value<T>(x, phase);
  const auto [cosine, sine] = cos_sin_of_turns(u.azimuth);
  photon.direction = turned(photon.direction, x, cosine, sine);
  return departure;
}

}  // namespace photic::transport
