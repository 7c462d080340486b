// Pieces of the path of light through the layers, and all that depends on them: optical depths, and
// group paths, which are the times of light.
#pragma once

#include "core/flatten.hpp"
#include "core/vec3.hpp"
#include "geometry/columns.hpp"
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
  T length{};    ///< [m]
  Ray<T> ray{};  ///< from its first place; known where the sea is a row of columns
  Course course = Course::straight;
  Slant<T> slant{};  ///< unless it is straight
};
template <class T>
Segment<T> to_surface(const Index<T>& line, const medium::Level<T>& from, const T& length,
                      const Slant<T>& slant, const Ray<T>& ray = {}) {
  return {line, from, {}, length, ray, Course::to_surface, slant};
}
template <class T>
Segment<T> by_surface(const Index<T>& line, const medium::Level<T>& from,
                      const medium::Level<T>& to, const T& length, const Slant<T>& slant,
                      const Ray<T>& ray = {}) {
  return {line, from, to, length, ray, Course::by_surface, slant};
}

/// A depth in a column of a row, likely in a layer.
template <class T>
medium::Level<T> level_in(const medium::MediumView& sea, const Index<T>& column,
                          const Index<T>& likely, const T& depth) {
  const Index<T> first = gather_index<T>(sea.row.first_layer, column);
  const Index<T> from = select(sea.row.column<T>(likely) == column, likely, first);
  return sea.level(sea.layer_at(from, depth), depth);
}

/// Straight light at its end.
template <class T>
struct StraightEnd {
  Mask<T> sideways{};  ///< it has left the row by a side before
  medium::Level<T> level{};
};
/// Calls f(mask, segment) for the pieces of a straight segment in each column of a row.
template <class T, class F>
StraightEnd<T> each_straight_piece(const medium::MediumView& sea, const Segment<T>& s, F f) {
  StraightEnd<T> end{Mask<T>(false), s.from};
  const Index<T> column = sea.row.template column<T>(s.from.layer);
  end.sideways =
      each_column(sea.row, s.ray, column, s.length, Mask<T>(true), [&](const InColumn<T>& in) {
        const T depth =
            select(in.to < s.length, s.from.depth - s.ray.direction.z * in.to, s.to.depth);
        const auto begin = level_in(sea, in.column, end.level.layer, end.level.depth);
        const auto last = level_in(sea, in.column, begin.layer, depth);
        f(in.on, Segment<T>{s.line, begin, last, in.to - in.from});
        end.level.layer = select(in.on, last.layer, end.level.layer);
        end.level.depth = select(in.on, last.depth, end.level.depth);
        return in.on;
      });
  return end;
}
/// The same of any segment. Returns the light that leaves the row by a side.
template <class T, class F>
Mask<T> each_piece(const medium::MediumView& sea, const Segment<T>& s, F f) {
  // Most ways stay in their column. A point of a lens may be in another one than its centre, whose
  // layer it has.
  const Index<T> column = sea.row.template column<T>(s.from.layer);
  const Mask<T> ends_there =
      Mask<T>(s.course == Course::to_surface) | (sea.row.template column<T>(s.to.layer) == column);
  if (all(ends_there & (s.length <= to_face(sea.row, s.ray, column).length))) {
    f(Mask<T>(true), s);
    return Mask<T>(false);
  }
  if (s.course == Course::straight) return each_straight_piece(sea, s, f).sideways;
  Segment<T> up = s;
  up.to = {};
  if (s.course == Course::by_surface) {
    const T to_surface = s.from.depth * s.slant.length / s.slant.depth;
    up.length = select(to_surface < s.length, to_surface, s.length);
  }
  const auto risen = each_straight_piece(sea, up, f);
  if (s.course == Course::to_surface) return risen.sideways;
  Segment<T> down = s;
  down.from = risen.level;
  down.length = s.length - up.length;
  down.ray.start = s.ray.start + up.length * s.ray.direction;
  down.ray.direction.z = T(0) - s.ray.direction.z;
  return risen.sideways | each_straight_piece(sea, down, f).sideways;
}

/// Optical depths of the light, and of the coefficient that free paths are drawn from.
template <class T>
struct OpticalDepths {
  T all, walk;

  friend OpticalDepths operator+(const OpticalDepths& a, const OpticalDepths& b) {
    return {a.all + b.all, a.walk + b.walk};
  }
  friend OpticalDepths select(const Mask<T>& mask, const OpticalDepths& yes,
                              const OpticalDepths& no) {
    return {select(mask, yes.all, no.all), select(mask, yes.walk, no.walk)};
  }
};

/// Of light that leaves a row of columns by a side: nothing of it comes on.
inline constexpr double opaque = 1e4;

/// Where there are no columns, or within one of them.
template <class T>
OpticalDepths<T> depths_in_column(const Slabs& sea, const Segment<T>& s) {
  if (s.course == Course::straight)
    return {sea.slant_optical_depth(s.line, s.from, s.to, s.length),
            sea.walk_slant_optical_depth(s.line, s.from, s.to, s.length)};
  OpticalDepths<T> down{sea.optical_depth(s.line, s.from), sea.walk_optical_depth(s.line, s.from)};
  if (s.course == Course::by_surface)
    down = {down.all + sea.optical_depth(s.line, s.to),
            down.walk + sea.walk_optical_depth(s.line, s.to)};
  return {down.all * s.slant.length / s.slant.depth, down.walk * s.slant.length / s.slant.depth};
}

template <class T>
PHOTIC_APART OpticalDepths<T> depths_through_columns(const Slabs& sea, const Segment<T>& s) {
  OpticalDepths<T> sum{T(0), T(0)};
  const Mask<T> sideways = each_piece(sea, s, [&](const Mask<T>& on, const Segment<T>& piece) {
    sum = select(on, sum + depths_in_column(sea, piece), sum);
  });
  return select(sideways, OpticalDepths<T>{T(opaque), T(opaque)}, sum);
}

template <class T>
OpticalDepths<T> optical_depths(const Slabs& sea, const Segment<T>& s) {
  if (sea.row.has_faces) [[unlikely]]
    return depths_through_columns(sea, s);
  return depths_in_column(sea, s);
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
