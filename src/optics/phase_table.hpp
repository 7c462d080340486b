// One tabulated form for every phase function: value, pdf and inverse-CDF sampling.
//
// The variable is x = 1 - cos(angle), 0 <= x <= 2, and the grid has equal cells within each octave
// of x up to 1 and of 2 - x behind it, so that a forward peak and a glory straight back keep their
// digits and a cell is found from the bits of x. Inside x_core the function is flat with the same
// mass (docs/theory.md, "Phase functions"); the last cell, straight back, is a straight line.
// Samples come from a table of the inverse of its cumulative, which is as close to it as the cells
// are to the formula.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "core/constants.hpp"
#include "core/lanes.hpp"
#include "core/twin_table.hpp"
#include "optics/phase_key.hpp"

namespace photic::optics {

/// A phase function as a walk sees it: pointers into a PhaseTable, copied freely.
struct PhaseView {
  static constexpr int cell_bits = 7;        ///< 128 cells in an octave
  static constexpr int core_exponent = -26;  ///< x_core = 2^-26: 0.00989 degree
  static constexpr int back_exponent = -16;  ///< the last cell: 2^-16, 0.32 degrees
  static constexpr int forward_cells = 1 + (-core_exponent << cell_bits);  ///< cell 0 is the core
  static constexpr int cells = forward_cells + 1 + (-back_exponent << cell_bits);
  static constexpr double x_core = 1.0 / (1 << -core_exponent);

  /// The straight line of p in a cell against the distance from the nearer pole, x or 2 - x: the
  /// cells from the forward pole to 90 degrees, then those from the backward pole, and the last of
  /// them again for 90 degrees itself.
  static constexpr int lines = cells + 1;
  enum Line : std::int32_t {
    at_pole,  ///< value where the line would meet the pole [1/sr]
    slope,    ///< per distance [1/sr]
    line_fields
  };
  Table line;  ///< [lines][line_fields]

  /// The place below which the fraction u of all scattering lies: x is a cubic of the place t of u
  /// in a cell, 0 <= t <= 1. The cells are equal within each octave of u below one half, and of 1 -
  /// u above.
  enum Quantile : std::int32_t { at, linear, square, cube, quantile_fields };
  static constexpr int quantile_bits = 6;      ///< 64 cells in an octave
  static constexpr int quantile_octaves = 24;  ///< below the last one cell 0 leads to u = 0
  static constexpr double min_octave = 1.0 / (1 << quantile_octaves);
  /// The rows of a half: cell 0, the octaves to one half, and a cell that begins there.
  static constexpr int half_quantiles = 2 + ((quantile_octaves - 1) << quantile_bits);
  static constexpr int quantiles = 2 * half_quantiles;
  Table quantile;         ///< [quantiles][quantile_fields], outside the core
  ShortTable core_per_u;  ///< x over u inside it

  /// Lower edge of a cell; 2 of the one behind the last.
  static double edge(int i) {
    if (i == 0) return 0;
    if (i == cells) return 2;
    return i <= forward_cells ? octave_edge<double>(first_octave_cell + i - 1, cell_bits)
                              : 2 - octave_edge<double>(forward_cells - i, cell_bits);
  }

  /// The line of an entry.
  template <class T>
  [[nodiscard]] std::array<T, line_fields> line_of(const Index<T>& i) const {
    return gather_row<line_fields, T>(line, i * Index<T>(static_cast<std::int32_t>(line_fields)));
  }

  // A view may hold several tables one behind the other (medium/medium.hpp): `table` picks one,
  // so that each lane of a walk can be in another layer.

  /// The entry of a place so far from the pole `ahead`, or from the other one.
  template <class T>
  static Index<T> entry(const T& near, const Mask<T>& ahead) {
    using Number = Element<T>;
    constexpr Number below = 1 - std::numeric_limits<Number>::epsilon();
    // In the cells at the poles, where rounding puts what lies beyond them, too.
    const T least = select(ahead, T(static_cast<Number>(x_core) * below),
                           T(static_cast<Number>(x_back) * below));
    const Index<T> cell = octave_cell(select(near > least, near, least), cell_bits).cell;
    return cell + select(ahead, Index<T>(1 - first_octave_cell),
                         Index<T>(forward_cells + 1 - first_octave_cell_back));
  }

  /// p(x) [1/sr], which is also the density per solid angle that sample() draws from.
  template <class T>
  T value(const T& x, const Index<T>& table = Index<T>(0)) const {
    const Mask<T> ahead = x < T(1);
    const T near = select(ahead, x, T(2) - x);
    const auto here = line_of<T>(entry(near, ahead) + table * Index<T>(lines));
    return here[at_pole] + here[slope] * near;
  }

  /// The x below which the fraction u of all scattering lies: monotone in u, 0 < u < 1.
  template <class T>
  T sample(const T& u, const Index<T>& table = Index<T>(0)) const;

 private:
  static constexpr std::int32_t first_octave_cell = core_exponent * (1 << cell_bits);
  static constexpr std::int32_t first_octave_cell_back = back_exponent * (1 << cell_bits);
  static constexpr double x_back = 1.0 / (1 << -back_exponent);
};

/// A phase function as its formula gives it: what the models produce and mixtures add up.
struct PhaseShape {
  std::function<double(double)> p;  ///< p(x) [1/sr] at x = 1 - cos, for x_core <= x <= 2
  double core_mass = 0;             ///< the share of all scattering inside x_core
  PhaseKey key{};                   ///< of those of one key p and core_mass are the same
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
  std::vector<double> cdf_;  ///< [cells] probability of x below a cell's lower edge
  TwinTable line_, quantile_, core_per_u_;
};

template <class T>
T PhaseView::sample(const T& u, const Index<T>& table) const {
  const Mask<T> lower = u < T(0.5);
  const T rest = select(lower, u, T(1) - u);
  const auto [cell, fraction] = octave_cell(rest, quantile_bits);
  const Index<T> i = cell + Index<T>((quantile_octaves << quantile_bits) + 1);
  const Mask<T> in_octave = i > Index<T>(0);
  const T t = select(in_octave, fraction, rest * T(1 / min_octave));
  const Index<T> row = select(in_octave, i, Index<T>(0)) +
                       select(lower, Index<T>(0), Index<T>(half_quantiles)) +
                       table * Index<T>(quantiles);
  const auto x = gather_row<quantile_fields, T>(
      quantile, row * Index<T>(static_cast<std::int32_t>(quantile_fields)));
  const T in_core = u * gather<T>(core_per_u, table);
  return select(in_core < T(x_core), in_core,
                x[at] + t * (x[linear] + t * (x[square] + t * x[cube])));
}

}  // namespace photic::optics
