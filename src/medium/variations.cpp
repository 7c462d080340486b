#include "medium/variations.hpp"

#include <algorithm>
#include <set>

namespace photic::medium {
namespace {

/// The amount of scattering that has a phase function.
double scattered_by(const Coefficients& of, std::int32_t phase) {
  double sum = 0;
  for (const auto& part : of.part) sum += part.phase == phase ? part.b_per_m : 0.0;
  return sum;
}

/// The phase functions that some variation has more or less of.
std::vector<std::int32_t> varied_phases(const std::vector<Variation>& variations,
                                        std::size_t cell) {
  std::vector<std::int32_t> out;
  std::set<std::int32_t> seen;
  const auto look_at = [&](const Coefficients& one) {
    for (const auto& part : one.part) {
      const auto differs = [&](const Variation& v) {
        return scattered_by(v.from[cell], part.phase) != scattered_by(v.to[cell], part.phase);
      };
      if (seen.insert(part.phase).second && std::ranges::any_of(variations, differs))
        out.push_back(part.phase);
    }
  };
  for (const Variation& v : variations) {
    look_at(v.from[cell]);
    look_at(v.to[cell]);
  }
  return out;
}

/// Adds a variation's numbers of a cell, where there is `here` in the medium.
void add_numbers(const Variation& v, const Coefficients& here, std::size_t cell,
                 const std::vector<std::int32_t>& phases, EnvironmentTables& out) {
  const Coefficients& from = v.from[cell];
  const Coefficients& to = v.to[cell];
  out.excess_c.push_back(v.scale * (to.c_per_m - from.c_per_m));
  out.excess_emitted.push_back(here.emitted_per_m > 0
                                   ? v.scale * (to.emitted_per_m - from.emitted_per_m) /
                                         here.emitted_per_m
                                   : 0.0);
  for (std::size_t p = 0; p < static_cast<std::size_t>(out.parts); ++p) {
    const bool counts = p < phases.size() && here.b_per_m > 0;
    out.excess_part.push_back(
        counts
            ? v.scale * (scattered_by(to, phases[p]) - scattered_by(from, phases[p])) / here.b_per_m
            : 0.0);
  }
}

}  // namespace

void add_variations(const LayerCoefficients& here, const std::vector<Variation>& variations,
                    std::size_t first_tangent, EnvironmentTables& out) {
  const std::size_t cells = here.size();
  std::vector<std::vector<std::int32_t>> varied;
  for (std::size_t i = 0; i < cells; ++i) varied.push_back(varied_phases(variations, i));
  out.count = static_cast<std::int32_t>(variations.size());
  out.first_tangent = static_cast<std::int32_t>(first_tangent);
  for (const auto& phases : varied)
    out.parts = std::max(out.parts, static_cast<std::int32_t>(phases.size()));
  for (const auto& phases : varied) {
    for (std::size_t p = 0; p < static_cast<std::size_t>(out.parts); ++p)
      out.part_phase.push_back(p < phases.size() ? phases[p] : 0);
  }
  for (const Variation& v : variations)
    for (std::size_t i = 0; i < cells; ++i) add_numbers(v, here[i], i, varied[i], out);
}

}  // namespace photic::medium
