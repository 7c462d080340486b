#include "medium/build.hpp"

#include <fmt/format.h>

#include <limits>

#include "medium/environments.hpp"
#include "medium/layer_optics.hpp"
#include "optics/phase_functions.hpp"

namespace photic::medium {
namespace {

/// Of the lobe in which walks look for the laser's beam: as wide as light spreads in it.
constexpr double beam_lobe_g = 0.9;

std::int32_t conversion_phase(Medium& medium, Process process, const optics::Library& library) {
  if (process == Process::elastic) return 0;  // never used
  const bool is_raman = process == Process::raman;
  const auto shape = is_raman ? optics::raman_phase(library.raman.at("depolarisation").value)
                              : optics::isotropic();
  return medium.add_phase(optics::PhaseTable(shape));
}

/// The table of line l, layer by layer; line 0 is the laser's and emits into the others.
void add_line_tables(const scene::Scene& scene, const LayerOptics& optics_of,
                     const std::vector<EmittedLine>& emitted, std::size_t l, Medium& medium) {
  for (std::size_t k = 0; k < scene.sea.layer.size(); ++k) {
    const auto& layer = scene.sea.layer[k];
    const WaterOptics water = optics_of(layer, medium.line[l].wavelength_nm);
    const double c = water.a_per_m + water.b_per_m;
    medium.c.push_back(c);
    medium.albedo.push_back(water.b_per_m / c);
    medium.conversion.push_back(l == 0 ? 0.0 : emitted[l - 1].coefficient_per_m[k] / medium.c[k]);
    const double given_back = l == 0 ? emitted_per_m(emitted, scene, k, water.a_per_m) : 0.0;
    medium.absorption.push_back((water.a_per_m - given_back) / c);
    medium.elastic_phase.push_back(medium.add_phase(
        optics::PhaseTable(optics_of.phase(layer, medium.line[l].wavelength_nm, water))));
    for (const auto& source : sources_of(water)) {
      medium.sources.push_back(
          fmt::format("layer {} at {:.2f} nm: {}", k, medium.line[l].wavelength_nm, source));
    }
  }
}

}  // namespace

Medium build_medium(const scene::Scene& scene, const optics::Library& library) {
  const LayerOptics optics_of(scene, library);
  Medium medium;
  medium.top.push_back(0.0);
  std::vector<double> a_exciting_per_m;
  for (const auto& layer : scene.sea.layer) {
    medium.top.push_back(layer.bottom_depth_m.value_or(std::numeric_limits<double>::infinity()));
    a_exciting_per_m.push_back(optics_of(layer, scene.source.wavelength_nm).a_exciting_per_m);
  }
  medium.line.push_back(make_line(scene.sea, Process::elastic, scene.source.wavelength_nm));
  const auto emitted = emitted_lines(scene, library, a_exciting_per_m);
  for (const EmittedLine& line : emitted) {
    medium.line.push_back(make_line(scene.sea, line.process, line.wavelength_nm));
    medium.sources.insert(medium.sources.end(), line.sources.begin(), line.sources.end());
  }
  for (std::size_t l = 0; l < medium.line.size(); ++l) {
    add_line_tables(scene, optics_of, emitted, l, medium);
    medium.conversion_phase.push_back(conversion_phase(medium, medium.line[l].process, library));
  }
  if (medium.line.size() > 1)
    medium.beam_lobe = medium.add_phase(optics::PhaseTable(optics::henyey_greenstein(beam_lobe_g)));
  add_environments(scene, library, medium);
  const scene::Simulation& simulation = scene.simulation;
  if (simulation.estimator == "bidirectional")
    medium.finish(simulation.walk_attenuation);
  else if (simulation.estimator == "analog")
    medium.finish(Medium::analog_share);
  else
    medium.finish();
  return medium;
}

}  // namespace photic::medium
