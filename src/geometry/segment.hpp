// Pieces of the path of light through the layers, and all that depends on them: optical depths, and
// group paths, which are the times of light.
#pragma once

#include "core/vec3.hpp"
#include "geometry/free_paths.hpp"

namespace photic::geometry {

/// The depth of a position [m].
template <class T>
T depth_of(const Vec3<T>& position) {
  return -position.z;
}

/// The mirror image of a position in the surface.
template <class T>
Vec3<T> mirror_image(const Vec3<T>& position) {
  return {position.x, position.y, -position.z};
}

/// The level of a thing in the water: a photon, a vertex, a ray where it begins.
template <class Placed>
auto level_of(const medium::MediumView& sea, const Placed& at) {
  return sea.level(at.layer, depth_of(at.position));
}

/// The slant of a piece: so much of the length of a piece for so much of its depth.
template <class T>
struct Slant {
  T length{1}, depth{1};

  static Slant of_secant(const T& secant) { return {secant, T(1)}; }
  static Slant of_cosine(const T& cosine) { return {T(1), cosine}; }
};

enum class Course {
  straight,    ///< from one level to another
  to_surface,  ///< from a level
  by_surface   ///< from a level to another, reflected by the surface on the way
};

/// A piece of the path of light of a line.
template <class T>
struct Segment {
  Index<T> line{};
  medium::Level<T> from{}, to{};
  T length{};  ///< [m]
  Course course = Course::straight;
  Slant<T> slant{};  ///< unless it is straight
};
template <class T>
Segment<T> to_surface(const Index<T>& line, const medium::Level<T>& from, const T& length,
                      const Slant<T>& slant) {
  return {line, from, {}, length, Course::to_surface, slant};
}
template <class T>
Segment<T> by_surface(const Index<T>& line, const medium::Level<T>& from,
                      const medium::Level<T>& to, const T& length, const Slant<T>& slant) {
  return {line, from, to, length, Course::by_surface, slant};
}

/// Optical depths of the light, and of the coefficient that free paths are drawn from.
template <class T>
struct OpticalDepths {
  T all, walk;

  friend OpticalDepths select(const Mask<T>& mask, const OpticalDepths& yes,
                              const OpticalDepths& no) {
    return {select(mask, yes.all, no.all), select(mask, yes.walk, no.walk)};
  }
};

template <class T>
OpticalDepths<T> optical_depths(const Slabs& sea, const Segment<T>& s) {
  if (s.course == Course::straight)
    return {sea.slant_optical_depth(s.line, s.from, s.to, s.length),
            sea.walk_slant_optical_depth(s.line, s.from, s.to, s.length)};
  OpticalDepths<T> down{sea.optical_depth(s.line, s.from), sea.walk_optical_depth(s.line, s.from)};
  if (s.course == Course::by_surface)
    down = {down.all + sea.optical_depth(s.line, s.to),
            down.walk + sea.walk_optical_depth(s.line, s.to)};
  return {down.all * s.slant.length / s.slant.depth, down.walk * s.slant.length / s.slant.depth};
}

/// The length that it counts as in time [m]. `length`: of it, or by how much it is longer than one
/// that is left out of paths.
template <class T>
T group_path(const medium::MediumView& sea, const Segment<T>& s, const T& length) {
  const T path = length * gather<T>(sea.group_index, s.line);
  if (sea.kind == medium::MediumKind::water) [[likely]]
    return path;
  if (s.course == Course::straight) return path + sea.air_delay(s.line, s.from, s.to, s.length);
  T down = sea.air_delay_down(s.line, s.from);
  if (s.course == Course::by_surface) down = down + sea.air_delay_down(s.line, s.to);
  return path + down * s.slant.length / s.slant.depth;
}
template <class T>
T group_path(const medium::MediumView& sea, const Segment<T>& segment) {
  return group_path(sea, segment, segment.length);
}

/// The length that a metre in a layer counts as [m].
template <class T>
T group_index_in(const medium::MediumView& sea, const Index<T>& line, const Index<T>& layer) {
  const T of_line = gather<T>(sea.group_index, line);
  if (sea.kind == medium::MediumKind::water) [[likely]]
    return of_line;
  return of_line + sea.template air_delay_per_metre<T>(line, layer);
}
/// The least of all layers: of air, a vacuum's.
template <class T>
T min_group_index(const medium::MediumView& sea, const Index<T>& line) {
  return gather<T>(sea.group_index, line);
}

}  // namespace photic::geometry
