#include "medium/lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "optics/data_table.hpp"
#include "optics/fluorescence.hpp"
#include "optics/raman.hpp"
#include "optics/refractive_index.hpp"

namespace photic::medium {
namespace {

void check_number(const std::vector<BandLine>& lines, Process process) {
  constexpr std::size_t most = spectral_bins / 2;
  if (lines.size() <= most) return;
  throw InputError({{"", 0, 0,
                     fmt::format("the channels' filters cut {} light into {} lines, more than {}",
                                 scene::word_of(process), lines.size(), most),
                     "take fewer filters, or filters whose edges coincide"}});
}

/// A process of a scene's water: what it emits per photon and metre, and so many photons and metres
/// by layer.
struct Emitter {
  Process process;
  optics::Emission emission;
  std::vector<double> photons_per_m;
};

std::vector<Emitter> emitters_of(const scene::Scene& scene, const optics::Library& library,
                                 const std::vector<WaterOptics>& at_laser) {
  const double laser_nm = scene.source.wavelength_nm;
  const scene::Optics& choice = scene.optics;
  const auto layers = scene::layers_of(scene.sea);
  std::vector<double> by_chlorophyll, by_cdom;
  for (std::size_t k = 0; k < at_laser.size(); ++k) {
    by_chlorophyll.push_back(at_laser[k].a_exciting_per_m * layers[k]->chlorophyll_yield);
    by_cdom.push_back(at_laser[k].a_cdom_per_m);
  }
  std::vector<Emitter> out{
      {Process::raman, optics::raman(library, choice.raman, laser_nm),
       std::vector(at_laser.size(), 1.0)},
      {Process::chlorophyll,
       optics::chlorophyll_fluorescence(library, laser_nm, choice.chlorophyll_share_730),
       by_chlorophyll}};
  if (std::ranges::any_of(by_cdom, [](double a) { return a > 0; }))
    out.push_back({Process::cdom, cdom_emission(scene, library), by_cdom});
  for (Emitter& emitter : out) {
    if (const double lifetime = lifetime_ns(choice, emitter.process); lifetime > 0)
      emitter.emission.source += fmt::format("; lifetime {:g} ns, given in the scene", lifetime);
  }
  return out;
}

/// The lines of an emitter's light that some channel counts.
std::vector<BandLine> lines_of(const Emitter& emitter, const scene::Scene& scene,
                               const std::vector<std::optional<Filter>>& filters) {
  const optics::Emission& emission = emitter.emission;
  if (emission.line && scene.optics.emission == scene::Emission::lines) {
    const double nm = emission.line->wavelength_nm;
    auto counted = counted_by(scene, filters, emitter.process, nm);
    if (std::ranges::all_of(counted, [](double share) { return share == 0; })) return {};
    return {{nm, emission.line->coefficient, std::move(counted)}};
  }
  return medium::lines_of(emitter.process, emission.spectrum, scene);
}

}  // namespace

std::vector<BandLine> lines_of(Process process, const optics::EmissionSpectrum& spectrum,
                               const scene::Scene& scene) {
  std::vector<bool> counts_all;
  for (const auto& channel : scene.channel) counts_all.push_back(channel.process == process);
  auto lines = cut_into_lines(spectrum, counts_all, filters_of(scene));
  check_number(lines, process);
  return lines;
}

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

double lifetime_ns(const scene::Optics& optics, Process process) {
  return process == Process::chlorophyll ? optics.chlorophyll_lifetime_ns
         : process == Process::cdom      ? optics.cdom_lifetime_ns
                                         : 0.0;
}

std::vector<double> counted_by(const scene::Scene& scene,
                               const std::vector<std::optional<Filter>>& filters, Process process,
                               double wavelength_nm) {
  std::vector<double> out;
  for (std::size_t c = 0; c < filters.size(); ++c) {
    const bool whole = scene.channel[c].process == process;
    out.push_back(filters[c] ? filters[c]->transmission(wavelength_nm) : whole ? 1 : 0);
  }
  return out;
}

optics::Emission cdom_emission(const scene::Scene& scene, const optics::Library& library) {
  const double laser_nm = scene.source.wavelength_nm;
  if (scene.optics.cdom_fluorescence != scene::CdomFluorescence::table)
    return optics::cdom_fluorescence(library, laser_nm);
  return optics::cdom_fluorescence(scene.optics.cdom_fluorescence_table.data(), laser_nm);
}

EmittedLight emitted_light(const scene::Scene& scene, const optics::Library& library,
                           const std::vector<WaterOptics>& at_laser) {
  const auto filters = filters_of(scene);
  EmittedLight light;
  for (const Emitter& emitter : emitters_of(scene, library, at_laser)) {
    const auto& by_layer = emitter.photons_per_m;
    if (std::ranges::all_of(by_layer, [](double a) { return a == 0; })) continue;
    const auto lines = lines_of(emitter, scene, filters);
    if (lines.empty()) continue;
    for (const BandLine& line : lines) {
      EmittedLine out{emitter.process, line.wavelength_nm, {}, line.counted_by, line.photons};
      for (const double a : by_layer) out.coefficient_per_m.push_back(a * line.photons);
      light.lines.push_back(std::move(out));
    }
    double photons = 0;
    for (const auto& line : lines) photons += line.photons;
    for (std::size_t k = 0; k < by_layer.size(); ++k) {
      if (by_layer[k] > 0)
        light.sources.push_back({emitter.process, k, lines.front().wavelength_nm,
                                 lines.back().wavelength_nm, photons * by_layer[k],
                                 emitter.emission.source});
    }
  }
  return light;
}

double emitted_per_m(const std::vector<EmittedLine>& lines, const scene::Scene& scene,
                     std::size_t layer, double a_per_m) {
  double sum = 0;
  for (const EmittedLine& line : lines) sum += line.coefficient_per_m[layer];
  if (sum <= a_per_m) return sum;
  const auto layers = scene::layers_of(scene.sea);
  const scene::PlacedLayer& l = layers[layer];
  throw InputError(
      {{"", 0, 0,
        fmt::format("layer \"{}\" emits more Raman and fluorescence light ({:.3g} 1/m) than it "
                    "absorbs ({:.3g} 1/m)",
                    l.name, sum, a_per_m),
        l->iop.empty() ? "choose other data in [optics], or give the layer's iop"
                       : "a is the total absorption, and includes the light that is emitted at "
                         "other wavelengths"}});
}

}  // namespace photic::medium
