#include "estimator/averaged_phases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

#include "core/constants.hpp"
#include "core/stop.hpp"
#include "estimator/cone_mean.hpp"
#include "estimator/walk_cones.hpp"

namespace photic::estimator {
namespace {

using optics::PhaseView;

/// Phase functions of a medium, integrated from one of their poles on: for each line of their
/// tables a parabola of the distance from the line's pole.
class Cumulatives {
 public:
  Cumulatives(const PhaseView& phases, const std::set<std::int32_t>& tables, bool from_back)
      : from_back_(from_back), tables_(tables.size()), row_(PhaseView::lines * tables_) {
    std::size_t number = 0;
    for (const auto table : tables) integrate(phases, table, number++);
  }
  /// The means of all tables over a cone.
  void means_of(const std::vector<MeanTerm>& terms, std::vector<double>& means) const {
    means.assign(tables_, 0);
    for (const auto& [x, weight] : terms) {
      const double near = std::min(x, 2 - x);
      const bool ahead = from_back_ ? x > 1 : x < 1;
      const auto entry = static_cast<std::size_t>(PhaseView::entry<double>(near, ahead));
      const Parabola* row = &row_[entry * tables_];
      for (double& mean : means) mean += weight * (row++)->value(near);
    }
  }

 private:
  struct Parabola {
    double at_pole, linear, square;
    [[nodiscard]] double value(double near) const {
      return at_pole + near * (linear + near * square);
    }
  };
  void integrate(const PhaseView& phases, std::int32_t table, std::size_t number) {
    double sum = 0;
    for (int k = 0; k < PhaseView::cells; ++k) {
      const int cell = from_back_ ? PhaseView::cells - 1 - k : k;
      const bool forward = cell < PhaseView::forward_cells;
      const int entry = forward ? cell : PhaseView::forward_cells + PhaseView::cells - 1 - cell;
      const auto line = phases.line_of<double>(entry + table * PhaseView::lines);
      const double per_near = forward == from_back_ ? -2 * pi : 2 * pi;
      Parabola row{0, per_near * line[PhaseView::at_pole], per_near * line[PhaseView::slope] / 2};
      const auto near = [&](int edge) {
        return forward ? PhaseView::edge(edge) : 2 - PhaseView::edge(edge);
      };
      row.at_pole = sum - row.value(near(from_back_ ? cell + 1 : cell));
      sum = row.value(near(from_back_ ? cell : cell + 1));
      row_[static_cast<std::size_t>(entry) * tables_ + number] = row;
    }
    row_[PhaseView::cells * tables_ + number] =  // 90 degrees
        row_[(PhaseView::cells - 1) * tables_ + number];
  }

  bool from_back_;
  std::size_t tables_;
  std::vector<Parabola> row_;  ///< [line][table]
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

/// A part of the directions that free walks begin in: even in a cone.
struct Part {
  double one_minus_cos, share;
};
/// The shares of all narrower cones of an entry cone, which end where its rings do.
std::vector<Part> parts_of(const EntryCone<double>& cone) {
  const auto frees = [&](std::size_t k) {
    return k < cone.rings && cone.ring[k].one_minus_cos <= cone.free_within;
  };
  std::vector<Part> parts;
  for (std::size_t k = 0; frees(k); ++k) {
    const double x = cone.ring[k].one_minus_cos;
    const double beyond = frees(k + 1) ? 1 / cone.ring[k + 1].solid_angle : 0;
    parts.push_back({x, 2 * pi * x * (1 / cone.ring[k].solid_angle - beyond) / cone.free_share});
  }
  return parts;
}

/// Values at the pole and slopes, of all tables.
using Lines = std::vector<std::array<double, AveragedPhases::line_fields>>;

/// The straight lines of a cell. Each has the mean and the mean slope of what it
/// stands for: two points do; at the rim of a cone, where the mean over it bends within a cell,
/// more.
void lines_of_cell(int cell, const std::vector<Part>& parts, const Cumulatives& from_pole,
                   Lines& lines) {
  static const Rule few = gauss(2), many = gauss(16);
  const auto [from, to] = AveragedPhases::edges(cell);
  const double middle = (from + to) / 2, half = (to - from) / 2;
  std::vector<double> means;
  std::vector<MeanTerm> terms;
  lines.assign(lines.size(), {});
  for (const auto& [x, share] : parts) {
    const bool at_rim = cell < AveragedPhases::forward_cells && to > 0.9 * x && from < 1.1 * x;
    const Rule& rule = at_rim ? many : few;
    for (std::size_t k = 0; k < rule.at.size(); ++k) {
      mean_over_cone(middle + rule.at[k] * half, x, terms);
      from_pole.means_of(terms, means);
      const double weight = share * rule.weight[k], per_slope = 3 * rule.at[k] / half;
      for (std::size_t t = 0; t < lines.size(); ++t) {
        lines[t][0] += weight * means[t];
        lines[t][1] += per_slope * weight * means[t];
      }
    }
  }
  for (auto& [at_pole, slope] : lines) at_pole -= slope * middle;
}

}  // namespace

AveragedPhaseTables::AveragedPhaseTables(const medium::Medium& medium,
                                         const std::vector<EntryCone<double>>& cones,
                                         const std::stop_token& stop)
    : tables_(medium.phase_count()) {
  const std::set elastic(medium.elastic_phase.begin(), medium.elastic_phase.end());
  const auto phases = medium.view().phases;
  const Cumulatives forward(phases, elastic, false), backward(phases, elastic, true);
  constexpr int cells = AveragedPhases::cells, fields = AveragedPhases::line_fields;
  for (const auto& cone : cones) {
    std::vector<double> rows(static_cast<std::size_t>(tables_ * cells * fields));
    const auto parts = cone.by_depth ? parts_of(cone) : std::vector<Part>{};  // else none is free
    Lines lines(elastic.size());
    for (int cell = 0; cell < cells && !parts.empty(); ++cell) {
      break_off_if(stop);
      const bool ahead = cell < AveragedPhases::forward_cells;
      lines_of_cell(cell, parts, ahead ? forward : backward, lines);
      auto line = lines.begin();
      for (const auto table : elastic)
        std::ranges::copy(*line++, rows.begin() + std::ptrdiff_t{fields} * (table * cells + cell));
    }
    line_.append(rows);
  }
}

AveragedPhaseTables averaged_phases(const scene::Scene& scene, const medium::Medium& medium,
                                    const std::stop_token& stop) {
  if (scene.simulation.estimator != scene::Estimator::bidirectional) return {};
  const auto walks = walk_cones(scene, medium, 0);
  std::vector<EntryCone<double>> cones{walks.laser};
  cones.insert(cones.end(), walks.telescope.begin(), walks.telescope.end());
  if (std::ranges::none_of(cones, &EntryCone<double>::by_depth)) return {};
  return {medium, cones, stop};
}

AveragedPhases AveragedPhaseTables::view() const { return {line_.table(), tables_}; }

}  // namespace photic::estimator
