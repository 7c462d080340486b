#include "medium/layer_optics.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "optics/cdom.hpp"
#include "optics/data_table.hpp"
#include "optics/fournier_forand.hpp"
#include "optics/phase_from_table.hpp"
#include "optics/phase_functions.hpp"
#include "optics/phytoplankton.hpp"
#include "optics/water_absorption.hpp"
#include "optics/water_scattering.hpp"

namespace photic::medium {
namespace {

/// A single entry of an iop list stands for this much on either side of its wavelength.
constexpr double single_entry_reach_nm = 1.0;

/// Fournier-Forand close to Petzold's average: Mobley, Sundman & Boss 2002, Appl. Opt. 41, 1035.
constexpr double default_ff_index = 1.10;
constexpr double default_ff_slope = 3.5835;

}  // namespace

LayerOptics::LayerOptics(const scene::Scene& scene, const optics::Library& library)
    : scene_(&scene), library_(&library) {}

WaterOptics LayerOptics::operator()(const scene::Layer& layer, double wavelength_nm) const {
  return layer.iop.empty() ? of_constituents(layer, wavelength_nm) : of_table(layer, wavelength_nm);
}

WaterOptics LayerOptics::of_constituents(const scene::Layer& layer, double wavelength_nm) const {
  const auto& choice = scene_->optics;
  const auto& sea = scene_->sea;
  const auto a_water = optics::water_absorption_per_m(
      *library_, choice.water_absorption, wavelength_nm, sea.salinity_psu, sea.temperature_c);
  const auto b_water = optics::water_scattering_per_m(
      *library_, choice.water_scattering, wavelength_nm, sea.salinity_psu, sea.temperature_c);
  const auto algae = optics::phytoplankton(*library_, choice.phytoplankton, layer.chlorophyll_mg_m3,
                                           wavelength_nm);
  const double a_cdom =
      optics::cdom_absorption_per_m(layer.cdom_a440_per_m, layer.cdom_slope_per_nm, wavelength_nm);
  WaterOptics water;
  water.a_per_m = a_water.value + algae.a_per_m + a_cdom;
  water.b_per_m = b_water.value + algae.b_per_m;
  water.a_exciting_per_m = algae.a_exciting_per_m;
  water.b_molecular_per_m = b_water.value;
  water.sources = {fmt::format("a of water = {:.5g} 1/m: {}", a_water.value, a_water.source),
                   fmt::format("b of water = {:.5g} 1/m: {}", b_water.value, b_water.source)};
  if (layer.chlorophyll_mg_m3 > 0) {
    water.sources.push_back(fmt::format("phytoplankton a = {:.5g} 1/m, b = {:.5g} 1/m: {}",
                                        algae.a_per_m, algae.b_per_m, algae.source));
  }
  if (a_cdom > 0) {
    water.sources.push_back(fmt::format("a of CDOM = {:.5g} 1/m: {}", a_cdom, optics::cdom_source));
  }
  return water;
}

WaterOptics LayerOptics::of_table(const scene::Layer& layer, double wavelength_nm) const {
  const auto& iop = layer.iop;
  WaterOptics water;
  const auto take = [&](const scene::IopEntry& low, const scene::IopEntry& high, double t) {
    water.a_per_m = std::lerp(low.a_per_m, high.a_per_m, t);
    water.b_per_m = std::lerp(low.b_per_m, high.b_per_m, t);
    water.a_exciting_per_m = std::lerp(low.a_phytoplankton_per_m, high.a_phytoplankton_per_m, t);
    water.sources = {fmt::format("a = {:.5g} 1/m, b = {:.5g} 1/m: given in the scene",
                                 water.a_per_m, water.b_per_m)};
    return water;
  };
  if (iop.size() == 1 && std::abs(wavelength_nm - iop[0].wavelength_nm) <= single_entry_reach_nm) {
    return take(iop[0], iop[0], 0.0);
  }
  for (std::size_t i = 1; i < iop.size(); ++i) {
    const auto& low = iop[i - 1];
    const auto& high = iop[i];
    if (low.wavelength_nm <= wavelength_nm && wavelength_nm <= high.wavelength_nm) {
      return take(low, high,
                  (wavelength_nm - low.wavelength_nm) / (high.wavelength_nm - low.wavelength_nm));
    }
  }
  throw InputError(
      {{"", 0, 0,
        fmt::format("layer \"{}\" has no optical properties at {:.2f} nm, which a channel needs",
                    layer.name, wavelength_nm),
        "add an entry to its iop that covers this wavelength, or leave the channel out"}});
}

optics::PhaseShape LayerOptics::phase(const scene::Layer& layer, const WaterOptics& water) const {
  if (layer.phase_function) return shape(*layer.phase_function);
  auto molecules = optics::rayleigh(scene_->optics.water_depolarisation);
  const double particles = water.b_per_m - water.b_molecular_per_m;
  if (particles <= 0) return molecules;
  const auto algae = scene_->optics.phytoplankton_phase == "petzold"
                         ? optics::petzold(*library_)
                         : optics::fournier_forand(default_ff_index, default_ff_slope);
  return optics::mixture(
      {{water.b_molecular_per_m / water.b_per_m, molecules}, {particles / water.b_per_m, algae}});
}

optics::PhaseShape LayerOptics::shape(const scene::PhaseFunction& function) const {
  if (function.model == "henyey-greenstein") return optics::henyey_greenstein(function.g);
  if (function.model == "fournier-forand")
    return optics::fournier_forand(function.refractive_index, function.slope);
  if (function.model == "petzold") return optics::petzold(*library_);
  if (function.model == "rayleigh") return optics::rayleigh(function.depolarisation);
  if (function.model == "isotropic") return optics::isotropic();
  if (function.model == "table")
    return optics::phase_from_table(optics::DataTable::read(function.file)).shape;
  expect(function.model == "mixture", "the scene's reader knows the phase function's model");
  std::vector<std::pair<double, optics::PhaseShape>> parts;
  for (const auto& part : function.components) parts.emplace_back(part.fraction, shape(part));
  return optics::mixture(parts);
}

}  // namespace photic::medium
