#include "optics/phase_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "core/error.hpp"

namespace photic::optics {
namespace {

/// Number of cells outside the core, and the lower edge of the one numbered i from 0.
constexpr int outer_cells = PhaseView::cells - 1;
double edge(int i) { return PhaseView::edge(i + 1); }

/// Integral over a cell of 2 pi p(x) for the straight line between its nodes.
double mass(const std::vector<double>& node, int i) {
  const auto k = static_cast<std::size_t>(i);
  return pi * (node[k] + node[k + 1]) * (edge(i + 1) - edge(i));
}

/// Far below any real value, but not 0: the inverse divides by the sum of the nodes of a cell.
constexpr double min_node = 1e-30;

/// A function of x at all edges of cells but the core's lower one. Towards 180 degrees most phase
/// functions are nearly straight: an octave of 2 - x whose line lies within 1e-7 of the function at
/// seven places between its ends has the line's values.
template <class P>
std::vector<double> at_edges(const P& p) {
  std::vector<double> out;
  for (int i = 0; i < PhaseView::forward_cells; ++i) out.push_back(p(edge(i)));
  constexpr int octave = 1 << PhaseView::cell_bits, step = octave / 8;
  for (int first = PhaseView::forward_cells - 1; first + octave < outer_cells; first += octave) {
    const double from = out.back(), to = p(edge(first + octave));
    const auto on_line = [&](int i) {
      return std::lerp(from, to, (edge(i) - edge(first)) / (edge(first + octave) - edge(first)));
    };
    bool straight = true;
    for (int i = first + step; i < first + octave && straight; i += step)
      straight = std::abs(p(edge(i)) - on_line(i)) <= 1e-7 * from;
    for (int i = first + 1; i < first + octave; ++i)
      out.push_back(straight ? on_line(i) : p(edge(i)));
    out.push_back(to);
  }
  out.push_back(p(2));
  return out;
}

std::vector<double> nodes_of(const PhaseShape& shape) {
  std::vector<double> node = at_edges(shape.p);
  for (double& p : node) {
    expect(std::isfinite(p) && p >= 0,
           "a phase function is finite and not negative outside its core");
    p = std::max(p, min_node);
  }
  return node;
}

double integral(const std::vector<double>& node, double core_mass) {
  double sum = core_mass;
  for (int i = 0; i < outer_cells; ++i) sum += mass(node, i);
  return sum;
}

/// The inverse of a table's cumulative, asked for one u after the other: each close to the last.
class Inverse {
 public:
  Inverse(const std::vector<double>& cdf, const std::vector<double>& line, double whole)
      : cdf_(cdf), line_(line), whole_(whole) {}

  struct Point {
    double x, per_u;  ///< and dx/du
  };
  /// The place below which the fraction u lies: the last such x if it is `from_below`, else the
  /// first.
  Point at(double u, bool from_below) {
    while (i_ + 1 < cdf_.size() && (from_below ? cdf_[i_ + 1] <= u : cdf_[i_ + 1] < u)) ++i_;
    while (i_ > 0 && (from_below ? cdf_[i_] > u : cdf_[i_] >= u)) --i_;
    // The cumulative of a straight line: 2 pi (p0 s + slope s^2 / 2) = u - cdf, solved for s.
    const double rest = (u - cdf_[i_]) / pi;
    const double p0 = line_[2 * i_], slope = line_[2 * i_ + 1];
    const double p = std::sqrt(std::max(p0 * p0 + rest * slope, 0.0));  // 0 by rounding
    const double from = i_ == 0 ? 0 : edge(static_cast<int>(i_) - 1);
    return {std::min(from + rest / (p0 + p), 2.0), 1 / (2 * pi * std::max(p, min_node))};
  }
  [[nodiscard]] double core() const { return cdf_[1]; }
  [[nodiscard]] double whole() const { return whole_; }

