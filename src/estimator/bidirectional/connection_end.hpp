// A vertex of a walk as the end of a connection: its weight and the densities of strategies, if
// light leaves it, or comes to it, along a new edge.
//
// An edge of the laser's light ends at a vertex of the telescope's walk that scatters it or
// converts it; an edge of converted light begins at a vertex of the laser's walk.
#pragma once

#include "estimator/bidirectional/depart.hpp"
#include "estimator/bidirectional/vertex.hpp"
#include "estimator/contribution.hpp"
#include "transport/scatter.hpp"

namespace photic::estimator {

template <class T>
struct ConnectionEnd {
  EndDensities<T> densities;
  T contribution{1};  ///< of this vertex [1/sr]
  T weight{};         ///< of the walk, this collision included
  T chance{1};        ///< h of connecting this edge, of choices on this side
  T goes_on{1};       ///< h of strategies on the laser's side: the telescope's walk goes on beyond
  T meeting{};        ///< density of meeting at this end, but for what the other end adds
};

/// The freedom of a path's walks to be moved as wholes to meet at one of its vertices.
template <class T>
struct Freedom {
  T translations{};      ///< of PathFreedom, there [m]
  RotationAxis<T> axis;  ///< of a telescope's walk's rotation beyond its pivot

  /// Density of meeting at a vertex that is left in a direction, but for the phase function there
  /// and for the edge beyond. `converts`: the walks that convert light there.
  T meeting(const Vertex<T>& v, const Vec3<T>& direction, const Mask<T>& converts) const {
    T density = v.translated;
    if (any(converts)) density = select(converts, met_either_way(density, direction.z), density);
    return translations * if_reversed(density, direction.z) + rotation_at(v, direction).about(axis);
  }
};

/// A vertex of a walk where light of the walk's line is scattered.
template <class T>
Interaction<T> scattering_at(const geometry::Slabs& sea, const Vertex<T>& v) {
  return scattering_at<T>(sea, v.line, v.layer, v.direction);
}

/// An end of a contribution, with the density of that; the rest is still to be set.
template <class T>
ConnectionEnd<T> end_with(const T& contribution) {
  ConnectionEnd<T> end;
  end.contribution = contribution;
  end.densities.p = density_of(contribution);
  return end;
}

/// The laser's walk, scattered into a direction of the laser's light. `goes_on`: of the other end;
/// `behind`: the densities behind the vertex.
template <class T>
ConnectionEnd<T> scattering_from_laser(const geometry::Slabs& sea, const Vertex<T>& v,
                                       const T& behind, const Vec3<T>& direction,
                                       const estimator::InverseConversion<T>& inverse_conversion,
                                       const T& goes_on, const Freedom<T>& freedom) {
  ConnectionEnd<T> end = end_with(contribution(sea, scattering_at(sea, v), direction));
  end.densities.arriving_edge = goes_on * arriving_edge(sea, v, end.densities.p);
  end.densities.behind =
      goes_on *
      inverse_conversion.scattered_over_phase(sea, v.layer, -v.direction, end.densities.p) * behind;
  end.meeting = goes_on * freedom.meeting(v, direction, Mask<T>(false));
  end.weight = v.weight * transport::scattered_share(sea, v.line, v.layer, T(-v.direction.z));
  return end;
}

/// The laser's walk, converted to a line and sent into a direction. The other end's walk scatters
/// this light: `chance` is that of a walk up to it, `goes_on` with its not being converted there;
/// both 1 where the other end is a telescope.
template <class T>
ConnectionEnd<T> conversion_from_laser(const geometry::Slabs& sea, const Vertex<T>& v,
                                       const T& behind, const Vec3<T>& direction,
                                       const Index<T>& line,
                                       const estimator::InverseConversion<T>& inverse_conversion,
                                       const Index<T>& before, const T& chance, const T& goes_on,
                                       const Freedom<T>& freedom) {
  const T ratio = walk_c_ratio<T>(sea, line, v.layer);
  ConnectionEnd<T> end =
      end_with(contribution(sea, conversion_at<T>(sea, line, v.layer, v.direction), direction));
  end.densities.arriving_edge = goes_on * arriving_edge(sea, v, end.densities.p);
  end.densities.behind = goes_on * inverse_conversion.chance(sea, line, v.layer, before) *
                         inverse_conversion.over_phase(sea, -v.direction, end.densities.p) * behind;
  end.meeting = goes_on * ratio * freedom.meeting(v, direction, Mask<T>(true));
  end.weight = v.weight * ratio * gather<T>(sea.conversion, sea.at(line, v.layer));
  end.chance = chance * ratio;
  return end;
}

/// The telescope's walk with the laser's light that comes to it: scattered if the walk has
/// already converted, else converted here. `direction`: in which the walk would go on; `behind`:
/// the densities behind the vertex.
template <class T>
ConnectionEnd<T> arrival_from_laser(const geometry::Slabs& sea, const Vertex<T>& v, const T& behind,
                                    const Vec3<T>& direction,
                                    const estimator::InverseConversion<T>& inverse_conversion,
                                    const Index<T>& before, const Freedom<T>& freedom) {
  const Mask<T> converts = v.line > Index<T>(0);
  const T ratio = walk_c_ratio<T>(sea, v.line, v.layer);  // 1 for the laser's line
  ConnectionEnd<T> end = end_with(
      contribution(sea, interaction_at<T>(sea, converts, v.line, v.layer, v.direction), direction));
  end.densities.arriving_edge = ratio * arriving_edge(sea, v, end.densities.p);
  end.densities.behind = behind;  // 0 before a conversion
  end.meeting = freedom.meeting(v, direction, converts);
  end.weight = v.weight * select(converts, conversion_per_emitted_c<T>(sea, v.line, v.layer),
                                 transport::scattered_share(sea, v.line, v.layer, direction.z));
  end.chance = v.chance;
  end.goes_on = v.chance * inverse_conversion.goes_on(sea, v.line, v.layer, before, converts,
                                                      direction, end.densities.p);
  return end;
}

/// The telescope's walk with converted light that it scatters here: nothing behind can be drawn by
/// another strategy.
template <class T>
ConnectionEnd<T> scattering_of_converted(const geometry::Slabs& sea, const Vertex<T>& v,
                                         const Vec3<T>& direction) {
  ConnectionEnd<T> end = end_with(contribution(sea, scattering_at(sea, v), direction));
  end.weight = v.weight * transport::scattered_share(sea, v.line, v.layer, direction.z);
  return end;
}

}  // namespace photic::estimator
