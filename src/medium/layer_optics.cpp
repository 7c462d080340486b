#include "medium/layer_optics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/interpolation.hpp"
#include "core/stop.hpp"
#include "medium/lines.hpp"
#include "optics/cdom.hpp"
#include "optics/data_table.hpp"
#include "optics/fournier_forand.hpp"
#include "optics/jerlov.hpp"
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

Between entries_around(const scene::Layer& layer, const scene::Sea& sea, double wavelength_nm) {
  const auto& iop = layer.iop;
  const double reach = iop.size() == 1 ? single_entry_reach_nm : 0.0;
  const double first = iop.front().wavelength_nm - reach;
  const double last = iop.back().wavelength_nm + reach;
  if (wavelength_nm < first || wavelength_nm > last)
    throw InputError({{"", 0, 0,
                       fmt::format("the iop of layer \"{}\" covers {:g} to {:g} nm, not {:.6g} nm",
                                   scene::name_in(sea, layer), first, last, wavelength_nm),
                       "add an entry for it"}});
  if (iop.size() == 1) return {iop[0], iop[0], 0.0};
  std::vector<double> nm;
  for (const auto& entry : iop) nm.push_back(entry.wavelength_nm);
  const auto [i, t] = interval_of(nm, wavelength_nm);
  return {iop[i - 1], iop[i], t};
}

WaterOptics of_table(const scene::Layer& layer, const scene::Sea& sea, double wavelength_nm) {
  const auto [low, high, t] = entries_around(layer, sea, wavelength_nm);
  WaterOptics water;
  water.a_per_m = std::lerp(low.a_per_m, high.a_per_m, t);
  water.b_per_m = std::lerp(low.b_per_m, high.b_per_m, t);
  water.a_exciting_per_m = std::lerp(low.a_phytoplankton_per_m, high.a_phytoplankton_per_m, t);
  water.a_cdom_per_m = std::lerp(low.a_cdom_per_m, high.a_cdom_per_m, t);
  std::string source = "given in the scene";
  if (low.bb_per_m && high.bb_per_m && water.b_per_m > 0) {
    water.backscatter_fraction = std::lerp(*low.bb_per_m, *high.bb_per_m, t) / water.b_per_m;
    source += fmt::format(
        "; b_b/b = {:.5g}, too: phase function Fournier-Forand with that b_b/b, "
        "Mobley, Sundman & Boss 2002 [verified]",
        *water.backscatter_fraction);
  }
  water.contributions = {{"", water.a_per_m, water.b_per_m, source}};
  return water;
}

}  // namespace

LayerOptics::LayerOptics(const scene::Scene& scene, const optics::Library& library,
                         std::stop_token stop)
    : scene_(&scene), library_(&library), stop_(std::move(stop)) {}

WaterOptics LayerOptics::operator()(const scene::Layer& layer, double wavelength_nm) const {
  break_off_if(stop_);
  WaterOptics water = !layer.iop.empty()      ? of_table(layer, scene_->sea, wavelength_nm)
                      : !layer.jerlov.empty() ? of_jerlov_type(layer, wavelength_nm)
                                              : of_constituents(layer, wavelength_nm);
  if (!std::isfinite(water.a_per_m + water.b_per_m))
    throw InputError({{"", 0, 0,
                       fmt::format("layer \"{}\" attenuates {:g} nm more than a number can hold",
                                   scene::name_in(scene_->sea, layer), wavelength_nm),
                       "are the units right?"}});
  return water;
}

double LayerOptics::salinity_psu(const scene::Layer& layer) const {
  return layer.salinity_psu.value_or(scene_->sea.salinity_psu);
}

double LayerOptics::temperature_c(const scene::Layer& layer) const {
  return layer.temperature_c.value_or(scene_->sea.temperature_c);
}

optics::Sourced LayerOptics::water_absorption(const scene::Layer& layer,
                                              double wavelength_nm) const {
  return optics::water_absorption_per_m(*library_, scene_->optics.water_absorption, wavelength_nm,
                                        salinity_psu(layer), temperature_c(layer));
}

optics::Sourced LayerOptics::water_scattering(const scene::Layer& layer,
                                              double wavelength_nm) const {
  return optics::water_scattering_per_m(*library_, scene_->optics.water_scattering, wavelength_nm,
                                        salinity_psu(layer), temperature_c(layer));
}

optics::Phytoplankton LayerOptics::phytoplankton(const scene::Layer& layer,
                                                 double wavelength_nm) const {
  const std::string& model = scene_->optics.phytoplankton;
  if (model != "table")
    return optics::phytoplankton(*library_, model, layer.chlorophyll_mg_m3, wavelength_nm);
  if (!phytoplankton_table_)
    phytoplankton_table_ = optics::phytoplankton_table(scene_->optics.phytoplankton_table.data());
  return optics::phytoplankton_of_table(*phytoplankton_table_, layer.chlorophyll_mg_m3,
                                        wavelength_nm);
}

optics::Minerals LayerOptics::minerals(const scene::Layer& layer, double wavelength_nm) const {
  const double g_m3 = layer.minerals_g_m3;
  if (g_m3 == 0) return {};
  if (scene_->optics.minerals == scene::MineralOptics::mie)
    return optics::minerals_of_spheres(
        library_->spheres.sections(spheres(optics::paper_minerals, wavelength_nm), stop_), g_m3);
  return optics::minerals_by_power_law(scene_->optics.minerals_power_law, g_m3, wavelength_nm);
}

