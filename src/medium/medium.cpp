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

constexpr std::size_t nodes = PhaseView::cells + 1;

}  // namespace

const char* process_name(Process process) {
  constexpr std::array names{"elastic", "raman", "chlorophyll"};
  return names.at(static_cast<std::size_t>(process));
}

std::int32_t Medium::add_phase(const optics::PhaseTable& table) {
  const PhaseView v = table.view();
  const auto count = static_cast<std::int32_t>(core_value_.size());
  for (std::int32_t i = 0; i < count; ++i) {
    const auto* there = node_.data() + static_cast<std::size_t>(i) * nodes;
    if (core_value_[static_cast<std::size_t>(i)] == *v.core_value &&
        std::equal(v.node, v.node + nodes, there)) {
      return i;
    }
  }
  node_.insert(node_.end(), v.node, v.node + nodes);
  slope_.insert(slope_.end(), v.slope, v.slope + nodes);
  cdf_.insert(cdf_.end(), v.cdf, v.cdf + nodes);
  guide_.insert(guide_.end(), v.guide, v.guide + PhaseView::guides);
  core_value_.push_back(*v.core_value);
  return count;
}

std::vector<double> Medium::depth_integrals(const std::vector<double>& coefficient) const {
  const auto n_layers = static_cast<std::size_t>(layers());
  std::vector<double> out;
  for (std::size_t l = 0; l < line.size(); ++l) {
    double sum = 0;
    out.push_back(sum);
    for (std::size_t k = 0; k < n_layers; ++k) {
      sum += coefficient[l * n_layers + k] * (top[k + 1] - top[k]);
      out.push_back(sum);
    }
  }
  return out;
}

void Medium::finish() {
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
  for (std::size_t i = 0; i < cells; ++i)
    walk_c_.push_back(c[i] * std::max(albedo[i], least_walk_share));
  depth_tau_ = depth_integrals(c);
  walk_depth_tau_ = depth_integrals(walk_c_);
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
  v.conversion = conversion.data();
  v.absorption = absorption.data();
  v.convertible = convertible_.data();
  v.convertible_count = convertible_count_.data();
  v.index = index_.data();
  v.inverse_index = inverse_index_.data();
  v.group_index = group_index_.data();
  v.elastic_phase = elastic_phase.data();
  v.conversion_phase = conversion_phase.data();
  v.phases.node = node_.data();
  v.phases.slope = slope_.data();
  v.phases.cdf = cdf_.data();
  v.phases.guide = guide_.data();
  v.phases.core_value = core_value_.data();
  return v;
}

std::int32_t Medium::layer_at(double depth_m) const {
  const auto below = std::upper_bound(top.begin(), top.end() - 1, depth_m);
  return std::max<std::int32_t>(0, static_cast<std::int32_t>(below - top.begin()) - 1);
}

}  // namespace photic::medium
