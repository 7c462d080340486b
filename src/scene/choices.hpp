// The choices of a scene among a few values: every value with its word in scene files and its
// meaning, listed once. Keys (describe_*.hpp), messages, results and the schema take their words
// from here.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/error.hpp"

namespace photic::scene {

/// One value of a choice. All those of an enum E are alternatives(E).
template <class E>
struct Alternative {
  E value;
  const char* word;
  const char* meaning;
};

/// The sources of light.
enum class SourceKind : std::int8_t { laser, beam, point, cone };
constexpr auto alternatives(SourceKind) {
  using enum SourceKind;
  return std::to_array<Alternative<SourceKind>>(
      {{laser, "laser", "a disc that emits light uniformly into a cone"},
       {beam, "beam",
        "parallel light from outside: as wide as the world, as the sun's; with position_m a disc, "
        "or a pencil"},
       {point, "point", "one place in the water or the air, and one direction"},
       {cone, "cone",
        "one place in the water or the air, uniformly into a cone, or to all sides"}});
}

/// The light of a laser by its angle to the axis.
enum class SourceProfile : std::int8_t { disc, gaussian };
constexpr auto alternatives(SourceProfile) {
  using enum SourceProfile;
  return std::to_array<Alternative<SourceProfile>>(
      {{disc, "disc", "even within the disc and the cone"},
       {gaussian, "gaussian",
        "a Gaussian: the diameter and the half divergence are those at 1/e2 of its peak, and it is "
        "cut off at three times these"}});
}

/// The shape of the air's layers.
enum class AirGeometry : std::int8_t { plane, spherical };
constexpr auto alternatives(AirGeometry) {
  using enum AirGeometry;
  return std::to_array<Alternative<AirGeometry>>(
      {{plane, "plane", "level layers"},
       {spherical, "spherical", "shells about the centre of a planet, above a ground"}});
}

/// The ground below air alone.
enum class GroundKind : std::int8_t { lambert, sea };
constexpr auto alternatives(GroundKind) {
  using enum GroundKind;
  return std::to_array<Alternative<GroundKind>>(
      {{lambert, "lambert", "light is reflected evenly, by an albedo"},
       {sea, "sea", "below spherical air a level sea: a mirror by Fresnel's law, black below"}});
}

/// The quantities of radiative transfer that are tallied beside echoes.
enum class TallyKind : std::int8_t { irradiance, boundaries, fluence, radiance };
constexpr auto alternatives(TallyKind) {
  using enum TallyKind;
  return std::to_array<Alternative<TallyKind>>(
      {{irradiance, "irradiance", "plane and scalar irradiances, down and up, at levels"},
       {boundaries, "boundaries", "where all light ends: absorbed, escaped, by layer and angle"},
       {fluence, "fluence", "the fluence about a source, by depth and distance"},
       {radiance, "radiance", "the radiance of scattered light at levels, in directions"}});
}

/// The weight of light at a facet of a rough surface.
enum class FacetWeight : std::int8_t { reciprocal, conserving };
constexpr auto alternatives(FacetWeight) {
  using enum FacetWeight;
  return std::to_array<Alternative<FacetWeight>>(
      {{reciprocal, "reciprocal",
        "by the facet's projected area: light goes both ways alike, and some is gained under "
        "grazing incidence"},
       {conserving, "conserving",
        "the same over its mean, Smith's 1 + Lambda: no light is gained"}});
}

/// The processes that turn light back, in the order of results.
enum class Process : std::int32_t { elastic, raman, chlorophyll, cdom, oil };
constexpr auto alternatives(Process) {
  using enum Process;
  return std::to_array<Alternative<Process>>(
      {{elastic, "elastic", "light of the laser's wavelength"},
       {raman, "raman", "light that water has scattered inelastically, by the Raman effect"},
       {chlorophyll, "chlorophyll", "fluorescence of the chlorophyll in phytoplankton"},
       {cdom, "cdom", "fluorescence of dissolved organic matter"},
       {oil, "oil", "fluorescence of a film of oil on the sea"}});
}

/// The shape of a filter's transmission, 1 at the centre.
enum class FilterShape { top_hat, gaussian };
constexpr auto alternatives(FilterShape) {
  using enum FilterShape;
  return std::to_array<Alternative<FilterShape>>(
      {{top_hat, "top-hat", "passes all light within half of fwhm_nm about the centre, no other"},
       {gaussian, "gaussian", "a Gaussian of that full width at half maximum"}});
}

/// The set that fills in the choices of the water's optics that are not given (presets.hpp).
enum class OpticsSet { modern, paper };
constexpr auto alternatives(OpticsSet) {
  using enum OpticsSet;
  return std::to_array<Alternative<OpticsSet>>(
      {{modern, "modern", "the best data and models of today"},
       {paper, "paper", "those of the PREMAR-2F paper, to compare with it"}});
}

/// The phase functions of a constituent's particles.
enum class ParticlePhase { fournier_forand, petzold, mie };
constexpr auto alternatives(ParticlePhase) {
  using enum ParticlePhase;
  return std::to_array<Alternative<ParticlePhase>>(
      {{fournier_forand, "fournier-forand",
        "Fournier and Forand's function, close to what is measured"},
       {petzold, "petzold", "the average of Petzold's measurements in the sea"},
       {mie, "mie", "the paper's spheres by Mie theory"}});
}

/// The absorption and scattering of minerals.
enum class MineralOptics { power_law, mie };
constexpr auto alternatives(MineralOptics) {
  using enum MineralOptics;
  return std::to_array<Alternative<MineralOptics>>(
      {{power_law, "power-law", "by mass: the coefficients minerals_a_… and minerals_b_…"},
       {mie, "mie", "the paper's spheres by Mie theory"}});
}

/// The emission of Raman light and chlorophyll's fluorescence: with spectra, or as lines.
enum class Emission { spectra, lines };
constexpr auto alternatives(Emission) {
  using enum Emission;
  return std::to_array<Alternative<Emission>>({{spectra, "spectra", "spread over their spectra"},
                                               {lines, "lines", "each at one wavelength"}});
}

/// The fluorescence of dissolved organic matter.
enum class CdomFluorescence { hawes, table };
constexpr auto alternatives(CdomFluorescence) {
  using enum CdomFluorescence;
  return std::to_array<Alternative<CdomFluorescence>>(
      {{hawes, "hawes", "Hawes 1992"},
       {table, "table", "your own matrix: cdom_fluorescence_file"}});
}

enum class PhaseModel {
  henyey_greenstein,
  fournier_forand,
  petzold,
  rayleigh,
  isotropic,
  table,
  mie,
  mixture
};
constexpr auto alternatives(PhaseModel) {
  using enum PhaseModel;
  return std::to_array<Alternative<PhaseModel>>(
      {{henyey_greenstein, "henyey-greenstein", "Henyey and Greenstein's, with a mean cosine g"},
       {fournier_forand, "fournier-forand",
        "Fournier and Forand's, for particles with a hyperbolic size distribution"},
       {petzold, "petzold", "the average of Petzold's measurements in the sea"},
       {rayleigh, "rayleigh", "that of molecules"},
       {isotropic, "isotropic", "the same in all directions"},
       {table, "table", "your own, by angle: file"},
       {mie, "mie", "spheres by Mie theory"},
       {mixture, "mixture", "several of these by their shares: components"}});
}

/// The distribution of the slopes of the sea surface's facets.
enum class SurfaceModel { flat, cox_munk, gaussian, paper };
constexpr auto alternatives(SurfaceModel) {
  using enum SurfaceModel;
  return std::to_array<Alternative<SurfaceModel>>(
      {{flat, "flat", "a level surface without waves"},
       {cox_munk, "cox-munk", "slopes that depend on the wind, Cox & Munk 1954"},
       {gaussian, "gaussian", "a Gaussian of your own variances"},
       {paper, "paper", "PREMAR-2F's: slopes only along the wind, rougher than the sea"}});
}

/// The share of the sea that whitecaps cover, by the wind.
enum class WhitecapLaw { monahan1980, stramska2003 };
constexpr auto alternatives(WhitecapLaw) {
  using enum WhitecapLaw;
  return std::to_array<Alternative<WhitecapLaw>>(
      {{monahan1980, "monahan1980", "Monahan & O'Muircheartaigh 1980"},
       {stramska2003, "stramska2003", "Stramska & Petelski 2003, none below 6.33 m/s"}});
}

/// The reflectance of whitecaps.
enum class WhitecapReflectance { koepke1984, frouin1996 };
constexpr auto alternatives(WhitecapReflectance) {
  using enum WhitecapReflectance;
  return std::to_array<Alternative<WhitecapReflectance>>(
      {{koepke1984, "koepke1984", "Koepke 1984: 0.22 in the visible"},
       {frouin1996, "frouin1996",
        "the same, falling towards the infrared as Frouin et al. 1996 found"}});
}

/// Oils on the sea: the classes of data/oils.csv.
enum class OilClass { light_refined, weakly_absorbing_crude, strongly_absorbing_crude };
constexpr auto alternatives(OilClass) {
  using enum OilClass;
  return std::to_array<Alternative<OilClass>>(
      {{light_refined, "light-refined", "diesel, petrol: hardly absorbs, bright blue fluorescence"},
       {weakly_absorbing_crude, "weakly-absorbing-crude", "light crude oil and lubricants"},
       {strongly_absorbing_crude, "strongly-absorbing-crude", "heavy crude oil and bunker oil"}});
}

enum class Estimator { automatic, bidirectional, forward, analog };
constexpr auto alternatives(Estimator) {
  using enum Estimator;
  return std::to_array<Alternative<Estimator>>(
      {{automatic, "auto",
        "the better of bidirectional and forward, by short pilot runs: with a target, until all "
        "gates meet it; else by the error of all gates at equal cost"},
       {bidirectional, "bidirectional",
        "walks from the laser and from the telescopes, connected and made to meet"},
       {forward, "forward", "photons from the laser, scored at every collision"},
       {analog, "analog",
        "photons followed by chance alone and counted on the detector, to verify the others"}});
}

/// The way of light to the detector.
enum class Reception { ray, overlap };
constexpr auto alternatives(Reception) {
  using enum Reception;
  return std::to_array<Alternative<Reception>>(
      {{ray, "ray", "single rays through the lens, which is exact"},
       {overlap, "overlap", "the mean over the lens, as if it were lit uniformly"}});
}

/// The starts of the photons or walks of a batch.
enum class Sampling { quasi_random, random };
constexpr auto alternatives(Sampling) {
  using enum Sampling;
  return std::to_array<Alternative<Sampling>>(
      {{quasi_random, "quasi-random", "spread evenly, at scrambled Sobol' points"},
       {random, "random",
        "independently, as the forward estimator always does with environments or telescopes in "
        "the water"}});
}

/// The collisions that are scored at points chosen in a telescope's view.
enum class LocalForcedCollisions { conversions, all };
constexpr auto alternatives(LocalForcedCollisions) {
  using enum LocalForcedCollisions;
  return std::to_array<Alternative<LocalForcedCollisions>>(
      {{conversions, "conversions", "those that change the wavelength"},
       {all, "all", "those of scattered light too"}});
}

/// The fate of photons below the weight threshold.
enum class AtThreshold { roulette, end, analog_absorption };
constexpr auto alternatives(AtThreshold) {
  using enum AtThreshold;
  return std::to_array<Alternative<AtThreshold>>(
      {{roulette, "roulette", "they play Russian roulette"},
       {end, "end", "they end, which makes echoes low"},
       {analog_absorption, "analog-absorption",
        "they may be absorbed by chance instead of losing more weight"}});
}

/// The word of a value.
template <class E>
  requires std::is_enum_v<E>
const char* word_of(E value) {
  for (const auto& alternative : alternatives(value))
    if (alternative.value == value) return alternative.word;
  throw ContractViolation("every value of a choice has a word");
}

/// "" where none has been chosen.
template <class E>
std::string word_of(const std::optional<E>& value) {
  return value ? word_of(*value) : "";
}
/// Names that are chosen are words themselves.
inline std::string word_of(std::string name) { return name; }

/// Several values of a choice.
template <class E>
struct Among {
  std::vector<E> values;
  friend bool operator==(const std::optional<E>& value, const Among& among) {
    return value && std::ranges::find(among.values, *value) != among.values.end();
  }
};
/// The words of one value, or of several.
template <class Value>
std::vector<std::string> words_of(const Value& value) {
  return {word_of(value)};
}
template <class E>
std::vector<std::string> words_of(const Among<E>& among) {
  std::vector<std::string> words;
  for (const E value : among.values) words.emplace_back(word_of(value));
  return words;
}

/// The value of one of the words.
template <class E>
E value_of(const std::string& word) {
  for (const auto& alternative : alternatives(E{}))
    if (alternative.word == word) return alternative.value;
  throw ContractViolation("no choice is called " + word);
}

}  // namespace photic::scene
