// The targets of directed sampling: scattered light is sent to the telescopes, or, before it is
// converted, into their views.
#pragma once

#include <cmath>

#include "estimator/forward/forward_tracks.hpp"
#include "transport/aim.hpp"

namespace photic::estimator {

/// Adds the ways to the telescopes as targets, one to each group by each route.
template <class T>
void aim_at_telescopes(const World<T>& world, ForwardTracks<T>& at) {
  using namespace transport;
  Targets<T>& targets = at.targets;
  const Vec3<T>& from = at.photon.position;
  const Index<T>& line = at.photon.line;
  for (std::size_t g = 0; g < world.instruments.groups.size(); ++g) {
    const auto& telescope = world.instruments.groups[g].widest;
    const Vec3<T> to =
        world.forward.single_rays ? in_space(telescope, at.lens[g]) : telescope.position;
    const auto& region = world.instruments.groups[g].region;
    for (const auto route : geometry::routes_to(region.outside)) {
      if (targets.count == target_capacity) return;
      const auto [direction, in_front] =
          by_waves(world.slabs, region, route)
              ? aim_by_waves(world.slabs, telescope, region, from, line, at.lens[g],
                             {at.surface[0], at.surface[1], at.surface[2]})
              : aim(world.slabs, telescope, region, from, line, to, route,
                    may_be_seen(world, g, from, line, at.lens));
      targets.add(direction, T(0), select(in_front, T(1), T(0)));
    }
  }
}

/// Adds the views of the telescopes as targets for light that has yet to be converted: converted
/// light leaves in all directions, so what counts is that the laser's light comes into view, at
/// whatever angle. The cones hold the whole of a view's parts, or light from the side could enter
/// it by a direction that is drawn too rarely.
template <class T>
void aim_at_views(const ForwardSettings<T>& forward, const transport::Photon<T>& photon,
                  Targets<T>& targets) {
  using std::sqrt;
  const Mask<T> convertible = photon.line == Index<T>(0);
  if (!any(convertible)) return;
  for (const auto& view : forward.views) {
    for (const auto& ball : view.part) {
      if (targets.count == target_capacity) return;
      const Vec3<T> there = ball.centre - photon.position;
      const T squared = dot(there, there);
      const Mask<T> apart = squared > T(0);
      const T safe = select(apart, squared, T(1));
      const T sine_squared = ball.radius * ball.radius / safe;
      const T rest = T(1) - sine_squared;
      const T cone = T(1) - sqrt(select(rest > T(0), rest, T(0)));
      targets.add((T(1) / sqrt(safe)) * there, cone,
                  select(convertible & apart, T(1.0 / view_parts), T(0)));
    }
  }
}

/// Fills in the targets of the direction that photons may take next, where they collide.
template <class T>
void aim_at_targets(const World<T>& world, ForwardTracks<T>& at) {
  if (!any(at.colliding)) return;
  at.targets.clear();
  aim_at_telescopes(world, at);
  aim_at_views(world.forward, at.photon, at.targets);
  for (const Vec3<T>& direction : world.forward.radiance_directions)
    at.targets.add(direction, T(0), T(1));
}

}  // namespace photic::estimator
