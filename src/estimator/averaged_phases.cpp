#include "estimator/averaged_phases.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/constants.hpp"
#include "estimator/walk_cones.hpp"

namespace photic::estimator {
namespace {

using optics::PhaseView;

double angle_of(double x) { return 2 * std::asin(std::sqrt(x / 2)); }

/// Rings about a direction a off the axis of a cone of half angle d, of which a share lies in the
/// cone (theory.md, eq. 84).
struct Rings {
  double whole = 0;               ///< up to this 1 - cos rings lie in the cone as a whole
  std::vector<double> x, weight;  ///< of the others
};
/// Rings at angles whose logarithms are those of a Chebyshev rule, which is right for the square
/// roots at its ends.
Rings rings_at(double a, double d) {
  Rings out;
  if (a < d) out.whole = one_minus_cos_of(d - a);
  constexpr double nearest = 1e-8;  // far inside the core of any phase function
  const double first = std::log(std::max(std::abs(d - a), nearest)), last = std::log(d + a);
  const double centre = (first + last) / 2, half = (last - first) / 2;
  const int points = static_cast<int>(std::clamp(24 + 32 * half, 24.0, 256.0));
  const double per_solid_angle = half * pi / points / (2 * pi * one_minus_cos_of(d));
  for (int j = 0; j < points; ++j) {
    const double phi = (j + 0.5) * pi / points;
    const double t = std::exp(centre + half * std::cos(phi));
    const double inside =
        std::sin((d + a - t) / 2) * std::sin((d - a + t) / 2) / (std::sin(a) * std::sin(t));
    const double share = std::asin(std::sqrt(std::clamp(inside, 0.0, 1.0)));
    out.x.push_back(one_minus_cos_of(t));
    out.weight.push_back(4 * std::sin(t) * share * t * std::sin(phi) * per_solid_angle);
  }
  return out;
}

/// A table of a medium against the distance x from one of its poles, and its integral.
class Cumulative {
 public:
  Cumulative(const PhaseView& phases, std::int32_t table, bool from_back)
      : phases_(phases), table_(table), from_back_(from_back), edge_{0}, sum_{0} {
    const int cells =
        from_back ? PhaseView::cells - PhaseView::forward_cells : PhaseView::forward_cells;
    for (int i = 1; i <= cells; ++i) {
      const double to = from_back ? 2 - PhaseView::edge(PhaseView::cells - i) : PhaseView::edge(i);
      sum_.push_back(sum_.back() + part(edge_.back(), to));
      edge_.push_back(to);
    }
  }
  [[nodiscard]] double p(double x) const {
    return phases_.value<double>(from_back_ ? 2 - x : x, table_);
  }
  [[nodiscard]] double up_to(double x) const {
    const auto next = std::upper_bound(edge_.begin(), edge_.end() - 1, x);
    const auto i = static_cast<std::size_t>(next - edge_.begin()) - 1;
    return sum_[i] + part(edge_[i], x);
  }

 private:
  /// In a cell, where p is a straight line.
  [[nodiscard]] double part(double from, double to) const {
    return 2 * pi * (to - from) * p((from + to) / 2);
  }

