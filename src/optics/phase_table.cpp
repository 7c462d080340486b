#include "optics/phase_table.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace photic::optics {
namespace {

/// Lower edge of cell i.
double edge(int i) {
  return octave_edge<double>(i + PhaseView::core_exponent * (1 << PhaseView::cell_bits),
                             PhaseView::cell_bits);
}

/// Integral over a cell of 2 pi p(x) for the straight line between its nodes.
double mass(const std::vector<double>& node, int i) {
  const auto k = static_cast<std::size_t>(i);
  return pi * (node[k] + node[k + 1]) * (edge(i + 1) - edge(i));
}

std::vector<double> nodes_of(const PhaseShape& shape) {
  // Far below any real value, but not 0: sample() divides by the sum of the nodes of a cell.
  constexpr double least = 1e-30;
  std::vector<double> node;
  for (int i = 0; i <= PhaseView::cells; ++i) {
    const double p = shape.p(edge(i));
    expect(std::isfinite(p) && p >= 0,
           "a phase function is finite and not negative outside its core");
    node.push_back(std::max(p, least));
  }
  return node;
}

}  // namespace

double table_integral(const PhaseShape& shape) {
  const std::vector<double> node = nodes_of(shape);
  double sum = shape.core_mass;
  for (int i = 0; i < PhaseView::cells; ++i) sum += mass(node, i);
  return sum;
}

PhaseTable::PhaseTable(const PhaseShape& shape) : node_(nodes_of(shape)) {
  expect(shape.core_mass >= 0 && shape.core_mass <= 1,
         "the core of a phase function holds a share of it");
  double sum = shape.core_mass;
  for (int i = 0; i < PhaseView::cells; ++i) {
    cdf_.push_back(sum);
    sum += mass(node_, i);
  }
  cdf_.push_back(sum);
  expect(std::abs(sum - 1) <= 1e-4, "a phase function integrates to 1");
  for (double& p : node_) p /= sum;
  for (double& share : cdf_) share /= sum;
  for (int i = 0; i < PhaseView::cells; ++i) {
    const auto k = static_cast<std::size_t>(i);
    slope_.push_back((node_[k + 1] - node_[k]) / (edge(i + 1) - edge(i)));
  }
  slope_.push_back(0.0);
  core_value_ = cdf_.front() / (2 * pi * PhaseView::x_core);

  std::size_t above = 0;  // first cell whose cdf is above u
  for (int k = 0; k < PhaseView::guides; ++k) {
    const double u = static_cast<double>(k) / PhaseView::guides;
    while (above < PhaseView::cells && cdf_[above] <= u) ++above;
    guide_.push_back(static_cast<std::int32_t>(above) - 1);
  }
}

PhaseView PhaseTable::view() const {
  return {node_.data(), slope_.data(), cdf_.data(), guide_.data(), &core_value_};
}

double PhaseTable::mean_cosine() const {
  double mean_x = cdf_.front() * PhaseView::x_core / 2;
  for (int i = 0; i < PhaseView::cells; ++i) {
    const double x0 = edge(i), x1 = edge(i + 1);
    const double p0 = node_[static_cast<std::size_t>(i)],
                 p1 = node_[static_cast<std::size_t>(i) + 1];
    // Integral of x times a straight line.
    mean_x += 2 * pi * (x1 - x0) * (p0 * (2 * x0 + x1) + p1 * (x0 + 2 * x1)) / 6;
  }
  return 1 - mean_x;
}

double PhaseTable::backscatter_fraction() const {
  constexpr auto at_90_degrees =
      static_cast<std::size_t>(PhaseView::cells - (1 << PhaseView::cell_bits));
  return 1 - cdf_[at_90_degrees];
}

}  // namespace photic::optics
