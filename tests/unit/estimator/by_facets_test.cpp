// Walks that meet facets one by one: those that go the way of light backwards draw the same ways,
// and know how likely the others do.
#include "estimator/crossing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/constants.hpp"
#include "core/random.hpp"

namespace photic::estimator {
namespace {

using surface::RoughSurface;
using surface::WavesView;

/// Steep and not alike to all sides, Gram-Charlier's series included; with whitecaps.
WavesView steep_waves(double whitecaps) {
  WavesView w;
  w.upwind_deviation = 0.30, w.crosswind_deviation = 0.24;
  w.upwind_x = std::cos(1.2), w.upwind_y = std::sin(1.2);
  w.series = {.c21 = -0.05, .c03 = -0.10, .c40 = 0.4, .c22 = 0.12, .c04 = 0.23};
  w.whitecap_fraction = whitecaps;
  return w;
}
constexpr surface::Whitecaps<double> none{};
constexpr surface::Whitecaps<double> some{0.2, 0.22, 1 - 0.78 / (1.34 * 1.34)};

constexpr auto ignored = [](bool, const surface::FacetHit<double>&) {};

/// Mean over walks, and its error.
struct Mean {
  double sum = 0, squares = 0, n = 0;
  void add(double x) { sum += x, squares += x * x, n += 1; }
  [[nodiscard]] double value() const { return sum / n; }
  [[nodiscard]] double error() const {
    return std::sqrt(squares / n - value() * value()) / std::sqrt(n);
  }
};

/// Of a way from a direction in which light rises in the water to one in which it goes down again.
using Weighing = std::function<double(const Vec3<double>& in, const Vec3<double>& out)>;
double slanted(const Vec3<double>& in, const Vec3<double>& out) {
  return 1 + 0.7 * in.x - 0.4 * out.y + 0.5 * in.y * out.x + 2 * std::pow(1 - in.z, 4);
}

enum class By { light, back };
enum class ScoredBy { weight, chance, chance_inverse, one };

/// Of walks by so many facets, one or several, that begin in directions from Lambert's law.
Mean mean_of(By by, const RoughSurface<double>& surface, bool several, ScoredBy scored, int walks,
             Facets which = Facets::any) {
  const RandomKey key{(by == By::light ? 7U : 8U) + (which == Facets::any ? 0U : 10U)};
  Mean mean;
  for (std::uint64_t n = 0; n < static_cast<std::uint64_t>(walks); ++n) {
    const auto draw = [&](std::uint32_t block) { return uniforms<double>(key, n, 1, block); };
    const auto u = uniforms<double>(key, n, 0, 0);
    const double c = std::sqrt(1 - u[0]), s = std::sqrt(u[0]), a = 2 * pi * u[1];
    transport::Photon<double> photon;
    const Vec3<double> begun = photon.direction = {s * std::cos(a), s * std::sin(a), c};
    const auto met =
        walk_by_facets(by == By::back, surface, photon, true, false, which, draw, ignored);
    if (!met.in_water || met.several != several) {
      mean.add(0);
      continue;
    }
    const double g =
        by == By::light ? slanted(begun, photon.direction) : slanted(-photon.direction, -begun);
    const double bounded = scored == ScoredBy::weight   ? photon.weight
                           : scored == ScoredBy::one    ? 1
                           : scored == ScoredBy::chance ? met.chance
                                                        : 1 / met.chance;
    mean.add(g * bounded);
  }
  return mean;
}

void expect_same(const Mean& a, const Mean& b, double within, const char* what) {
  const double error = std::hypot(a.error(), b.error());
  EXPECT_LT(std::abs(a.value() - b.value()), 4 * error) << what;
  EXPECT_LT(error, within * std::abs(a.value())) << what;
}

constexpr int walks = 400000;

// What light goes from all directions to all: light's own walks and those backwards give the same,
// by one facet and by several, with whitecaps and without. 12 comparisons of 4 errors.
TEST(ByFacets, WalksBackwardsCarryWhatLightDoes) {
  for (const auto& white : {none, some}) {
    const WavesView waves = steep_waves(white.fraction);
    const RoughSurface<double> surface{waves, 1.34, white};
    for (const bool several : {false, true})  // seen red: without 1 / (1 + Smith's function)
      expect_same(mean_of(By::light, surface, several, ScoredBy::weight, walks),
                  mean_of(By::back, surface, several, ScoredBy::weight, walks), 0.05,
                  several ? "several facets" : "one facet");
  }
}
// Walks that are to return carry the same, and most do. 8 comparisons of 4 errors. Seen red:
// without the chance in the weight.
TEST(ByFacets, WalksThatReturnCarryWhatOthersDo) {
  for (const auto& white : {none, some}) {
    const WavesView waves = steep_waves(white.fraction);
    const RoughSurface<double> surface{waves, 1.34, white};
    const auto mean = [&](By by, bool several, ScoredBy scored, Facets which) {
      return mean_of(by, surface, several, scored, walks, which);
    };
    for (const By by : {By::light, By::back}) {
      for (const bool several : {false, true})
        expect_same(mean(by, several, ScoredBy::weight, Facets::any),
                    mean(by, several, ScoredBy::weight, Facets::that_return), 0.08,
                    several ? "several facets" : "one facet");
      EXPECT_GT(mean(by, false, ScoredBy::one, Facets::that_return).value(),
                1.5 * mean(by, false, ScoredBy::one, Facets::any).value());
    }
  }
}
// The chance of the one over that of the other: weighed with it, the one draws as the other does.
TEST(ByFacets, KnowHowLikelyTheOtherWalkIs) {
  for (const auto& white : {none, some}) {
    const WavesView waves = steep_waves(white.fraction);
    const RoughSurface<double> surface{waves, 1.34, white};
    for (const bool several : {false, true}) {
      expect_same(mean_of(By::light, surface, several, ScoredBy::chance, walks),
                  mean_of(By::back, surface, several, ScoredBy::one, walks), 0.1,
                  several ? "light, several" : "light, one");
      expect_same(mean_of(By::back, surface, several, ScoredBy::chance_inverse, walks),
                  mean_of(By::light, surface, several, ScoredBy::one, walks), 0.1,
                  several ? "back, several" : "back, one");
    }
  }
}

/// Of walks that come down in the air, weighed by where they go in the water.
Mean mean_from_air(By by, const RoughSurface<double>& surface, bool several, bool must) {
  const RandomKey key{by == By::light ? 9U : 10U + (must ? 1U : 0U)};
  Mean mean;
  for (std::uint64_t n = 0; n < static_cast<std::uint64_t>(walks); ++n) {
    const auto draw = [&](std::uint32_t block) { return uniforms<double>(key, n, 1, block); };
    transport::Photon<double> photon;
    photon.direction = {0.8, 0.1, -std::sqrt(1 - 0.65)};
    const bool back = by == By::back;
    const auto which = back && must ? Facets::several : Facets::any;
    const auto met = walk_by_facets(back, surface, photon, true, true, which, draw, ignored);
    const bool counts = met.in_water && met.several == several;
    mean.add(counts ? photon.weight * (1 + photon.direction.x) : 0);
  }
  return mean;
}
// A telescope's walk carries étendue: through one facet 1 / n^2 of what light does.
TEST(ByFacets, WalksBackwardsTakeTheSquareOfTheIndex) {
  const WavesView waves = steep_waves(0.2);
  const RoughSurface<double> surface{waves, 1.34, some};
  const auto light = mean_from_air(By::light, surface, false, false);
  auto back = mean_from_air(By::back, surface, false, false);
  back.sum *= 1.34 * 1.34, back.squares *= std::pow(1.34, 4);
  expect_same(light, back, 0.02, "one facet");
}
// Walks that have to meet a further facet do so as often as those that choose.
TEST(ByFacets, WalksThatMeetSeveralAreTheSameIfTheyHaveTo) {
  const WavesView waves = steep_waves(0.2);
  const RoughSurface<double> surface{waves, 1.34, some};
  expect_same(mean_from_air(By::back, surface, true, false),
              mean_from_air(By::back, surface, true, true), 0.15, "several");
}

}  // namespace
}  // namespace photic::estimator