  const PhaseView& phases_;
  std::int32_t table_;
  bool from_back_;
  std::vector<double> edge_, sum_;
};

/// Points of a Gauss-Legendre rule on -1 ... 1 and their weights, which sum up to 1.
struct Rule {
  std::vector<double> at, weight;
};
Rule gauss(int n) {
  Rule rule;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(pi * (i + 0.75) / (n + 0.5)), slope = 1;
    for (int step = 0; step < 8; ++step) {
      double p0 = 1, p1 = x;
      for (int k = 2; k <= n; ++k)
        p0 = std::exchange(p1, ((2 * k - 1) * x * p1 - (k - 1) * p0) / k);
      slope = n * (x * p1 - p0) / (x * x - 1);
      x -= p1 / slope;
    }
    rule.at.push_back(x);
    rule.weight.push_back(1 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

/// The rings of all cells, which are the same for all phase functions. The straight line of a cell
/// has the mean and the mean slope of what it stands for: two points do; at the rim of the cone,
/// where the mean over it bends within a cell, more.
class Cone {
 public:
  explicit Cone(double one_minus_cos) : solid_angle_(2 * pi * one_minus_cos) {
    const double d = angle_of(one_minus_cos);
    for (int i = 0; i < AveragedPhases::cells; ++i) {
      const auto [from, to] = AveragedPhases::edges(i);
      const bool at_rim = i < AveragedPhases::forward_cells && to > 0.9 * one_minus_cos &&
                          from < 1.1 * one_minus_cos;
      Cell& cell = cell_.emplace_back(Cell{(from + to) / 2, (to - from) / 2, &rule(at_rim), {}});
      for (const double at : cell.rule->at)
        cell.rings.push_back(rings_at(angle_of(cell.middle + at * cell.half), d));
    }
  }

  /// The lines of a table: AveragedPhases::line.
  [[nodiscard]] std::vector<double> lines(const PhaseView& phases, std::int32_t table) const {
    const Cumulative forward(phases, table, false), backward(phases, table, true);
    std::vector<double> out;
    for (std::size_t i = 0; i < cell_.size(); ++i) {
      const auto& of = i < AveragedPhases::forward_cells ? forward : backward;
      const Cell& cell = cell_[i];
      double mean = 0, slope = 0;
      for (std::size_t k = 0; k < cell.rings.size(); ++k) {
        const double weighted = cell.rule->weight[k] * value(of, cell.rings[k]);
        mean += weighted;
        slope += 3 * cell.rule->at[k] * weighted / cell.half;
      }
      out.insert(out.end(), {mean - slope * cell.middle, slope});
    }
    return out;
  }

 private:
  struct Cell {
    double middle, half;
    const Rule* rule;
    std::vector<Rings> rings;
  };
  static const Rule& rule(bool at_rim) {
    static const Rule few = gauss(2), many = gauss(16);
    return at_rim ? many : few;
  }
  [[nodiscard]] double value(const Cumulative& of, const Rings& rings) const {
    double sum = rings.whole > 0 ? of.up_to(rings.whole) / solid_angle_ : 0;
    for (std::size_t j = 0; j < rings.x.size(); ++j) sum += rings.weight[j] * of.p(rings.x[j]);
    return sum;
  }

  double solid_angle_;
  std::vector<Cell> cell_;
};

/// The mean over the part of an entry cone that free walks begin in: the shares of all its narrower
/// ones, which end where its rings do.
class MeanOverCone {
 public:
  explicit MeanOverCone(const EntryCone<double>& cone) {
    const auto frees = [&](std::size_t k) {
      return k < cone.rings && cone.ring[k].one_minus_cos <= cone.free_within;
    };
    for (std::size_t k = 0; frees(k); ++k) {
      const double x = cone.ring[k].one_minus_cos;
      const double beyond = frees(k + 1) ? 1 / cone.ring[k + 1].solid_angle : 0;
      part_.emplace_back(2 * pi * x * (1 / cone.ring[k].solid_angle - beyond) / cone.free_share,
                         Cone(x));
    }
  }
  [[nodiscard]] std::vector<double> lines(const PhaseView& phases, std::int32_t table) const {
    std::vector<double> sum(std::size_t{AveragedPhases::cells} * AveragedPhases::line_fields);
    for (const auto& [share, cone] : part_) {
      const auto line = cone.lines(phases, table);
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += share * line[i];
    }
    return sum;
  }

 private:
  std::vector<std::pair<double, Cone>> part_;
};

}  // namespace

AveragedPhaseTables::AveragedPhaseTables(const medium::Medium& medium,
                                         const std::vector<EntryCone<double>>& cones)
    : tables_(medium.phase_count()) {
  const auto phases = medium.view().phases;
  for (const auto& cone : cones) {
    if (!cone.by_depth) {  // no walk is free
      const std::vector<double> none(static_cast<std::size_t>(tables_) * AveragedPhases::cells *
                                     AveragedPhases::line_fields);
      line_.append(none);
      continue;
    }
    const MeanOverCone of(cone);
    for (std::int32_t table = 0; table < tables_; ++table) line_.append(of.lines(phases, table));
  }
}

AveragedPhaseTables averaged_phases(const scene::Scene& scene, const medium::Medium& medium) {
  if (scene.simulation.estimator != scene::Estimator::bidirectional) return {};
  const auto walks = walk_cones(scene, medium, 0);
  std::vector<EntryCone<double>> cones{walks.laser};
  cones.insert(cones.end(), walks.telescope.begin(), walks.telescope.end());
  if (std::ranges::none_of(cones, &EntryCone<double>::by_depth)) return {};
  return {medium, cones};
}

AveragedPhases AveragedPhaseTables::view() const { return {line_.table(), tables_}; }

}  // namespace photic::estimator
