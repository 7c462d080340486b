#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "optics/fournier_forand.hpp"
#include "scene/checks.hpp"
#include "scene/describe_sea.hpp"

namespace photic::scene {
namespace {

void check_depths(const Stack& stack, Findings& findings) {
  const std::vector<Layer>& layers = stack.layer;
  double top = 0.0;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::string path = below(below(stack.path, i), "bottom_depth_m");
    if (!findings.good({path})) continue;
    const auto& bottom = layers[i].bottom_depth_m;
    if (!bottom && i + 1 < layers.size())
      findings.add(path, fmt::format("'bottom_depth_m' is missing in [[{}]]", stack.section),
                   "only the last layer may be bottomless");
    if (bottom && *bottom <= top)
      findings.add(
          path,
          fmt::format("the layer ends at {} m, not below the one above it, which ends at {} m",
                      plain_number(*bottom), plain_number(top)),
          "layers go from the surface down");
    if (bottom) top = std::max(top, *bottom);
  }
}

void check_iop_entry(const Layer& layer, std::size_t k, const std::string& path,
                     Findings& findings) {
  const IopEntry& entry = layer.iop[k];
  if (!(entry.a_per_m + entry.b_per_m > 0.0))
    findings.add(path, "a_per_m + b_per_m is 0: there is no water without attenuation", "");
  if (entry.a_phytoplankton_per_m > entry.a_per_m)
    findings.add(
        path + ".a_phytoplankton_per_m",
        fmt::format("phytoplankton absorbs {} 1/m, more than the total of {} 1/m",
                    plain_number(entry.a_phytoplankton_per_m), plain_number(entry.a_per_m)),
        "it is a part of a_per_m");
  else if (entry.a_phytoplankton_per_m + entry.a_cdom_per_m > entry.a_per_m)
    findings.add(path + ".a_cdom_per_m",
                 fmt::format("CDOM and phytoplankton absorb {} 1/m, more than the total of {} 1/m",
                             plain_number(entry.a_phytoplankton_per_m + entry.a_cdom_per_m),
                             plain_number(entry.a_per_m)),
                 "they are parts of a_per_m");
  if (k > 0 && !(entry.wavelength_nm > layer.iop[k - 1].wavelength_nm))
    findings.add(path + ".wavelength_nm",
                 fmt::format("{} nm does not come after {} nm", plain_number(entry.wavelength_nm),
                             plain_number(layer.iop[k - 1].wavelength_nm)),
                 "sort the iop by ascending wavelength, each once");
}

void check_backscatter_fraction(const IopEntry& entry, const std::string& path,
                                Findings& findings) {
  if (!entry.bb_per_m || (entry.b_per_m == 0 && *entry.bb_per_m == 0)) return;
  try {
    optics::FournierForand::of_backscatter(*entry.bb_per_m / entry.b_per_m);
  } catch (const InputError& error) {
    const Diagnostic& d = error.diagnostics().front();
    findings.add(path + ".bb_per_m", d.reason, d.suggestion);
  }
}

/// The phase function is given, or follows from all entries' bb_per_m.
void check_phase_source(const Layer& layer, const std::string& layer_path,
                        const std::string& section, Findings& findings) {
  const std::string iop = below(layer_path, "iop");
  const std::string function = below(layer_path, "phase_function");
  const bool by_backscatter = layer.iop.front().bb_per_m.has_value();
  for (std::size_t k = 0; k < layer.iop.size(); ++k) {
    if (layer.iop[k].bb_per_m.has_value() != by_backscatter)
      findings.add(below(iop, k), "'bb_per_m' is in some entries of the iop and not in others",
                   "give it in all or in none");
    check_backscatter_fraction(layer.iop[k], below(iop, k), findings);
  }
  if (by_backscatter && layer.phase_function)
    findings.add(
        function,
        fmt::format("'bb_per_m' and 'phase_function' exclude each other in [[{}]]", section),
        "keep one of them");
  if (!by_backscatter && !layer.phase_function)
    findings.add(function, fmt::format("'phase_function' is missing in [[{}]]", section),
                 std::string("add it: ") + phase_function_meaning);
}

void check_iop(const Stack& stack, std::size_t i, Findings& findings) {
  const Layer& layer = stack.layer[i];
  const std::string path = below(below(stack.path, i), "iop");
  if (layer.iop.empty() || !findings.good({path})) return;
  for (std::size_t k = 0; k < layer.iop.size(); ++k)
    check_iop_entry(layer, k, below(path, k), findings);
  check_phase_source(layer, below(stack.path, i), stack.section, findings);
}

void check_mixture(const PhaseFunction& mixture, const std::string& path, Findings& findings) {
  double sum = 0.0;
  for (const PhaseFunction& component : mixture.components) sum += component.fraction;
  constexpr double tolerance = 1e-6;
  if (findings.good({path}) && std::fabs(sum - 1.0) > tolerance)
    findings.add(path,
                 fmt::format("the fractions of the mixture sum to {}, not to 1", plain_number(sum)),
                 "");
}

void check_radii(const optics::SeaParticles& particles, const std::string& path,
                 Findings& findings) {
  const std::string max = path + ".max_radius_um";
  if (!findings.good({path + ".min_radius_um", max}) ||
      particles.max_radius_um > particles.min_radius_um)
    return;
  findings.add(
      max, findings.place_of(findings.given(max) ? max : path + ".min_radius_um"),
      fmt::format("the largest radius, {} um, is not above the smallest, {} um",
                  plain_number(particles.max_radius_um), plain_number(particles.min_radius_um)),
      "");
}

void check_phase_function(const PhaseFunction& function, const std::string& path,
                          Findings& findings) {
  const std::string components = path + ".components";
  for (std::size_t k = 0; k < function.components.size(); ++k)
    check_phase_function(function.components[k], below(components, k), findings);
  if (!function.components.empty()) check_mixture(function, components, findings);
  if (function.model == PhaseModel::mie) check_radii(function.particles, path, findings);
}

/// A constituent, and more of it than any water has: a unit is wrong, or it is no sea.
struct Plenty {
  const char* key;
  double Layer::*value;
  double most;
  const char* unit;
  const char* known;
};

// From memory. Chlorophyll: lakes in bloom have some hundred mg/m3. CDOM: the brownest rivers and
// lakes have 20 to 60 1/m (Kirk 2011). Minerals: water with more than 10 kg/m3 is fluid mud.
constexpr Plenty plenties[] = {
    {"chlorophyll_mg_m3", &Layer::chlorophyll_mg_m3, 1e3, "mg/m3", "lakes in bloom have hundreds"},
    {"cdom_a440_per_m", &Layer::cdom_a440_per_m, 1e2, "1/m", "the brownest rivers have tens"},
    {"minerals_g_m3", &Layer::minerals_g_m3, 1e4, "g/m3", "what has more is mud"}};

/// A remark that layers cut from one profile share is made once, with the greatest value.
void remark_plenty(const std::vector<PlacedLayer>& layers, const Plenty& plenty,
                   Findings& findings) {
  std::map<std::tuple<std::string, int, int>, std::pair<double, std::string>> greatest;
  for (const PlacedLayer& at : layers) {
    const double value = at.layer.*plenty.value;
    if (!(value > plenty.most)) continue;
    const std::string path = below(at.path, plenty.key);
    if (!findings.good({path})) continue;
    const Place place = findings.place_of(path);
    auto& most = greatest[{place.file, place.line, place.column}];
    if (value > most.first) most = {value, path};
  }
  for (const auto& [place, found] : greatest)
    findings.remark(found.second,
                    fmt::format("{} {} of '{}' are more than water has ({}): are the units right?",
                                plain_number(found.first), plenty.unit, plenty.key, plenty.known));
}

}  // namespace

std::optional<double> sea_bed_m(const Scene& scene, const Findings& findings) {
  const Stack stack = stacks_of(scene.sea).front();  // the others have the same bed
  if (stack.layer.empty()) return std::nullopt;
  const std::string path = below(below(stack.path, stack.layer.size() - 1), "bottom_depth_m");
  return findings.good({path}) ? stack.layer.back().bottom_depth_m : std::nullopt;
}

void check_sea(const Scene& scene, Findings& findings) {
  for (const Stack& stack : stacks_of(scene.sea)) {
    check_depths(stack, findings);
    for (std::size_t i = 0; i < stack.layer.size(); ++i) check_iop(stack, i, findings);
  }
  const auto layers = layers_of(scene.sea);
  for (const PlacedLayer& at : layers)
    if (at->phase_function)
      check_phase_function(*at->phase_function, below(at.path, "phase_function"), findings);
  for (const Plenty& plenty : plenties) remark_plenty(layers, plenty, findings);
}

}  // namespace photic::scene
