#include "medium/lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "optics/fluorescence.hpp"
#include "optics/raman.hpp"
#include "optics/refractive_index.hpp"

namespace photic::medium {
namespace {

/// Whether some channel asks for a process, or might see it through its filter.
bool asked_for(const scene::Scene& scene, const Line& line) {
  return std::any_of(scene.channel.begin(), scene.channel.end(),
                     [&](const scene::Channel& channel) { return counts(channel, line); });
}

/// Adds what a layer emits by a process, where a channel counts it.
void add(const scene::Scene& scene, std::size_t layer, Process process,
         const optics::Emission& emission, std::vector<EmittedLine>& lines) {
  for (const auto& emitted : emission.lines) {
    const double nm = emitted.wavelength_nm;
    if (!asked_for(scene, {process, nm, 1, 1})) continue;
    auto line = std::find_if(lines.begin(), lines.end(), [&](const EmittedLine& l) {
      return l.process == process && l.wavelength_nm == nm;
    });
    if (line == lines.end())
      line = lines.insert(line, {process, nm, std::vector(scene.sea.layer.size(), 0.0), {}});
    line->coefficient_per_m[layer] = emitted.coefficient_per_m;
    line->sources.push_back(fmt::format("layer {}: {} light at {:.2f} nm = {:.5g} 1/m: {}", layer,
                                        process_name(process), nm, emitted.coefficient_per_m,
                                        emission.source));
  }
}

}  // namespace

double refractive_index(const scene::Sea& sea, double wavelength_nm) {
  return sea.refractive_index
             ? *sea.refractive_index
             : optics::refractive_index(wavelength_nm, sea.salinity_psu, sea.temperature_c);
}

Line make_line(const scene::Sea& sea, Process process, double wavelength_nm) {
  Line line;
  line.process = process;
  line.wavelength_nm = wavelength_nm;
  line.refractive_index = refractive_index(sea, wavelength_nm);
  line.group_index = sea.group_index
                         ? *sea.group_index
                         : optics::group_index(wavelength_nm, sea.salinity_psu, sea.temperature_c);
  return line;
}

bool counts(const scene::Channel& channel, const Line& line) {
  if (channel.process) return *channel.process == process_name(line.process);
  return std::abs(line.wavelength_nm - *channel.centre_nm) <= *channel.fwhm_nm / 2;
}

std::vector<ProcessEmission> emissions(const scene::Scene& scene, const optics::Library& library,
                                       const scene::Layer& layer, double a_exciting_per_m) {
  const double laser_nm = scene.source.wavelength_nm;
  return {
      {Process::raman, optics::raman(library, scene.optics.raman, laser_nm)},
      {Process::chlorophyll, optics::chlorophyll_fluorescence(library, laser_nm, a_exciting_per_m,
                                                              layer.chlorophyll_yield)}};
}

std::vector<EmittedLine> emitted_lines(const scene::Scene& scene, const optics::Library& library,
                                       const std::vector<double>& a_exciting_per_m) {
  const auto& layers = scene.sea.layer;
  std::vector<std::vector<ProcessEmission>> of_layer;
  for (std::size_t k = 0; k < layers.size(); ++k)
    of_layer.push_back(emissions(scene, library, layers[k], a_exciting_per_m[k]));
  std::vector<EmittedLine> lines;  // by process first, whatever layer emits it
  for (std::size_t p = 0; !of_layer.empty() && p < of_layer.front().size(); ++p) {
    for (std::size_t k = 0; k < layers.size(); ++k)
      add(scene, k, of_layer[k][p].process, of_layer[k][p].emission, lines);
  }
  return lines;
}

double emitted_per_m(const std::vector<EmittedLine>& lines, const scene::Scene& scene,
                     std::size_t layer, double a_per_m) {
  double sum = 0;
  for (const EmittedLine& line : lines) sum += line.coefficient_per_m[layer];
  if (sum <= a_per_m) return sum;
  const scene::Layer& l = scene.sea.layer[layer];
  throw InputError(
      {{"", 0, 0,
        fmt::format("layer \"{}\" emits more Raman and fluorescence light ({:.3g} 1/m) than it "
                    "absorbs ({:.3g} 1/m)",
                    l.name, sum, a_per_m),
        l.iop.empty() ? "choose other data in [optics], or give the layer's iop"
                      : "a is the total absorption, the light given back at other wavelengths is "
                        "part of it"}});
}

}  // namespace photic::medium
