#include <fmt/format.h>

#include "scene/checks.hpp"

namespace photic::scene {
namespace {

constexpr double thickest_film_um = 1000;
/// A line of the band has at least half as many spectral bins as its light is of all.
constexpr double max_analog_yield = 0.5;

void check_surface_under_oil(const Scene& scene, Findings& findings) {
  const Surface& surface = scene.sea.surface;
  if (!surface.has_whitecaps() || !findings.good({"sea.surface"})) return;
  const char* key = surface.whitecap_fraction ? "whitecap_fraction" : "whitecaps";
  findings.add(below("sea.surface", key), "there are no whitecaps on a film of oil",
               "leave it out, or leave [oil] out");
}

/// Refuses what a film at a path cannot do with. `label`: of what may be left out.
void check_film(const Scene& scene, const Oil& oil, const std::string& path, const char* label,
                Findings& findings) {
  if (oil.thickness_um > thickest_film_um)
    findings.remark(below(path, "thickness_um"),
                    "oil of more than 1 mm is not a film: scattering in it, and the sideways shift "
                    "of light, are left out");
  if (oil.yield.value_or(0) > max_analog_yield && scene.simulation.estimator == Estimator::analog &&
      findings.good({"simulation.estimator"}))
    findings.add("simulation.estimator",
                 fmt::format("analog photons are emitted with a probability below 1, and so by "
                             "oils with a yield up to {}",
                             max_analog_yield),
                 "write estimator = \"forward\"");
  if (scene.simulation.tools.forced_collisions > 0 && findings.good({"simulation.tools"}))
    findings.add("simulation.tools.forced_collisions",
                 "how much light leaves the water is known only for a clean surface",
                 fmt::format("write forced_collisions = 0, or leave {} out", label));
  if (scene.simulation.reception == Reception::overlap && findings.good({"simulation.reception"}))
    findings.add("simulation.reception",
                 "a film of oil lights the lens unevenly: the mean over the lens is not known",
                 "write reception = \"ray\"");
}

}  // namespace

void check_oil(const Scene& scene, Findings& findings) {
  if (scene.oil && findings.good({"oil"})) {
    check_surface_under_oil(scene, findings);
    check_film(scene, *scene.oil, "oil", "[oil]", findings);
  }
  for (std::size_t i = 0; i < scene.sea.column.size(); ++i) {
    const auto& oil = scene.sea.column[i].oil;
    const std::string path = below(below("sea.column", i), "oil");
    if (!oil || !findings.good({path})) continue;
    check_film(scene, *oil, path, "the column's oil", findings);
    if (scene.oil)
      findings.add(path, "[oil] is a film on all columns, and this is one on one of them",
                   "keep one of them");
  }
}

}  // namespace photic::scene
