#include "scene/presets.hpp"

#include <array>
#include <string>

#include "core/error.hpp"

namespace photic::scene {
namespace {

const std::array<Optics, 2>& presets() {
  static const std::array<Optics, 2> all{
      Optics{.set = OpticsSet::modern,
             .water_absorption = "mason-ioccg",
             .water_scattering = "zhang",
             .water_depolarisation = 0.039,  // Farinato & Rowell 1976, used by Zhang et al. 2009
             .phytoplankton = "bricaud",
             .phytoplankton_table = {},
             .phytoplankton_phase = ParticlePhase::fournier_forand,
             .minerals = MineralOptics::power_law,
             .minerals_phase = ParticlePhase::fournier_forand,
             .raman = "bartlett",
             .emission = {},  // spectra, unless iops are given (read.cpp)
             .cdom_fluorescence = CdomFluorescence::hawes,
             .cdom_fluorescence_table = {}},
      Optics{.set = OpticsSet::paper,
             .water_absorption = "smith-baker",
             .water_scattering = "smith-baker",
             .water_depolarisation = 0.17,  // as PREMAR-2F has it; it is a Raman value (Porto 1966)
             .phytoplankton = "prieur-sathyendranath",
             .phytoplankton_table = {},
             .phytoplankton_phase = ParticlePhase::mie,
             .minerals = MineralOptics::mie,
             .minerals_phase = ParticlePhase::mie,
             .raman = "marshall-smith",
             .emission = Emission::lines,
             .cdom_fluorescence = CdomFluorescence::hawes,
             .cdom_fluorescence_table = {}}};
  return all;
}

}  // namespace

Optics optics_of(OpticsSet set) {
  for (const Optics& preset : presets())
    if (preset.set == set) return preset;
  throw ContractViolation(std::string("no optics are those of set ") + word_of(set));
}

}  // namespace photic::scene
