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

/// For each entry of the guide the last cell that begins at or below all its u.
std::vector<std::int32_t> guide_to(const std::vector<double>& cdf) {
  constexpr int half = PhaseView::half_guide;
  constexpr int first = -(PhaseView::guide_octaves << PhaseView::guide_bits);
  const auto guide_edge = [](int i) {
    return octave_edge<double>(first + i, PhaseView::guide_bits);
  };
  std::vector<std::int32_t> guide(PhaseView::guides);
  // Each half with u rising, for there are hundreds of tables in a scene of many layers.
  std::size_t last = 0;
  const auto set = [&](int entry, double least_u) {
    while (last + 1 < cdf.size() && cdf[last + 1] <= least_u) ++last;
    guide[static_cast<std::size_t>(entry)] = static_cast<std::int32_t>(last);
  };
  for (int i = 0; i < half; ++i) set(i, i == 0 ? 0 : guide_edge(i));
  last = 0;
  for (int i = half; i-- > 0;) set(half + i, 1 - guide_edge(i + 1));
  return guide;
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

  std::vector<double> cdf, line;
  double sum = 0;
  const auto add = [&](double mass, double p, double slope) {
    cdf.push_back(sum);
    line.insert(line.end(), {p, slope});
    sum += mass;
  };
  const double core_mass = shape.core_mass / whole;
  add(core_mass, core_mass / (2 * pi * PhaseView::x_core), 0.0);
  for (int i = 0; i < outer_cells; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double slope = (node[k + 1] - node[k]) / (edge(i + 1) - edge(i));
    add(mass(node, i) / whole, node[k] / whole, slope / whole);
  }
  guide_ = guide_to(cdf);
  cdf.resize(PhaseView::stride, 2.0);
  line.resize(std::size_t{PhaseView::stride} * PhaseView::line_fields);
  cdf_ = TwinTable(cdf);
  line_ = TwinTable(line);
}

PhaseView PhaseTable::view() const { return {cdf_.table(), line_.table(), guide_.data()}; }

double PhaseTable::mean_cosine() const {
  double mean_x = cdf_.table()[1] * PhaseView::x_core / 2;
  for (int i = 0; i < outer_cells; ++i) {
    const double x0 = edge(i), x1 = edge(i + 1);
    const auto [p0, slope] = view().line_of<double>(i + 1);
    const double p1 = p0 + slope * (x1 - x0);
    // Integral of x times a straight line.
    mean_x += 2 * pi * (x1 - x0) * (p0 * (2 * x0 + x1) + p1 * (x0 + 2 * x1)) / 6;
  }
  return 1 - mean_x;
}

double PhaseTable::backscatter_fraction() const {
  constexpr int at_90_degrees = PhaseView::cells - (1 << PhaseView::cell_bits);
  return 1 - cdf_.table()[at_90_degrees];
}

}  // namespace photic::optics
