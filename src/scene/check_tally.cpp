// Checks of [[tally]] across keys: levels and edges, and what can have which quantity.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <vector>

#include "scene/checks.hpp"

namespace photic::scene {
namespace {

/// "tally.2.key"
std::string key_of(std::size_t i, const char* key) { return fmt::format("tally.{}.{}", i, key); }

/// Numbers of a list that ascend strictly.
void check_ascent(const std::vector<double>& values, const std::string& path, Findings& findings) {
  for (std::size_t k = 1; k < values.size(); ++k)
    if (!(values[k] > values[k - 1]))
      findings.add(below(path, k),
                   fmt::format("{} does not come after {}", plain_number(values[k]),
                               plain_number(values[k - 1])),
                   "list them in ascending order, each once");
}

// --- Places --------------------------------------------------------------------------------------

void check_depths(const Scene& scene, const std::string& path, const std::vector<double>& depths,
                  Findings& findings) {
  if (depths.empty()) return;
  if (scene.is_of_air_alone())
    return findings.add(path, "there are no depths: a ground takes the place of the sea",
                        "give heights: height_m");
  const auto bed = sea_bed_m(scene, findings);
  for (std::size_t k = 0; bed && k < depths.size(); ++k)
    if (depths[k] > *bed)
      return findings.add(below(path, k),
                          fmt::format("{} m is below the sea bed at {} m", plain_number(depths[k]),
                                      plain_number(*bed)),
                          "end above it, or lower the last layer's bottom_depth_m");
}

void check_heights(const Scene& scene, const std::string& path, const std::vector<double>& heights,
                   Findings& findings) {
  const auto top = top_of_air_m(scene, findings);
  for (std::size_t k = 0; top && k < heights.size(); ++k)
    if (heights[k] > *top)
      return findings.add(below(path, k),
                          fmt::format("{} m is above the top of the air at {} m",
                                      plain_number(heights[k]), plain_number(*top)),
                          "end below it: above there is a vacuum");
}

void check_places(const Scene& scene, std::size_t i, Findings& findings) {
  const Tally& tally = scene.tally[i];
  const std::string depths = key_of(i, "depth_m"), heights = key_of(i, "height_m");
  if (findings.good({depths})) {
    check_ascent(tally.depth_m, depths, findings);
    check_depths(scene, depths, tally.depth_m, findings);
  }
  if (findings.good({heights})) {
    check_ascent(tally.height_m, heights, findings);
    check_heights(scene, heights, tally.height_m, findings);
  }
}

// --- Irradiance ----------------------------------------------------------------------------------

/// A part of the water or the air between two depths, or two heights.
struct Extent {
  double from, to;
};

std::vector<Extent> extents_of(const Stack& stack) {
  std::vector<Extent> out;
  double top = 0;
  for (const Layer& layer : stack.layer) {
    if (!layer.bottom_depth_m) break;
    out.push_back({top, *layer.bottom_depth_m});
    top = *layer.bottom_depth_m;
  }
  return out;
}

std::vector<Extent> extents_of_air(const Scene& scene) {
  std::vector<Extent> out;
  if (scene.atmosphere)
    for (const AirLayer& layer : scene.atmosphere->layer)
      out.push_back({layer.bottom_height_m, layer.top_height_m});
  return out;
}

/// A slab is cut to the layer of its level: one that is thicker holds the whole layer, wherever the
/// level is in it. A level between two layers belongs to the one beyond it.
void check_slab(double slab_m, const std::vector<double>& levels,
                const std::vector<Extent>& extents, const std::string& path, Findings& findings) {
  constexpr double least_of_level = 1e-5;  // a hundred steps of floats
  for (const double level : levels) {
    const auto layer = std::ranges::find_if(
        extents, [&](const Extent& extent) { return level >= extent.from && level < extent.to; });
    if (layer != extents.end() && slab_m > layer->to - layer->from)
      return findings.add(
          path,
          fmt::format("a slab of {} m about {} m is thicker than its layer from {} to {} m",
                      plain_number(slab_m), plain_number(level), plain_number(layer->from),
                      plain_number(layer->to)),
          fmt::format("write at most {}", plain_number(layer->to - layer->from)));
    if (slab_m < least_of_level * level)
      return findings.add(
          path,
          fmt::format("a slab of {} m about {} m holds nothing: it is lost in the rounding",
                      plain_number(slab_m), plain_number(level)),
          fmt::format("write at least {}", plain_number(least_of_level * level)));
  }
}

void check_irradiance(const Scene& scene, std::size_t i, Findings& findings) {
  const Tally& tally = scene.tally[i];
  const std::string slab = key_of(i, "slab_m");
  if (!tally.slab_m || !findings.good({slab, key_of(i, "depth_m"), key_of(i, "height_m")})) return;
  for (const Stack& stack : stacks_of(scene.sea))
    if (findings.good({stack.path, slab}))
      check_slab(*tally.slab_m, tally.depth_m, extents_of(stack), slab, findings);
  if (findings.good({"atmosphere.layer", slab}))
    check_slab(*tally.slab_m, tally.height_m, extents_of_air(scene), slab, findings);
}

// --- Boundaries, fluence, radiance ---------------------------------------------------------------

void check_escape(const Scene& scene, std::size_t i, Findings& findings) {
  const std::string path = key_of(i, "zenith_deg");
  const std::vector<double>& edges = scene.tally[i].zenith_deg;
  if (!findings.good({path})) return;
  check_ascent(edges, path, findings);
  const char* whole = "the bins of light that escapes go from 0 to 90 degrees";
  if (edges.front() != 0)
    findings.add(
        below(path, std::size_t{0}),
        fmt::format("the angles begin at {} degrees, not at 0", plain_number(edges.front())),
        whole);
  if (edges.back() != 90)
    findings.add(below(path, edges.size() - 1),
                 fmt::format("the angles end at {} degrees, not at 90", plain_number(edges.back())),
                 whole);
}

/// Results call a quantity after it.
bool is_for_variables(const std::string& name) {
  return std::ranges::all_of(
      name, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; });
}

void check_fluence(const Scene& scene, std::size_t i, Findings& findings) {
  const Tally& tally = scene.tally[i];
  if (findings.good({key_of(i, "radius_m")}))
    check_ascent(tally.radius_m, key_of(i, "radius_m"), findings);
  if (findings.good({key_of(i, "x_m")})) check_ascent(tally.x_m, key_of(i, "x_m"), findings);
  if (findings.good({key_of(i, "name")}) && !is_for_variables(tally.name))
    findings.add(key_of(i, "name"),
                 fmt::format("{} cannot be part of the name of a variable", quoted(tally.name)),
                 "take letters, digits, _ and -");
  if (scene.source.is_everywhere && findings.good({"source"}))
    findings.add(key_of(i, "kind"), "a beam as wide as the world has no fluence about a place",
                 "give the beam a position_m, or take kind = \"irradiance\"");
}

void check_directions(const Scene& scene, std::size_t i, Findings& findings) {
  const std::string path = key_of(i, "direction_deg");
  if (!findings.good({path})) return;
  const auto& directions = scene.tally[i].direction_deg;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const double zenith = directions[k].zenith_deg;
    if (zenith < 0 || zenith > 180)
      findings.add(
          below(path, k),
          fmt::format("a zenith angle of {} degrees is not from 0 to 180", plain_number(zenith)),
          "0 is light that travels straight up, 180 straight down");
    else if (zenith == 90)
      findings.add(below(path, k), "horizontal light crosses no level: its radiance is not known",
                   "take another zenith angle than 90 degrees");
  }
}