WaterOptics LayerOptics::of_constituents(const scene::Layer& layer, double wavelength_nm) const {
  const auto a_water = water_absorption(layer, wavelength_nm);
  const auto b_water = water_scattering(layer, wavelength_nm);
  const auto algae = phytoplankton(layer, wavelength_nm);
  const auto minerals_there = minerals(layer, wavelength_nm);
  const double a_cdom =
      optics::cdom_absorption_per_m(layer.cdom_a440_per_m, layer.cdom_slope_per_nm, wavelength_nm);
  WaterOptics water;
  auto& all = water.contributions;
  all.push_back({"water", a_water.value, {}, a_water.source});
  all.push_back({"water", {}, b_water.value, b_water.source});
  if (layer.chlorophyll_mg_m3 > 0)
    all.push_back({"phytoplankton", algae.a_per_m, algae.b_per_m, algae.source});
  if (a_cdom > 0) all.push_back({"CDOM", a_cdom, {}, optics::cdom_source});
  if (layer.minerals_g_m3 > 0)
    all.push_back(
        {"minerals", minerals_there.a_per_m, minerals_there.b_per_m, minerals_there.source});
  for (const Contribution& each : all) {
    water.a_per_m += each.a_per_m.value_or(0);
    water.b_per_m += each.b_per_m.value_or(0);
  }
  water.a_exciting_per_m = algae.a_exciting_per_m;
  water.a_cdom_per_m = a_cdom;
  water.b_molecular_per_m = b_water.value;
  // As it is rounded in the sum, so that water and phytoplankton are the rest of any sum of them.
  water.b_phytoplankton_per_m = (b_water.value + algae.b_per_m) - b_water.value;
  water.b_minerals_per_m = minerals_there.b_per_m;
  return water;
}

/// Particles scatter all that the water itself does not.
WaterOptics LayerOptics::of_jerlov_type(const scene::Layer& layer, double wavelength_nm) const {
  const auto all = optics::jerlov_water(*library_, layer.jerlov, wavelength_nm);
  WaterOptics water;
  water.a_per_m = all.a_per_m;
  water.b_per_m = all.b_per_m;
  water.b_molecular_per_m = std::min(all.b_per_m, water_scattering(layer, wavelength_nm).value);
  water.b_phytoplankton_per_m = all.b_per_m - water.b_molecular_per_m;
  water.contributions = {{"", all.a_per_m, all.b_per_m, all.source}};
  return water;
}

std::vector<ScatteringPart> LayerOptics::scattering(const scene::Layer& layer, double wavelength_nm,
                                                    const WaterOptics& water) const {
  if (layer.phase_function)
    return {{Scatterer::all, water.b_per_m, shape(*layer.phase_function, wavelength_nm)}};
  if (const auto fraction = water.backscatter_fraction)
    return {
        {Scatterer::all, water.b_per_m, optics::FournierForand::of_backscatter(*fraction).shape()}};
  const scene::Optics& choice = scene_->optics;
  std::vector<ScatteringPart> parts{
      {Scatterer::water, water.b_molecular_per_m, optics::rayleigh(choice.water_depolarisation)}};
  if (water.b_phytoplankton_per_m > 0)
    parts.push_back({Scatterer::phytoplankton, water.b_phytoplankton_per_m,
                     phase_of_particles(choice.phytoplankton_phase, optics::paper_phytoplankton,
                                        default_ff_index, default_ff_slope, wavelength_nm)});
  if (water.b_minerals_per_m > 0)
    parts.push_back(
        {Scatterer::minerals, water.b_minerals_per_m,
         phase_of_particles(choice.minerals_phase, optics::paper_minerals,
                            optics::minerals_ff_index, optics::minerals_ff_slope, wavelength_nm)});
  return parts;
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
  using enum scene::PhaseModel;
  expect(function.model.has_value(), "a phase function that was read has a model");
  switch (*function.model) {
    case henyey_greenstein:
      return optics::henyey_greenstein(function.g);
    case fournier_forand:
      return optics::fournier_forand(function.refractive_index, function.slope);
    case petzold:
      return optics::petzold(*library_);
    case rayleigh:
      return optics::rayleigh(function.depolarisation);
    case isotropic:
      return optics::isotropic();
    case table:
      return optics::phase_from_table(function.table.data()).shape;
    case mie:
      return *library_->spheres.phase(spheres(function.particles, wavelength_nm), stop_);
    case mixture:
      return mixed(function, wavelength_nm);
  }
  throw ContractViolation("every model of a phase function has a shape");
}

optics::PhaseShape LayerOptics::mixed(const scene::PhaseFunction& mixture,
                                      double wavelength_nm) const {
  double sum = 0;  // 1, but for the digits of the user
  for (const auto& part : mixture.components) sum += part.fraction;
  std::vector<std::pair<double, optics::PhaseShape>> parts;
  for (const auto& part : mixture.components)
    parts.emplace_back(part.fraction / sum, shape(part, wavelength_nm));
  return optics::mixture(parts);
}

optics::Spheres LayerOptics::spheres(const optics::SeaParticles& particles,
                                     double wavelength_nm) const {
  return optics::spheres_in_water(particles, wavelength_nm,
                                  refractive_index(scene_->sea, wavelength_nm));
}

optics::PhaseShape LayerOptics::phase_of_particles(scene::ParticlePhase model,
                                                   const optics::SeaParticles& particles,
                                                   double ff_index, double ff_slope,
                                                   double wavelength_nm) const {
  if (model == scene::ParticlePhase::mie)
    return *library_->spheres.phase(spheres(particles, wavelength_nm), stop_);
  if (model == scene::ParticlePhase::petzold) return optics::petzold(*library_);
  return optics::fournier_forand(ff_index, ff_slope);
}

}  // namespace photic::medium
