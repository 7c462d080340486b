#include "optics/phase_table.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/error.hpp"

namespace photic::optics {
namespace {

/// Number of cells outside the core, and the lower edge of the one numbered i from 0.
constexpr int outer_cells = PhaseView::cells - 1;
double edge(int i) { return PhaseView::edge<double>(i + 1); }

/// Integral over a cell of 2 pi p(x) for the straight line between its nodes.
double mass(const std::vector<double>& node, int i) {
  const auto k = static_cast<std::size_t>(i);
  return pi * (node[k] + node[k + 1]) * (edge(i + 1) - edge(i));
}

std::vector<double> nodes_of(const PhaseShape& shape) {
  // Far below any real value, but not 0: sample() divides by the sum of the nodes of a cell.
  constexpr double least = 1e-30;
  std::vector<double> node;
  for (int i = 0; i <= outer_cells; ++i) {
    const double p = shape.at_node(edge(i));
    expect(std::isfinite(p) && p >= 0,
           "a phase function is finite and not negative outside its core");
    node.push_back(std::max(p, least));
  }
  return node;
}

}  // namespace

PhaseShape tabulated(const PhaseShape& shape) {
  struct Known {
    PhaseShape shape;
    std::vector<double> x, p;
  };
  Known known{shape, {}, {}};
  for (int i = 0; i <= outer_cells; ++i) {
    known.x.push_back(edge(i));
    known.p.push_back(shape.p(edge(i)));
  }
  PhaseShape out;
  out.core_mass = shape.core_mass;
  out.p = [known = std::make_shared<const Known>(std::move(known))](double x) {
    const auto node = std::lower_bound(known->x.begin(), known->x.end(), x);
    return node != known->x.end() && *node == x
               ? known->p[static_cast<std::size_t>(node - known->x.begin())]
               : known->shape.p(x);
  };
  return out;
}

double table_integral(const PhaseShape& shape) {
  const std::vector<double> node = nodes_of(shape);
  double sum = shape.core_mass;
  for (int i = 0; i < outer_cells; ++i) sum += mass(node, i);
  return sum;
}

PhaseTable::PhaseTable(const PhaseShape& shape) {
  expect(shape.core_mass >= 0 && shape.core_mass <= 1,
         "the core of a phase function holds a share of it");
  const std::vector<double> node = nodes_of(shape);
  const double whole = table_integral(shape);
  expect(std::abs(whole - 1) <= 1e-4, "a phase function integrates to 1");

  std::vector<double> numbers;
  const auto add = [&](double cdf, double mass, double p, double slope) {
    numbers.insert(numbers.end(), {cdf, cdf + mass, p, slope});
    return cdf + mass;
  };
  const double core_mass = shape.core_mass / whole;
  double sum = add(0.0, core_mass, core_mass / (2 * pi * PhaseView::x_core), 0.0);
  for (int i = 0; i < outer_cells; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double slope = (node[k + 1] - node[k]) / (edge(i + 1) - edge(i));
    sum = add(sum, mass(node, i) / whole, node[k] / whole, slope / whole);
  }

  cell_ = TwinTable(numbers);

  std::int32_t last = 0;
  for (int k = 0; k <= PhaseView::guides; ++k) {
    const double u = static_cast<double>(k) / PhaseView::guides;
    while (last + 1 < PhaseView::cells && at(last + 1, PhaseView::cdf) <= u) ++last;
    guide_.push_back(last);
  }
}

double PhaseTable::at(std::int32_t cell, PhaseView::Field field) const {
  return cell_.table()[cell * PhaseView::fields + field];
}

PhaseView PhaseTable::view() const { return {cell_.table(), guide_.data()}; }

double PhaseTable::mean_cosine() const {
  double mean_x = at(0, PhaseView::cdf_end) * PhaseView::x_core / 2;
  for (int i = 0; i < outer_cells; ++i) {
    const double x0 = edge(i), x1 = edge(i + 1);
    const double p0 = at(i + 1, PhaseView::node);
    const double p1 = p0 + at(i + 1, PhaseView::slope) * (x1 - x0);
    // Integral of x times a straight line.
    mean_x += 2 * pi * (x1 - x0) * (p0 * (2 * x0 + x1) + p1 * (x0 + 2 * x1)) / 6;
  }
  return 1 - mean_x;
}

double PhaseTable::backscatter_fraction() const {
  constexpr int at_90_degrees = PhaseView::cells - (1 << PhaseView::cell_bits);
  return 1 - at(at_90_degrees, PhaseView::cdf);
}

}  // namespace photic::optics
