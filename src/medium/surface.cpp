#include "medium/surface.hpp"

#include <cmath>

#include "core/constants.hpp"
#include "optics/whitecaps.hpp"

namespace photic::medium {

optics::SlopeLaw slopes_of(const scene::Surface& surface) {
  using enum scene::SurfaceModel;
  if (!surface.is_rough()) return {};
  switch (surface.model) {
    case cox_munk:
      return optics::cox_munk_slopes(surface.wind_speed_m_s, surface.slick, surface.gram_charlier);
    case gaussian:
      return optics::gaussian_slopes(surface.upwind_slope_variance,
                                     surface.crosswind_slope_variance);
    case paper:
      return optics::paper_slopes(surface.wind_speed_m_s);
    case flat:
      break;
  }
  return {};
}

optics::Sourced whitecap_fraction_of(const scene::Surface& surface) {
  if (!surface.has_whitecaps()) return {0, ""};
  if (surface.whitecap_fraction) return {*surface.whitecap_fraction, "the scene"};
  return surface.whitecap_law == scene::WhitecapLaw::monahan1980
             ? optics::whitecap_fraction_monahan(surface.wind_speed_m_s)
             : optics::whitecap_fraction_stramska(surface.wind_speed_m_s);
}

optics::Sourced whitecap_reflectance_of(const scene::Surface& surface,
                                        const optics::Library& library, double wavelength_nm) {
  return surface.whitecap_reflectance == scene::WhitecapReflectance::koepke1984
             ? optics::whitecap_reflectance_koepke(library, wavelength_nm)
             : optics::whitecap_reflectance_frouin(library, wavelength_nm);
}

void add_surface(const scene::Scene& scene, const optics::Library& library, Medium& medium) {
  const scene::Surface& surface = scene.sea.surface;
  if (!surface.is_rough()) return;
  Waves& waves = medium.waves;
  waves.slopes = slopes_of(surface);
  const double azimuth = surface.wind_direction_deg * radian_per_degree;
  waves.upwind_x = std::cos(azimuth);
  waves.upwind_y = std::sin(azimuth);
  constexpr double all_nm = 0;  // of what is the same at all wavelengths none is told
  add_source("slopes of the sea surface", waves.slopes.source, all_nm, medium.sources);
  const auto [fraction, law] = whitecap_fraction_of(surface);
  if (fraction == 0) return;
  waves.whitecap_fraction = fraction;
  add_source("fraction of whitecaps", law, all_nm, medium.sources);
  for (const Line& line : medium.line) {
    const auto [value, source] = whitecap_reflectance_of(surface, library, line.wavelength_nm);
    waves.whitecap_reflectance.push_back(value);
    add_source("reflectance of whitecaps", source, line.wavelength_nm, medium.sources);
  }
}

}  // namespace photic::medium
