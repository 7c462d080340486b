#include "medium/air_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "core/interpolation.hpp"
#include "optics/air_plausibility.hpp"
#include "optics/library.hpp"
#include "scene/air_levels.hpp"

namespace photic::medium {
namespace {

constexpr std::size_t max_levels = 1000;
/// The end of LOWTRAN 7's boundary layer.
constexpr double boundary_layer_km = 2;

}  // namespace

optics::AirProfile whole_profile(const scene::Atmosphere& air, const optics::AirLibrary& library) {
  const auto* name = std::get_if<std::string>(&air.profile);
  optics::AirProfile profile =
      name ? library.atmosphere(*name)
           : optics::air_profile(std::get<scene::UserTable>(air.profile).data());
  if (profile.z_km.size() > max_levels)
    throw InputError({{"", 0, 0, fmt::format("the profile has {} levels", profile.z_km.size()),
                       fmt::format("at most {} are possible: leave some out", max_levels)}});
  if (profile.z_km.front() != 0)
    throw InputError(
        {{"", 0, 0,
          fmt::format("the profile begins at {:g} km, not at the sea", profile.z_km.front()),
          "add a level at 0"}});
  if (!air.has_aerosols())
    for (auto& aerosols : profile.aerosols_per_km) std::ranges::fill(aerosols, 0.0);
  else if (air.visibility_km || !scene::has_own_aerosols(air))
    profile =
        optics::with_aerosols(library, std::move(profile),
                              air.visibility_km.value_or(optics::clear_visibility_km), air.season);
  if (air.relative_humidity_percent)
    for (std::size_t i = 0; i < profile.z_km.size(); ++i)
      if (profile.z_km[i] <= boundary_layer_km)
        profile.relative_humidity_percent[i] = *air.relative_humidity_percent;
  return profile;
}

std::vector<std::string> doubts_about_levels(const scene::Atmosphere& air) {
  const auto* levels = std::get_if<scene::UserTable>(&air.profile);
  if (!levels) return {};
  return optics::doubts_about(optics::air_profile(levels->data()));
}

optics::AirProfile profile_to_top(const scene::Atmosphere& air, const optics::AirProfile& whole) {
  const double end = whole.z_km.back(), if_in_m = air.top_km / metre_per_km;
  constexpr double far_km = 1000;  // from here on metres are more likely
  if (end < air.top_km)
    throw InputError(
        {{"", 0, 0,
          fmt::format("the profile ends at {:g} km, below the top of the air at {:g} "
                      "km",
                      end, air.top_km),
          air.top_km >= far_km && if_in_m <= end
              ? fmt::format("did you mean {:g}? {:g} would be in m", if_in_m, air.top_km)
              : fmt::format("write top_km = {:g}, or add levels", end)}});
  return optics::up_to(whole, air.top_km);
}

optics::AirProfile as_deep_as_given(const scene::Atmosphere& air, optics::AirProfile to_top) {
  if (!air.aerosol_optical_depth_550) return to_top;
  return optics::with_aerosol_depth(std::move(to_top), *air.aerosol_optical_depth_550);
}

std::vector<double> gas_depths(const scene::Atmosphere& air, double wavelength_nm) {
  constexpr double rounding = 2e-3;  // of four digits of transmittances, down to 0.1
  std::vector<double> out;
  for (const scene::AirGases& rung : air.gases) {
    const optics::DataTable& table = rung.depth.data();
    const LinearTable depth(optics::wavelengths_of(table), table.numbers_from_0("optical_depth"));
    if (!depth.covers(wavelength_nm))
      optics::no_data("gas", wavelength_nm, table.name(), depth.min(), depth.max(),
                      "add it to the table, or choose another wavelength");
    const double here = depth(wavelength_nm), before = out.empty() ? 0 : out.back();
    if (here < before * (1 - rounding) - rounding)
      throw InputError({{"", 0, 0,
                         fmt::format("gases have an optical depth of {:.4g} at {:g} nm up to {:g} "
                                     "km, and of {:.4g} up to the rung below it",
                                     here, wavelength_nm, rung.top_km, before),
                         "all rungs begin at the sea"}});
    out.push_back(std::max(here, before));
  }
  return out;
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
