#include "medium/other_airs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/stop.hpp"
#include "medium/outside_column.hpp"
#include "medium/variations.hpp"

namespace photic::medium {
namespace {

/// No history is scattered where the scene's air does not scatter.
void check_scattering(const scene::Scene& scene, const Air& here, const OtherAir& other) {
  for (std::size_t i = 0; i < here.b.size(); ++i) {
    if (here.b[i] > 0 || other.to.b[i] == 0) continue;
    const auto& layers = scene.atmosphere->layer;
    throw InputError(
        {{"", 0, 0,
          fmt::format("{}: the layer of air \"{}\" scatters light, but not in the scene itself",
                      other.name, layers.empty() ? "" : layers[i % here.layers()].name),
          "no history of the scene goes that way: give the scene a little of it, too"}});
  }
}

/// The coefficients of the air as a medium, whose phase functions go into it.
LayerCoefficients coefficients_of(const Air& air, Medium& medium, const std::stop_token& stop) {
  LayerCoefficients out;
  const std::size_t layers = air.layers();
  const bool vacuum = static_cast<std::size_t>(medium.layers()) > layers;
  for (std::size_t l = 0; l < medium.line.size(); ++l) {
    const AirPhases& phases = air.phases[air.phases_of[l]];
    for (std::size_t k = 0; k < layers; ++k) {
      const std::size_t at = l * layers + k;
      out.push_back({air.a[at] + air.b[at], air.b[at], 0, {}});
      if (air.b[at] == 0) continue;
      // The line is scattered in the shares of those that it shares phase functions with.
      for (const optics::AirScatterer& by : phases.scatterers[k]) {
        const double b = phases.b[k] > 0 ? air.b[at] / phases.b[k] * by.b_per_m : air.b[at];
        break_off_if(stop);
        out.back().part.push_back({b, medium.add_phase((*air.tables)(by.phase))});
      }
    }
    if (vacuum) out.emplace_back();
  }
  return out;
}

}  // namespace

std::vector<OtherAir> other_airs(const scene::Scene& scene, const optics::Library& library,
                                 const std::vector<Line>& lines, const std::stop_token& stop) {
  const AirBuilder build(scene, library, lines, stop);
  const Air here = build(scene);
  const auto in = [&](const scene::Environment& environment) {
    return environment.atmosphere == scene.atmosphere ? here
                                                      : build(scene::scene_in(scene, environment));
  };
  std::vector<OtherAir> out;
  for (const auto& e : scene.environment)
    out.push_back({fmt::format("environment \"{}\"", e.name), here, in(e)});
  for (const auto& s : scene.sensitivity)
    out.push_back({fmt::format("sensitivity \"{}\"", s.path), in(s.below), in(s.above),
                   s.value / (2 * s.step)});
  for (const OtherAir& other : out) {
    expect(other.from.height_m == here.height_m && other.to.height_m == here.height_m,
           "the airs of a scene have the same layers");
    check_scattering(scene, here, other);
  }
  return out;
}

std::vector<double> excess_depths(const std::vector<OtherAir>& airs,
                                  const std::vector<double>& height_m) {
  std::vector<double> out;
  for (const OtherAir& other : airs)
    for (const double height : height_m) {
      const double up = std::max(0.0, height);
      const auto from = column_to(other.from, up).optical_depth;
      const auto to = column_to(other.to, up).optical_depth;
      for (std::size_t l = 0; l < to.size(); ++l) out.push_back(other.scale * (to[l] - from[l]));
    }
  return out;
}

void add_other_airs(const Air& air, const std::vector<OtherAir>& airs, const Medium& sea,
                    Medium& medium, const std::stop_token& stop) {
  std::vector<Variation> variations;
  for (const OtherAir& other : airs)
    variations.push_back({other.name, coefficients_of(other.from, medium, stop),
                          coefficients_of(other.to, medium, stop), other.scale});
  EnvironmentTables& out = medium.environments;
  add_variations(coefficients_of(air, medium, stop), variations,
                 static_cast<std::size_t>(sea.environments.first_tangent), out);
  out.surface = sea.environments.surface;
}

}  // namespace photic::medium
