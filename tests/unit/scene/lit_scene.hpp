// Scenes of other sources than the laser, and of tallies.
#pragma once

#include <string>

namespace photic::scene {

inline constexpr const char* sun = "kind = \"beam\"\nzenith_deg = 30";
inline constexpr const char* lamp =
    "kind = \"cone\"\nposition_m = [0, 0, -5]\ndirection = [0, 0, 1]\nhalf_angle_deg = 180";
inline constexpr const char* laser =
    "position_m = [0, 0, 12]\ndirection = [0, 0, -1]\ndiameter_m = 0.04\nhalf_divergence_mrad = 5";
inline constexpr const char* telescope =
    "[[telescope]]\nposition_m = [0, 0, 12]\ndirection = [0, 0, -1]\ndiameter_m = 0.4\n"
    "focal_length_m = 2\ndetector_diameter_m = 0.04\n[[channel]]\nname = \"e\"\n"
    "process = \"elastic\"\n[gates]\ndepth_max_m = 15\ndepth_step_m = 1";
inline constexpr const char* balance = "[[tally]]\nkind = \"boundaries\"";
inline constexpr const char* water = "[[sea.layer]]\nbottom_depth_m = 20\nchlorophyll_mg_m3 = 0.1";
inline constexpr const char* air_alone =
    "[atmosphere]\nprofile = \"us-standard\"\ntop_km = 50\nsurface = { albedo = 0.3 }";

/// The keys of the source begin in line 3, the sections after them.
inline std::string lit_scene(const std::string& source, const std::string& sections = balance,
                             const std::string& world = water,
                             const std::string& simulation = "photons = 1000") {
  return "[source]\nwavelength_nm = 532\n" + source + '\n' + sections + '\n' + world +
         "\n[simulation]\n" + simulation + '\n';
}

}  // namespace photic::scene
