// The places that light has touched on its way, which separate the processes of light of the
// laser's wavelength.
#pragma once

#include <cstdint>

#include "medium/medium.hpp"
#include "surface/lambert.hpp"

namespace photic::transport {

/// Places that light has touched; the highest counts. `surface`: nothing but a rough surface.
/// `air`: nothing but that and the air.
enum class Touched : std::int32_t { water, bed, surface, air };
inline constexpr std::int32_t kinds_touched = 4;

/// The places touched by light that comes to a place.
template <class T>
Index<T> touched_at(const medium::MediumView& sea, const Index<T>& layer, const Index<T>& before) {
  const Index<T> bed(static_cast<std::int32_t>(Touched::bed));
  return select(surface::on_bed<T>(sea, layer), bed, before);
}

/// The places touched by light that leaves a medium for the other one, where it is scored when it
/// is scattered again. What the air alone has scattered is light of the water once that scatters
/// it; light that nothing has scattered is light of the air then.
template <class T>
Index<T> touched_beyond(const medium::MediumView& sea, const Index<T>& order,
                        const Index<T>& before) {
  const Index<T> air(static_cast<std::int32_t>(Touched::air));
  const Index<T> water(static_cast<std::int32_t>(Touched::water));
  if (sea.kind == medium::MediumKind::air) return select(before == air, water, before);
  return select(order == Index<T>(0), air, before);
}

/// A line and what its light has touched, as tallies count them: an index [touched][line].
template <class T>
Index<T> light_of(const medium::MediumView& sea, const Index<T>& line, const Index<T>& touched) {
  return touched * Index<T>(sea.lines) + line;
}
/// The same of light that is scored where it is scattered.
template <class T>
Index<T> component_of(const medium::MediumView& sea, const Index<T>& line,
                      const Index<T>& touched) {
  if (sea.bed_angles == 0 && sea.surface.one_direction_each &&
      sea.kind == medium::MediumKind::water)
    return line;
  return light_of<T>(sea, line, touched);
}

/// The depth below the surface of a place in a medium: negative in the air.
template <class T>
T signed_depth(const medium::MediumView& sea, const T& depth) {
  return sea.kind == medium::MediumKind::air ? T(0) - depth : depth;
}

}  // namespace photic::transport