 private:
  const std::vector<double>&cdf_, &line_;
  double whole_;
  std::size_t i_ = 0;
};

/// The cubic of t that has given values and slopes at `from` and `to`, no slope so steep that it
/// would not be monotone (Fritsch & Carlson, SIAM J. Numer. Anal. 17, 238, 1980).
std::array<double, 4> cubic(double from, Inverse::Point a, double to, Inverse::Point b) {
  const double rise = b.x - a.x, per = 1 / (to - from);
  const auto slope = [&](double per_t) {
    return std::copysign(std::min(std::abs(per_t) * (to - from), 3 * std::abs(rise)), rise);
  };
  const double s0 = slope(a.per_u), s1 = slope(b.per_u);
  // Coefficients in (t - from) / (to - from), then in t.
  const double linear = s0 * per, square = (3 * rise - 2 * s0 - s1) * per * per,
               cube = (s0 + s1 - 2 * rise) * per * per * per;
  return {a.x - from * (linear - from * (square - from * cube)),
          linear - from * (2 * square - 3 * from * cube), square - 3 * from * cube, cube};
}

/// The rows of PhaseView::quantile. A cell that reaches into the core has the cubic of what is
/// outside.
std::vector<double> quantiles_of(Inverse inverse) {
  constexpr int first = -(PhaseView::quantile_octaves << PhaseView::quantile_bits);
  const auto edge_of = [](int i) {
    return i == 0 ? 0 : octave_edge<double>(first + i - 1, PhaseView::quantile_bits);
  };
  std::vector<double> rows;
  for (const bool lower : {true, false}) {
    // The core in u, or in 1 - u.
    const double core = lower ? inverse.core() : inverse.whole() - inverse.core();
    const auto point = [&](double u, double width) {
      auto p = u == core ? inverse.at(inverse.core(), true)
                         : inverse.at(lower ? u : inverse.whole() - u, lower);
      p.per_u *= lower ? width : -width;
      return p;
    };
    for (int i = 0; i < PhaseView::half_quantiles; ++i) {
      const double begin = edge_of(i), width = edge_of(i + 1) - begin;
      const bool reaches = core > begin && core < begin + width;
      const double from = lower && reaches ? core : begin;
      const double to = !lower && reaches ? core : begin + width;
      const auto row =
          cubic((from - begin) / width, point(from, width), (to - begin) / width, point(to, width));
      rows.insert(rows.end(), row.begin(), row.end());
    }
  }
  return rows;
}

/// The rows of PhaseView::line, of p at the lower edges of the cells by x and its slope in them.
std::vector<double> from_the_poles(const std::vector<double>& line) {
  std::vector<double> rows;
  const auto add = [&](int cell, double pole, double toward) {
    const auto k = 2 * static_cast<std::size_t>(cell);
    const double p = line[k], slope = line[k + 1];
    rows.insert(rows.end(), {p + slope * (pole - PhaseView::edge(cell)), toward * slope});
  };
  for (int i = 0; i < PhaseView::forward_cells; ++i) add(i, 0, 1);
  for (int i = PhaseView::cells - 1; i >= PhaseView::forward_cells; --i) add(i, 2, -1);
  add(PhaseView::forward_cells, 2, -1);
  return rows;
}

}  // namespace

PhaseShape tabulated(const PhaseShape& shape) {
  struct Known {
    PhaseShape shape;
    std::vector<double> x, p;
  };
  Known known{shape, {}, at_edges(shape.p)};
  for (int i = 0; i <= outer_cells; ++i) known.x.push_back(edge(i));
  PhaseShape out;
  out.core_mass = shape.core_mass;
  // p is that of the lines that at_edges() takes for straight.
  if (!shape.key.empty()) out.key = PhaseKey("tabulated").add(shape.key);
  out.p = [known = std::make_shared<const Known>(std::move(known))](double x) {
    const auto node = std::lower_bound(known->x.begin(), known->x.end(), x);
    return node != known->x.end() && *node == x
               ? known->p[static_cast<std::size_t>(node - known->x.begin())]
               : known->shape.p(x);
  };
  return out;
}

double table_integral(const PhaseShape& shape) {
  return integral(nodes_of(shape), shape.core_mass);
}

PhaseTable::PhaseTable(const PhaseShape& shape) {
  expect(shape.core_mass >= 0 && shape.core_mass <= 1,
         "the core of a phase function holds a share of it");
  const std::vector<double> node = nodes_of(shape);
  const double whole = integral(node, shape.core_mass);
  expect(std::abs(whole - 1) <= 1e-4, "a phase function integrates to 1");

  std::vector<double> line;
  double sum = 0;
  const auto add = [&](double mass, double p, double slope) {
    cdf_.push_back(sum);
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
  line_ = TwinTable(from_the_poles(line));
  constexpr double never = 1e30;
  core_per_u_ = TwinTable({{core_mass > 0 ? PhaseView::x_core / core_mass : never}});
  quantile_ = TwinTable(quantiles_of(Inverse(cdf_, line, sum)));
}

PhaseView PhaseTable::view() const {
  return {line_.table(), quantile_.table(), core_per_u_.view()};
}

double PhaseTable::mean_cosine() const {
  double mean_x = cdf_[1] * PhaseView::x_core / 2;
  for (int i = 0; i < outer_cells; ++i) {
    const double x0 = edge(i), x1 = edge(i + 1);
    const double p0 = view().value(x0), p1 = view().value(x1);
    // Integral of x times a straight line.
    mean_x += 2 * pi * (x1 - x0) * (p0 * (2 * x0 + x1) + p1 * (x0 + 2 * x1)) / 6;
  }
  return 1 - mean_x;
}

double PhaseTable::backscatter_fraction() const { return 1 - cdf_[PhaseView::forward_cells]; }

}  // namespace photic::optics
