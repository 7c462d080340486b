#include "scene/presets.hpp"

#include <array>

#include "core/error.hpp"

namespace photic::scene {
namespace {

const std::array<Optics, 2>& presets() {
  static const std::array<Optics, 2> all{
      Optics{.set = "modern",
             .water_absorption = "mason-ioccg",
             .water_scattering = "zhang",
             .water_depolarisation = 0.039,  // Farinato & Rowell 1976, used by Zhang et al. 2009
             .phytoplankton = "bricaud",
             .phytoplankton_table = {},
             .phytoplankton_phase = "fournier-forand",
             .minerals = "power-law",
             .minerals_phase = "fournier-forand",
             .raman = "bartlett",
             .emission = "",  // spectra, unless iops are given (read.cpp)
             .cdom_fluorescence = "hawes",
             .cdom_fluorescence_table = {}},
      Optics{.set = "paper",
             .water_absorption = "smith-baker",
             .water_scattering = "smith-baker",
             .water_depolarisation = 0.17,  // as PREMAR-2F has it; it is a Raman value (Porto 1966)
             .phytoplankton = "prieur-sathyendranath",
             .phytoplankton_table = {},
             .phytoplankton_phase = "mie",
             .minerals = "mie",
             .minerals_phase = "mie",
             .raman = "marshall-smith",
             .emission = "lines",
             .cdom_fluorescence = "hawes",
             .cdom_fluorescence_table = {}}};
  return all;
}

}  // namespace

std::vector<Word> optics_sets() {
  return {{"modern", "the best data and models of today"},
          {"paper", "those of the PREMAR-2F paper, to compare with it"}};
}

Optics optics_of(const std::string& set) {
  for (const Optics& preset : presets())
    if (preset.set == set) return preset;
  throw ContractViolation("no set of optics is called " + set);
}

}  // namespace photic::scene
