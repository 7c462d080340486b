#include "medium/film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/stop.hpp"
#include "optics/film.hpp"

namespace photic::medium {
namespace {

constexpr double metre_per_um = 1e-6;

}  // namespace

std::optional<optics::Oil> oil_of(const scene::Scene& scene, const optics::Library& library) {
  const auto& film = scene.oil;
  if (!film || film->thickness_um == 0) return std::nullopt;
  optics::Oil oil = film->of_class
                        ? optics::oil(library, scene::word_of(*film->of_class))
                        : optics::oil_of_table(film->table.data(), film->yield.value_or(0),
                                               film->lifetime_ns.value_or(0));
  oil.yield = film->yield.value_or(oil.yield);
  oil.lifetime_ns = film->lifetime_ns.value_or(oil.lifetime_ns);
  oil.absorption_per_m = [factor = film->absorption_factor,
                          whole = oil.absorption_per_m](double nm) { return factor * whole(nm); };
  return oil;
}

std::vector<EmittedLine> oil_lines(const scene::Scene& scene, const optics::Oil& oil) {
  const auto spectrum = optics::emission_above(oil, scene.source.wavelength_nm);
  std::vector<EmittedLine> out;
  for (const BandLine& line : lines_of(Process::oil, spectrum, scene))
    out.push_back({Process::oil, line.wavelength_nm,
                   std::vector(scene::layers_of(scene.sea).size(), 0.0), line.counted_by,
                   line.photons});
  return out;
}

void add_film(const scene::Scene& scene, const optics::Oil& oil, Medium& medium) {
  Film& film = medium.film;
  film.exists = true;
  const double thickness_m = scene.oil->thickness_um * metre_per_um;
  for (const Line& line : medium.line) {
    const double nm = line.wavelength_nm;
    film.index.push_back(oil.refractive_index(nm));
    film.optical_thickness.push_back(oil.absorption_per_m(nm) * thickness_m);
    film.emission.push_back(line.process == Process::oil ? line.photons : 0.0);
  }
  for (const auto& property : oil.properties)
    for (const double nm : {medium.line.front().wavelength_nm, medium.line.back().wavelength_nm})
      add_source(fmt::format("{} of the oil ({})", property.item, oil.name), property.source, nm,
                 medium.sources);
}

namespace {

/// The film of a scene, with its own yield.
OtherFilm other_film(const scene::Scene& scene, const optics::Library& library,
                     const Medium& medium) {
  const auto oil = oil_of(scene, library);
  OtherFilm film;
  if (!oil) {
    film.index = film.optical_thickness = std::vector(medium.line.size(), 0.0);
    return film;
  }
  film.exists = true;
  film.yield = oil->yield;
  for (const Line& line : medium.line) {
    film.index.push_back(oil->refractive_index(line.wavelength_nm));
    film.optical_thickness.push_back(oil->absorption_per_m(line.wavelength_nm) *
                                     scene.oil->thickness_um * metre_per_um);
  }
  return film;
}

/// The share of light of a line, of index n in the medium, that goes on by a way.
double going_on(const OtherFilm& film, std::size_t l, double n, std::int32_t way, double cosine) {
  const bool from_outside = way == back_into_air;
  const double n1 = from_outside ? 1 : n, n2 = from_outside ? n : 1;
  const auto [other, bare] = optics::refract(n1, n2, cosine);
  if (!film.exists) return way == through_film ? 1 - bare : bare;
  const auto shares = optics::film_shares(
      optics::Film<double>{film.index[l], film.optical_thickness[l]}, n1, n2, cosine, other);
  return way == through_film ? shares.transmittance : shares.reflectance;
}

/// Appends how much less goes on in one film than in another, as an optical depth, times a scale:
/// [way][line][angle]. Angles at which no light goes on have the value of the nearest angle where
/// some does.
void add_crossings(const FilmChange& change, const Medium& medium, std::vector<double>& out) {
  constexpr double least = 1e-300;
  for (std::int32_t way = 0; way < ways_at_film; ++way)
    for (std::size_t l = 0; l < medium.line.size(); ++l) {
      const double n = medium.line[l].refractive_index;
      double last = 0;
      for (std::int32_t k = 0; k <= film_angle_steps; ++k) {
        const double s = k / static_cast<double>(film_angle_steps), cosine = 1 - s * s;
        const double there = going_on(change.to, l, n, way, cosine);
        const double here = going_on(change.from, l, n, way, cosine);
        if (here > 0) last = change.scale * (std::log(here) - std::log(std::max(there, least)));
        out.push_back(last);
      }
    }
}

/// Two films and what their difference counts, as EnvironmentTables has them.
void add_emissions(const FilmChange& change, std::vector<double>& out) {
  for (const OtherFilm* film : {&change.from, &change.to}) {
    out.insert(out.end(), film->optical_thickness.begin(), film->optical_thickness.end());
    out.push_back(film->exists ? film->yield : 0.0);
  }
  out.push_back(change.scale);
}

void check_other_film(const std::string& who, bool there, const OtherFilm& here,
                      const OtherFilm& other) {
  const auto refuse = [&](const char* reason, const char* suggestion) {
    throw InputError({{"", 0, 0, fmt::format("{}: {}", who, reason), suggestion}});
  };
  if (there && !here.exists)
    refuse("there is a film of oil, but none in the scene itself",
           "give the scene the film, and let environments be without it: oil.thickness_um = 0");
  if (other.yield > 0 && here.yield == 0)
    refuse("the film emits light, but not in the scene itself",
           "no history of the scene has such light: give the scene's oil a yield");
}

}  // namespace

void add_films_of_environments(const scene::Scene& scene, const optics::Library& library,
                               Medium& medium, const std::stop_token& stop) {
  const auto& own = scene.oil;
  const bool same =
      std::ranges::all_of(scene.environment, [&](const auto& e) { return e.oil == own; }) &&
      std::ranges::all_of(scene.sensitivity, [&](const auto& s) { return s.above.oil == own; });
  if (same) return;
  const OtherFilm here = other_film(scene, library, medium);
  const double yield = here.yield > 0 ? here.yield : 1;
  const auto of = [&](const scene::Environment& e) {
    break_off_if(stop);
    return other_film(scene::scene_in(scene, e), library, medium);
  };
  const auto add = [&](OtherFilm from, OtherFilm to, double scale) {
    from.yield /= yield, to.yield /= yield;
    medium.film_changes.push_back({std::move(from), std::move(to), scale});
  };
  for (const auto& e : scene.environment) {
    OtherFilm there = of(e);
    check_other_film(fmt::format("environment \"{}\"", e.name), there.exists, here, there);
    add(here, std::move(there), 1);
  }
  for (const auto& s : scene.sensitivity) {
    OtherFilm above = of(s.above);
    check_other_film(fmt::format("sensitivity \"{}\"", s.path), above.exists, here, above);
    add(of(s.below), std::move(above), s.value / (2 * s.step));
  }
}

void fill_film_tables(Medium& medium, const std::stop_token& stop) {
  for (const FilmChange& change : medium.film_changes) {
    break_off_if(stop);
    add_crossings(change, medium, medium.environments.film);
    add_emissions(change, medium.environments.film_emission);
  }
}

void add_film_from_air(const Medium& sea, Medium& air, const std::stop_token& stop) {
  const auto against_water = [&](std::vector<double>& index) {
    for (std::size_t l = 0; l < index.size(); ++l) index[l] /= sea.line[l].refractive_index;
  };
  air.film = sea.film;
  against_water(air.film.index);
  air.film_changes = sea.film_changes;
  for (FilmChange& change : air.film_changes)
    against_water(change.from.index), against_water(change.to.index);
  fill_film_tables(air, stop);
}

namespace {

/// The way through a film of light of a wavelength along an instrument's axis.
FilmBothWays one_way(const Vec3<double>& position, const Vec3<double>& direction, double index,
                     double absorption_per_m, double water_index) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const double cosine = -direction.z / length(direction);
  if (position.z < 0 || !(cosine > 0)) return {nan, nan};
  const auto [cos_water, bare] = optics::refract(1.0, water_index, cosine);
  const auto clear =
      optics::film_shares(optics::Film<double>{index, 0}, 1.0, water_index, cosine, cos_water);
  return {absorption_per_m / optics::cosine_in_film(index, 1.0, cosine),
          clear.transmittance / (1 - bare)};
}

}  // namespace

FilmBothWays film_both_ways(const scene::Scene& scene, const Medium& medium, std::size_t telescope,
                            std::size_t channel) {
  const Film& film = medium.film;
  const double thickness_m = scene.oil->thickness_um * metre_per_um;
  double all = 0, index = 0, absorption = 0, water = 0;
  for (std::size_t l = 0; l < medium.line.size(); ++l) {
    const Line& line = medium.line[l];
    const double counted = line.photons * line.counted_by[channel];
    all += counted;
    index += counted * film.index[l];
    absorption += counted * film.optical_thickness[l] / thickness_m;
    water += counted * line.refractive_index;
  }
  const auto& t = scene.telescope[telescope];
  const auto down =
      one_way(scene.source.position_m, scene.source.direction, film.index.front(),
              film.optical_thickness.front() / thickness_m, medium.line.front().refractive_index);
  const auto up = one_way(t.position_m, t.direction, index / all, absorption / all, water / all);
  return {down.attenuation_per_m + up.attenuation_per_m, down.interface_ratio * up.interface_ratio};
}

}  // namespace photic::medium
