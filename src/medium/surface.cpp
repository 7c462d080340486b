#include "medium/surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "core/error.hpp"
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
  waves.conserving = scene.facet_weight() == scene::FacetWeight::conserving;
  const double azimuth = surface.wind_direction_deg * radian_per_degree;
  waves.upwind_x = std::cos(azimuth);
  waves.upwind_y = std::sin(azimuth);
  constexpr double all_nm = 0;  // in place of a wavelength where all have the same value
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

namespace {

/// Appends the rows of one surface (SurfaceRow), as they are over the medium's.
void add_rows(const scene::Surface& surface, const Waves& medium, std::vector<double>& out) {
  const optics::SlopeLaw law = slopes_of(surface), &here = medium.slopes;
  const double fraction = whitecap_fraction_of(surface).value;
  const auto per_deviation = [](double variance) {
    return variance > 0 ? 1 / std::sqrt(variance) : 0.0;
  };
  /// The deviation there over that here, or 1 where all facets are level.
  const auto ratio = [](double there, double variance_here) {
    return variance_here > 0 ? std::sqrt(there / variance_here) : 1.0;
  };
  const double widths = ratio(law.upwind_variance, here.upwind_variance) *
                        ratio(law.crosswind_variance, here.crosswind_variance);
  out.insert(out.end(),
             {per_deviation(law.upwind_variance), per_deviation(law.crosswind_variance),
              law.series.c21, law.series.c03, here.norm / law.norm / widths,
              medium.whitecap_fraction < 1 ? (1 - fraction) / (1 - medium.whitecap_fraction) : 0.0,
              medium.whitecap_fraction > 0 ? fraction / medium.whitecap_fraction : 0.0});
}

void refuse(const std::string& who, const std::string& reason, const std::string& suggestion) {
  throw InputError({{"", 0, 0, fmt::format("{}: {}", who, reason), suggestion}});
}

/// Slopes so much wider than the scene's are still met: those of a derivative's step.
constexpr double wider = 1.005;
/// Facets that Cox & Munk's series denies are so few that nothing is missed.
constexpr double denied = 1e-5;

/// Checks that a scene's histories go where those of another surface would.
void check_other(const std::string& who, const scene::Surface& here, const scene::Surface& there) {
  if (there == here) return;
  const optics::SlopeLaw own = slopes_of(here), other = slopes_of(there);
  if (!there.is_rough())
    refuse(who, "a flat surface sends light only one way, which no history over waves takes",
           "simulate the flat sea in a scene of its own, or write a weak wind");
  if ((other.upwind_variance == 0) != (own.upwind_variance == 0) ||
      (other.crosswind_variance == 0) != (own.crosswind_variance == 0))
    refuse(who,
           "along or across the wind its facets or the scene's, but not both, are all level: the "
           "densities of such slopes have no ratio",
           "let a variance be 0 in both or in neither");
  if (other.upwind_variance > wider * own.upwind_variance ||
      other.crosswind_variance > wider * own.crosswind_variance)
    refuse(who, "its waves are steeper than the scene's, whose histories hardly meet such facets",
           "give the scene the strongest wind, and environments the weaker ones");
  const bool same_slopes = other.upwind_variance == own.upwind_variance &&
                           other.crosswind_variance == own.crosswind_variance;
  if (!same_slopes && own.norm > 1 + denied)
    refuse(who,
           "in the scene's wind Cox & Munk's series lacks slopes that waves of another wind have",
           "write gram_charlier = false in the scene's 'sea.surface'");
  const double white = whitecap_fraction_of(here).value;
  const double other_white = whitecap_fraction_of(there).value;
  if ((white == 0 && other_white > 0) || (white == 1 && other_white < 1))
    refuse(who,
           white == 0 ? "there are whitecaps, but none in the scene itself"
                      : "whitecaps leave some of the surface free, but none in the scene",
           "no history of the scene goes that way: give the scene a little of it, too");
}

}  // namespace

void add_surfaces_of_environments(const scene::Scene& scene, Medium& medium) {
  const scene::Surface& here = scene.sea.surface;
  const bool same = std::ranges::all_of(scene.environment,
                                        [&](const auto& e) { return e.sea.surface == here; }) &&
                    std::ranges::all_of(scene.sensitivity,
                                        [&](const auto& s) { return s.above.sea.surface == here; });
  if (!here.is_rough() || same) return;
  for (const auto& e : scene.environment)
    check_other(fmt::format("environment \"{}\"", e.name), here, e.sea.surface);
  for (const auto& s : scene.sensitivity)
    check_other(fmt::format("sensitivity \"{}\"", s.path), here, s.above.sea.surface);
  auto& rows = medium.environments.surface;
  for (const auto& e : scene.environment) {
    add_rows(here, medium.waves, rows);
    add_rows(e.sea.surface, medium.waves, rows);
    rows.push_back(1);
  }
  for (const auto& s : scene.sensitivity) {
    add_rows(s.below.sea.surface, medium.waves, rows);
    add_rows(s.above.sea.surface, medium.waves, rows);
    rows.push_back(s.value / (2 * s.step));
  }
}

}  // namespace photic::medium
