#include "medium/air.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "core/interpolation.hpp"
#include "core/stop.hpp"
#include "medium/air_profile.hpp"
#include "medium/bent_axis.hpp"
#include "medium/layer_optics.hpp"
#include "optics/air_molecules.hpp"
#include "optics/phase_functions.hpp"

namespace photic::medium {
namespace {

/// Optical depth of each layer.
std::vector<double> depths_of(const optics::AirOptics& air) {
  std::vector<double> out;
  for (const optics::AirLayer& layer : air.layers)
    out.push_back((layer.a_per_m() + layer.b_per_m()) * (layer.top_km - layer.bottom_km) *
                  metre_per_km);
  return out;
}

/// Halfway between the edges.
std::vector<double> middles_km(const optics::AirProfile& profile) {
  std::vector<double> out;
  for (std::size_t i = 1; i < profile.edges_km.size(); ++i)
    out.push_back((profile.edges_km[i - 1] + profile.edges_km[i]) / 2);
  return out;
}

/// The middles of layers that are too thick.
std::vector<double> too_thick(const optics::AirLibrary& library, const optics::AirProfile& profile,
                              const optics::AerosolChoice& aerosols, double laser_nm,
                              const std::stop_token& stop) {
  const std::vector<double> middles = middles_km(profile);
  const auto depths = depths_of(optics::air_at(library, with_edges(profile, middles), aerosols,
                                               laser_nm, optics::Phases::left_out, stop));
  std::vector<double> out;
  for (std::size_t k = 0; k < middles.size(); ++k) {
    const double lower = depths[2 * k], upper = depths[2 * k + 1];
    if (std::abs(lower - upper) / 2 > air_depth_tolerance * std::max(1.0, lower + upper))
      out.push_back(middles[k]);
  }
  return out;
}

/// Spreads the absorption by other gases evenly between rungs.
void add_gases(const scene::Atmosphere& air, double wavelength_nm, optics::AirOptics& to) {
  if (air.gases.empty()) return;
  std::vector<double> rung_km{0}, depths{0};
  for (const scene::AirGases& rung : air.gases) rung_km.push_back(rung.top_km);
  std::ranges::copy(gas_depths(air, wavelength_nm), std::back_inserter(depths));
  rung_km.push_back(std::max(air.top_km, rung_km.back() + 1));  // above the last there are none
  depths.push_back(depths.back());
  const LinearTable up_to(rung_km, depths);
  for (optics::AirLayer& layer : to.layers)
    layer.gases_a_per_m = (up_to(layer.top_km) - up_to(layer.bottom_km)) /
                          (metre_per_km * (layer.top_km - layer.bottom_km));
  to.gases_source = "given in the scene";
}

void add_sources(const optics::AirOptics& at, double nm, std::vector<Source>& sources) {
  add_source("profile of the air", at.profile_source, nm, sources);
  add_source("b of the air's molecules", at.molecules_source, nm, sources);
  add_source("a of ozone", at.ozone_source, nm, sources);
  add_source("a of other gases", at.gases_source, nm, sources);
  add_source("a and b of aerosols", at.aerosols_source, nm, sources);
  add_source("refractive index of the air", optics::air_index_source, nm, sources);
}

AirDepths depths_by_part(const optics::AirOptics& air) {
  AirDepths out;
  for (const optics::AirLayer& layer : air.layers) {
    const double thickness_m = (layer.top_km - layer.bottom_km) * metre_per_km;
    out.gases += layer.gases_a_per_m * thickness_m;
    out.molecules += layer.molecules_b_per_m * thickness_m;
    out.ozone += layer.ozone_a_per_m * thickness_m;
    out.aerosols += (layer.aerosols_a_per_m + layer.aerosols_b_per_m) * thickness_m;
  }
  return out;
}

/// Lines one behind the other that share phase functions, those of a wavelength.
struct SharedPhases {
  std::size_t first = 0, end = 0;
  double wavelength_nm = 0;
};

/// Phase functions that are given outright are the same at all wavelengths.
bool same_at_all_wavelengths(const scene::Atmosphere& air) {
  return !air.layer.empty() && std::ranges::all_of(air.layer, [](const scene::AirLayer& layer) {
    return layer.phase_function.has_value();
  });
}

std::vector<SharedPhases> shared_phases(const scene::Atmosphere& air,
                                        const std::vector<Line>& lines) {
  if (same_at_all_wavelengths(air)) return {{0, lines.size(), lines.front().wavelength_nm}};
  std::vector<SharedPhases> out;
  for (std::size_t first = 0, end = 1; first < lines.size(); first = end++) {
    const Line& from = lines[first];
    while (end < lines.size() && lines[end].process == from.process &&
           lines[end].wavelength_nm - from.wavelength_nm <= air_phases_apart_nm)
      ++end;
    double photons = 0, photons_nm = 0;
    for (std::size_t l = first; l < end; ++l) {
      photons += lines[l].photons;
      photons_nm += lines[l].photons * lines[l].wavelength_nm;
    }
    const bool alone = end == first + 1 || photons == 0;
    out.push_back({first, end, alone ? from.wavelength_nm : photons_nm / photons});
  }
  return out;
}

/// "0 to 1.5 km", or the layer's own name.
std::string name_of_layer(const scene::Atmosphere& air, std::size_t k,
                          const optics::AirLayer& layer) {
  if (!air.layer.empty()) return air.layer[k].name;
  return fmt::format("{:.4g} to {:.4g} km", layer.bottom_km, layer.top_km);
}

Absorbers absorbers_of(const scene::Atmosphere& air, const optics::AirOptics& at_source) {
  const char* aerosols = air.layer.empty() ? "aerosols" : "";  // they stand for all there is
  Absorbers out;
  for (std::size_t k = 0; k < at_source.layers.size(); ++k) {
    const optics::AirLayer& layer = at_source.layers[k];
    out.add(name_of_layer(air, k, layer), {{"ozone", layer.ozone_a_per_m},
                                           {"gases", layer.gases_a_per_m},
                                           {aerosols, layer.aerosols_a_per_m}});
  }
  return out;
}

void add_coefficients(const optics::AirOptics& of, Air& air) {
  for (const optics::AirLayer& layer : of.layers) {
    air.a.push_back(layer.a_per_m());
    air.b.push_back(layer.b_per_m());
    air.refractive_index.push_back(layer.refractive_index);
    air.group_index.push_back(layer.group_index);
  }
}

AirPhases phases_of_all(const optics::AirOptics& air) {
  AirPhases out;
  for (const optics::AirLayer& layer : air.layers) {
    out.b.push_back(layer.b_per_m());
    out.scatterers.push_back(layer.scatterers);
  }
  return out;
}

}  // namespace

std::shared_ptr<const optics::PhaseTable> Air::phase(std::size_t place, std::size_t layer) const {
  return (*tables)(optics::phase_of(phases[place].scatterers[layer]));
}

double Air::optical_depth(std::size_t line) const {
  double depth = 0;
  for (std::size_t k = 0; k < layers(); ++k) {
    const std::size_t at = line * layers() + k;
    depth += (a[at] + b[at]) * (height_m[k + 1] - height_m[k]);
  }
  return depth;
}

AirBuilder::AirBuilder(const scene::Scene& scene, const optics::Library& library,
                       const std::vector<Line>& lines, std::stop_token stop)
    : library_(library), lines_(lines), stop_(std::move(stop)) {
  const scene::Atmosphere& air = *scene.atmosphere;
  if (!air.layer.empty()) return;
  for (;;) {
    auto more = too_thick(library.air(), in_layers(air), aerosols_of(air),
                          lines.front().wavelength_nm, stop_);
    if (more.empty()) return;
    halved_km_.push_back(std::move(more));
  }
}

Air AirBuilder::operator()(const scene::Scene& scene) const {
  const bool outright = !scene.atmosphere->layer.empty();
  Air air;
  air.tables = library_.phases;
  for (const SharedPhases& of : shared_phases(*scene.atmosphere, lines_)) {
    const auto there = at(scene, of.wavelength_nm, optics::Phases::wanted);
    for (std::size_t l = of.first; l < of.end; ++l) {
      const double nm = lines_[l].wavelength_nm;
      const auto here = nm == of.wavelength_nm ? there : at(scene, nm, optics::Phases::left_out);
      add_coefficients(here, air);
      air.phases_of.push_back(air.phases.size());
      if (outright)
        add_source("a and b of the air", here.profile_source, nm, air.sources);
      else
        add_sources(here, nm, air.sources);
    }
    if (of.first == 0) air.absorbers = absorbers_of(*scene.atmosphere, there);
    if (of.first == 0 && !outright) {
      air.depths = depths_by_part(there);
      air.depths->aerosols_550 = optics::aerosol_depth(in_layers(*scene.atmosphere));
    }
    air.phases.push_back(phases_of_all(there));
  }
  air.height_m.push_back(0);
  if (outright)
    for (const auto& layer : scene.atmosphere->layer) air.height_m.push_back(layer.top_height_m);
  else
    for (const double km : in_layers(*scene.atmosphere).edges_km)
      if (km > 0) air.height_m.push_back(km * metre_per_km);
  return air;
}

optics::AirOptics AirBuilder::at(const scene::Scene& scene, double wavelength_nm,
                                 optics::Phases phases) const {
  break_off_if(stop_);
  const scene::Atmosphere& atmosphere = *scene.atmosphere;
  if (!atmosphere.layer.empty()) return of_layers(scene, wavelength_nm);
  auto air = optics::air_at(library_.air(), in_layers(atmosphere), aerosols_of(atmosphere),
                            wavelength_nm, phases, stop_);
  add_gases(atmosphere, wavelength_nm, air);
  return air;
}

optics::AirProfile AirBuilder::in_layers(const scene::Atmosphere& air) const {
  auto profile = profile_to_top(air, whole_profile(air, library_.air()));
  std::vector<double> rungs_km;
  for (const scene::AirGases& rung : air.gases) rungs_km.push_back(rung.top_km);
  profile = with_edges(std::move(profile), rungs_km);
  for (const auto& more : halved_km_) profile = with_edges(std::move(profile), more);
  return as_deep_as_given(air, std::move(profile));
}

optics::AirOptics AirBuilder::of_layers(const scene::Scene& scene, double wavelength_nm) const {
  const LayerOptics optics_of(scene, library_, stop_);
  optics::AirOptics air;
  air.depolarisation = optics::air_depolarisation(wavelength_nm);
  air.profile_source = "given in the scene";
  for (const scene::AirLayer& of : scene.atmosphere->layer) {
    const WaterOptics here = optics_of(as_layer(of), wavelength_nm);
    optics::AirLayer layer;
    layer.bottom_km = of.bottom_height_m / metre_per_km;
    layer.top_km = of.top_height_m / metre_per_km;
    layer.refractive_index = of.refractive_index;
    layer.group_index = of.refractive_index;  // as if it were alike at all wavelengths
    layer.aerosols_a_per_m = here.a_per_m;
    layer.aerosols_b_per_m = here.b_per_m;
    layer.phase = of.phase_function ? optics_of.shape(*of.phase_function, wavelength_nm)
                                    : optics::rayleigh(air.depolarisation);
    layer.scatterers = {{here.b_per_m, layer.phase}};
    air.layers.push_back(std::move(layer));
  }
  return air;
}

std::optional<Air> build_air(const scene::Scene& scene, const optics::Library& library,
                             const std::vector<Line>& lines, const std::stop_token& stop) {
  if (!scene.atmosphere) return std::nullopt;
  return AirBuilder(scene, library, lines, stop)(scene);
}

std::vector<std::string> reported_air(const scene::Scene& scene, const Air& air) {
  const scene::Atmosphere& of = *scene.atmosphere;
  const double nm = scene.source.wavelength_nm, top_km = air.height_m.back() / metre_per_km;
  std::string what = "of the scene's own";
  if (of.layer.empty()) {
    const auto* name = std::get_if<std::string>(&of.profile);
    what = name ? "of the profile " + *name : "of the scene's own profile";
  }
  std::vector<std::string> out{fmt::format("{} layers {}, up to {:.6g} km; above them a vacuum",
                                           air.layers(), what, top_km)};
  if (of.refraction && scene.source.position_m.z >= 0) {
    const auto axis = normalised(scene.source.direction);
    const auto bent = bent_axis(air, scene.source.position_m.z, -axis.z);
    out.push_back(fmt::format(
        "refraction bends the laser's axis by {:.3g} urad; it meets the sea {:.3g} m from where a "
        "straight one would",
        1e6 * std::abs(std::acos(bent.cosine) - std::acos(-axis.z)),
        std::abs(bent.aside_m - scene.source.position_m.z * std::hypot(axis.x, axis.y) / -axis.z)));
  }
  if (!air.depths) {
    out.push_back(fmt::format("optical depth at {:.6g} nm from the sea to the top: {:.4g}", nm,
                              air.optical_depth(0)));
    return out;
  }
  const std::string gases =
      of.gases.empty() ? "" : fmt::format("other gases {:.4g}, ", air.depths->gases);
  out.push_back(fmt::format(
      "optical depth at {:.6g} nm from the sea to the top: {:.4g}, of which molecules {:.4g}, "
      "ozone {:.4g}, {}aerosols {:.4g}",
      nm, air.optical_depth(0), air.depths->molecules, air.depths->ozone, gases,
      air.depths->aerosols));
  if (of.has_aerosols())
    out.push_back(
        fmt::format("optical depth of the aerosols at 550 nm: {:.7g}", air.depths->aerosols_550));
  if (of.gases.empty())
    out.emplace_back(
        "left out: the absorption lines of water vapour, oxygen, carbon dioxide and other gases");
  return out;
}

}  // namespace photic::medium
