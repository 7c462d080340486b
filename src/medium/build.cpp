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
#include "medium/phase_numbers.hpp"
#include "medium/surface.hpp"
#include "optics/phase_functions.hpp"
#include "scene/bed_albedo.hpp"

namespace photic::medium {
namespace {

/// The asymmetry of the lobe in which walks look for the laser's beam: as wide as light spreads in
/// it.
constexpr double beam_lobe_g = 0.9;
constexpr double infinity = std::numeric_limits<double>::infinity();

std::int32_t conversion_phase(Process process, const optics::Library& library,
                              const PhaseNumbers& number_of) {
  if (process == Process::elastic) return 0;  // never used
  const bool is_raman = process == Process::raman;
  return number_of(is_raman ? optics::raman_phase(library.raman.at("depolarisation").value)
                            : optics::isotropic());
}

/// The table of line l, layer by layer; line 0 is the laser's and emits into the others.
void add_line_tables(const scene::Scene& scene, const LayerOptics& optics_of,
                     const std::vector<EmittedLine>& emitted, std::size_t l,
                     const PhaseNumbers& number_of, Medium& medium) {
  const auto layers = scene::layers_of(scene.sea);
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const scene::Layer& layer = layers[k].layer;
    const WaterOptics water = optics_of(layer, medium.line[l].wavelength_nm);
    const double c = water.a_per_m + water.b_per_m;
    medium.c.push_back(c);
    medium.albedo.push_back(water.albedo());
    medium.conversion.push_back(l == 0 ? 0.0 : emitted[l - 1].coefficient_per_m[k] / medium.c[k]);
    const double given_back = l == 0 ? emitted_per_m(emitted, scene, k, water.a_per_m) : 0.0;
    medium.absorption.push_back((water.a_per_m - given_back) / c);
    medium.elastic_phase.push_back(
        number_of(optics_of.phase(layer, medium.line[l].wavelength_nm, water)));
    for (const Contribution& each : water.contributions)
      add_source(each, medium.line[l].wavelength_nm, medium.sources);
  }
}

/// The faces of the scene's columns, and which layers are theirs.
Row row_of(const scene::Sea& sea) {
  Row row;
  if (sea.column.empty()) return row;
  row.first_layer.clear();
  row.face_m = {sea.column.front().x_min_m.value_or(-infinity)};
  std::int32_t layer = 0;
  for (const scene::Column& column : sea.column) {
    row.first_layer.push_back(layer);
    row.face_m.push_back(column.x_max_m.value_or(infinity));
    layer += static_cast<std::int32_t>(column.layer.size());
  }
  row.y_min_m = sea.y_min_m.value_or(-infinity);
  row.y_max_m = sea.y_max_m.value_or(infinity);
  return row;
}

}  // namespace

Medium build_medium(const scene::Scene& scene, const optics::Library& library,
                    const std::stop_token& stop, optics::Phases phases) {
  const LayerOptics optics_of(scene, library, stop);
  Medium medium;
  const PhaseNumbers number_of(*library.phases, phases, medium);
  medium.row = row_of(scene.sea);
  const double laser_nm = scene.source.wavelength_nm;
  std::vector<WaterOptics> at_laser;
  const auto layers = scene::layers_of(scene.sea);
  for (const scene::PlacedLayer& at : layers) {
    medium.top.push_back(at.top_m);
    at_laser.push_back(optics_of(at.layer, laser_nm));
    std::vector<std::pair<std::string, double>> a_per_m;
    for (const Contribution& each : at_laser.back().contributions)
      a_per_m.emplace_back(each.name, each.a_per_m.value_or(0));
    medium.absorbers.add(at.name, a_per_m);
  }
  medium.top.push_back(layers.back()->bottom_depth_m.value_or(infinity));
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
  for (const auto& [bed, path] : scene::beds_of(scene.sea, scene.bottom))
    for (const Line& line : medium.line)
      if (bed)
        add_source("albedo of the sea bed", scene::reported_albedo(*bed), line.wavelength_nm,
                   medium.sources);
  for (std::size_t l = 0; l < medium.line.size(); ++l) {
    add_line_tables(scene, optics_of, light.lines, l, number_of, medium);
    medium.conversion_phase.push_back(conversion_phase(medium.line[l].process, library, number_of));
  }
  if (medium.line.size() > 1) medium.beam_lobe = number_of(optics::henyey_greenstein(beam_lobe_g));
  const bool is_wanted = phases == optics::Phases::wanted;
  if (is_wanted) {
    add_bed(scene, medium);
    add_surface(scene, library, medium);
    if (oil) add_film(scene, *oil, medium);
  }
  add_environments(scene, library, number_of, medium, stop);
  add_surfaces_of_environments(scene, medium);
  add_films_of_environments(scene, library, medium, stop);
  if (!is_wanted) return medium;
  fill_film_tables(medium, stop);
  medium.finish();
  return medium;
}

}  // namespace photic::medium
