#include "medium/build.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "medium/layer_optics.hpp"
#include "optics/fluorescence.hpp"
#include "optics/phase_functions.hpp"
#include "optics/raman.hpp"
#include "optics/refractive_index.hpp"

namespace photic::medium {
namespace {

/// Whether some channel asks for a process, or might see it through its filter.
bool asked_for(const scene::Scene& scene, const Line& line) {
  for (const auto& channel : scene.channel) {
    if (counts(channel, line)) return true;
  }
  return false;
}

Line make_line(const scene::Sea& sea, Process process, double wavelength_nm) {
  const auto quan_fry = [&](auto index) {
    return index(wavelength_nm, sea.salinity_psu, sea.temperature_c);
  };
  Line line;
  line.process = process;
  line.wavelength_nm = wavelength_nm;
  line.refractive_index =
      sea.refractive_index ? *sea.refractive_index : quan_fry(optics::refractive_index);
  line.group_index = sea.group_index ? *sea.group_index : quan_fry(optics::group_index);
  return line;
}

/// Emission of every layer by one process; what is emitted may differ by layer, its wavelengths do
/// not.
struct ProcessEmission {
  Process process;
  std::vector<optics::Emission> layer;
};

std::vector<ProcessEmission> emissions(const scene::Scene& scene, const LayerOptics& optics_of,
                                       const optics::Library& library) {
  const double laser_nm = scene.source.wavelength_nm;
  ProcessEmission raman{Process::raman, {}};
  ProcessEmission chlorophyll{Process::chlorophyll, {}};
  for (const auto& layer : scene.sea.layer) {
    raman.layer.push_back(optics::raman(library, scene.optics.raman, laser_nm));
    const double exciting = optics_of(layer, laser_nm).a_exciting_per_m;
    chlorophyll.layer.push_back(
        optics::chlorophyll_fluorescence(library, laser_nm, exciting, layer.chlorophyll_yield));
  }
  return {raman, chlorophyll};
}

/// Adds a process' lines to the medium's, where a channel counts them, and their coefficients [1/m]
/// by layer.
void add_lines(const scene::Scene& scene, const ProcessEmission& emission, Medium& medium,
               std::vector<std::vector<double>>& coefficients) {
  for (std::size_t k = 0; k < emission.layer.size(); ++k) {
    for (const auto& emitted : emission.layer[k].lines) {
      const Line line = make_line(scene.sea, emission.process, emitted.wavelength_nm);
      if (!asked_for(scene, line)) continue;
      std::size_t at = 1;
      while (at < medium.line.size() && (medium.line[at].process != line.process ||
                                         medium.line[at].wavelength_nm != line.wavelength_nm)) {
        ++at;
      }
      if (at == medium.line.size()) {
        medium.line.push_back(line);
        coefficients.emplace_back(emission.layer.size(), 0.0);
      }
      medium.sources.push_back(fmt::format("layer {}: {} light at {:.2f} nm = {:.5g} 1/m: {}", k,
                                           process_name(line.process), line.wavelength_nm,
                                           emitted.coefficient_per_m, emission.layer[k].source));
      coefficients[at][k] = emitted.coefficient_per_m;
    }
  }
}

std::int32_t conversion_phase(Medium& medium, Process process, const optics::Library& library) {
  if (process == Process::elastic) return 0;  // never used
  const bool is_raman = process == Process::raman;
  const auto shape = is_raman ? optics::raman_phase(library.raman.at("depolarisation").value)
                              : optics::isotropic();
  return medium.add_phase(optics::PhaseTable(shape));
}

[[noreturn]] void give_back_too_much(const scene::Layer& layer, double a_per_m,
                                     double emitted_per_m) {
  throw InputError(
      {{"", 0, 0,
        fmt::format("layer \"{}\" emits more Raman and fluorescence light ({:.3g} 1/m) than it "
                    "absorbs ({:.3g} 1/m)",
                    layer.name, emitted_per_m, a_per_m),
        "a is the total absorption, the light given back at other wavelengths is part of it"}});
}

/// The tables of one line, layer by layer.
void add_line_tables(const scene::Scene& scene, const LayerOptics& optics_of,
                     const optics::Library& library, Medium& medium, std::size_t l,
                     const std::vector<std::vector<double>>& coefficients) {
  for (std::size_t k = 0; k < scene.sea.layer.size(); ++k) {
    const auto& layer = scene.sea.layer[k];
    const WaterOptics water = optics_of(layer, medium.line[l].wavelength_nm);
    const double c = water.a_per_m + water.b_per_m;
    medium.c.push_back(c);
    medium.albedo.push_back(water.b_per_m / c);
    medium.conversion.push_back(l == 0 ? 0.0 : coefficients[l][k] / medium.c[k]);
    double emitted = 0;
    for (std::size_t other = 1; l == 0 && other < medium.line.size(); ++other)
      emitted += coefficients[other][k];
    if (emitted > water.a_per_m) give_back_too_much(layer, water.a_per_m, emitted);
    medium.absorption.push_back((water.a_per_m - emitted) / c);
    medium.elastic_phase.push_back(
        medium.add_phase(optics::PhaseTable(optics_of.phase(layer, water))));
    for (const auto& source : water.sources) {
      medium.sources.push_back(
          fmt::format("layer {} at {:.2f} nm: {}", k, medium.line[l].wavelength_nm, source));
    }
  }
  medium.conversion_phase.push_back(conversion_phase(medium, medium.line[l].process, library));
}

}  // namespace

bool counts(const scene::Channel& channel, const Line& line) {
  if (channel.process) return *channel.process == process_name(line.process);
  return std::abs(line.wavelength_nm - *channel.centre_nm) <= *channel.fwhm_nm / 2;
}

Medium build_medium(const scene::Scene& scene, const optics::Library& library) {
  const LayerOptics optics_of(scene, library);
  Medium medium;
  medium.top.push_back(0.0);
  for (const auto& layer : scene.sea.layer) {
    medium.top.push_back(layer.bottom_depth_m.value_or(std::numeric_limits<double>::infinity()));
  }
  medium.line.push_back(make_line(scene.sea, Process::elastic, scene.source.wavelength_nm));
  std::vector<std::vector<double>> coefficients(1);
  for (const auto& emission : emissions(scene, optics_of, library)) {
    add_lines(scene, emission, medium, coefficients);
  }
  for (std::size_t l = 0; l < medium.line.size(); ++l) {
    add_line_tables(scene, optics_of, library, medium, l, coefficients);
  }
  medium.finish();
  return medium;
}

}  // namespace photic::medium
