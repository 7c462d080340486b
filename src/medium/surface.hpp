// The sea surface of a scene, as numbers of a Medium.
#pragma once

#include "medium/medium.hpp"
#include "optics/library.hpp"
#include "scene/scene.hpp"

namespace photic::medium {

/// The slopes of facets that a scene asks for. Flat at a wind of 0.
optics::SlopeLaw slopes_of(const scene::Surface& surface);

/// The share of the surface that whitecaps cover, and why; 0 where there are none.
optics::Sourced whitecap_fraction_of(const scene::Surface& surface);

/// The reflectance of whitecaps for light from above. Throws InputError for a wavelength without
/// data.
optics::Sourced whitecap_reflectance_of(const scene::Surface& surface,
                                        const optics::Library& library, double wavelength_nm);

/// Fills in the medium's waves and whitecaps, at its lines. Throws InputError for a wavelength at
/// which no reflectance of whitecaps is known.
void add_surface(const scene::Scene& scene, const optics::Library& library, Medium& medium);

/// Fills in the surfaces of a scene's environments and derivatives, if some differ from the
/// medium's own, which has to be filled in before.
void add_surfaces_of_environments(const scene::Scene& scene, Medium& medium);

}  // namespace photic::medium
