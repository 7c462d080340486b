// One tabulated form for every phase function: value, pdf and inverse-CDF sampling.
//
// The variable is x = 1 - cos(angle), 0 <= x <= 2, and the grid has equal cells within each octave
// of x, from x_core to 2, so that a forward peak keeps its digits and a cell is found from the bits
// of x. Inside x_core the function is flat with the same mass (docs/theory.md, "Phase functions").
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/constants.hpp"
#include "core/lanes.hpp"
#include "core/twin_table.hpp"

namespace photic::optics {

/// What a walk sees of a phase function: pointers into a PhaseTable, copied freely.
struct PhaseView {
  static constexpr int cell_bits = 7;                       ///< 128 cells in an octave
  static constexpr int core_exponent = -26;                 ///< x_core = 2^-26: 0.00989 degree
  static constexpr int octaves = 1 - core_exponent;         ///< from x_core to 2
  static constexpr int cells = 1 + (octaves << cell_bits);  ///< cell 0 is the core
  static constexpr double x_core = 1.0 / (1 << -core_exponent);

  /// The straight line of p in a cell.
  enum Line : std::int32_t {
    node,   ///< p at the lower edge [1/sr]
    slope,  ///< dp/dx [1/sr]
    line_fields
  };
  /// Cells whose cdf is looked at together, and the entries of a table: with some behind its end.
  static constexpr int together = 4;
  static constexpr int stride = cells + together - 1;
  Table cdf;   ///< [stride] probability of x below a cell's lower edge; behind the end 2
  Table line;  ///< [stride][line_fields]

  /// The guide has equal cells within each octave of u below one half, and of 1 - u above, so that
  /// a cell of it holds few cells of the table in the tails, too.
  static constexpr int guide_bits = 8, guide_octaves = 24;
  static constexpr int half_guide = ((guide_octaves - 1) << guide_bits) + 1;
  static constexpr int guides = 2 * half_guide;
  const std::int32_t* guide = nullptr;  ///< [guides] last cell whose cdf is <= all u of an entry

  /// Lower edge of a cell but the core.
  template <class T>
  static T edge(const Index<T>& i) {
    return octave_edge<T>(i + Index<T>(first_octave_cell - 1), cell_bits);
  }

  /// The line of an entry.
  template <class T>
  [[nodiscard]] std::array<T, line_fields> line_of(const Index<T>& i) const {
    return gather_row<line_fields, T>(line, i * Index<T>(static_cast<std::int32_t>(line_fields)));
  }

  // A view may hold several tables one behind the other (medium/medium.hpp): `table` picks one,
  // so that each lane of a walk can be in another layer.

  /// p(x) [1/sr], which is also the density per solid angle that sample() draws from.
  template <class T>
  T value(const T& x, const Index<T>& table = Index<T>(0)) const {
    const T within = select(x < T(2), x, T(2));
    Index<T> i = octave_cell(within, cell_bits).cell - Index<T>(first_octave_cell - 1);
    i = select(i > Index<T>(0), i, Index<T>(0));
    i = select(i < Index<T>(cells), i, Index<T>(cells - 1));
    const auto here = line_of<T>(i + table * Index<T>(stride));
    return here[node] + here[slope] * (within - edge<T>(i));
  }

  /// The x below which the fraction u of all scattering lies: monotone in u, 0 < u < 1.
  template <class T>
  T sample(const T& u, const Index<T>& table = Index<T>(0)) const;

 private:
  static constexpr std::int32_t first_octave_cell = core_exponent * (1 << cell_bits);

  template <class T>
  static Index<T> guide_entry(const T& u) {
    const Mask<T> lower = u < T(0.5);
    const Index<T> i = octave_cell(select(lower, u, T(1) - u), guide_bits).cell +
                       Index<T>(guide_octaves << guide_bits);
    const Index<T> within = select(i > Index<T>(0), i, Index<T>(0));
    return select(lower, within, within + Index<T>(half_guide));
  }
};

/// A phase function as its formula gives it: what the models produce and mixtures add up.
struct PhaseShape {
  std::function<double(double)> p;  ///< p(x) [1/sr] at x = 1 - cos, for x_core <= x <= 2
  double core_mass = 0;             ///< the share of all scattering inside x_core
  /// What a table holds at its nodes, where p has detail finer than its cells: p over the cells
  /// around. Empty: p itself.
  std::function<double(double)> resolved = {};

  [[nodiscard]] double at_node(double x) const { return resolved ? resolved(x) : p(x); }
};

/// The same shape, which knows what the nodes of a table ask it for: that is computed once.
PhaseShape tabulated(const PhaseShape& shape);

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
  TwinTable cdf_, line_;
  std::vector<std::int32_t> guide_;
};

template <class T>
T PhaseView::sample(const T& u, const Index<T>& table) const {
  using std::sqrt;
  const Index<T> base = table * Index<T>(stride);
  Index<T> i = gather_index<T>(guide, guide_entry(u) + table * Index<T>(guides));
  // The cell is this one or one of the next: seldom beyond the first three.
  T below;
  Mask<T> further;
  do {
    const auto row = gather_row<together, T>(cdf, base + i);
    below = row[0];
    for (std::size_t k = 1; k < together; ++k) {
      further = row[k] <= u;
      below = select(further, row[k], below);
      i = i + select(further, Index<T>(1), Index<T>(0));
    }
  } while (any(further));

  // Inverse of the cumulative of a straight line: 2 pi (p0 s + slope s^2 / 2) = u - below, solved
  // for s = x - x0.
  const auto here = line_of<T>(base + i);
  const T rest = (u - below) * T(1 / pi);
  const T p0 = here[node];
  const T square = p0 * p0 + rest * here[slope];
  const T root = sqrt(select(square > T(0), square, T(0)));  // rounding, where p ends at 0
  const T x = select(i > Index<T>(0), edge<T>(i), T(0)) + rest / (p0 + root);
  return select(x < T(2), x, T(2));
}

}  // namespace photic::optics
