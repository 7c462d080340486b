// One tabulated form for every phase function: value, pdf and inverse-CDF sampling.
//
// The variable is x = 1 - cos(angle), 0 <= x <= 2, and the grid has equal cells within each octave
// of x, from x_core to 2, so that a forward peak keeps its digits and a cell is found from the bits
// of x. Inside x_core the function is flat with the same mass (docs/theory.md, "Phase functions").
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/constants.hpp"
#include "core/lanes.hpp"

namespace photic::optics {

/// What a walk sees of a phase function: pointers into a PhaseTable, copied freely.
struct PhaseView {
  static constexpr int cell_bits = 7;                 ///< 128 cells in an octave
  static constexpr int core_exponent = -26;           ///< x_core = 2^-26: 0.00989 degree
  static constexpr int octaves = 1 - core_exponent;   ///< from x_core to 2
  static constexpr int cells = octaves << cell_bits;  ///< cell 0 is the first one outside the core
  static constexpr int guides = 4096;                 ///< a power of two

  const double* node = nullptr;   ///< p at the lower edge of cell i [1/sr]; cells + 1 values
  const double* slope = nullptr;  ///< dp/dx in cell i [1/sr]; cells + 1 values, the last unused
  const double* cdf =
      nullptr;  ///< probability of x below the lower edge of cell i; cells + 1 values
  const std::int32_t* guide = nullptr;  ///< last cell (-1: the core) whose cdf is <= k / guides
  const double* core_value = nullptr;   ///< p inside the core [1/sr]; one value

  static constexpr double x_core = 1.0 / (1 << -core_exponent);

  // A view may hold several tables one behind the other (medium/medium.hpp): `table` picks one,
  // so that each lane of a walk can be in another layer.

  /// p(x) [1/sr], which is also the density per solid angle that sample() draws from.
  template <class T>
  T value(const T& x, const Index<T>& table = Index<T>(0)) const {
    const auto [octave, fraction] = octave_cell(select(x < T(x_core), T(x_core), x), cell_bits);
    Index<T> i = octave - Index<T>(core_exponent * (1 << cell_bits));
    i = select(i > Index<T>(cells - 1), Index<T>(cells - 1), i) + table * Index<T>(cells + 1);
    const T t = select(x < T(2), fraction, T(1));
    const T low = gather<T>(node, i);
    const T high = gather<T>(node, i + Index<T>(1));
    return select(x < T(x_core), gather<T>(core_value, table), low + t * (high - low));
  }

  /// The x below which the fraction u of all scattering lies: monotone in u, 0 < u < 1.
  template <class T>
  T sample(const T& u, const Index<T>& table = Index<T>(0)) const;
};

/// A phase function as its formula gives it: what the models produce and mixtures add up.
struct PhaseShape {
  std::function<double(double)> p;  ///< p(x) [1/sr] at x = 1 - cos, for x_core <= x <= 2
  double core_mass = 0;             ///< the share of all scattering inside x_core
};

/// The shape's integral over the sphere with straight lines between the nodes of a table: 1, but
/// for what is finer than the cells. Its formulas stay below 5e-5 off.
double table_integral(const PhaseShape& shape);

/// Owns the numbers behind a PhaseView.
class PhaseTable {
 public:
  /// table_integral(shape) must be 1 within 1e-4 (else ContractViolation); what it is off is
  /// divided out.
  explicit PhaseTable(const PhaseShape& shape);

  [[nodiscard]] PhaseView view() const;
  [[nodiscard]] double mean_cosine() const;           ///< g, of the table
  [[nodiscard]] double backscatter_fraction() const;  ///< b_b / b, of the table

 private:
  std::vector<double> node_, slope_, cdf_;
  std::vector<std::int32_t> guide_;
  double core_value_ = 0;
};

template <class T>
T PhaseView::sample(const T& u, const Index<T>& table) const {
  using std::sqrt;
  const Index<T> base = table * Index<T>(cells + 1);
  Index<T> i = gather_index<T>(guide, floor_index(u * T(guides)) + table * Index<T>(guides));
  // The guide is at most a few cells short; the first step is taken without asking, which is seldom
  // wrong.
  const auto behind = [&](const Index<T>& cell) {
    return (cell + Index<T>(1) < Index<T>(cells)) &
           (gather<T>(cdf, base + cell + Index<T>(1)) <= u);
  };
  i = i + select(behind(i), Index<T>(1), Index<T>(0));
  for (Mask<T> on = behind(i); any(on); on = behind(i))
    i = i + select(on, Index<T>(1), Index<T>(0));

  const Mask<T> in_core = i < Index<T>(0);
  const Index<T> cell = select(in_core, Index<T>(0), i);
  // Inverse of the cumulative of a straight line: 2 pi (p0 s + slope s^2 / 2) = u - below, solved
  // for s = x - x0.
  const T rest = (u - gather<T>(cdf, base + cell)) * T(1 / pi);
  const T p0 = gather<T>(node, base + cell);
  const T square =
      p0 * p0 +
      rest * gather<T>(slope, base + cell);  // rounding may take it below 0 where p ends at 0
  const T root = sqrt(select(square > T(0), square, T(0)));
  const T x0 = octave_edge<T>(cell + Index<T>(core_exponent * (1 << cell_bits)), cell_bits);
  const T x = x0 + rest / (p0 + root);
  const T inside = select(x < T(2), x, T(2));
  if (!any(in_core)) return inside;
  return select(in_core, T(x_core) * (u / gather<T>(cdf, base)), inside);
}

}  // namespace photic::optics
