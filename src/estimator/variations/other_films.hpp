// A path's weight in environments with another film of oil, or none (docs/theory.md,
// "Environments").
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/lanes.hpp"
#include "estimator/variations/terms.hpp"
#include "medium/medium.hpp"
#include "surface/film_crossing.hpp"
#include "surface/oil.hpp"

namespace photic::estimator {

using medium::back_into_water;
using medium::through_film;
using surface::FilmCrossing;

/// Adds the loss of light there, as an optical depth. Between the angles that it is known at it is
/// linear in sqrt(1 - cos).
template <class T>
void add_film(const medium::MediumView& sea, const FilmCrossing<T>& crossing, Terms<T>& ways) {
  using std::sqrt;
  if (!sea.environments.other_film) return;
  const T x = T(1) - crossing.cosine;
  const T place =
      T(static_cast<double>(medium::film_angle_steps)) * sqrt(select(x > T(0), x, T(0)));
  const Index<T> last(medium::film_angle_steps - 1);
  const Index<T> found = floor_index(place);
  const Index<T> step = select(found < last, found, last);
  const T rest = place - to_real<T>(step);
  const Mask<T> meets = crossing.way >= Index<T>(0);
  const Index<T> row = sea.film_row(select(meets, crossing.way, Index<T>(0)), crossing.line, step);
  ways.add(row, select(meets, T(1) - rest, T(0)));
  ways.add(row + Index<T>(1), select(meets, rest, T(0)));
}

/// The same of a flat sea; waves have films of their facets (other_surfaces.hpp).
template <class T>
void add_flat_film(const medium::MediumView& sea, const FilmCrossing<T>& crossing, Terms<T>& ways) {
  if (sea.surface.one_direction_each) add_film(sea, crossing, ways);
}

/// Light that a film emits, lane by lane.
template <class T>
class OtherEmission {
 public:
  void clear() { any_ = false; }
  /// Notes an emission as surface::emitted_by_film() takes it.
  void emit(const medium::MediumView& sea, const surface::AtFilm<T>& at, const Index<T>& line,
            const Vec3<T>& direction, bool up) {
    using std::abs;
    any_ = sea.environments.other_film;
    if (!any_) return;
    const T along = dot(direction, at.normal);
    up_ = up;
    line_ = each_lane(line);
    from_above_ = each_lane(select(at.outside, T(1), T(0)));
    cosine_in_ = each_lane(T(abs(dot(at.direction, at.normal))));
    cosine_out_ = each_lane(up ? along : T(T(0) - along));
    here_ = each_lane(surface::emitted_by_film(sea, at, line, direction, up));
  }
  /// The excess over the value here, relative to it, for environments from `first` on.
  [[nodiscard]] T sum(const medium::MediumView& sea, std::size_t lane, std::int32_t first) const {
    if (!any_ || !(here_[lane] > 0)) return T(0);
    const auto& of = sea.environments;
    const auto row = [&](std::int32_t k) {
      return load<T>(of.number, (of.first_emission + k) * of.stride + first);
    };
    const std::int32_t lines = sea.lines, scale = 2 * (lines + 1);
    const auto emitted = [&](std::int32_t from) {
      return row(from + lines) * emission(sea, lane, row(from), row(from + line_[lane]));
    };
    return row(scale) * (emitted(lines + 1) - emitted(0)) * T(1 / here_[lane]);
  }

 private:
  /// For the optical thicknesses at the laser's line and at that of the light.
  [[nodiscard]] T emission(const medium::MediumView& sea, std::size_t lane, const T& laser,
                           const T& own) const {
    const auto film = [&](std::int32_t line, const T& optical_thickness) {
      const auto l = static_cast<std::size_t>(line);
      using Scalar = Element<T>;
      return optics::FilmOnWater<T>{
          {T(gather<Scalar>(sea.film.index, static_cast<std::int32_t>(l))), optical_thickness},
          T(gather<Scalar>(sea.index, static_cast<std::int32_t>(l)))};
    };
    const T share(gather<Element<T>>(sea.film.emission, line_[lane]));
    return share * optics::film_emission(film(0, laser), from_above_[lane] > 0, T(cosine_in_[lane]),
                                         film(line_[lane], own), up_, T(cosine_out_[lane]));
  }

  bool any_ = false, up_ = false;
  std::array<std::int32_t, lanes_of<T>> line_{};
  std::array<Element<T>, lanes_of<T>> from_above_{}, cosine_in_{}, cosine_out_{}, here_{};
};

}  // namespace photic::estimator
