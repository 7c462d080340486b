#include "optics/aerosol_profiles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/interpolation.hpp"
#include "optics/air_library.hpp"

namespace photic::optics {
namespace {

/// Linear in 1 / visibility through two values.
double by_visibility(double visibility_km, double v0, double at_v0, double v1, double at_v1) {
  const double t = (1 / visibility_km - 1 / v0) / (1 / v1 - 1 / v0);
  return std::max(0.0, (1 - t) * at_v0 + t * at_v1);
}

using Values = std::vector<double>;

Values boundary_layer_of(const AerosolProfiles& p, double visibility_km) {
  const auto& v = AerosolProfiles::visibility_km;  // descends
  std::size_t i = 1;
  while (i + 1 < v.size() && visibility_km < v[i]) ++i;
  Values out;
  for (std::size_t k = 0; k < p.z_km.size(); ++k)
    out.push_back(by_visibility(visibility_km, v[i - 1], p.boundary_layer[i - 1][k], v[i],
                                p.boundary_layer[i][k]));
  return out;
}

Values troposphere_of(const AerosolProfiles& p, double visibility_km, std::size_t season) {
  const auto& [clear, hazy] = p.troposphere[season];
  const double v = std::max(visibility_km, AerosolProfiles::visibility_km[1]);
  Values out;
  for (std::size_t k = 0; k < p.z_km.size(); ++k)
    out.push_back(by_visibility(v, AerosolProfiles::visibility_km[0], clear[k],
                                AerosolProfiles::visibility_km[1], hazy[k]));
  return out;
}

/// From the table's altitudes to a profile's; 0 outside.
Values at_levels(const Values& z_km, const Values& values, const Values& levels_km) {
  Values out;
  for (const double z : levels_km) {
    if (z < z_km.front() || z > z_km.back()) {
      out.push_back(0);
      continue;
    }
    const auto [i, t] = interval_of(z_km, z);
    out.push_back(geometric_lerp(values[i - 1], values[i], t));
  }
  return out;
}

double depth_of(const AirProfile& profile, const Values& extinction_per_km) {
  const double bottom = profile.edges_km.front(), top = profile.edges_km.back();
  return (top - bottom) * mean_between(profile.aerosol_z_km, extinction_per_km, bottom, top);
}

}  // namespace

AerosolProfiles::AerosolProfiles(const DataTable& table)
    : z_km(table.ascending_numbers("z_km")),
      upper_atmosphere(table.numbers("upper")),
      source(source_of(table)) {
  for (std::size_t v = 0; v < visibility_km.size(); ++v)
    boundary_layer[v] = table.numbers(fmt::format("boundary_vis{:g}", visibility_km[v]));
  for (std::size_t s = 0; s < seasons.size(); ++s) {
    const std::string season = s == 0 ? "spring_summer" : "fall_winter";
    for (std::size_t v = 0; v < troposphere[s].size(); ++v)
      troposphere[s][v] =
          table.numbers(fmt::format("troposphere_{}_vis{:g}", season, visibility_km[v]));
    stratosphere[s] = table.numbers("stratosphere_" + season);
  }
}

double aerosols_of_visibility_per_km(double visibility_km) {
  return contrast_depth / visibility_km - molecules_at_visibility_per_km;
}

AirProfile with_aerosols(const AirLibrary& library, AirProfile profile, double visibility_km,
                         const std::string& season) {
  if (!(visibility_km >= lowest_visibility_km && visibility_km <= highest_visibility_km)) {
    throw InputError({{"", 0, 0,
                       fmt::format("a visibility of {:g} km is outside {:g} to {:g} km",
                                   visibility_km, lowest_visibility_km, highest_visibility_km),
                       ""}});
  }
  const auto& names = AerosolProfiles::seasons;
  const auto found = std::find(names.begin(), names.end(), season);
  if (found == names.end()) no_model("season of aerosols", season, "spring-summer, fall-winter");
  const auto s = static_cast<std::size_t>(found - names.begin());

  const AerosolProfiles& p = library.aerosol_profiles;
  const auto first = std::ranges::upper_bound(p.z_km, profile.z_km.front());
  const auto last = std::ranges::lower_bound(p.z_km, profile.z_km.back());
  profile = with_edges(std::move(profile), {std::min(first, last), last});
  profile.aerosol_z_km = profile.edges_km;
  const auto put = [&](AerosolRegion region, const Values& values) {
    profile.aerosols_per_km[region] = at_levels(p.z_km, values, profile.aerosol_z_km);
  };
  put(boundary_layer, boundary_layer_of(p, visibility_km));
  put(troposphere, troposphere_of(p, visibility_km, s));
  put(stratosphere, p.stratosphere[s]);
  put(upper_atmosphere, p.upper_atmosphere);
  profile.source += "; aerosols " + p.source;
  return profile;
}

double aerosol_depth(const AirProfile& profile) {
  double depth = 0;
  for (const auto& aerosols : profile.aerosols_per_km) depth += depth_of(profile, aerosols);
  return depth;
}

AirProfile with_aerosol_depth(AirProfile profile, double depth) {
  Values& low = profile.aerosols_per_km[boundary_layer];
  const double below = depth_of(profile, low), above = aerosol_depth(profile) - below;
  if (below == 0)
    throw InputError({{"", 0, 0,
                       "the profile has no aerosols in the boundary layer, which an optical depth "
                       "scales",
                       "give it a visibility, or aerosols"}});
  if (depth < above) {
    constexpr double digits = 1e4;
    throw InputError({{"", 0, 0,
                       fmt::format("{:g} is less than the optical depth at 550 nm of the aerosols "
                                   "above the boundary layer alone, {:.4g}",
                                   depth, above),
                       fmt::format("write at least {:g}, or aerosol = \"none\"",
                                   std::ceil(digits * above) / digits)}});
  }
  for (double& extinction : low) extinction *= (depth - above) / below;
  return profile;
}

}  // namespace photic::optics
