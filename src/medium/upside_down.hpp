// The air above the sea as a medium like the sea, upside down: heights above the surface stand for
// depths. The code for instruments and light in the water serves those in the air then, with the
// surface as light from the air sees it.
#pragma once

#include <stop_token>

#include "medium/air.hpp"
#include "medium/medium.hpp"
#include "medium/other_airs.hpp"

namespace photic::medium {

/// The least scattering and absorption [1/m]: a vacuum counts as this, which has no visible effect.
inline constexpr double min_attenuation = 1e-20;

/// Light of the sea's lines is scattered there and absorbed, but not converted. Above the air there
/// is nothing up to the height `end`, where light ends. `counts_to`: the height up to which light
/// that the air scatters may come to a telescope; `others`: other_airs() of the scene.
Medium upside_down(const Air& air, const std::vector<OtherAir>& others, const Medium& sea,
                   double counts_to_m, double end_m, const std::stop_token& stop = {});

/// Takes the group index of the water, which is relative to air, relative to vacuum: n_g n_a + n
/// (n_ga - n_a), with the indices of the lowest air [D]. Its index stays relative to that air.
void count_against_vacuum(const Air& air, Medium& sea);

}  // namespace photic::medium
