#include "medium/bed.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/constants.hpp"
#include "scene/bed_albedo.hpp"

namespace photic::medium {
namespace {

using Beds = std::vector<scene::PlacedBed>;

/// [line][column][angle], at even steps of sqrt(1 - cos); one angle stands for all.
std::vector<double> albedos(const Beds& beds, const std::vector<Line>& lines, std::int32_t angles) {
  std::vector<double> out;
  for (const Line& line : lines)
    for (const auto& [bed, path] : beds)
      for (std::int32_t k = 0; k < angles; ++k) {
        const double s = angles > 1 ? k / static_cast<double>(angles - 1) : 0.0;
        const double zenith_deg =
            std::min(90.0, std::acos(std::max(0.0, 1 - s * s)) / radian_per_degree);
        out.push_back(bed ? albedo_of(*bed, line.wavelength_nm, zenith_deg) : 0.0);
      }
  return out;
}

}  // namespace

void add_bed(const scene::Scene& scene, Medium& medium) {
  using scene::beds_of;
  const Beds own = beds_of(scene.sea, scene.bottom);
  /// Beds as an environment has them, or two about a parameter's value, and what that counts.
  struct Variation {
    Beds from, to;
    double scale = 1;
  };
  std::vector<Variation> variations;
  for (const auto& e : scene.environment) variations.push_back({own, beds_of(e.sea, e.bottom)});
  for (const auto& s : scene.sensitivity)
    variations.push_back({beds_of(s.below.sea, s.below.bottom),
                          beds_of(s.above.sea, s.above.bottom), s.value / (2 * s.step)});
  const auto of_angle = [](const Beds& beds) {
    return std::ranges::any_of(
        beds, [](const auto& at) { return at.bottom && depends_on_angle(*at.bottom); });
  };
  const bool by_angle = of_angle(own) || std::ranges::any_of(variations, [&](const auto& v) {
                          return of_angle(v.from) || of_angle(v.to);
                        });
  const std::int32_t angles = by_angle ? bed_angle_steps + 1 : 1;
  auto albedo = albedos(own, medium.line, angles);
  if (std::ranges::all_of(albedo, [](double one) { return one == 0; })) return;
  medium.bed_albedo = std::move(albedo);
  for (const Variation& v : variations) {
    const auto from = albedos(v.from, medium.line, angles);
    const auto to = albedos(v.to, medium.line, angles);
    for (std::size_t i = 0; i < to.size(); ++i)
      medium.environments.excess_bed.push_back(v.scale * (to[i] - from[i]));
  }
}

}  // namespace photic::medium
