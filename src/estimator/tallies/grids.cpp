#include "estimator/tallies/grids.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/constants.hpp"
#include "core/vec3.hpp"
#include "estimator/tallies/levels.hpp"

namespace photic::estimator {
namespace {

using tally::Coordinate;
using tally::Dimension;
using tally::TallyGrid;

const std::vector<std::pair<std::string, std::string>> downwards{{"positive", "down"},
                                                                 {"axis", "Z"}};
constexpr const char* below_surface = "depth below the sea surface, negative in the air";
constexpr const char* above_ground = "depth, the negative height above the ground";

/// "W" and "m-2" make "W m-2".
std::string times(const std::string& units, const std::string& others) {
  if (units == "1") return others;
  return others == "1" ? units : units + " " + others;
}

/// The grids of a scene, one after the other.
class Grids {
 public:
  Grids(const scene::Scene& scene, const medium::Medium& medium,
        const std::optional<medium::Air>& air)
      : scene_(scene), medium_(medium), air_(air), strength_(strength_of(scene.source)) {
    if (!strength_ || !scene.source.is_everywhere || !scene.is_of_spherical_air()) return;
    const double radius = scene.atmosphere->planet_radius_m() + medium.top.back();
    share_strength_ = Strength{"W", strength_->value * pi * radius * radius};
  }

  void add(const scene::Tally& tally) {
    using enum scene::TallyKind;
    kind_ = tally.kind;
    switch (tally.kind) {
      case irradiance:
        return add_irradiance(tally);
      case boundaries:
        return add_boundaries(tally);
      case fluence:
        return add_fluence(tally);
      case radiance:
        return add_radiance(tally);
    }
  }
  std::vector<TallyGrid> take() { return std::move(grids_); }

 private:
  /// A grid of shares of the light.
  TallyGrid& add_share(const char* name, const std::string& long_name, const std::string& units,
                       std::vector<Dimension> dimensions) {
    TallyGrid& grid = grids_.emplace_back();
    grid.name = name;
    grid.long_name = long_name;
    grid.kind = kind_;
    grid.units = units;
    grid.dimensions = std::move(dimensions);
    grid.normalisation = !scene_.source.is_everywhere ? "per photon emitted"
                         : scene_.is_of_spherical_air()
                             ? "per photon that comes to the planet's air"
                             : "per photon that comes to a horizontal area";
    if (const auto& strength = share_strength_ ? share_strength_ : strength_)
      grid.by_strength = {strength->value * strength->share_scale, times(strength->units, units)};
    return grid;
  }
  /// A grid of a quantity that is, for light as wide as the world, per irradiance across its beam.
  TallyGrid& add_flux(const char* name, const std::string& long_name, const std::string& units,
                      std::vector<Dimension> dimensions) {
    TallyGrid& grid = add_share(name, long_name, units, std::move(dimensions));
    if (!scene_.source.is_everywhere) return grid;
    grid.normalisation = "per unit irradiance across the beam";
    grid.factor.assign(grid.size(), std::abs(normalised(scene_.source.direction).z));
    if (strength_) grid.by_strength = {strength_->value, times(strength_->units, units)};
    return grid;
  }
  [[nodiscard]] Dimension levels(const scene::Tally& tally, const std::string& name) const {
    const auto all = levels_of(tally);
    Coordinate depth{.name = name + "_depth",
                     .units = "m",
                     .long_name = has_sea() ? below_surface : above_ground,
                     .attributes = downwards};
    Coordinate medium{.name = name + "_medium",
                      .long_name = "the medium of a level: at depth 0 just above or below"};
    for (const TallyLevel& level : all) {
      depth.values.push_back(level.in_air ? 0.0 - level.distance : level.distance);
      medium.labels.emplace_back(level.in_air ? "air" : "water");
    }
    return {name, all.size(), {std::move(depth), std::move(medium)}};
  }

