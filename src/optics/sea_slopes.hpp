// The slopes of the facets of a rough sea surface: their densities by the wind.
#pragma once

#include <string>

namespace photic::optics {

/// Cox & Munk's Gram-Charlier series, by which the density of slopes is more than a Gaussian (1954,
/// J. Opt. Soc. Am. 44, 838); all 0 of a Gaussian. Slopes are over their standard deviations;
/// `upwind` is positive where the surface rises upwind, so that the most probable facet faces the
/// wind and lee sides are steep.
/// Coefficients of type C: numbers, or those of many seas at once.
template <class C>
struct GramCharlierOf {
  C c21{}, c03{};         ///< skewness
  C c40{}, c22{}, c04{};  ///< peakedness

  /// May be below 0 far out.
  template <class T>
  [[nodiscard]] T operator()(const T& crosswind, const T& upwind) const {
    const T xi2 = crosswind * crosswind, eta2 = upwind * upwind;
    return T(1) - T(c21 * C(0.5)) * (xi2 - T(1)) * upwind -
           T(c03 * C(1.0 / 6)) * (eta2 - T(3)) * upwind +
           T(c40 * C(1.0 / 24)) * (xi2 * xi2 - T(6) * xi2 + T(3)) +
           T(c22 * C(0.25)) * (xi2 - T(1)) * (eta2 - T(1)) +
           T(c04 * C(1.0 / 24)) * (eta2 * eta2 - T(6) * eta2 + T(3));
  }
};
using GramCharlier = GramCharlierOf<double>;

/// The density of slopes: a Gaussian along the wind and across it, as Cox & Munk's Gram-Charlier
/// series changes it. A facet rises by `upwind` metres per metre towards where the wind comes from,
/// and by `crosswind` at right angles to that. A variance of 0: all facets are level that way.
struct SlopeLaw {
  double upwind_variance = 0, crosswind_variance = 0;
  GramCharlier series = {};
  /// Integral of the Gaussian times the series, which counts as 0 where it is below that.
  double norm = 1;
  std::string source = {};  ///< "Author year, journal, what of it [status]"

  /// The density of a two-dimensional law [1].
  [[nodiscard]] double density(double upwind, double crosswind) const;

  [[nodiscard]] bool is_flat() const { return upwind_variance == 0 && crosswind_variance == 0; }
  /// Waves of one direction alone.
  [[nodiscard]] bool is_one_dimensional() const {
    return !is_flat() && (upwind_variance == 0 || crosswind_variance == 0);
  }
  /// Slopes alike to all sides.
  [[nodiscard]] bool is_isotropic() const {
    const auto& [c21, c03, c40, c22, c04] = series;
    const bool is_gaussian = c21 == 0 && c03 == 0 && c40 == 0 && c22 == 0 && c04 == 0;
    return upwind_variance == crosswind_variance && is_gaussian;
  }
};

/// The paper's waves: slopes along the wind alone, of variance 0.008 + 0.0156 v, at v > 0 [m/s].
SlopeLaw paper_slopes(double wind_speed_m_s);

/// Cox & Munk's, of a clean sea or of one with a slick, at a wind above 0 [m/s]; with their
/// Gram-Charlier series or without. The series was measured on the clean sea.
SlopeLaw cox_munk_slopes(double wind_speed_m_s, bool slick, bool gram_charlier);

/// A Gaussian of given variances.
SlopeLaw gaussian_slopes(double upwind_variance, double crosswind_variance);

}  // namespace photic::optics
