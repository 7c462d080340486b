#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/vec3.hpp"
#include "scene/checks.hpp"
#include "scene/waves.hpp"

namespace photic::scene {
namespace {

/// Refuses what is neither flat nor a sea, and would be lost in the rounding of floats.
void check_size(const Surface& surface, Findings& findings) {
  constexpr double min_variance = 1e-6, min_m_s = 1e-3;
  const auto check = [&](const char* key, double value, double least, const char* what,
                         const char* unit) {
    if (value > 0 && value < least)
      findings.add(
          below("sea.surface", key),
          fmt::format("{} of {}{} is too small for waves", what, plain_number(value), unit),
          fmt::format("write 0, or at least {}", plain_number(least)));
  };
  check("wind_speed_m_s", surface.wind_speed_m_s, min_m_s, "a wind", " m/s");
  const char* variance = "a variance";
  check("upwind_slope_variance", surface.upwind_slope_variance, min_variance, variance, "");
  check("crosswind_slope_variance", surface.crosswind_slope_variance, min_variance, variance, "");
}

/// Walks through waves of one direction have to be translated to meet, which flat rays of tilted
/// lenses are not (instrument::flattest_translated, 11.5 degrees).
constexpr double flattest_degrees = 12;
/// Returns whether a telescope in the air sees rays flatter than that.
bool looks_flat(const Telescope& t) {
  if (t.position_m.z < 0) return false;
  const double distance = t.detector_distance_m();
  const double blur = t.diameter_m / 2 * std::abs(1 / t.focal_length_m - 1 / distance);
  const double view = std::atan(t.effective_detector_diameter_m() / 2 / distance + blur);
  const double off_vertical = std::acos(std::clamp(-normalised(t.direction).z, -1.0, 1.0));
  return off_vertical + view > (90 - flattest_degrees) * radian_per_degree;
}

/// The local estimate of a telescope through facets has the weight that is alike both ways.
void check_facets(const Scene& scene, Findings& findings) {
  if (scene.sea.surface.facets == FacetWeight::conserving && !scene.telescope.empty())
    findings.add("sea.surface.facets", "telescopes see waves with facets = \"reciprocal\" alone",
                 "write that, leave facets out, or leave the telescopes out");
}

std::optional<std::string> lacks_for_waves(const Scene& scene) {
  const Surface& surface = scene.sea.surface;
  if (!surface.is_rough()) return {};
  if (!surface.is_one_dimensional() || !std::ranges::any_of(scene.telescope, looks_flat)) return {};
  return fmt::format("one-dimensional waves seen by rays within {} degrees of the horizontal",
                     flattest_degrees);
}

/// Refuses settings for which only the flat surface is known.
void check_simulation(const Scene& scene, Findings& findings) {
  const Simulation& s = scene.simulation;
  if (const auto reason = lacks_for_waves(scene); reason && s.estimator == Estimator::bidirectional)
    findings.add("simulation.estimator", "the bidirectional estimator cannot treat " + *reason,
                 "write estimator = \"forward\", or sea.surface = { model = \"flat\" }");
  if (s.reception == Reception::overlap)
    findings.add("simulation.reception",
                 "waves spread light over the lens unevenly: the mean over the lens is not known",
                 "write reception = \"ray\"");
  if (s.tools.forced_collisions > 0)
    findings.add("simulation.tools.forced_collisions",
                 "how much light leaves the water is known only for a flat surface",
                 "write forced_collisions = 0, or sea.surface = { model = \"flat\" }");
}

void check_whitecaps(const Surface& surface, Findings& findings) {
  if (surface.whitecaps == false && surface.whitecap_fraction.value_or(0) > 0)
    findings.add("sea.surface.whitecap_fraction",
                 "whitecaps = false says that there are no whitecaps", "leave one of them out");
  if (surface.model == SurfaceModel::gaussian && surface.has_whitecaps() &&
      !surface.whitecap_fraction)
    findings.add("sea.surface.whitecaps",
                 "without a wind it is not known how much of the sea whitecaps cover",
                 "give whitecap_fraction");
}

}  // namespace

std::optional<std::string> bidirectional_lacks(const Scene& scene) {
  if (!scene.sea.column.empty())
    return "columns of water: five of its seven strategies move a walk and need a sea that is "
           "alike everywhere, and what stays does not converge on peaked water";
  return lacks_for_waves(scene);
}

void check_surface(const Scene& scene, Findings& findings) {
  const Surface& surface = scene.sea.surface;
  if (!findings.good({"sea.surface"})) return;
  if (!surface.is_rough()) {
    if (surface.whitecap_fraction.value_or(0) > 0)
      findings.add("sea.surface.whitecap_fraction", "a sea without waves has no whitecaps",
                   "give it a wind, or variances of slopes, or leave whitecap_fraction out");
    return;
  }
  check_size(surface, findings);
  check_whitecaps(surface, findings);
  check_facets(scene, findings);
  if (findings.good({"simulation.estimator", "simulation.reception", "simulation.tools"}))
    check_simulation(scene, findings);
}

}  // namespace photic::scene
