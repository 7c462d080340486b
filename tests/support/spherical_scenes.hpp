// Scenes of spherical air.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "support/lit_scenes.hpp"

namespace photic::test {

/// Layers of air from the ground up; `index`: of refraction, none: 1.
struct AirLayers {
  double thickness_m = 1500;
  std::vector<double> a, b, index;  ///< a and b in 1/m
  std::string phase = R"({ model = "rayleigh", depolarisation = 0.0 })";

  [[nodiscard]] std::size_t count() const { return b.size(); }
  [[nodiscard]] double top_m() const { return thickness_m * static_cast<double>(count()); }
};
/// The atmosphere of the table of direct and diffuse light: 40 layers of 1.5 km, a scale height of
/// 7 km, an optical depth of 0.3.
inline AirLayers forty_layers(bool bend = false) {
  AirLayers air;
  for (int i = 0; i < 40; ++i) {
    air.a.push_back(0);
    air.b.push_back(0.2e-3 * (std::exp(-1.5 * i / 7) - std::exp(-1.5 * (i + 1) / 7)));
    if (bend) air.index.push_back(1 + 3.5e-4 * std::exp(-1.5 * (i + 0.5) / 7));
  }
  return air;
}
/// The same, of which a share of the attenuation is absorption.
inline AirLayers absorbing(AirLayers air, double share) {
  for (std::size_t i = 0; i < air.count(); ++i) {
    air.a[i] = share * air.b[i];
    air.b[i] *= 1 - share;
  }
  return air;
}

inline std::string text_of(const AirLayers& air) {
  std::string out;
  for (std::size_t i = 0; i < air.count(); ++i) {
    const double bottom = air.thickness_m * static_cast<double>(i);
    out += fmt::format(
        "[[atmosphere.layer]]\nbottom_height_m = {}\ntop_height_m = {}\n"
        "iop = [{{ wavelength_nm = 532, a_per_m = {}, b_per_m = {} }}]\nphase_function = {}\n",
        bottom, bottom + air.thickness_m, air.a[i], air.b[i], air.phase);
    if (!air.index.empty()) out += fmt::format("refractive_index = {:.17g}\n", air.index[i]);
  }
  return out;
}
/// Air above a ground; `radius_km`: of the planet, 0: plane air.
inline std::string air_over(const AirLayers& air, double radius_km, double albedo = 0) {
  std::string out = fmt::format("[atmosphere]\nsurface = {{ albedo = {} }}\n", albedo);
  if (radius_km > 0)
    out += fmt::format("geometry = \"spherical\"\nplanet_radius_km = {}\n", radius_km);
  if (!air.index.empty()) out += "refraction = true\n";
  return out + text_of(air);
}

/// A pencil whose straight continuation meets the ground at the origin, from a zenith angle.
inline std::string pencil_at(double zenith_deg, double from_m = 2e6) {
  const double sine = std::sin(zenith_deg * radian_per_degree);
  const double cosine = std::cos(zenith_deg * radian_per_degree);
  return light("beam", fmt::format("position_m = [{0:.17g}, 0, {1:.17g}]\n"
                                   "direction = [{2:.17g}, 0, {3:.17g}]",
                                   from_m * sine, from_m * cosine, -sine, -cosine));
}

}  // namespace photic::test
