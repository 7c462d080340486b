// Contributions: how much of the light that comes to a vertex of a path leaves it in a direction.
// The numerators of scores are made of them. Densities, with which walks draw that direction, and
// which weight the strategies, are apart (docs/bidirectional.md, "Contributions and densities").
#pragma once

#include "core/lanes.hpp"
#include "core/vec3.hpp"
#include "medium/medium.hpp"
#include "transport/scatter.hpp"

namespace photic::estimator {

/// A vertex of a path: the bed, where `place` is that, else water with a phase function.
template <class T>
struct Interaction {
  Index<T> place;     ///< a layer, or the bed
  Index<T> phase;     ///< table of the medium
  Vec3<T> direction;  ///< in which light comes there, or a walk the other way
};

/// A vertex where light of a line is scattered, or reflected by the bed.
template <class T>
Interaction<T> scattering_at(const medium::MediumView& sea, const Index<T>& line,
                             const Index<T>& place, const Vec3<T>& direction) {
  return {place, gather_index<T>(sea.elastic_phase, sea.at(line, place)), direction};
}
/// A vertex where the laser's light becomes light of a line.
template <class T>
Interaction<T> conversion_at(const medium::MediumView& sea, const Index<T>& line,
                             const Index<T>& place, const Vec3<T>& direction) {
  return {place, gather_index<T>(sea.conversion_phase, line), direction};
}
/// Either: a conversion where it `converts`.
template <class T>
Interaction<T> interaction_at(const medium::MediumView& sea, const Mask<T>& converts,
                              const Index<T>& line, const Index<T>& place,
                              const Vec3<T>& direction) {
  return {place,
          select(converts, conversion_at<T>(sea, line, place, direction).phase,
                 scattering_at<T>(sea, line, place, direction).phase),
          direction};
}

/// The contribution of a vertex that light leaves in a direction, or comes from where a walk goes
/// on: the phase function, or Lambert's law of the bed [1/sr].
template <class T>
T contribution(const medium::MediumView& sea, const Interaction<T>& vertex,
               const Vec3<T>& direction) {
  return transport::scattered_density(sea, vertex.place, vertex.phase, vertex.direction, direction);
}

/// The density of that direction, of which light takes a contribution: walks draw directions from
/// phase functions, and on the bed from Lambert's law [1/sr].
template <class T>
T density_of(const T& contribution) {
  return contribution;
}

}  // namespace photic::estimator
