#include "medium/upside_down.hpp"

#include <algorithm>
#include <iterator>

#include "core/stop.hpp"
#include "medium/film.hpp"
#include "medium/outside_column.hpp"

namespace photic::medium {
namespace {

/// The sea's surface from the other side: what rises there falls, seen from here, and whitecaps
/// reflect from below what they do from above.
void add_surface(const Medium& sea, Medium& medium) {
  Waves& waves = medium.waves = sea.waves;
  waves.upwind_x = -waves.upwind_x;
  waves.upwind_y = -waves.upwind_y;
  for (std::size_t l = 0; l < waves.whitecap_reflectance.size(); ++l) {
    const double n = sea.line[l].refractive_index;
    waves.whitecap_reflectance[l] = 1 - (1 - waves.whitecap_reflectance[l]) / (n * n);
  }
}

}  // namespace

Medium upside_down(const Air& air, const std::vector<OtherAir>& others, const Medium& sea,
                   double counts_to_m, double end_m, const std::stop_token& stop) {
  Medium medium;
  medium.kind = MediumKind::air;
  medium.line = sea.line;
  for (Line& line : medium.line) {
    line.refractive_index = 1 / line.refractive_index;
    line.group_index = 1;
  }
  medium.top = air.height_m;
  medium.air_m = air.height_m.back();
  medium.absorbers = air.absorbers;
  const bool vacuum = end_m > air.height_m.back();
  if (vacuum) medium.top.push_back(end_m);
  const std::size_t layers = air.layers();
  std::vector<std::vector<std::int32_t>> phases;
  for (std::size_t i = 0; i < air.phases.size(); ++i) {
    auto& of_layers = phases.emplace_back();
    for (std::size_t k = 0; k < layers; ++k) {
      break_off_if(stop);
      of_layers.push_back(medium.add_phase(air.phase(i, k)));
    }
    if (vacuum) of_layers.push_back(of_layers.back());
  }
  const auto add = [&](double a, double b, double delay) {
    const double c = std::max(a + b, min_attenuation);
    medium.c.push_back(c);
    medium.albedo.push_back(b / c);
    medium.absorption.push_back(1 - b / c);
    medium.conversion.push_back(0);
    medium.delay.push_back(delay);
  };
  for (std::size_t l = 0; l < medium.line.size(); ++l) {
    for (std::size_t i = l * layers; i < (l + 1) * layers; ++i)
      add(air.a[i], air.b[i], air.group_index[i] - 1);
    if (vacuum) add(0, 0, 0);
    std::ranges::copy(phases[air.phases_of[l]], std::back_inserter(medium.elastic_phase));
    medium.conversion_phase.push_back(0);
  }
  add_surface(sea, medium);
  add_film_from_air(sea, medium, stop);
  medium.scattering_to_instruments = integral_to(air.height_m, air.b, 0, counts_to_m);
  medium.depth_to_instruments =
      medium.scattering_to_instruments + integral_to(air.height_m, air.a, 0, counts_to_m);
  if (!others.empty()) add_other_airs(air, others, sea, medium, stop);
  medium.finish();
  return medium;
}

void count_against_vacuum(const Air& air, Medium& sea) {
  for (std::size_t l = 0; l < sea.line.size(); ++l) {
    const double n = air.refractive_index[l * air.layers()],
                 group = air.group_index[l * air.layers()];
    Line& line = sea.line[l];
    line.group_index = line.group_index * n + line.refractive_index * (group - n);
  }
  sea.finish();
}

}  // namespace photic::medium
