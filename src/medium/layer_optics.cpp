#include "medium/layer_optics.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "medium/lines.hpp"
#include "optics/cdom.hpp"
#include "optics/data_table.hpp"
#include "optics/fournier_forand.hpp"
#include "optics/phase_functions.hpp"
#include "optics/sea_particles.hpp"
#include "optics/spheres.hpp"
#include "optics/water_absorption.hpp"
#include "optics/water_scattering.hpp"

namespace photic::medium {
namespace {

/// A single entry of an iop list stands for this much on either side of its wavelength.
constexpr double single_entry_reach_nm = 1.0;

/// Fournier-Forand close to Petzold's average: Mobley, Sundman & Boss 2002, Appl. Opt. 41, 1035.
constexpr double default_ff_index = 1.10;
constexpr double default_ff_slope = 3.5835;

/// The entries of an iop list around a wavelength, and how far between them it lies: 0 to 1.
struct Between {
  const scene::IopEntry& low;
  const scene::IopEntry& high;
  double t;
};

Between entries_around(const scene::Layer& layer, double wavelength_nm) {
  const auto& iop = layer.iop;
  const double reach = iop.size() == 1 ? single_entry_reach_nm : 0.0;
  const double first = iop.front().wavelength_nm - reach;
  const double last = iop.back().wavelength_nm + reach;
  if (wavelength_nm < first || wavelength_nm > last)
    throw InputError({{"", 0, 0,
                       fmt::format("the iop of layer \"{}\" covers {:g} to {:g} nm, not {:.6g} nm",
                                   layer.name, first, last, wavelength_nm),
                       "add an entry for it"}});
  if (iop.size() == 1) return {iop[0], iop[0], 0.0};
  std::size_t i = 1;
  while (iop[i].wavelength_nm < wavelength_nm) ++i;
  const auto& low = iop[i - 1];
  const auto& high = iop[i];
  return {low, high,
          (wavelength_nm - low.wavelength_nm) / (high.wavelength_nm - low.wavelength_nm)};
}

WaterOptics of_table(const scene::Layer& layer, double wavelength_nm) {
  const auto [low, high, t] = entries_around(layer, wavelength_nm);
  WaterOptics water;
  water.a_per_m = std::lerp(low.a_per_m, high.a_per_m, t);
  water.b_per_m = std::lerp(low.b_per_m, high.b_per_m, t);
  water.a_exciting_per_m = std::lerp(low.a_phytoplankton_per_m, high.a_phytoplankton_per_m, t);
  water.sources = {fmt::format("a = {:.5g} 1/m, b = {:.5g} 1/m: given in the scene", water.a_per_m,
                               water.b_per_m)};
  if (low.bb_per_m && high.bb_per_m && water.b_per_m > 0) {
    water.backscatter_fraction = std::lerp(*low.bb_per_m, *high.bb_per_m, t) / water.b_per_m;
    water.sources.push_back(
        fmt::format("b_b/b = {:.5g}: given in the scene; phase function: Fournier-Forand of that "
                    "b_b/b, Mobley, Sundman & Boss 2002 [verified]",
                    *water.backscatter_fraction));
  }
  return water;
}

}  // namespace

LayerOptics::LayerOptics(const scene::Scene& scene, const optics::Library& library)
    : scene_(&scene), library_(&library) {}

WaterOptics LayerOptics::operator()(const scene::Layer& layer, double wavelength_nm) const {
  WaterOptics water =
      layer.iop.empty() ? of_constituents(layer, wavelength_nm) : of_table(layer, wavelength_nm);
  if (!std::isfinite(water.a_per_m + water.b_per_m))
    throw InputError({{"", 0, 0,
                       fmt::format("layer \"{}\" attenuates {:g} nm more than a number can say",
                                   layer.name, wavelength_nm),
                       "are the units right?"}});
  return water;
}

optics::Sourced LayerOptics::water_absorption(double wavelength_nm) const {
  return optics::water_absorption_per_m(*library_, scene_->optics.water_absorption, wavelength_nm,
                                        scene_->sea.salinity_psu, scene_->sea.temperature_c);
}

optics::Sourced LayerOptics::water_scattering(double wavelength_nm) const {
  return optics::water_scattering_per_m(*library_, scene_->optics.water_scattering, wavelength_nm,
                                        scene_->sea.salinity_psu, scene_->sea.temperature_c);
}

optics::Phytoplankton LayerOptics::phytoplankton(const scene::Layer& layer,
                                                 double wavelength_nm) const {
  return optics::phytoplankton(*library_, scene_->optics.phytoplankton, layer.chlorophyll_mg_m3,
                               wavelength_nm);
}

WaterOptics LayerOptics::of_constituents(const scene::Layer& layer, double wavelength_nm) const {
  const auto a_water = water_absorption(wavelength_nm);
  const auto b_water = water_scattering(wavelength_nm);
  const auto algae = phytoplankton(layer, wavelength_nm);
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

std::vector<ScatteringPart> LayerOptics::scattering(const scene::Layer& layer, double wavelength_nm,
                                                    const WaterOptics& water) const {
  if (layer.phase_function) return {{water.b_per_m, shape(*layer.phase_function, wavelength_nm)}};
  if (const auto fraction = water.backscatter_fraction)
    return {{water.b_per_m, optics::FournierForand::of_backscatter(*fraction).shape()}};
  auto molecules = optics::rayleigh(scene_->optics.water_depolarisation);
  const double particles = water.b_per_m - water.b_molecular_per_m;
  if (particles <= 0) return {{water.b_per_m, molecules}};
  const std::string& model = scene_->optics.phytoplankton_phase;
  const auto algae = model == "mie" ? spheres(optics::paper_phytoplankton, wavelength_nm)
                     : model == "petzold"
                         ? optics::petzold(*library_)
                         : optics::fournier_forand(default_ff_index, default_ff_slope);
  return {{water.b_molecular_per_m, molecules}, {particles, algae}};
}

optics::PhaseShape LayerOptics::phase(const scene::Layer& layer, double wavelength_nm,
                                      const WaterOptics& water) const {
  const auto parts = scattering(layer, wavelength_nm, water);
  if (parts.size() == 1) return parts.front().phase;
  std::vector<std::pair<double, optics::PhaseShape>> shares;
  for (const auto& part : parts) shares.emplace_back(part.b_per_m / water.b_per_m, part.phase);
  return optics::mixture(shares);
}

optics::PhaseShape LayerOptics::shape(const scene::PhaseFunction& function,
                                      double wavelength_nm) const {
  if (function.model == "henyey-greenstein") return optics::henyey_greenstein(function.g);
  if (function.model == "fournier-forand")
    return optics::fournier_forand(function.refractive_index, function.slope);
  if (function.model == "petzold") return optics::petzold(*library_);
  if (function.model == "rayleigh") return optics::rayleigh(function.depolarisation);
  if (function.model == "isotropic") return optics::isotropic();
  if (function.model == "table") return phase_of_file(function.file).shape;
  if (function.model == "mie") return spheres(function.particles, wavelength_nm);
  expect(function.model == "mixture", "the scene's reader knows the phase function's model");
  double sum = 0;  // 1, but for the digits of the user
  for (const auto& part : function.components) sum += part.fraction;
  std::vector<std::pair<double, optics::PhaseShape>> parts;
  for (const auto& part : function.components)
    parts.emplace_back(part.fraction / sum, shape(part, wavelength_nm));
  return optics::mixture(parts);
}

optics::PhaseShape LayerOptics::spheres(const optics::SeaParticles& particles,
                                        double wavelength_nm) const {
  return optics::phase_of_spheres(library_->spheres(optics::spheres_in_water(
      particles, wavelength_nm, refractive_index(scene_->sea, wavelength_nm))));
}

optics::TabulatedPhase phase_of_file(const std::string& path) {
  return optics::phase_from_table(optics::DataTable::read(path));
}

}  // namespace photic::medium
