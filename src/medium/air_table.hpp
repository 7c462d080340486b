// The optics of the air's layers as the table that those of water come as.
#pragma once

#include <vector>

#include "medium/optical_table.hpp"
#include "optics/air.hpp"

namespace photic::medium {

/// The table of each layer between two levels of the profile, for ascending wavelengths: the parts
/// are molecules, ozone and aerosols. Phase functions have all their detail; b_b and g are those of
/// a PhaseTable. Throws InputError for a wavelength without data or a model that does not exist.
OpticalTable air_table(const optics::Library& library, const optics::AirProfile& profile,
                       const optics::AerosolChoice& aerosols,
                       const std::vector<double>& wavelength_nm);

/// The table of the air above a scene's sea, in the layers that light in it meets. Throws the same.
OpticalTable air_table(const scene::Scene& scene, const optics::Library& library,
                       const std::vector<double>& wavelength_nm);

}  // namespace photic::medium
