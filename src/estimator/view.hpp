// A telescope's view in the water, as sampling takes it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/vec3.hpp"
#include "geometry/axis.hpp"
#include "instrument/telescope.hpp"
#include "medium/medium.hpp"

namespace photic::estimator {

/// A telescope's view in the water as sampling takes it: a cone about its (refracted) axis from the
/// point where that enters the lens or the surface, whose light is attenuated with `rate` on its
/// way to the entry.
template <class T>
struct ViewCone {
  Vec3<T> entry;
  Vec3<T> axis;  ///< unit vector into the water
  T rate{};      ///< [1/m]
  T radius{};    ///< at the entry [m]
  T widening{};  ///< of the radius, per metre
};

inline constexpr int view_parts = 3;

/// Clearer media count as this [1/m], so that squares of distances in a view stay in the range of
/// floats.
inline constexpr double min_view_rate = 1e-6;

/// A ball in the water.
template <class T>
struct Ball {
  Vec3<T> centre;
  T radius{};
};

/// A telescope's view as seen by light that is still to be converted: a cone about its axis, and
/// balls along it that hold the part of it that most of the converted light comes from.
template <class T>
struct View {
  ViewCone<T> cone;
  std::array<Ball<T>, view_parts> part;
};

template <class T>
View<T> make_view(const instrument::Telescope<double>& telescope, const medium::Medium& medium,
                  std::size_t layer) {
  double c = min_view_rate;
  for (std::size_t l = medium.line.size() > 1 ? 1 : 0; l < medium.line.size(); ++l) {
    c = std::max(c, medium.c[l * static_cast<std::size_t>(medium.layers()) + layer]);
  }
  const auto axis = geometry::axis_in_water(telescope.position, telescope.axis,
                                            medium.line.front().refractive_index);
  // Lateral reach of the view: detector and blur, seen from the lens.
  const auto reach = [&](double in_water) {
    const double apparent = axis.in_air + in_water / axis.index;
    const double blur = telescope.detector_distance * (1 - apparent * telescope.per_sharp_range);
    return (apparent * telescope.detector_radius + telescope.lens_radius * std::abs(blur)) /
           telescope.detector_distance;
  };
  const double widening = std::max(0.0, (reach(2 / c) - reach(0)) * c / 2);
  View<T> view;
  view.cone = {vec3_cast<T>(axis.entry), vec3_cast<T>(axis.direction), T(c),
               T(std::max(reach(0), reach(2 / c) - widening * 2 / c)), T(widening)};
  constexpr std::array edge{0.0, 0.5, 1.2, 2.5};  // in mean free paths of the converted light
  for (std::size_t i = 0; i < view.part.size(); ++i) {
    const double middle = (edge[i] + edge[i + 1]) / 2 / c;
    view.part[i] = {vec3_cast<T>(axis.entry + middle * axis.direction),
                    T(std::hypot(reach(middle), (edge[i + 1] - edge[i]) / 2 / c))};
  }
  return view;
}

}  // namespace photic::estimator
