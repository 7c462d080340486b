// Scenes with a film of oil.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/constants.hpp"
#include "support/scenes.hpp"

namespace photic::test {

inline std::string film(double thickness_um, const std::string& more = "") {
  return fmt::format(
      "[oil]\nclass = \"weakly-absorbing-crude\"\nthickness_um = {}\n"
      "lifetime_ns = 0.0\n{}",
      thickness_um, more);
}
/// A thin beam and a lens of 0.4 m beside each other, looking off nadir.
inline std::string instrument(double height, double off_nadir_deg, double laser_nm) {
  const double t = off_nadir_deg * radian_per_degree;
  const std::string place =
      fmt::format("position_m = [0.0, 0.0, {}]\ndirection = [{:.15g}, 0.0, {:.15g}]\n", height,
                  std::sin(t), -std::cos(t));
  return fmt::format(
      "[source]\nwavelength_nm = {1}\n{0}diameter_m = 1e-6\nhalf_divergence_mrad = 0.1\n"
      "[[telescope]]\n{0}diameter_m = 0.4\nfocal_length_m = 1.0\nhalf_field_of_view_mrad = 50.0\n",
      place, laser_nm);
}
inline const std::string two_gates =
    "[gates]\ndepth_min_m = -1.0\ndepth_max_m = 3.0\ndepth_step_m = 2.0\n";
inline const std::string clear_water = "[[sea.layer]]\nchlorophyll_mg_m3 = 0.1\n";

/// Photons of the laser near a film, wide lenses above it and below it.
inline std::string wide_lenses() {
  return "[source]\nwavelength_nm = 355.0\nposition_m = [0.0, 0.0, 1.0]\n"
         "direction = [0.3, 0.0, -1.0]\ndiameter_m = 0.05\nhalf_divergence_mrad = 50.0\n"
         "[[telescope]]\nname = \"above\"\nposition_m = [0.8, 0.2, 1.0]\n"
         "direction = [-0.2, 0.0, -1.0]\ndiameter_m = 1.5\nfocal_length_m = 3.0\n"
         "half_field_of_view_mrad = 700.0\n"
         "[[telescope]]\nname = \"below\"\nposition_m = [0.3, 0.0, -1.0]\n"
         "direction = [0.2, 0.1, 1.0]\ndiameter_m = 1.0\nfocal_length_m = 2.0\n"
         "half_field_of_view_mrad = 800.0\n";
}

inline const std::string flat = R"(model = "flat")";
inline const std::string waves = R"(model = "cox-munk", wind_speed_m_s = 7.0)";
inline const std::string of_water = channel("raman") + channel("elastic");

}  // namespace photic::test
