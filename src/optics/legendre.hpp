// Functions of the cosine of an angle as sums of Legendre polynomials.
#pragma once

#include <vector>

namespace photic::optics {

/// Gauss & Legendre's quadrature over -1 … 1, exact for polynomials of a degree below twice its
/// number of nodes.
struct GaussRule {
  /// An even number of nodes, 2 or more.
  explicit GaussRule(int count);

  std::vector<double> node;    ///< ascending
  std::vector<double> weight;  ///< 2 together
};

/// A polynomial of the cosine, through its Legendre coefficients.
class LegendreSeries {
 public:
  /// The polynomial of a degree below the number of nodes with these values there.
  LegendreSeries(const GaussRule& rule, const std::vector<double>& values);

  /// At cosine = 1 - x, 0 <= x <= 2, with the digits that x has near the forward direction.
  [[nodiscard]] double at(double x) const;

  /// Its mean over -1 … 1, and that of its product with the cosine.
  [[nodiscard]] double mean() const { return coefficient_.front(); }
  [[nodiscard]] double mean_with_cosine() const { return coefficient_[1] / 3; }

 private:
  std::vector<double> coefficient_;  ///< of P_l, l = 0, 1, …
};

}  // namespace photic::optics
