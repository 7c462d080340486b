#include "medium/build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "medium/bed.hpp"
#include "medium/environments.hpp"
#include "medium/film.hpp"
#include "medium/layer_optics.hpp"
#include "medium/surface.hpp"
#include "optics/phase_functions.hpp"
#include "scene/bed_albedo.hpp"

namespace photic::medium {
namespace {

/// The asymmetry of the lobe in which walks look for the laser's beam: as wide as light spreads in
/// it.
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
    medium.albedo.push_back(water.albedo());
    medium.conversion.push_back(l == 0 ? 0.0 : emitted[l - 1].coefficient_per_m[k] / medium.c[k]);
    const double given_back = l == 0 ? emitted_per_m(emitted, scene, k, water.a_per_m) : 0.0;
    medium.absorption.push_back((water.a_per_m - given_back) / c);
    medium.elastic_phase.push_back(medium.add_phase(
        optics::PhaseTable(optics_of.phase(layer, medium.line[l].wavelength_nm, water))));
    for (const Contribution& each : water.contributions)
      add_source(each, medium.line[l].wavelength_nm, medium.sources);
  }
}

}  // namespace

Medium build_medium(const scene::Scene& scene, const optics::Library& library) {
  const LayerOptics optics_of(scene, library);
  Medium medium;
  medium.top.push_back(0.0);
  const double laser_nm = scene.source.wavelength_nm;
  std::vector<WaterOptics> at_laser;
  for (const auto& layer : scene.sea.layer) {
    medium.top.push_back(layer.bottom_depth_m.value_or(std::numeric_limits<double>::infinity()));
    at_laser.push_back(optics_of(layer, laser_nm));
    std::vector<std::pair<std::string, double>> a_per_m;
    for (const Contribution& each : at_laser.back().contributions)
      a_per_m.emplace_back(each.name, each.a_per_m.value_or(0));
    medium.absorbers.add(layer.name, a_per_m);
  }
  medium.line.push_back(make_line(scene.sea, Process::elastic, laser_nm));
  medium.line.front().counted_by = counted_by(scene, filters_of(scene), Process::elastic, laser_nm);
  auto light = emitted_light(scene, library, at_laser);
  const auto oil = oil_of(scene, library);
  if (oil) std::ranges::move(oil_lines(scene, *oil), std::back_inserter(light.lines));
  for (const EmittedLine& emitted : light.lines) {
    Line line = make_line(scene.sea, emitted.process, emitted.wavelength_nm);
    line.photons = emitted.photons;
    line.lifetime_ns = emitted.process == Process::oil ? oil->lifetime_ns
                                                       : lifetime_ns(scene.optics, emitted.process);
    line.counted_by = emitted.counted_by;
    medium.line.push_back(std::move(line));
  }
  for (const EmissionSource& of : light.sources)
    for (const double nm : {of.first_nm, of.last_nm})
      add_source(fmt::format("{} light", scene::word_of(of.process)), of.source, nm,
                 medium.sources);
  if (scene.bottom)
    for (const Line& line : medium.line)
      add_source("albedo of the sea bed", scene::reported_albedo(*scene.bottom), line.wavelength_nm,
                 medium.sources);
  for (std::size_t l = 0; l < medium.line.size(); ++l) {
    add_line_tables(scene, optics_of, light.lines, l, medium);
    medium.conversion_phase.push_back(conversion_phase(medium, medium.line[l].process, library));
  }
  if (medium.line.size() > 1)
    medium.beam_lobe = medium.add_phase(optics::PhaseTable(optics::henyey_greenstein(beam_lobe_g)));
  add_bed(scene, medium);
  add_surface(scene, library, medium);
  if (oil) add_film(scene, *oil, medium);
  add_environments(scene, library, medium);
  add_surfaces_of_environments(scene, medium);
  add_films_of_environments(scene, library, medium);
  medium.finish();
  return medium;
}

}  // namespace photic::medium
