// The film of oil of a scene, as numbers of a Medium.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "medium/lines.hpp"
#include "medium/medium.hpp"
#include "optics/library.hpp"
#include "optics/oil.hpp"
#include "scene/scene.hpp"

namespace photic::medium {

/// The oil of a scene, with its own yield, lifetime and absorption; none if it has no film, or one
/// of thickness 0. Throws InputError for a table that is of no use.
std::optional<optics::Oil> oil_of(const scene::Scene& scene, const optics::Library& library);

/// The lines of an oil's light that some channel counts; no layer of water emits into them. Their
/// photons are those per photon of the laser's light that the oil absorbs.
std::vector<EmittedLine> oil_lines(const scene::Scene& scene, const optics::Oil& oil);

/// Fills in the medium's film, at its lines. Throws InputError for a wavelength without data.
void add_film(const scene::Scene& scene, const optics::Oil& oil, Medium& medium);

/// The loss in a flat film of light that comes down along the laser's axis, and goes up along a
/// telescope's as light that a channel counts.
struct FilmBothWays {
  double attenuation_per_m = 0;  ///< absorption along both ways, per thickness
  double interface_ratio = 1;    ///< transmission of a clear film over that of bare water
};
/// NaN where an instrument is in the water, or looks along the surface.
FilmBothWays film_both_ways(const scene::Scene& scene, const Medium& medium, std::size_t telescope,
                            std::size_t channel);

/// Fills in the medium's film_changes by the films of a scene's environments and derivatives, if
/// some differ from its own. Throws InputError where the scene's histories do not
/// cover them.
void add_films_of_environments(const scene::Scene& scene, const optics::Library& library,
                               Medium& medium, const std::stop_token& stop);

/// Fills in the tables of a medium's film_changes.
void fill_film_tables(Medium& medium, const std::stop_token& stop);

/// Gives the air the film of the sea below it: its index is that against the water, which lies
/// outside of the air.
void add_film_from_air(const Medium& sea, Medium& air, const std::stop_token& stop);

}  // namespace photic::medium
