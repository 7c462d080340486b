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

  const double* node = nullptr;  ///< p at the lower edge of cell i [1/sr]; cells + 1 values
  const double* cdf =
      nullptr;  ///< probability of x below the lower edge of cell i; cells + 1 values
  const std::int32_t* guide = nullptr;  ///< last cell (-1: the core) whose cdf is <= k / guides
  const double* core_value = nullptr;   ///< p inside the core [1/sr]; one value

  static constexpr double x_core = 1.0 / (1 << -core_exponent);

  // A view may hold several tables one behind the other (medium/phase_bank.hpp): `table` picks one,
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
  std::vector<double> node_, cdf_;
  std::vector<std::int32_t> guide_;
  double core_value_ = 0;
};

template <class T>
T PhaseView::sample(const T& u, const Index<T>& table) const {
  using std::sqrt;
  const Index<T> base = table * Index<T>(cells + 1);
  Index<T> i = gather_index<T>(guide, floor_index(u * T(guides)) + table * Index<T>(guides));
  // The guide is at most a few cells short.
  for (;;) {
    const Index<T> next = i + Index<T>(1);
    const Mask<T> behind = (next < Index<T>(cells)) & (gather<T>(cdf, base + next) <= u);
    if (!any(behind)) break;
    i = select(behind, next, i);
  }
  const auto in_core = i < Index<T>(0);
  const Index<T> cell = select(in_core, Index<T>(0), i);
  const T below = gather<T>(cdf, base + cell);
  const T share = (u - below) / (gather<T>(cdf, base + cell + Index<T>(1)) - below);
  const T p0 = gather<T>(node, base + cell);
  const T p1 = gather<T>(node, base + cell + Index<T>(1));
  // Inverse of the cumulative of a straight line from p0 to p1.
  const T t = share * (p0 + p1) / (p0 + sqrt(p0 * p0 + share * (p1 * p1 - p0 * p0)));
  const Index<T> octave = cell + Index<T>(core_exponent * (1 << cell_bits));
  const T x0 = octave_edge<T>(octave, cell_bits);
  const T x1 = octave_edge<T>(octave + Index<T>(1), cell_bits);
  const T in_core_x = T(x_core) * (u / gather<T>(cdf, base));
  return select(in_core, in_core_x, x0 + t * (x1 - x0));
}

}  // namespace photic::optics
