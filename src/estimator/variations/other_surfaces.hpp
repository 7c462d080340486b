// A path's weight in environments with other waves or whitecaps where it meets the surface
// (docs/theory.md, "Environments").
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/elementary.hpp"
#include "core/lanes.hpp"
#include "estimator/variations/other_films.hpp"
#include "medium/medium.hpp"
#include "surface/waves.hpp"

namespace photic::estimator {

/// The ratio of weights by a meeting in each lane, lane by lane, for as many environments at once
/// as there are lanes. Facets have the ratio of two densities of slopes and of Smith's factors
/// between facets, whitecaps that of their fractions.
template <class T>
class OtherSurfaces {
 public:
  void clear() { any_ = false; }
  void meet(const medium::MediumView& sea, const surface::FacetHit<T>& m) {
    using std::abs;
    any_ = sea.surface.differs_in_environments;
    if (!any_) return;
    film_.clear();
    add_film(sea, m.film, film_);
    if (!sea.environments.other_waves) return;
    const auto& waves = sea.waves;
    const T up = m.slope.upwind * per(waves.upwind_deviation);
    const T across = m.slope.crosswind * per(waves.crosswind_deviation);
    const T series = waves.series(across, up);
    const Mask<T> exists = series > T(0);
    const auto [along, aside] = surface::by_wind(waves, m.between.x, m.between.y);
    upwind_ = each_lane(m.slope.upwind);
    crosswind_ = each_lane(m.slope.crosswind);
    exponent_ = each_lane(T(0.5) * (up * up + across * across));
    per_here_ = each_lane(select(exists, T(1) + surface::smith(waves, m.between), T(0)) /
                          select(exists, series, T(1)));
    by_whitecaps_ = each_lane(m.by_whitecaps);
    along_ = each_lane(along);
    aside_ = each_lane(aside);
    cosine_ = each_lane(T(abs(m.between.z)));
  }
  /// The ratio less 1, or of tangents what it adds to their sum, for environments from `first` on.
  [[nodiscard]] T sum(const medium::MediumView& sea, std::size_t lane, std::int32_t first) const {
    if (!any_) return T(0);
    const T of_waves = sea.environments.other_waves ? sum_of_waves(sea, lane, first) : T(0);
    if (!sea.environments.other_film) return of_waves;
    const T less = film_.sum(sea.environments, lane, first);
    const Mask<T> tangent =
        Index<T>(first) + lane_numbers<T>() >= Index<T>(sea.environments.first_tangent);
    return select(tangent, of_waves - less, (T(1) + of_waves) * exp_minus(less) - T(1));
  }

 private:
  [[nodiscard]] T sum_of_waves(const medium::MediumView& sea, std::size_t lane,
                               std::int32_t first) const {
    constexpr auto rows = static_cast<std::int32_t>(medium::SurfaceRow::rows);
    const Rows at{sea.environments, first};
    return at[2 * rows] * (ratio(sea, at, lane, rows) - ratio(sea, at, lane, 0));
  }
  struct Rows {
    const medium::EnvironmentsView& of;
    std::int32_t first;
    T operator[](std::int32_t row) const {
      return load<T>(of.number, (of.first_surface + row) * of.stride + first);
    }
  };
  static T per(double deviation) { return T(deviation > 0 ? 1 / deviation : 0); }

  /// The ratio with the surfaces whose rows begin at one.
  [[nodiscard]] T ratio(const medium::MediumView& sea, const Rows& at, std::size_t lane,
                        std::int32_t from) const {
    using enum medium::SurfaceRow;
    using std::sqrt;
    const auto row = [&](medium::SurfaceRow which) {
      return at[from + static_cast<std::int32_t>(which)];
    };
    const T white = T(by_whitecaps_[lane]);
    // The facets that would do so may be so steep that no number holds what becomes of them.
    if (by_whitecaps_[lane] == 1) return row(whitecaps);
    const T per_up = row(per_upwind), per_across = row(per_crosswind);
    const T up = T(upwind_[lane]) * per_up, across = T(crosswind_[lane]) * per_across;
    const auto& here = sea.waves.series;
    const optics::GramCharlierOf<T> series{row(c21), row(c03), T(here.c40), T(here.c22),
                                           T(here.c04)};
    const T value = series(across, up);
    // Never below 0, but for a derivative's step, and where rows are padded with zeros.
    const T less = T(0.5) * (up * up + across * across) - T(exponent_[lane]);
    const T density = row(of_facets) * exp_minus(select(less > T(-80), less, T(-80))) *
                      select(value > T(0), value, T(0));
    const T along = T(along_[lane]) * deviation(per_up),
            aside = T(aside_[lane]) * deviation(per_across);
    const T between =
        T(1) + surface::smith_of(T(sqrt(along * along + aside * aside)), T(cosine_[lane]));
    return white * row(whitecaps) +
           (T(1) - white) * row(facets) * density * T(per_here_[lane]) / between;
  }
  static T deviation(const T& per) {
    return select(per > T(0), T(1) / select(per > T(0), per, T(1)), T(0));
  }

  bool any_ = false;
  Terms<T> film_;
  std::array<Element<T>, lanes_of<T>> upwind_{}, crosswind_{}, exponent_{}, per_here_{},
      by_whitecaps_{}, along_{}, aside_{}, cosine_{};
};

}  // namespace photic::estimator
