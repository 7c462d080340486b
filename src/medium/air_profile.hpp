// The air of a scene as it is given: a profile up to the top, with its aerosols and gases, or
// layers. The check of a scene asks for each part by itself.
#pragma once

#include <string>
#include <vector>

#include "optics/air.hpp"
#include "optics/air_library.hpp"
#include "scene/scene.hpp"

namespace photic::medium {

/// The profile of a scene that has one, with its aerosols. Throws InputError where it is of no use.
optics::AirProfile whole_profile(const scene::Atmosphere& air, const optics::AirLibrary& library);

/// Remarks on levels of a scene that are possible, but more likely in another unit.
std::vector<std::string> doubts_about_levels(const scene::Atmosphere& air);

/// The part of it below the top of the air. Throws InputError if it does not reach it.
optics::AirProfile profile_to_top(const scene::Atmosphere& air, const optics::AirProfile& whole);

/// The profile below the top, with as much aerosol as the scene's optical depth has, if it gives
/// one. Throws InputError where that cannot be.
optics::AirProfile as_deep_as_given(const scene::Atmosphere& air, optics::AirProfile to_top);

/// Optical depths by other gases than ozone, from the sea straight up to each rung. Throws
/// InputError for wavelengths without data, and where it is less than up to a lower rung.
std::vector<double> gas_depths(const scene::Atmosphere& air, double wavelength_nm);

/// The choice of aerosols by altitude.
optics::AerosolChoice aerosols_of(const scene::Atmosphere& air);

/// A layer given outright as a layer of water, for LayerOptics.
scene::Layer as_layer(const scene::AirLayer& layer);

}  // namespace photic::medium
