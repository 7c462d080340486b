// Pieces of scene files that tests put together.
#pragma once

#include <fmt/format.h>

#include <string>

#include "scene/read.hpp"

namespace photic::test {

inline scene::Scene read(const std::string& toml) {
  return scene::read_scene_text(toml, "test.toml", ".").scene;
}

/// The instrument of the paper's Table 1.
inline const std::string ship_instrument = R"(
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, 12.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.04
half_divergence_mrad = 5.0
[[telescope]]
position_m = [0.0, 0.0, 12.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.40
focal_length_m = 2.0
detector_diameter_m = 0.04
)";

/// Beside its beam, a metre deep, tilted and obstructed.
inline const std::string submerged_telescope = R"(
[[telescope]]
name = "below"
position_m = [0.3, 0.0, -1.0]
direction = [0.0, 0.1, -1.0]
diameter_m = 0.10
focal_length_m = 0.5
detector_diameter_m = 0.05
obstruction_diameter_m = 0.02
)";

inline std::string channel(const std::string& process) {
  return fmt::format("[[channel]]\nname = \"{0}\"\nprocess = \"{0}\"\n", process);
}

inline const std::string henyey_greenstein_phase = R"({ model = "henyey-greenstein", g = 0.924 })";
inline const std::string peaked_phase =
    R"({ model = "fournier-forand", refractive_index = 1.10, slope = 3.5835 })";

/// A bottomless layer at 532 nm.
inline std::string water(double a_per_m, double b_per_m, const std::string& phase) {
  return fmt::format(
      "[[sea.layer]]\niop = [ {{ wavelength_nm = 532.0, a_per_m = {}, b_per_m = {} }} "
      "]\nphase_function = {}\n",
      a_per_m, b_per_m, phase);
}

/// The optics of a layer of water or air, alike from 355 to 800 nm.
inline std::string scattering(double a_per_m, double b_per_m, double g) {
  return fmt::format(
      "iop = [{{ wavelength_nm = 355.0, a_per_m = {0}, b_per_m = {1} }}, "
      "{{ wavelength_nm = 800.0, a_per_m = {0}, b_per_m = {1} }}]\n"
      "phase_function = {{ model = \"henyey-greenstein\", g = {2} }}\n",
      a_per_m, b_per_m, g);
}
inline std::string depth_gates(double max_m, double step_m) {
  return fmt::format("[gates]\ndepth_max_m = {}\ndepth_step_m = {}\n", max_m, step_m);
}

/// `more` are further lines of the section.
inline std::string simulation(double photons, std::uint64_t seed, const std::string& more = "",
                              const std::string& estimator = "forward") {
  return fmt::format("[simulation]\nestimator = \"{}\"\nphotons = {:.0f}\nseed = {}\n{}\n",
                     estimator, photons, seed, more);
}

/// Of a bidirectional run without the pilot runs that else choose how many free walks it has.
inline const std::string no_free_walks = "free_telescope_meetings = 0.0\nfree_laser_meetings = 0.0";

/// Of much, little and very much chlorophyll, down to a sea bed at 15 m.
inline const std::string three_layers = R"(
[[sea.layer]]
bottom_depth_m = 4.0
chlorophyll_mg_m3 = 1.0
[[sea.layer]]
bottom_depth_m = 9.0
chlorophyll_mg_m3 = 0.1
[[sea.layer]]
bottom_depth_m = 15.0
chlorophyll_mg_m3 = 5.0
)";
}  // namespace photic::test
