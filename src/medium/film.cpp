#include "medium/film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
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
    out.push_back({Process::oil, line.wavelength_nm, std::vector(scene.sea.layer.size(), 0.0),
                   line.counted_by, line.photons});
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

/// A film as light of the medium's lines meets it.
struct LinesOfFilm {
  bool exists = false;
  std::vector<double> index, optical_thickness;  ///< [line]
  double yield = 0;
};
LinesOfFilm lines_of_film(const scene::Scene& scene, const optics::Library& library,
                          const Medium& medium) {
  const auto oil = oil_of(scene, library);
  LinesOfFilm film;
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

/// The share of light of a line, of index n in the water, that goes on by a way.
double going_on(const LinesOfFilm& film, std::size_t l, double n, std::int32_t way, double cosine) {
  const bool from_air = way == back_into_air;
  const double n1 = from_air ? 1 : n, n2 = from_air ? n : 1;
  const auto [other, bare] = optics::refract(n1, n2, cosine);
  if (!film.exists) return way == through_film ? 1 - bare : bare;
  const auto shares = optics::film_shares(
      optics::Film<double>{film.index[l], film.optical_thickness[l]}, n1, n2, cosine, other);
  return way == through_film ? shares.transmittance : shares.reflectance;
}

/// Appends how much less goes on in one film than in another, as an optical depth, times a scale:
/// [way][line][angle]. Angles at which no light goes on have the value of the nearest angle where
/// some does.
void add_crossings(const LinesOfFilm& from, const LinesOfFilm& to, double scale,
                   const Medium& medium, std::vector<double>& out) {
  constexpr double least = 1e-300;
  for (std::int32_t way = 0; way < ways_at_film; ++way)
    for (std::size_t l = 0; l < medium.line.size(); ++l) {
      const double n = medium.line[l].refractive_index;
      double last = 0;
      for (std::int32_t k = 0; k <= film_angle_steps; ++k) {
        const double s = k / static_cast<double>(film_angle_steps), cosine = 1 - s * s;
        const double there = going_on(to, l, n, way, cosine);
        const double here = going_on(from, l, n, way, cosine);
        if (here > 0) last = scale * (std::log(here) - std::log(std::max(there, least)));
        out.push_back(last);
      }
    }
}

/// Two films and what their difference counts, as EnvironmentTables has them.
void add_emissions(const LinesOfFilm& from, const LinesOfFilm& to, double scale, double yield,
                   std::vector<double>& out) {
  for (const LinesOfFilm* film : {&from, &to}) {
    out.insert(out.end(), film->optical_thickness.begin(), film->optical_thickness.end());
    out.push_back(film->exists ? film->yield / yield : 0.0);
  }
  out.push_back(scale);
}

void check_other_film(const std::string& who, bool there, const LinesOfFilm& here,
                      const LinesOfFilm& other) {
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
                               Medium& medium) {
  const auto& own = scene.oil;
  const bool same =
      std::ranges::all_of(scene.environment, [&](const auto& e) { return e.oil == own; }) &&
      std::ranges::all_of(scene.sensitivity, [&](const auto& s) { return s.above.oil == own; });
  if (same) return;
  if (scene.sea.surface.is_one_dimensional())
    throw InputError(
        {{"", 0, 0, "over one-dimensional waves all environments have the film of the scene",
          "write a surface with waves in both directions, or leave 'oil' as it is"}});
  const auto of = [&](const scene::Environment& e) {
    return lines_of_film(scene::scene_in(scene, e), library, medium);
  };
  const LinesOfFilm here = lines_of_film(scene, library, medium);
  const double yield = here.yield > 0 ? here.yield : 1;
  auto& tables = medium.environments;
  const auto add = [&](const LinesOfFilm& from, const LinesOfFilm& to, double scale) {
    add_crossings(from, to, scale, medium, tables.film);
    add_emissions(from, to, scale, yield, tables.film_emission);
  };
  for (const auto& e : scene.environment) {
    const LinesOfFilm there = of(e);
    check_other_film(fmt::format("environment \"{}\"", e.name), there.exists, here, there);
    add(here, there, 1);
  }
  for (const auto& s : scene.sensitivity) {
    const LinesOfFilm above = of(s.above);
    check_other_film(fmt::format("sensitivity \"{}\"", s.path), above.exists, here, above);
    add(of(s.below), above, s.value / (2 * s.step));
  }
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