void check_radiance(const Scene& scene, std::size_t i, Findings& findings) {
  check_directions(scene, i, findings);
  if (!scene.source.is_everywhere && findings.good({"source"}))
    findings.add(key_of(i, "kind"),
                 "of a source with a place a radiance would be an integral over the horizontal "
                 "plane",
                 "take a beam without position_m, or kind = \"irradiance\"");
  if (!scene.sea.is_alike_everywhere() && findings.good({"sea"}))
    findings.add(key_of(i, "kind"),
                 "a radiance is that of a sea that is alike everywhere, and this one has columns",
                 "take kind = \"irradiance\", or one column without ends");
  if (scene.sea.surface.is_rough() && findings.good({"sea.surface"}))
    findings.add(key_of(i, "kind"), "radiances are known below and above a flat surface alone",
                 "write sea.surface = { model = \"flat\" }, or take kind = \"irradiance\"");
}

// --- All of them ---------------------------------------------------------------------------------

void check_kinds(const std::vector<Tally>& all, Findings& findings) {
  std::set<TallyKind> seen;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!findings.good({key_of(i, "kind")}) || all[i].kind == TallyKind::fluence) continue;
    if (!seen.insert(all[i].kind).second)
      findings.add(key_of(i, "kind"),
                   fmt::format("two of [[tally]] are of the kind {}", quoted(word_of(all[i].kind))),
                   "make one of both: only fluences may be several");
  }
}

