// One tabulated form for every phase function: value, pdf and inverse-CDF sampling.
//
// The variable is x = 1 - cos(angle), 0 <= x <= 2, and the grid has equal cells within each octave of x, from
// x_core to 2, so that a forward peak keeps its digits and a cell is found from the bits of x. Inside
// x_core the function is flat with the same mass (docs/theory.md, "Phase functions").
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/constants.hpp"
#include "core/lanes.hpp"

namespace photic::optics {

/// What a walk sees of a phase function: pointers into a PhaseTable, copied freely.
struct PhaseView {
  static constexpr int cell_bits = 7;                       ///< 128 cells in an octave
  static constexpr int core_exponent = -26;                 ///< x_core = 2^-26: 0.00989 degree
  static constexpr int octaves = 1 - core_exponent;         ///< from x_core to 2
  static constexpr int cells = octaves << cell_bits;        ///< cell 0 is the first one outside the core
  static constexpr int guides = 1024;                       ///< a power of two

  const double* node = nullptr;        ///< p at the lower edge of cell i [1/sr]; cells + 1 values
  const double* cdf = nullptr;         ///< probability of x below the lower edge of cell i; cells + 1 values
  const std::int32_t* guide = nullptr; ///< last cell (-1: the core) whose cdf is <= k / guides
  double core_value = 0;               ///< p inside the core [1/sr]

  static constexpr double x_core = 1.0 / (1 << -core_exponent);

  /// p(x) [1/sr], which is also the density per solid angle that sample() draws from.
  template <class T>
  T value(const T& x) const {
    const auto [octave, fraction] = octave_cell(select(x < T(x_core), T(x_core), x), cell_bits);
    Index<T> i = octave - (core_exponent << cell_bits);
    i = select(i > Index<T>(cells - 1), Index<T>(cells - 1), i);
    const T t = select(x < T(2), fraction, T(1));
    const T low = gather<T>(node, i);
    const T high = gather<T>(node, i + Index<T>(1));
    return select(x < T(x_core), T(core_value), low + t * (high - low));
  }

  /// The x below which the fraction u of all scattering lies: monotone in u, 0 < u < 1.
  template <class T>
  T sample(const T& u) const;
};

/// A phase function as its formula gives it: what the models produce and mixtures add up.
struct PhaseShape {
  std::function<double(double)> p;  ///< p(x) [1/sr] at x = 1 - cos, for x_core <= x <= 2
  double core_mass = 0;             ///< the share of all scattering inside x_core
};

/// Owns the numbers behind a PhaseView.
class PhaseTable {
 public:
  /// The shape's integral over the sphere must be 1 within 1e-4 (else ContractViolation: not normalised);
  /// what the interpolation adds to it (below 5e-5) is divided out.
  explicit PhaseTable(const PhaseShape& shape);

  [[nodiscard]] PhaseView view() const;
  [[nodiscard]] double mean_cosine() const;          ///< g, of the table
  [[nodiscard]] double backscatter_fraction() const; ///< b_b / b, of the table

 private:
  std::vector<double> node_, cdf_;
  std::vector<std::int32_t> guide_;
  double core_value_ = 0;
};

template <class T>
T PhaseView::sample(const T& u) const {
  using std::sqrt;
  Index<T> i = gather_index<T>(guide, floor_index(u * T(guides)));
  // The guide is at most a few cells short.
  for (;;) {
    const auto next = i + Index<T>(1);
    const auto short_of = (next < Index<T>(cells)) & (gather<T>(cdf, next) <= u);
    if (!any(short_of)) break;
    i = select(short_of, next, i);
  }
  const auto in_core = i < Index<T>(0);
  const Index<T> c = select(in_core, Index<T>(0), i);
  const T below = gather<T>(cdf, c);
  const T share = (u - below) / (gather<T>(cdf, c + Index<T>(1)) - below);
  const T p0 = gather<T>(node, c);
  const T p1 = gather<T>(node, c + Index<T>(1));
  // Inverse of the cumulative of a straight line from p0 to p1.
  const T t = share * (p0 + p1) / (p0 + sqrt((T(1) - share) * p0 * p0 + share * p1 * p1));
  const T x0 = octave_edge<T>(c + Index<T>(core_exponent << cell_bits), cell_bits);
  const T x1 = octave_edge<T>(c + Index<T>((core_exponent << cell_bits) + 1), cell_bits);
  return select(in_core, T(x_core) * (u / gather<T>(cdf, Index<T>(0))), x0 + t * (x1 - x0));
}

}  // namespace photic::optics