  void add_irradiance(const scene::Tally& tally) {
    std::vector<Dimension> dimensions{levels(tally, "level")};
    if (!tally.zone_deg.empty())
      dimensions.push_back(
          {"zone",
           tally.zone_deg.size() - 1,
           {{.name = "zone",
             .units = "degree",
             .long_name = "angle at the planet's centre from the point under the source",
             .edges = tally.zone_deg}}});
    const std::vector<double> factor = per_area_of_zones(tally);
    const auto add = [&](const char* name, const char* long_name) {
      TallyGrid& grid = add_flux(name, long_name, "1", dimensions);
      if (!factor.empty()) grid.factor = factor;
    };
    add("irradiance_down", "downward plane irradiance");
    add("irradiance_up", "upward plane irradiance");
    add("scalar_irradiance_down", "downward scalar irradiance");
    add("scalar_irradiance_up", "upward scalar irradiance");
  }
  /// The area of the disc that lights a planet over that of each zone at each level; none without
  /// zones.
  [[nodiscard]] std::vector<double> per_area_of_zones(const scene::Tally& tally) const {
    std::vector<double> out;
    if (tally.zone_deg.empty()) return out;
    const double radius = scene_.atmosphere->planet_radius_m();
    for (const TallyLevel& level : levels_of(tally))
      for (std::size_t z = 0; z + 1 < tally.zone_deg.size(); ++z) {
        const double share = (radius + medium_.top.back()) / (radius + level.distance);
        const double cosines = std::cos(tally.zone_deg[z] * radian_per_degree) -
                               std::cos(tally.zone_deg[z + 1] * radian_per_degree);
        out.push_back(share * share / (2 * cosines));
      }
    return out;
  }

  void add_boundaries(const scene::Tally& tally) {
    const AbsorberNames names = absorber_names(medium_, air_);
    add_share(
        "absorbed", "light absorbed, or converted to other wavelengths", "1",
        {{"layer",
          names.layer.size(),
          {{.name = "layer", .long_name = "layer", .labels = names.layer}}},
         {"constituent",
          names.constituent.size(),
          {{.name = "constituent", .long_name = "constituent", .labels = names.constituent}}}})
        .in_balance = true;
    add_share("escaped", "light that goes away for good, by the zenith angle of its direction", "1",
              {{"escape_zenith",
                escape_edges(tally, medium_).size() - 1,
                {{.name = "escape_zenith",
                  .units = "degree",
                  .long_name = "angle between the light's direction and straight up",
                  .edges = escape_edges(tally, medium_)}}}})
        .in_balance = true;
    if (has_sea()) {
      add_share("reflected_by_surface", "light that escaped and never was in the water", "1", {});
      add_share("left_water", "light that escaped and was in the water", "1", {});
    }
    const bool ends = std::isfinite(medium_.top.back());
    if (ends)
      add_share(has_sea() ? "absorbed_by_bottom" : "absorbed_by_ground",
                has_sea() ? "light absorbed by the sea bed" : "light absorbed by the ground", "1",
                {})
          .in_balance = true;
    if (medium_.film.exists)
      add_share("absorbed_by_film", "light absorbed by the film of oil", "1", {}).in_balance = true;
    add_share("balance", "all light that is absorbed or escapes", "1", {}).is_balance = true;
  }

