#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/checks.hpp"

namespace photic::scene {
namespace {

void check_depths(const std::vector<Layer>& layers, Findings& findings) {
  double top = 0.0;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::string path = below(below("sea.layer", i), "bottom_depth_m");
    if (!findings.good({path})) continue;
    const auto& bottom = layers[i].bottom_depth_m;
    if (!bottom && i + 1 < layers.size())
      findings.add(path, "'bottom_depth_m' is missing in [[sea.layer]]",
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
        fmt::format("phytoplankton absorbs {} 1/m, more than the {} 1/m of all",
                    plain_number(entry.a_phytoplankton_per_m), plain_number(entry.a_per_m)),
        "it is a share of a_per_m");
  if (k > 0 && !(entry.wavelength_nm > layer.iop[k - 1].wavelength_nm))
    findings.add(path + ".wavelength_nm",
                 fmt::format("{} nm does not come after {} nm", plain_number(entry.wavelength_nm),
                             plain_number(layer.iop[k - 1].wavelength_nm)),
                 "sort the iop by ascending wavelength, each once");
}

void check_iop(const Layer& layer, std::size_t i, Findings& findings) {
  const std::string path = below(below("sea.layer", i), "iop");
  if (layer.iop.empty() || !findings.good({path})) return;
  for (std::size_t k = 0; k < layer.iop.size(); ++k)
    check_iop_entry(layer, k, below(path, k), findings);
}

void check_mixture(const PhaseFunction& mixture, const std::string& path, Findings& findings) {
  const std::string components = path + ".components";
  if (mixture.components.empty()) return;
  double sum = 0.0;
  for (std::size_t k = 0; k < mixture.components.size(); ++k) {
    check_mixture(mixture.components[k], below(components, k), findings);
    sum += mixture.components[k].fraction;
  }
  constexpr double tolerance = 1e-6;
  if (findings.good({components}) && std::fabs(sum - 1.0) > tolerance)
    findings.add(components,
                 fmt::format("the fractions of the mixture sum to {}, not to 1", plain_number(sum)),
                 "");
}

void check_phytoplankton_phase(const Scene& scene, Findings& findings) {
  const std::string path = "optics.phytoplankton_phase";
  if (scene.optics.phytoplankton_phase != "mie" || !findings.good({path, "optics.set"})) return;
  const auto has_chlorophyll = [](const Layer& l) { return l.chlorophyll_mg_m3 > 0.0; };
  if (std::none_of(scene.sea.layer.begin(), scene.sea.layer.end(), has_chlorophyll)) return;
  findings.add(path, findings.place_of(findings.given(path) ? path : "optics.set"),
               "the phase function of phytoplankton \"mie\" is not available yet",
               "set phytoplankton_phase = \"fournier-forand\" or \"petzold\" in [optics]");
}

}  // namespace

std::optional<double> sea_bed_m(const Scene& scene, const Findings& findings) {
  const std::vector<Layer>& layers = scene.sea.layer;
  if (layers.empty()) return std::nullopt;
  const std::string path = below(below("sea.layer", layers.size() - 1), "bottom_depth_m");
  return findings.good({path}) ? layers.back().bottom_depth_m : std::nullopt;
}

void check_sea(const Scene& scene, Findings& findings) {
  const std::vector<Layer>& layers = scene.sea.layer;
  check_depths(layers, findings);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    check_iop(layers[i], i, findings);
    if (layers[i].phase_function)
      check_mixture(*layers[i].phase_function, below(below("sea.layer", i), "phase_function"),
                    findings);
  }
  check_phytoplankton_phase(scene, findings);
}

}  // namespace photic::scene
