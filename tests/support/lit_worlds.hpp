// Scenes of all kinds of sources in all kinds of worlds, with all tallies that they can have.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/films.hpp"
#include "support/lit_scenes.hpp"

namespace photic::test {

/// A scene but for its [simulation].
struct LitWorld {
  std::string name, scene;
};
/// Names tests after worlds.
inline std::string name_of_world(const testing::TestParamInfo<LitWorld>& of) {
  std::string name = of.param.name;
  std::ranges::replace(name, ' ', '_');
  return name;
}

inline const std::string everywhere_in_sea =
    tally_of("boundaries") + tally_of("irradiance", {{0, 0.5, 1, 2}, {0, 1}});
/// Of a source with a place.
inline const std::string rings_in_sea =
    tally_of("fluence", {{0, 0.4, 1.2, 2}}, "radius_m = [0, 0.3, 1, 3]\nname = \"rings\"");
inline const std::string strips_in_air =
    tally_of("fluence", {{}, {0, 0.3, 1}}, "x_m = [-2, -0.5, 0, 1]\nname = \"strips\"");
inline const std::string flat_radiance = tally_of(
    "radiance", {{0, 1}, {0, 1}}, "direction_deg = [[0, 0], [20, 0], [70, 120], [150, 90]]");

/// Two layers over a bed, with so much of light in its way; `surface`: keys of [sea].
inline std::string two_layers_and_bed(const std::string& surface = "") {
  return "[sea]\nrefractive_index = 1.34\n" + surface +
         layer_to(1, 0.2, 0.8, R"({ model = "henyey-greenstein", g = 0.7 })") +
         layer_to(2, 0.1, 1.2) + "[bottom]\nalbedo = 0.4\n";
}
inline const std::string wavy =
    "surface = { model = \"cox-munk\", wind_speed_m_s = 5.0, whitecaps = true }\n";
/// Of lasers, whose facets gain light else.
inline const std::string wavy_for_lasers =
    "surface = { model = \"cox-munk\", wind_speed_m_s = 5.0, facets = \"conserving\" }\n";
inline const std::string wavy_without_foam =
    "surface = { model = \"cox-munk\", wind_speed_m_s = 5.0, whitecaps = false }\n";
inline const std::string two_airs =
    "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 1.0\n" +
    scattering(0.05, 0.4, 0.5) +
    "[[atmosphere.layer]]\nbottom_height_m = 1.0\ntop_height_m = 2.0\n" + scattering(0.1, 0.2, 0);
inline const std::string air_over_ground = "[atmosphere]\nsurface = { albedo = 0.4 }\n" + two_airs;

inline std::string lamp_at(double z, double half_angle_deg) {
  return light("cone", fmt::format("position_m = [0.2, 0.1, {}]\ndirection = [0.3, 0, -1]\n"
                                   "half_angle_deg = {}",
                                   z, half_angle_deg));
}

/// Columns side by side over a bed; `ends`: keys of the first column, and of [sea].
inline std::string columns_and_beds(const std::string& surface = "", const std::string& x_min = "",
                                    const std::string& ends = "") {
  const auto layer = [](double bottom_m, double a_per_m, double b_per_m, double g) {
    return fmt::format("[[sea.column.layer]]\nbottom_depth_m = {}\n", bottom_m) +
           scattering(a_per_m, b_per_m, g);
  };
  return "[sea]\nrefractive_index = 1.34\n" + surface + ends + "[[sea.column]]\n" + x_min +
         "x_max_m = 0.3\n" + layer(1, 0.2, 0.8, 0.7) + layer(2, 0.1, 1.2, 0) +
         "[sea.column.bottom]\nalbedo = 0.4\n[[sea.column]]\nx_max_m = 1.2\n" +
         layer(2, 0.5, 2.5, 0.5) + "[sea.column.bottom]\nalbedo = 0.1\n" +
         (ends.empty() ? "[[sea.column]]\n" + layer(1.5, 0.05, 0.1, 0) + layer(2, 0.4, 0.1, 0)
                       : "");
}
inline const std::string raft_ends = "y_min_m = -0.8\ny_max_m = 0.5\n";

/// A laser's light that a film and the water convert, and telescopes count.
inline std::string converted(const std::string& surface) {
  return "[source]\nwavelength_nm = 355.0\nposition_m = [0, 0, 2]\ndirection = [0.3, 0, -1]\n"
         "diameter_m = 0.05\nhalf_divergence_mrad = 50\n"
         "[[telescope]]\nposition_m = [0.8, 0, 2]\ndirection = [0, 0, -1]\ndiameter_m = 1.0\n"
         "focal_length_m = 2.0\nhalf_field_of_view_mrad = 300.0\n" +
         channel("oil") + channel("raman") + "[gates]\ndepth_max_m = 2.0\ndepth_step_m = 1.0\n" +
         everywhere_in_sea + film(3, "yield = 0.5\n") + "[sea]\nrefractive_index = 1.34\n" +
         surface + "[[sea.layer]]\nbottom_depth_m = 2.0\n" + scattering(0.2, 0.8, 0.7);
}

inline std::vector<LitWorld> lit_worlds() {
  const std::string point = "position_m = [0, 0, -1.5]\ndirection = [0.4, 0.2, 1]";
  const std::string disc = "position_m = [0, 0, 3]\nzenith_deg = 30\ndiameter_m = 0.5";
  const std::string laser =
      "position_m = [0, 0, 5]\ndirection = [0.2, 0, -1]\ndiameter_m = 0.04\n"
      "half_divergence_mrad = 5";
  const std::string in_sea = everywhere_in_sea + rings_in_sea + strips_in_air;
  const std::string in_columns =
      everywhere_in_sea + strips_in_air +
      tally_of("fluence", {{0, 0.4, 1.2, 2}}, "x_m = [-2, -0.3, 0.3, 0.8, 2]\nname = \"front\"");
  return {
      {"the sun over a flat sea",
       sun_at(50) + everywhere_in_sea + flat_radiance + two_layers_and_bed()},
      {"the sun over waves", sun_at(70) + everywhere_in_sea + two_layers_and_bed(wavy)},
      {"the sun through air",
       sun_at(50) + everywhere_in_sea + flat_radiance + two_airs + two_layers_and_bed()},
      {"the sun through air over waves",
       sun_at(70) + everywhere_in_sea + two_airs + two_layers_and_bed(wavy)},
      {"the sun over a film",
       sun_at(50) + everywhere_in_sea + flat_radiance + film(3) + two_layers_and_bed()},
      {"the sun over a film on waves",
       sun_at(50) + everywhere_in_sea + film(3) + two_layers_and_bed(wavy_without_foam)},
      {"a film that shines", converted("")},
      {"a film that shines on waves",
       converted("surface = { model = \"cox-munk\", wind_speed_m_s = 5.0 }\n")},
      {"a lamp in the water", lamp_at(-0.7, 180) + in_sea + two_layers_and_bed()},
      {"a lamp under waves", lamp_at(-0.7, 120) + in_sea + two_layers_and_bed(wavy)},
      {"a lamp above the sea", lamp_at(0.6, 180) + in_sea + two_layers_and_bed()},
      {"a lamp above waves", lamp_at(0.6, 180) + in_sea + two_layers_and_bed(wavy)},
      {"a lamp in the air", lamp_at(0.6, 180) + in_sea + two_airs + two_layers_and_bed()},
      {"a lamp in the water under air",
       lamp_at(-0.7, 180) + in_sea + two_airs + two_layers_and_bed()},
      {"a lamp under air and waves",
       lamp_at(-0.7, 180) + in_sea + two_airs + two_layers_and_bed(wavy)},
      {"a laser under air and waves",
       light("laser", laser) + in_sea + two_airs + two_layers_and_bed(wavy_for_lasers)},
      {"a point in the water under air",
       light("point", point) + in_sea + two_airs + two_layers_and_bed()},
      {"a point", light("point", point) + in_sea + two_layers_and_bed()},
      {"a disc", light("beam", disc) + in_sea + two_airs + two_layers_and_bed()},
      {"a laser", light("laser", laser) + in_sea + two_layers_and_bed()},
      {"a lamp among columns", lamp_at(-0.7, 180) + in_columns + columns_and_beds()},
      {"a lamp among columns under waves",
       lamp_at(-0.7, 180) + in_columns + columns_and_beds(wavy)},
      {"a lamp in a raft",
       lamp_at(-0.7, 180) + in_columns + columns_and_beds("", "x_min_m = -0.4\n", raft_ends)},
      {"a disc over the end of a raft",
       light("beam", "position_m = [1.7, 0, 3]\nzenith_deg = 30\ndiameter_m = 0.5") + in_columns +
           columns_and_beds("", "x_min_m = -0.1\n", raft_ends)},
      {"a laser beside a face over waves",
       light("laser", laser) + in_columns +
           columns_and_beds(wavy_for_lasers, "x_min_m = -0.4\n", raft_ends)},
      {"the sun in air alone",
       sun_at(50) + tally_of("boundaries") + tally_of("irradiance", {{}, {0, 0.5, 1, 2}}) +
           tally_of("radiance", {{}, {0, 1, 2}}, "direction_deg = [[0, 0], [70, 120], [150, 90]]") +
           air_over_ground},
      {"a lamp in air alone", lamp_at(0.6, 180) + tally_of("boundaries") +
                                  tally_of("irradiance", {{}, {0, 0.5, 1, 2}}) + strips_in_air +
                                  air_over_ground}};
}

}  // namespace photic::test
