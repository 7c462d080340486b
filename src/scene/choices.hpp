// What a scene chooses among a few: every value with its word in scene files and what it stands
// for, said once. Keys (describe_*.hpp), messages, results and the schema take their words from
// here.
#pragma once

#include <array>
#include <string>
#include <type_traits>

#include "core/error.hpp"

namespace photic::scene {

/// One value of a choice. All those of an enum E are alternatives(E).
template <class E>
struct Alternative {
  E value;
  const char* word;
  const char* meaning;
};

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

/// How light reaches the detector.
enum class Reception { ray, overlap };
constexpr auto alternatives(Reception) {
  using enum Reception;
  return std::to_array<Alternative<Reception>>(
      {{ray, "ray", "single rays through the lens, which is exact"},
       {overlap, "overlap", "the mean over the lens as if light fell evenly on it"}});
}

/// How the photons or walks of a batch begin.
enum class Sampling { quasi_random, random };
constexpr auto alternatives(Sampling) {
  using enum Sampling;
  return std::to_array<Alternative<Sampling>>(
      {{quasi_random, "quasi-random", "spread evenly, at scrambled Sobol' points"},
       {random, "random",
        "independently, as the forward estimator always does with environments or telescopes in "
        "the water"}});
}

/// Which collisions are scored at points chosen in a telescope's view.
enum class LocalForcedCollisions { conversions, all };
constexpr auto alternatives(LocalForcedCollisions) {
  using enum LocalForcedCollisions;
  return std::to_array<Alternative<LocalForcedCollisions>>(
      {{conversions, "conversions", "those that change the wavelength"},
       {all, "all", "those of scattered light too"}});
}

/// What becomes of photons below the weight threshold.
enum class AtThreshold { roulette, end, analog_absorption };
constexpr auto alternatives(AtThreshold) {
  using enum AtThreshold;
  return std::to_array<Alternative<AtThreshold>>(
      {{roulette, "roulette", "they play Russian roulette"},
       {end, "end", "they end, which makes echoes low"},
       {analog_absorption, "analog-absorption",
        "they may be absorbed by chance in place of losing more weight"}});
}

/// The word of a value.
template <class E>
  requires std::is_enum_v<E>
const char* word_of(E value) {
  for (const auto& alternative : alternatives(value))
    if (alternative.value == value) return alternative.word;
  throw ContractViolation("every value of a choice has a word");
}

/// The value of one of the words.
template <class E>
E value_of(const std::string& word) {
  for (const auto& alternative : alternatives(E{}))
    if (alternative.word == word) return alternative.value;
  throw ContractViolation("no choice is called " + word);
}

}  // namespace photic::scene
