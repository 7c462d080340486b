#include "medium/optical_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/constants.hpp"
#include "medium/layer_optics.hpp"
#include "medium/lines.hpp"
#include "medium/optical_parts.hpp"
#include "optics/phase_table.hpp"

namespace photic::medium {
namespace {

/// Ascending, each once.
void sort_each_once(std::vector<double>& values) {
  std::ranges::sort(values);
  const auto repeated = std::ranges::unique(values);
  values.erase(repeated.begin(), repeated.end());
}

void add_phase(const optics::PhaseTable& phase, OpticalTable& table) {
  table.backscatter_fraction.push_back(phase.backscatter_fraction());
  table.mean_cosine.push_back(phase.mean_cosine());
  for (const double angle : table.angle_deg)
    table.phase_function_per_sr.push_back(phase.view().value<double>(x_of_angle(angle)));
}

/// The optics of all layers at the laser's wavelength.
std::vector<WaterOptics> at_laser(const scene::Scene& scene, const LayerOptics& optics_of) {
  std::vector<WaterOptics> out;
  for (const scene::PlacedLayer& at : scene::layers_of(scene.sea))
    out.push_back(optics_of(at.layer, scene.source.wavelength_nm));
  return out;
}

/// The light of one process in all layers.
OpticalTable::Emission emission_of(Process process, const EmittedLight& light, std::size_t layers) {
  OpticalTable::Emission out{scene::word_of(process), {}, {}, std::vector(layers, 0.0), {}};
  std::vector<const EmittedLine*> lines;
  for (const EmittedLine& line : light.lines)
    if (line.process == process) lines.push_back(&line);
  for (const EmittedLine* line : lines) out.wavelength_nm.push_back(line->wavelength_nm);
  for (std::size_t k = 0; k < layers; ++k)
    for (const EmittedLine* line : lines) {
      out.line_per_m.push_back(line->coefficient_per_m[k]);
      out.coefficient_per_m[k] += line->coefficient_per_m[k];
    }
  for (const EmissionSource& from : light.sources) {
    if (from.process == process && std::ranges::find(out.sources, from.source) == out.sources.end())
      out.sources.push_back(from.source);
  }
  return out;
}

/// The emission of all inelastic processes, even if no channel counts their light.
std::vector<OpticalTable::Emission> emission_in(scene::Scene scene, const optics::Library& library,
                                                const LayerOptics& optics_of) {
  constexpr std::array processes{Process::raman, Process::chlorophyll, Process::cdom};
  scene.channel.clear();
  for (const Process process : processes) {
    scene.channel.emplace_back();
    scene.channel.back().process = process;
  }
  const auto light = emitted_light(scene, library, at_laser(scene, optics_of));
  std::vector<OpticalTable::Emission> out;
  for (const Process process : processes)
    out.push_back(emission_of(process, light, scene::layers_of(scene.sea).size()));
  return out;
}

}  // namespace

std::vector<double> OpticalTable::c_per_m() const {
  std::vector<double> c = a_per_m;
  for (std::size_t i = 0; i < c.size(); ++i) c[i] += b_per_m[i];
  return c;
}

std::vector<double> OpticalTable::bb_per_m() const {
  std::vector<double> bb = b_per_m;
  for (std::size_t i = 0; i < bb.size(); ++i) bb[i] *= backscatter_fraction[i];
  return bb;
}

std::vector<double> OpticalTable::albedo() const {
  std::vector<double> albedo = c_per_m();
  for (std::size_t i = 0; i < albedo.size(); ++i) albedo[i] = b_per_m[i] / albedo[i];
  return albedo;
}

double x_of_angle(double angle_deg) {
  const double half = std::sin(angle_deg * radian_per_degree / 2);
  return 2 * half * half;
}

std::vector<double> table_angles_deg() {
  std::vector<double> angles = {0};
  for (int k = -20; k <= 10; ++k) angles.push_back(std::pow(10, k / 10.0));
  for (int angle = 15; angle <= 180; angle += 5) angles.push_back(angle);
  return angles;
}

std::vector<double> wavelengths_of_light(const scene::Scene& scene,
                                         const optics::Library& library) {
  const LayerOptics optics_of(scene, library);
  const auto light = emitted_light(scene, library, at_laser(scene, optics_of));
  std::map<Process, std::pair<double, double>> sums;  // of photons, and of their wavelengths
  for (const EmittedLine& line : light.lines) {
    sums[line.process].first += line.photons;
    sums[line.process].second += line.photons * line.wavelength_nm;
  }
  std::vector<double> nm = {scene.source.wavelength_nm};
  for (const auto& [process, sum] : sums) nm.push_back(sum.second / sum.first);
  sort_each_once(nm);
  return nm;
}

OpticalTable optical_table(const scene::Scene& scene, const optics::Library& library,
                           const std::vector<double>& wavelength_nm) {
  const LayerOptics optics_of(scene, library);
  OpticalTable table;
  table.wavelength_nm = wavelength_nm;
  table.angle_deg = table_angles_deg();
  table.in_columns = !scene.sea.column.empty();
  WatersOptics waters;
  Backscattering backscattering_in(optics_of, *library.phases);
  std::vector<BackscatteringByName> backscattering;
  for (const scene::PlacedLayer& at : scene::layers_of(scene.sea)) {
    const scene::Layer& layer = at.layer;
    table.layer_name.push_back(at.name);
    table.first_m.push_back(at.top_m);
    table.last_m.push_back(layer.bottom_depth_m.value_or(std::numeric_limits<double>::infinity()));
    for (const double nm : wavelength_nm) {
      waters.push_back(optics_of(layer, nm));
      backscattering.push_back(backscattering_in(layer, nm, waters.back()));
      table.a_per_m.push_back(waters.back().a_per_m);
      table.b_per_m.push_back(waters.back().b_per_m);
      table.a_exciting_per_m.push_back(waters.back().a_exciting_per_m);
      add_phase(*(*library.phases)(optics_of.phase(layer, nm, waters.back())), table);
      for (const Contribution& each : waters.back().contributions)
        add_source(each, nm, table.sources);
    }
  }
  table.parts = parts_of(waters, backscattering);
  table.excitation_nm = scene.source.wavelength_nm;
  table.emission = emission_in(scene, library, optics_of);
  return table;
}

}  // namespace photic::medium
