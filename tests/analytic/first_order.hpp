// Whole runs at first order, held against the lidar equation.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "estimator/model.hpp"
#include "optics/phase_functions.hpp"
#include "run/run.hpp"
#include "support/lidar_equation.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"
#include "support/slant_path.hpp"
#include "support/tables.hpp"
#include "support/z_test.hpp"

namespace photic::test {

inline constexpr double level = 0.01;  // of the family of all gates of a scene
/// How precisely an estimator is held to the equation.
struct Precision {
  std::string simulation;
  double largest_error;       ///< relative standard error that every gate must reach
  double largest_difference;  ///< relative
  bool independent_gates;
};
/// One scattering each. The equation has the overlap's mean over the lens.
inline const Precision forward{
    simulation(1.25e7, 7, "max_order = 1\norders_kept = 1\nreception = \"overlap\""), 0.005, 0.005,
    true};
/// Where every photon's score is about the same.
inline const Precision forward_in_short{
    simulation(1e6, 7, "max_order = 1\norders_kept = 1\nreception = \"overlap\""), 0.005, 0.005,
    true};
/// Meetings of one pair of walks are seen in many gates. To points of the lens ways are longer, and
/// solid angles smaller, than to its centre: by some 1e-4, less than these errors.
inline const Precision bidirectional{
    simulation(4e5, 7, "max_order = 1\norders_kept = 1", "bidirectional"), 0.01, 0.02, false};

/// The water that light of a line sees on its way.
inline EquationWater water_of(const medium::Medium& medium, std::size_t line,
                              const std::function<double(double)>& phase) {
  const auto layers = static_cast<std::size_t>(medium.layers());
  EquationWater water;
  water.n_out = medium.line[0].refractive_index;
  water.group_out = medium.line[0].group_index;
  water.n_back = medium.line[line].refractive_index;
  water.group_back = medium.line[line].group_index;
  for (std::size_t k = 0; k < layers; ++k) {
    const double share = line == 0 ? medium.albedo[k] : medium.conversion[line * layers + k];
    water.layers.push_back(
        {medium.top[k], medium.c[k], medium.c[line * layers + k], share * medium.c[k]});
  }
  water.phase = phase;
  return water;
}

/// Where the gates of a telescope and channel begin and end, as group path: that to the depths that
/// the result has them, where there are any and the light is of one line.
inline std::vector<double> edge_paths(const estimator::Model& model, std::size_t telescope,
                                      std::size_t channel) {
  const tally::Result described = estimator::describe(model);
  const auto& lines = model.medium.line;
  const auto counted = [&](const medium::Line& line) { return line.counted_by[channel] > 0; };
  const bool one_line = std::ranges::count_if(lines, counted) == 1;
  const auto back = std::ranges::find_if(lines, counted);
  std::vector<double> edges;
  for (std::int32_t e = 0; e <= model.gates.count(); ++e) {
    const std::size_t row = telescope * described.channels() + channel;
    const double depth =
        described.gate_depth_edge_m[row * (described.gates() + 1) + static_cast<std::size_t>(e)];
    edges.push_back(described.gate_depth_is_range || !one_line
                        ? model.gates.edge_path(e)
                        : slant_path(model.scene.source, model.scene.telescope[telescope],
                                     lines.front(), *back, depth));
  }
  return edges;
}

/// What a scene's first order should be in one channel and telescope: the light of all its lines.
inline std::vector<double> expected(const estimator::Model& model, std::size_t telescope,
                                    std::size_t channel,
                                    const std::function<double(double)>& phase) {
  const std::vector<double> edges = edge_paths(model, telescope, channel);
  std::vector<double> sum(edges.size() - 1, 0.0);
  for (std::size_t line = 0; line < model.medium.line.size(); ++line) {
    const double counted = model.medium.line[line].counted_by[channel];
    if (counted == 0) continue;
    const auto echo = first_order_echo(model.scene.source, model.scene.telescope[telescope],
                                       water_of(model.medium, line, phase), edges);
    for (std::size_t g = 0; g < sum.size(); ++g) sum[g] += counted * echo[g];
  }
  return sum;
}

/// Runs a problem at first order and holds every gate of every telescope and channel against the
/// equation, [telescope * channels + channel][gate].
inline void compare(const tally::Result& result, const Precision& precision,
                    const std::vector<std::vector<double>>& equations) {
  ZFamily family(level);
  double largest = 0;
  for (std::size_t t = 0; t < result.telescopes(); ++t) {
    for (std::size_t c = 0; c < result.channels(); ++c) {
      const auto& equation = equations[t * result.channels() + c];
      // Gates are independent of each other; channels and telescopes see the same collisions.
      ZFamily gates(level / static_cast<double>(result.telescopes() * result.channels()));
      for (std::size_t g = 0; g < result.gates(); ++g) {
        const std::size_t i = (t * result.channels() + c) * result.gates() + g;
        const double mean = result.echo.mean[i];
        const double error = result.echo.standard_error[i];
        const auto where = fmt::format("telescope {} channel {} gate {}: {} +- {}, equation {}", t,
                                       c, g, mean, error, equation[g]);
        if (equation[g] == 0) {  // before the first light
          EXPECT_EQ(mean, 0) << where;
          continue;
        }
        EXPECT_LT(error, precision.largest_error * equation[g]) << where;
        EXPECT_LT(std::abs(mean - equation[g]), precision.largest_difference * equation[g])
            << where;
        largest = std::max(largest, std::abs(mean / equation[g] - 1));
        family.add(mean, equation[g], error, where);
        gates.add(mean, equation[g], error, where);
      }
      if (precision.independent_gates) gates.judge_spread();
    }
  }
  std::printf("largest difference %.2f %% in %zu gates\n", 100 * largest, family.size());
  family.judge();
}

inline std::function<double(double)> shape(const optics::PhaseShape& s) {
  return [s](double cosine) { return s.p(std::max(1 - cosine, 1e-7)); };
}

/// By both estimators.
inline void compare(const std::string& toml,
                    const std::vector<std::function<double(double)>>& phase_of_channel,
                    const std::vector<Precision>& precisions = {forward, bidirectional}) {
  std::vector<std::vector<double>> equations;
  for (const Precision& precision : precisions) {
    SCOPED_TRACE(precision.simulation);
    const auto scene = read(toml + precision.simulation);
    if (equations.empty()) {
      const auto model = estimator::make_model(scene, *test::tables());
      for (std::size_t t = 0; t < scene.telescope.size(); ++t) {
        for (std::size_t c = 0; c < phase_of_channel.size(); ++c)
          equations.push_back(expected(model, t, c, phase_of_channel[c]));
      }
    }
    compare(run_in_lanes(scene), precision, equations);
  }
}

}  // namespace photic::test