void check_names_of_fluences(const std::vector<Tally>& all, Findings& findings) {
  const auto is_fluence = [](const Tally& tally) { return tally.kind == TallyKind::fluence; };
  if (std::ranges::count_if(all, is_fluence) < 2) return;
  std::set<std::string> seen;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string path = key_of(i, "name");
    if (!is_fluence(all[i]) || !findings.good({path, key_of(i, "kind")})) continue;
    if (all[i].name.empty())
      findings.add(path, "there are several fluences, and this one has no name",
                   "give each its own name");
    else if (!seen.insert(all[i].name).second)
      findings.add(path, fmt::format("two of [[tally]] are called {}", quoted(all[i].name)),
                   "give each its own name");
  }
}

void check_settings(const Scene& scene, Findings& findings) {
  const Simulation& s = scene.simulation;
  if (s.estimator == Estimator::bidirectional && findings.good({"simulation.estimator"}))
    findings.add("simulation.estimator",
                 "the bidirectional estimator has no tallies: it follows only light that comes to "
                 "a telescope",
                 "write estimator = \"forward\", or leave [[tally]] out");
  if (s.tools.forced_collisions > 0 && findings.good({"simulation.tools"}))
    findings.add("simulation.tools.forced_collisions",
                 "photons that are forced to stay do not cross the levels on their way out",
                 "write forced_collisions = 0, or leave [[tally]] out");
  if (s.directed_fraction.value_or(0) > 0 && findings.good({"simulation.directed_fraction"}))
    findings.add("simulation.directed_fraction",
                 "directions drawn towards a telescope make tallies noisy",
                 "write directed_fraction = 0, or leave [[tally]] out");
}

void check_other_waters(const Scene& scene, Findings& findings) {
  if (!scene.has_environments()) return;
  const char* path = scene.environment.empty() ? "sensitivity" : "environment.0";
  const char* what = scene.environment.empty() ? "sensitivity" : "[[environment]]";
  if (scene.telescope.empty())
    findings.add(path, fmt::format("{} has only echoes, and there is no telescope", what),
                 fmt::format("add a [[telescope]], or leave {} out", what));
  else
    findings.remark(path, fmt::format("{} has only echoes: tallies are of the scene alone", what));
}

}  // namespace

void check_tallies(const Scene& scene, Findings& findings) {
  if (scene.tally.empty()) return;
  for (std::size_t i = 0; i < scene.tally.size(); ++i) {
    if (!findings.good({key_of(i, "kind")})) continue;
    check_places(scene, i, findings);
    switch (scene.tally[i].kind) {
      case TallyKind::irradiance:
        check_irradiance(scene, i, findings);
        break;
      case TallyKind::boundaries:
        check_escape(scene, i, findings);
        break;
      case TallyKind::fluence:
        check_fluence(scene, i, findings);
        break;
      case TallyKind::radiance:
        check_radiance(scene, i, findings);
        break;
    }
  }
  check_kinds(scene.tally, findings);
  check_names_of_fluences(scene.tally, findings);
  check_settings(scene, findings);
  if (findings.good({"telescope", "environment", "sensitivity"}))
    check_other_waters(scene, findings);
  if (!scene.telescope.empty() && !scene.simulation.directed_fraction)
    findings.remark("tally.0",
                    "beside tallies no directions are drawn towards telescopes: "
                    "simulation.directed_fraction is 0, and echoes take longer");
}

}  // namespace photic::scene
