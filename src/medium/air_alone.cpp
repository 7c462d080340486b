#include "medium/air_alone.hpp"

#include <algorithm>
#include <vector>

#include "core/stop.hpp"
#include "medium/air.hpp"
#include "medium/bed.hpp"
#include "medium/lines.hpp"
#include "medium/upside_down.hpp"
#include "optics/fresnel.hpp"

namespace photic::medium {
namespace {

Shells shells_of(const scene::Scene& scene, const Air& air) {
  const scene::Atmosphere& asked = *scene.atmosphere;
  Shells shells(asked.planet_radius_m(), air.height_m,
                asked.refraction ? air.refractive_index : std::vector<double>{});
  shells.source_outside =
      scene.source.is_everywhere || scene.height_of(scene.source.position_m) >= air.height_m.back();
  shells.mirrors = asked.surface->kind == scene::GroundKind::sea;
  return shells;
}

/// A level sea reflects by the angle as a bed does whose albedo is Fresnel's reflectance.
void add_ground(const scene::Scene& scene, Medium& medium) {
  const scene::Ground& ground = *scene.atmosphere->surface;
  if (ground.kind == scene::GroundKind::lambert) {
    scene::Scene over_ground = scene;
    over_ground.bottom = scene::Bottom{ground.albedo};
    return add_bed(over_ground, medium);
  }
  const double index = refractive_index(scene.sea, scene.source.wavelength_nm);
  for (std::int32_t k = 0; k <= bed_angle_steps; ++k) {
    const double s = k / static_cast<double>(bed_angle_steps);
    medium.bed_albedo.push_back(optics::refract(1.0, index, 1 - s * s).reflectance);
  }
}

}  // namespace

Medium build_air_alone(const scene::Scene& scene, const optics::Library& library,
                       const std::stop_token& stop) {
  Medium medium;
  medium.line.push_back(
      {.process = Process::elastic, .wavelength_nm = scene.source.wavelength_nm, .counted_by = {}});
  const Air air = build_air(scene, library, medium.line, stop).value();
  medium.sources = air.sources;
  for (auto height = air.height_m.rbegin(); height != air.height_m.rend(); ++height)
    medium.top.push_back(air.height_m.back() - *height);
  const Absorbers& absorbers = air.absorbers;
  medium.absorbers = {{absorbers.layer.rbegin(), absorbers.layer.rend()},
                      absorbers.constituent,
                      {absorbers.share.rbegin(), absorbers.share.rend()}};
  for (std::size_t k = air.layers(); k-- > 0;) {
    break_off_if(stop);
    const double c = std::max(air.a[k] + air.b[k], min_attenuation);
    medium.c.push_back(c);
    medium.albedo.push_back(air.b[k] / c);
    medium.absorption.push_back(1 - air.b[k] / c);
    medium.conversion.push_back(0);
    medium.elastic_phase.push_back(medium.add_phase(air.phase(air.phases_of.front(), k)));
  }
  medium.conversion_phase.push_back(0);
  add_ground(scene, medium);
  if (scene.atmosphere->is_spherical()) medium.shells = shells_of(scene, air);
  medium.finish();
  return medium;
}

}  // namespace photic::medium
