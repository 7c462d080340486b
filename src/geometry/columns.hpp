// Straight light through the columns of a row, one after the other: the one loop over them.
#pragma once

#include "core/vec3.hpp"
#include "medium/row.hpp"

namespace photic::geometry {

template <class T>
struct Ray {
  Vec3<T> start;      ///< [m]
  Vec3<T> direction;  ///< a unit vector
};

/// A piece of rays in a column each, from one length along them to another [m].
template <class T>
struct InColumn {
  Mask<T> on{};  ///< of the rays that are in a column still
  Index<T> column{};
  T from{}, to{};
};

/// The faces by which rays leave the columns that they are in.
template <class T>
struct ToFace {
  T length{};          ///< along the ray, from its start [m]
  Mask<T> sideways{};  ///< by a side of the row, in y
  Index<T> step{};     ///< or else: to the next column, or to the one before
};
template <class T>
ToFace<T> to_face(const medium::RowView& row, const Ray<T>& ray, const Index<T>& column) {
  const T never(medium::RowView::never);
  const auto reach = [&](const T& speed, const T& way) {
    const Mask<T> level = speed == T(0);
    return select(level, never, way / select(level, T(1), speed));
  };
  const auto& [start, direction] = ray;
  const Mask<T> ascends = direction.x > T(0), leftwards = direction.y > T(0);
  const Index<T> step = select(ascends, Index<T>(1), Index<T>(0));
  const T face = reach(direction.x, gather<T>(row.face, column + step) - start.x);
  const T side = reach(direction.y,
                       gather<T>(row.side, select(leftwards, Index<T>(1), Index<T>(0))) - start.y);
  return {select(side < face, side, face), side < face, step + step - Index<T>(1)};
}

/// Calls f(piece) for the pieces of rays, so long, in each column that they come through, in their
/// order from the first column on. f returns the rays that go on. Returns those that have left the
/// row.
template <class T, class F>
Mask<T> each_column(const medium::RowView& row, const Ray<T>& ray, const Index<T>& first,
                    const T& length, const Mask<T>& exist, F f) {
  InColumn<T> piece{exist, first, T(0), T(0)};
  Mask<T> left(false);
  while (any(piece.on)) {
    const ToFace<T> face = to_face(row, ray, piece.column);
    const T end = select(face.length < length, face.length, length);
    piece.to = select(end > piece.from, end, piece.from);  // what floats round off
    const Mask<T> goes_on = f(piece) & piece.on & (face.length < length);
    const Index<T> next = piece.column + face.step;
    const Mask<T> leaves =
        goes_on & (face.sideways | (next < Index<T>(0)) | (next >= Index<T>(row.columns)));
    left = left | leaves;
    piece.on = goes_on & !leaves;
    piece.column = select(piece.on, next, piece.column);
    piece.from = piece.to;
  }
  return left;
}

}  // namespace photic::geometry
