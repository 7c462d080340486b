#include "medium/air.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "medium/layer_optics.hpp"
#include "optics/air_molecules.hpp"
#include "optics/data_folder.hpp"
#include "optics/phase_functions.hpp"

namespace photic::medium {
namespace {

constexpr double metre_per_km = 1e3;
constexpr std::size_t most_levels = 1000;
/// Where LOWTRAN 7's boundary layer ends.
constexpr double boundary_layer_km = 2;

/// Optical depth of each layer.
std::vector<double> depths_of(const optics::AirOptics& air) {
  std::vector<double> out;
  for (const optics::AirLayer& layer : air.layers)
    out.push_back((layer.a_per_m() + layer.b_per_m()) * (layer.top_km - layer.bottom_km) *
                  metre_per_km);
  return out;
}

/// Halfway between the levels.
std::vector<double> middles_km(const optics::AirProfile& profile) {
  std::vector<double> out;
  for (std::size_t i = 1; i < profile.z_km.size(); ++i)
    out.push_back((profile.z_km[i - 1] + profile.z_km[i]) / 2);
  return out;
}

/// The middles of layers that are too thick.
std::vector<double> too_thick(const optics::AirLibrary& library, const optics::AirProfile& profile,
                              const optics::AerosolChoice& aerosols, double laser_nm) {
  const std::vector<double> middles = middles_km(profile);
  const auto depths = depths_of(optics::air_at(library, with_levels(profile, middles), aerosols,
                                               laser_nm, optics::Phases::left_out));
  std::vector<double> out;
  for (std::size_t k = 0; k < middles.size(); ++k) {
    const double lower = depths[2 * k], upper = depths[2 * k + 1];
    if (std::abs(lower - upper) / 2 > air_depth_tolerance * std::max(1.0, lower + upper))
      out.push_back(middles[k]);
  }
  return out;
}

void add_sources(const optics::AirOptics& at, double nm, std::vector<Source>& sources) {
  add_source("profile of the air", at.profile_source, nm, sources);
  add_source("b of the air's molecules", at.molecules_source, nm, sources);
  add_source("a of ozone", at.ozone_source, nm, sources);
  add_source("a and b of aerosols", at.aerosols_source, nm, sources);
  add_source("refractive index of the air", optics::air_index_source, nm, sources);
}

AirDepths depths_by_part(const optics::AirOptics& air) {
  AirDepths out;
  for (const optics::AirLayer& layer : air.layers) {
    const double thickness_m = (layer.top_km - layer.bottom_km) * metre_per_km;
    out.molecules += layer.molecules_b_per_m * thickness_m;
    out.ozone += layer.ozone_a_per_m * thickness_m;
    out.aerosols += (layer.aerosols_a_per_m + layer.aerosols_b_per_m) * thickness_m;
  }
  return out;
}

}  // namespace

optics::PhaseTable Air::phase(std::size_t layer) const {
  return optics::PhaseTable(optics::phase_of(scatterers[layer]));
}

double Air::optical_depth(std::size_t line) const {
  double depth = 0;
  for (std::size_t k = 0; k < layers(); ++k) {
    const std::size_t at = line * layers() + k;
    depth += (a[at] + b[at]) * (height_m[k + 1] - height_m[k]);
  }
  return depth;
}

AirBuilder::AirBuilder(const scene::Scene& scene, const std::vector<Line>& lines) : lines_(lines) {
  const std::string folder = optics::find_data_folder();
  if (!scene.atmosphere->layer.empty()) {
    library_.emplace(folder);
    return;
  }
  of_air_.emplace(folder);
  const auto refine_for = [&](const scene::Atmosphere& air) {
    for (auto profile = in_layers(air);;) {
      auto more = too_thick(*of_air_, profile, aerosols_of(air), lines.front().wavelength_nm);
      if (more.empty()) return;
      profile = with_levels(profile, more);
      halved_km_.push_back(std::move(more));
    }
  };
  refine_for(*scene.atmosphere);
  for (const auto& environment : scene.environment) refine_for(*environment.atmosphere);
}

Air AirBuilder::operator()(const scene::Scene& scene) const {
  return scene.atmosphere->layer.empty() ? of_profile(*scene.atmosphere) : of_layers(scene);
}

optics::AirProfile AirBuilder::in_layers(const scene::Atmosphere& air) const {
  auto profile = profile_to_top(air, whole_profile(air, *of_air_));
  for (const auto& more : halved_km_) profile = with_levels(profile, more);
  return profile;
}

Air AirBuilder::of_profile(const scene::Atmosphere& atmosphere) const {
  const optics::AerosolChoice aerosols = aerosols_of(atmosphere);
  const optics::AirProfile profile = in_layers(atmosphere);
  Air air;
  for (const double km : profile.z_km) air.height_m.push_back(km * metre_per_km);
  for (const Line& line : lines_) {
    const bool is_laser = &line == &lines_.front();
    const auto at = optics::air_at(*of_air_, profile, aerosols, line.wavelength_nm,
                                   is_laser ? optics::Phases::told : optics::Phases::left_out);
    for (const optics::AirLayer& layer : at.layers) {
      air.a.push_back(layer.a_per_m());
      air.b.push_back(layer.b_per_m());
      air.refractive_index.push_back(layer.refractive_index);
      air.group_index.push_back(layer.group_index);
      if (is_laser) air.scatterers.push_back(layer.scatterers);
    }
    if (is_laser) air.depths = depths_by_part(at);
    add_sources(at, line.wavelength_nm, air.sources);
  }
  return air;
}

Air AirBuilder::of_layers(const scene::Scene& scene) const {
  const LayerOptics optics_of(scene, *library_);
  const double laser_nm = lines_.front().wavelength_nm;
  Air air;
  air.height_m.push_back(0);
  for (const scene::AirLayer& layer : scene.atmosphere->layer) {
    air.height_m.push_back(layer.top_height_m);
    const auto shape = layer.phase_function
                           ? optics_of.shape(*layer.phase_function, laser_nm)
                           : optics::rayleigh(optics::air_depolarisation(laser_nm));
    air.scatterers.push_back({{"", optics_of(as_layer(layer), laser_nm).b_per_m, shape}});
  }
  for (const Line& line : lines_)
    for (const scene::AirLayer& layer : scene.atmosphere->layer) {
      const WaterOptics at = optics_of(as_layer(layer), line.wavelength_nm);
      air.a.push_back(at.a_per_m);
      air.b.push_back(at.b_per_m);
      air.refractive_index.push_back(layer.refractive_index);
      air.group_index.push_back(layer.refractive_index);  // as if it were alike at all wavelengths
      add_source("a and b of the air", "given in the scene", line.wavelength_nm, air.sources);
    }
  return air;
}

std::optional<Air> build_air(const scene::Scene& scene, const std::vector<Line>& lines) {
  if (!scene.atmosphere) return std::nullopt;
  return AirBuilder(scene, lines)(scene);
}

std::vector<std::string> air_told(const scene::Scene& scene, const Air& air) {
  const scene::Atmosphere& of = *scene.atmosphere;
  const double nm = scene.source.wavelength_nm, top_km = air.height_m.back() / metre_per_km;
  std::string what = "of the scene's own";
  if (of.layer.empty()) {
    const auto* name = std::get_if<std::string>(&of.profile);
    what = name ? "of the profile " + *name : "of the scene's own profile";
  }
  std::vector<std::string> out{fmt::format("{} layers {}, up to {:.6g} km; above them a vacuum",
                                           air.layers(), what, top_km)};
  if (!air.depths) {
    out.push_back(fmt::format("optical depth at {:.6g} nm from the sea to the top: {:.4g}", nm,
                              air.optical_depth(0)));
    return out;
  }
  out.push_back(fmt::format(
      "optical depth at {:.6g} nm from the sea to the top: {:.4g}, of which molecules {:.4g}, "
      "ozone {:.4g}, aerosols {:.4g}",
      nm, air.optical_depth(0), air.depths->molecules, air.depths->ozone, air.depths->aerosols));
  out.emplace_back(
      "left out: the absorption lines of water vapour, oxygen, carbon dioxide and other gases");
  return out;
}

optics::AirProfile whole_profile(const scene::Atmosphere& air, const optics::AirLibrary& library) {
  const auto* name = std::get_if<std::string>(&air.profile);
  optics::AirProfile profile =
      name ? library.atmosphere(*name)
           : optics::air_profile(std::get<scene::UserTable>(air.profile).data());
  if (profile.z_km.size() > most_levels)
    throw InputError({{"", 0, 0, fmt::format("the profile has {} levels", profile.z_km.size()),
                       fmt::format("at most {} can be had: leave some out", most_levels)}});
  if (profile.z_km.front() != 0)
    throw InputError(
        {{"", 0, 0,
          fmt::format("the profile begins at {:g} km, not at the sea", profile.z_km.front()),
          "add a level at 0"}});
  if (!air.has_aerosols())
    for (auto& aerosols : profile.aerosols_per_km) std::ranges::fill(aerosols, 0.0);
  else if (air.visibility_km)
    profile = optics::with_aerosols(library, std::move(profile), *air.visibility_km, air.season);
  if (air.relative_humidity_percent)
    for (std::size_t i = 0; i < profile.z_km.size(); ++i)
      if (profile.z_km[i] <= boundary_layer_km)
        profile.relative_humidity_percent[i] = *air.relative_humidity_percent;
  return profile;
}

optics::AirProfile profile_to_top(const scene::Atmosphere& air, const optics::AirProfile& whole) {
  const double end = whole.z_km.back();
  if (end < air.top_km)
    throw InputError({{"", 0, 0,
                       fmt::format("the profile ends at {:g} km, below the top of the air at {:g} "
                                   "km",
                                   end, air.top_km),
                       fmt::format("write top_km = {:g}, or add levels", end)}});
  return optics::up_to(whole, air.top_km);
}

optics::AerosolChoice aerosols_of(const scene::Atmosphere& air) {
  optics::AerosolChoice choice;
  if (air.has_aerosols()) choice.model[optics::boundary_layer] = air.aerosol;
  return choice;
}

scene::Layer as_layer(const scene::AirLayer& layer) {
  scene::Layer out;
  out.name = layer.name;
  out.iop = layer.iop;
  out.phase_function = layer.phase_function;
  return out;
}

}  // namespace photic::medium
