// Checks across keys, after every value has been checked alone. Each looks only at good values.
#pragma once

#include <optional>
#include <string>

#include "scene/findings.hpp"
#include "scene/scene.hpp"

namespace photic::scene {

void check_sea(const Scene& scene, Findings& findings);
/// Columns of water, and what cannot do with them.
void check_columns(const Scene& scene, Findings& findings);
/// Waves and whitecaps, and what cannot do with them.
void check_surface(const Scene& scene, Findings& findings);
/// A film of oil, and what cannot do with it.
void check_oil(const Scene& scene, Findings& findings);
/// The air, and what cannot do with it.
void check_atmosphere(const Scene& scene, Findings& findings);
/// Spherical air, and what is known in it, or in it alone.
void check_spherical(const Scene& scene, Findings& findings);
void check_bottom(const Scene& scene, Findings& findings);
void check_instrument(const Scene& scene, Findings& findings);
/// The quantities beside echoes, and what cannot do with them.
void check_tallies(const Scene& scene, Findings& findings);
void check_gates(const Scene& scene, Findings& findings);
/// Checks that the estimator has what the scene asks for.
void check_estimator(const Scene& scene, Findings& findings);
/// Checks the memory that the tallies need.
void check_memory(const Scene& scene, Findings& findings);

/// Depth of the sea bed, if there is one and nothing is wrong with it.
std::optional<double> sea_bed_m(const Scene& scene, const Findings& findings);

/// Returns whether there is a sea bed that may reflect light, below all columns or below one.
bool has_bed(const Scene& scene);

/// Top of the air above the sea, if there is air and nothing is wrong with it.
std::optional<double> top_of_air_m(const Scene& scene, const Findings& findings);

/// Checks the table of an albedo at a path.
void check_albedo(const UserTable& table, const std::string& path, Findings& findings);

}  // namespace photic::scene
