#include "medium/medium.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"

namespace photic::medium {
namespace {

using optics::PhaseView;
/// Free paths are drawn from scattering alone, absorption being continuous along them: deep light
/// is then reached by more photons, of less weight. Where water hardly scatters, from this share of
/// c.
constexpr double least_walk_share = 0.2;

constexpr std::size_t table_size = std::size_t{PhaseView::cells} * PhaseView::fields;

}  // namespace

const char* process_name(Process process) {
  constexpr std::array names{"elastic", "raman", "chlorophyll"};
  return names.at(static_cast<std::size_t>(process));
}

std::int32_t Medium::add_phase(const optics::PhaseTable& table) {
  const PhaseView v = table.view();
  const std::int32_t count = static_cast<std::int32_t>(phase_cells_.size() / table_size);
  for (std::int32_t i = 0; i < count; ++i) {
    const auto* there = phase_cells_.data() + static_cast<std::size_t>(i) * table_size;
    if (std::equal(v.cell, v.cell + table_size, there)) return i;
  }
  phase_cells_.insert(phase_cells_.end(), v.cell, v.cell + table_size);
  phase_guides_.insert(phase_guides_.end(), v.guide, v.guide + PhaseView::guides);
  return count;
}

std::vector<double> Medium::depth_integrals(const std::vector<double>& coefficient) const {
  const auto n_layers = static_cast<std::size_t>(layers());
  std::vector<double> out;
  for (std::size_t l = 0; l < line.size(); ++l) {
    double sum = 0;
    out.push_back(sum);
    for (std::size_t k = 0; k < n_layers; ++k) {
      const double per_metre = coefficient[l * n_layers + k];
      if (per_metre > 0) sum += per_metre * (top[k + 1] - top[k]);  // the last layer has no end
      out.push_back(sum);
    }
  }
  return out;
}

void Medium::finish(std::optional<double> walk_share) {
  const auto n_layers = static_cast<std::size_t>(layers());
  const std::size_t n_lines = line.size();
  const std::size_t cells = n_layers * n_lines;
  expect(n_layers >= 1 && n_lines >= 1 && top.front() == 0.0,
         "a medium has layers from the surface and lines");
  expect(c.size() == cells && albedo.size() == cells && conversion.size() == cells &&
             absorption.size() == cells && elastic_phase.size() == cells &&
             conversion_phase.size() == n_lines,
         "every table of the medium is complete");
  for (const Line& l : line) {
    index_.push_back(l.refractive_index);
    inverse_index_.push_back(1 / l.refractive_index);
    group_index_.push_back(l.group_index);
  }
  for (std::size_t i = 0; i < cells; ++i) {
    const double share = walk_share.value_or(std::max(albedo[i], least_walk_share));
    walk_c_.push_back(c[i] * share);
    continuous_c_.push_back(c[i] * (1 - share));
    collision_gain_.push_back(1 / share);
  }
  depth_tau_ = depth_integrals(c);
  walk_depth_tau_ = depth_integrals(walk_c_);
  continuous_depth_tau_ = depth_integrals(continuous_c_);
  convertible_.assign(cells, 0);
  for (std::size_t k = 0; k < n_layers; ++k) {
    std::int32_t count = 0;
    for (std::size_t l = 1; l < n_lines; ++l) {
      if (conversion[l * n_layers + k] > 0) {
        convertible_[k * n_lines + static_cast<std::size_t>(count++)] =
            static_cast<std::int32_t>(l);
      }
    }
    convertible_count_.push_back(count);
  }
}

MediumView Medium::view() const {
  MediumView v;
  v.layers = layers();
  v.lines = static_cast<std::int32_t>(line.size());
  v.top = top.data();
  v.c = c.data();
  v.albedo = albedo.data();
  v.depth_tau = depth_tau_.data();
  v.walk_c = walk_c_.data();
  v.walk_depth_tau = walk_depth_tau_.data();
  v.continuous_c = continuous_c_.data();
  v.continuous_depth_tau = continuous_depth_tau_.data();
  v.collision_gain = collision_gain_.data();
  v.conversion = conversion.data();
  v.absorption = absorption.data();
  v.convertible = convertible_.data();
  v.convertible_count = convertible_count_.data();
  v.index = index_.data();
  v.inverse_index = inverse_index_.data();
  v.group_index = group_index_.data();
  v.elastic_phase = elastic_phase.data();
  v.conversion_phase = conversion_phase.data();
  v.phases.cell = phase_cells_.data();
  v.phases.guide = phase_guides_.data();
  return v;
}

std::int32_t Medium::layer_at(double depth_m) const {
  const auto below = std::upper_bound(top.begin(), top.end() - 1, depth_m);
  return std::max<std::int32_t>(0, static_cast<std::int32_t>(below - top.begin()) - 1);
}

}  // namespace photic::medium