  void add_fluence(const scene::Tally& tally) {
    const bool rings = !tally.radius_m.empty();
    const std::string name = fluence_name(tally);
    const auto& aside = rings ? tally.radius_m : tally.x_m;
    const bool in_air = !tally.height_m.empty();
    const auto& distances = in_air ? tally.height_m : tally.depth_m;
    Coordinate depth{.name = name + "_depth",
                     .units = "m",
                     .long_name = has_sea() ? below_surface : above_ground,
                     .attributes = downwards};
    for (const double distance : distances)
      depth.edges.push_back(in_air ? 0.0 - distance : distance);
    Coordinate from_vertical{
        .name = name + (rings ? "_radius" : "_x"),
        .units = "m",
        .long_name = rings ? "distance from the vertical through the source" : "x",
        .edges = aside};
    const std::size_t rows = distances.size() - 1, columns = aside.size() - 1;
    TallyGrid& grid =
        add_share(name.c_str(), "fluence of the source's light", rings ? "m-2" : "m-1",
                  {{depth.name, rows, {depth}}, {from_vertical.name, columns, {from_vertical}}});
    if (!rings) grid.normalisation += " and metre of y";
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t column = 0; column < columns; ++column) {
        const double from = aside[column], to = aside[column + 1];
        const double area = rings ? pi * (to * to - from * from) : to - from;
        grid.factor.push_back(1 / ((distances[row + 1] - distances[row]) * area));
      }
  }

  void add_radiance(const scene::Tally& tally) {
    Coordinate zenith{.name = "direction_zenith",
                      .units = "degree",
                      .long_name = "angle between the light's direction and straight up"};
    Coordinate azimuth{.name = "direction_azimuth",
                       .units = "degree",
                       .long_name = "azimuth of the light's direction, from +x to +y"};
    for (const auto& direction : tally.direction_deg) {
      zenith.values.push_back(direction.zenith_deg);
      azimuth.values.push_back(direction.azimuth_deg);
    }
    add_flux("radiance", "radiance of scattered light", "sr-1",
             {{"direction", tally.direction_deg.size(), {std::move(zenith), std::move(azimuth)}},
              levels(tally, "radiance_level")});
  }

  [[nodiscard]] bool has_sea() const { return !scene_.is_of_air_alone(); }

  const scene::Scene& scene_;
  const medium::Medium& medium_;
  const std::optional<medium::Air>& air_;
  std::optional<Strength> strength_;
  std::optional<Strength> share_strength_;  ///< of shares, where it is of another kind
  scene::TallyKind kind_{};                 ///< of the tally at hand
  std::vector<TallyGrid> grids_;
};

}  // namespace

std::optional<Strength> strength_of(const scene::Source& source) {
  if (source.energy_j) return Strength{"J", *source.energy_j};
  if (source.photons_per_pulse) return Strength{"1", *source.photons_per_pulse};
  if (source.power_w) return Strength{"W", *source.power_w};
  if (source.irradiance_w_m2)
    return Strength{"W m-2", *source.irradiance_w_m2, std::abs(normalised(source.direction).z)};
  return std::nullopt;
}

AbsorberNames absorber_names(const medium::Medium& medium, const std::optional<medium::Air>& air) {
  AbsorberNames out{medium.absorbers.layer, medium.absorbers.constituent};
  if (!air) return out;
  std::ranges::copy(air->absorbers.layer, std::back_inserter(out.layer));
  for (const std::string& name : air->absorbers.constituent)
    if (std::ranges::find(out.constituent, name) == out.constituent.end())
      out.constituent.push_back(name);
  return out;
}

std::vector<double> escape_edges(const scene::Tally& tally, const medium::Medium& medium) {
  constexpr double straight_down = 180;
  std::vector<double> edges = tally.zenith_deg;
  if (medium.row.ends()) edges.push_back(straight_down);
  return edges;
}

std::string fluence_name(const scene::Tally& tally) {
  return tally.name.empty() ? "fluence" : "fluence_" + tally.name;
}

std::vector<TallyGrid> tally_grids(const scene::Scene& scene, const medium::Medium& medium,
                                   const std::optional<medium::Air>& air) {
  Grids grids(scene, medium, air);
  for (const scene::Tally& tally : scene.tally) grids.add(tally);
  return grids.take();
}

std::optional<std::size_t> first_cell(const std::vector<TallyGrid>& grids,
                                      const std::string& name) {
  std::size_t cell = 0;
  for (const TallyGrid& grid : grids) {
    if (grid.name == name) return cell;
    cell += grid.size();
  }
  return std::nullopt;
}

}  // namespace photic::estimator
