// The instruments of a world, made of a model.
#pragma once

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "estimator/ahead.hpp"
#include "estimator/instruments.hpp"
#include "estimator/model.hpp"
#include "estimator/nested_views.hpp"
#include "estimator/origin.hpp"
#include "geometry/shells.hpp"

namespace photic::estimator {

/// The number of the layer that an instrument of a model stands in.
template <class Instrument>
std::size_t layer_of(const medium::Medium& medium, const Instrument& instrument) {
  const auto& at = instrument.position_m;
  return medium.layer_at(std::max(0.0, -at.z), medium.row.column_at(at.x));
}

/// The region of an instrument, of_laser or a telescope behind it.
template <class T, class Instrument>
geometry::Region<T> region_in(const Model& model, const geometry::Slabs& slabs,
                              const Instrument& instrument, std::size_t number) {
  const bool outside = !geometry::stands_in_water(instrument.position_m);
  geometry::OutsideColumn column;
  if (outside && !model.columns.empty())
    column = model.columns[number].view(
        slabs.environments.other_outside ? slabs.excess_outside(number) : -1);
  return {outside, Index<T>(layer_of(model.medium, instrument)), column};
}

/// The greatest rounding error of paths in the air between an instrument and the sea [m], by which
/// they count as longer: light that the sea mirrors comes hardly later than light that turns at the
/// surface, and must never come before it. It is 0.5 mm from 3 km, 2 cm from space in float:
/// length, delay, and half the sum of both ways are each rounded by half the last digit.
template <class T, class Instrument>
double max_rounded_off(const Instrument& instrument, const medium::Medium& air) {
  const double epsilon = std::numeric_limits<Element<T>>::epsilon();
  return 1.5 * epsilon * std::clamp(-instrument.position_m.z, 0.0, air.air_m);
}

/// Adds a model's telescopes, with their regions and the paths that are left out.
template <class T>
void add_telescopes(const Model& model, const geometry::Slabs& slabs, const Vec3<double>& origin,
                    const geometry::Ahead& of_laser, Instruments<T>& out) {
  const auto& [scene, medium] = std::tie(model.scene, model.medium);
  for (const auto& t : scene.telescope) {
    const std::size_t number = out.telescopes.size();
    out.telescopes.push_back(
        instrument::make_telescope<T>(from_origin(t, origin), ahead_in(medium, t)));
    double left_out =
        path_to_origin(of_laser, from_origin(t, origin), out.telescopes.back().above_air);
    if (medium.kind == medium::MediumKind::air)
      left_out += max_rounded_off<T>(scene.source, medium) + max_rounded_off<T>(t, medium);
    out.path_to_origin.push_back(left_out - model.apparent_path.both_paths(number));
    out.telescope_region.push_back(region_in<T>(model, slabs, t, number + 1));
  }
}

/// Adds the groups of a scene's telescopes.
template <class T>
void add_groups(const scene::Scene& scene, Instruments<T>& out) {
  for (const NestedViews& views : nested_views(scene)) {
    const std::size_t widest = views.back();
    ViewGroup<T> group{widest,
                       out.telescopes[widest],
                       out.telescope_region[widest],
                       out.path_to_origin[widest],
                       {}};
    for (std::size_t i = views.size() - 1; i-- > 0;)
      group.narrower.push_back({Index<T>(static_cast<std::int32_t>(views[i])),
                                out.telescopes[views[i]].detector_radius});
    out.groups.push_back(std::move(group));
  }
}

/// Adds the source in spherical air. Its light sets out where it stands, also outside, and comes to
/// the air by its first flight.
template <class T>
void add_source_in_shells(const scene::Source& source, const medium::ShellsView& shells,
                          Instruments<T>& out) {
  out.laser = instrument::make_laser<T>(source, geometry::Ahead{});
  const double height = geometry::place_in(shells, source.position_m).height;
  std::int32_t shell = 0;
  while (!shells.source_outside && height < shells.height[static_cast<std::size_t>(shell) + 1])
    ++shell;
  out.laser_region = {false, Index<T>(shell), {}};
}

/// Deadlines are the caller's: they follow from the walks' cones, too.
template <class T>
Instruments<T> make_instruments(const Model& model, const geometry::Slabs& slabs) {
  Instruments<T> out;
  const scene::Source& source = model.scene.source;
  if (slabs.shells.exist()) {
    add_source_in_shells(source, slabs.shells, out);
    return out;
  }
  const Vec3<double> origin = origin_of(source, model.medium.kind);
  const geometry::Ahead of_laser = ahead_in(model.medium, source);
  out.laser = instrument::make_laser<T>(from_origin(source, origin), of_laser);
  out.laser_region = region_in<T>(model, slabs, source, 0);
  add_telescopes(model, slabs, origin, of_laser, out);
  add_groups(model.scene, out);
  return out;
}

}  // namespace photic::estimator
