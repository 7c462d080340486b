// Checks of spherical air, and of what is known in it, or in it alone.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "scene/checks.hpp"

namespace photic::scene {
namespace {

/// Air above a planet that is hardly larger is no thin layer: a unit may be wrong. The earth's, up
/// to 100 km, has 64.
constexpr double least_radius_per_top = 50;

void check_planet(const Scene& scene, Findings& findings) {
  const char* path = "atmosphere.planet_radius_km";
  const auto top = top_of_air_m(scene, findings);
  if (!top || !findings.good({path})) return;
  const double radius_km = scene.atmosphere->planet_radius_km, top_km = *top / 1000;
  if (radius_km < least_radius_per_top * top_km)
    findings.add(
        path,
        fmt::format("the planet's radius of {} km is less than {:g} times the top of its air at {} "
                    "km",
                    plain_number(radius_km), least_radius_per_top, plain_number(top_km)),
        fmt::format("let the air end at {} km at most, or write at least {}",
                    plain_number(radius_km / least_radius_per_top),
                    plain_number(least_radius_per_top * top_km)));
}

void check_ground(const Scene& scene, Findings& findings) {
  if (scene.is_of_air_alone() || !findings.good({"atmosphere.geometry", "atmosphere.surface"}))
    return;
  findings.add("atmosphere.geometry",
               "below spherical air there is a ground, and no water: layers, columns and films are "
               "plane",
               "write surface = { albedo = 0.1 } into [atmosphere] and leave [sea], [bottom] and "
               "[oil] out, or take geometry = \"plane\"");
}

/// Below plane air a level sea is one of water.
void refuse_sea_below_planes(const Scene& scene, Findings& findings) {
  if (!scene.is_of_air_alone() || scene.atmosphere->surface->kind != GroundKind::sea) return;
  if (scene.is_of_spherical_air() || !findings.good({"atmosphere.surface", "atmosphere.geometry"}))
    return;
  findings.add("atmosphere.surface",
               "a sea that is black below its surface is one of spherical air",
               "write geometry = \"spherical\", or a [[sea.layer]] in place of it");
}

void check_telescopes(const Scene& scene, Findings& findings) {
  if (scene.telescope.empty() || !findings.good({"telescope"})) return;
  findings.add("telescope.0",
               "echoes are known in plane air alone: ranges and incidences of spherical air are "
               "not in them",
               "take geometry = \"plane\", or a [[tally]] in place of telescopes");
}

void refuse_importance(const Scene& scene, Findings& findings) {
  if (scene.simulation.tools.importance.empty() || !findings.good({"simulation.tools"})) return;
  findings.add("simulation.tools.importance",
               "importances are of depths, which spherical air does not have",
               "leave them out, or take geometry = \"plane\"");
}

/// Zones are of light as wide as the planet, which has no irradiance without them.
void check_zones(const Scene& scene, std::size_t i, Findings& findings) {
  const std::string path = fmt::format("tally.{}.zone_deg", i);
  const auto& zones = scene.tally[i].zone_deg;
  if (!findings.good({path, "source", "atmosphere.geometry"})) return;
  if (!zones.empty() && !scene.is_of_spherical_air())
    return findings.add(path, "there are zones below spherical air alone",
                        "leave them out, or write geometry = \"spherical\" into [atmosphere]");
  if (!zones.empty() && !scene.source.is_everywhere)
    return findings.add(path,
                        "zones are for light as wide as the planet: of a source with a place "
                        "irradiances are integrals over spheres",
                        "leave them out, or take a beam without position_m");
  if (zones.empty() && scene.is_of_spherical_air() && scene.source.is_everywhere)
    findings.add(path,
                 "a beam without a place lights the whole planet, and its irradiance differs from "
                 "zone to zone",
                 "add the edges of zones, as zone_deg = [0, 30, 60, 90, 180]");
}

/// Areas of narrower zones are lost in rounding.
void check_width_of_zones(const Scene& scene, std::size_t i, Findings& findings) {
  constexpr double least_deg = 1e-3;
  const std::string path = fmt::format("tally.{}.zone_deg", i);
  const auto& zones = scene.tally[i].zone_deg;
  if (!findings.good({path})) return;
  for (std::size_t k = 1; k < zones.size(); ++k)
    if (zones[k] > zones[k - 1] && zones[k] - zones[k - 1] < least_deg)
      return findings.add(
          below(path, k),
          fmt::format("the zone from {} to {} degrees is narrower than {:g} degrees",
                      plain_number(zones[k - 1]), plain_number(zones[k]), least_deg),
          "make it wider: hardly any light comes to it");
}

/// Light from farther away would be at the air only to within its rounding.
void check_distance(const Scene& scene, Findings& findings) {
  constexpr double farthest_m = 1e12;
  const auto& at = scene.source.position_m;
  if (scene.source.is_everywhere || !findings.good({"source.position_m"})) return;
  if (std::hypot(at.x, at.y, at.z) > farthest_m)
    findings.add("source.position_m",
                 fmt::format("the source is more than {:g} m away from the ground", farthest_m),
                 "move it along its direction, or leave position_m of a beam out: it is as wide as "
                 "the planet then");
}

/// Quantities of planes and of cylinders.
void refuse_plane_tally(const Scene& scene, std::size_t i, Findings& findings) {
  if (!scene.is_of_spherical_air() || !findings.good({"atmosphere.geometry"})) return;
  const char* what = scene.tally[i].kind == TallyKind::radiance
                         ? "radiances are known where the air is the same at all places, in planes"
                         : "the cells of a fluence are between planes";
  findings.add(fmt::format("tally.{}.kind", i), what,
               "take kind = \"irradiance\", or geometry = \"plane\"");
}

}  // namespace

void check_spherical(const Scene& scene, Findings& findings) {
  for (std::size_t i = 0; i < scene.tally.size(); ++i) {
    if (!findings.good({fmt::format("tally.{}.kind", i)})) continue;
    const TallyKind kind = scene.tally[i].kind;
    if (kind == TallyKind::irradiance) {
      check_zones(scene, i, findings);
      check_width_of_zones(scene, i, findings);
    }
    if (kind == TallyKind::radiance || kind == TallyKind::fluence)
      refuse_plane_tally(scene, i, findings);
  }
  refuse_sea_below_planes(scene, findings);
  if (!scene.is_of_spherical_air()) return;
  check_planet(scene, findings);
  check_distance(scene, findings);
  check_ground(scene, findings);
  check_telescopes(scene, findings);
  refuse_importance(scene, findings);
}

}  // namespace photic::scene
