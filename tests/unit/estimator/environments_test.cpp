// What a path's weight becomes in other water: against that water itself, and lane by lane.
#include "estimator/variations/ratios.hpp"

#include <cmath>
#include <vector>

#include "estimator/bidirectional/path_point.hpp"
#include "geometry/sightline.hpp"
#include "transport/connect.hpp"
#include "unit/transport/packs.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using test::Random;

constexpr double more_molecules = 0.3;  // of all scattering, in environment 1
constexpr int both = 2;                 // environments; and a tangent

/// The sea with two environments: itself, and one with other attenuation and emission everywhere
/// and more scattering by molecules. Behind them a tangent, that of the second one's excess.
Sea make_environments() {
  Sea sea = make_sea(60);
  auto& e = sea.environments;
  e.count = both + 1;
  e.first_tangent = both;
  e.parts = 1;
  e.part_phase.assign(sea.c.size(), sea.elastic_phase[2]);
  for (const double other : {0, 1, 1}) {
    for (std::size_t i = 0; i < sea.c.size(); ++i) {
      e.excess_c.push_back(other * (i % 2 == 0 ? 0.1 : -0.5) * sea.c[i]);
      e.excess_emitted.push_back(other * (i < 3 ? 0.1 : 0.5));
      e.excess_part.push_back(other * more_molecules);
    }
  }
  sea.finish();
  return sea;
}

/// The water of environment 1, on its own.
Sea make_other() {
  Sea sea = make_environments();
  for (std::size_t i = 0; i < sea.c.size(); ++i)
    sea.c[i] += sea.environments.excess_c[sea.c.size() + i];
  sea.environments = {};
  sea.finish();
  return sea;
}

double depth_of_way(const Sea& sea, const Photon<double>& a, const Photon<double>& b) {
  return geometry::optical_depths(
             sea.view(), geometry::Segment<double>{a.line, geometry::level_of(sea.view(), a),
                                                   geometry::level_of(sea.view(), b),
                                                   length(b.position - a.position)})
      .all;
}

/// A path on its own.
struct Kept {
  explicit Kept(const medium::MediumView& sea) : paths(sea.environments, 1) {
    ratios.paths = &paths;
    paths.of(0).begin(sea.environments);
  }
  estimator::PathRatios<double> paths;
  estimator::Ratios<double> ratios;
};

/// The ratios that a path has if nothing more happens to it, [environment].
template <class T>
std::vector<Element<T>> ratios_of(const medium::MediumView& sea, estimator::PathRatios<T>& paths,
                                  std::size_t path) {
  std::vector<Element<T>> out(static_cast<std::size_t>(sea.environments.stride));
  estimator::complete<T>(
      sea, {}, 0, [&](std::int32_t e) { return paths.at(path, e); }, out.data());
  return out;
}

// Seen red: with the depths of the medium in place of what they have in excess; with the sign of
// the way up lost; with the line of the first environment for all.
TEST(Environments, WaysAreDeeperByWhatTheirWaterAttenuatesMore) {
  const auto sea = make_environments(), other = make_other();
  const auto view = sea.view();
  Random random(301);
  for (int i = 0; i < groups; ++i) {
    Photon<double> from = random_photon(sea, random), to = random_photon(sea, random);
    to.line = from.line;
    Kept path(view);
    path.ratios.before = from;
    path.ratios.flown(view, to, length(to.position - from.position), true);
    const auto ratio = ratios_of(view, path.paths, 0);
    EXPECT_EQ(ratio[0], 1);
    const double deeper = depth_of_way(other, from, to) - depth_of_way(sea, from, to);
    ASSERT_NEAR(std::log(ratio[1]), -deeper, 1e-11 * (1 + std::abs(deeper)));
    ASSERT_NEAR(ratio[2], 1 - deeper, 1e-11 * (1 + std::abs(deeper)));
  }
}

// Seen red: without the scene's own scattering; with the emission of the
// line before.
TEST(Environments, CollisionsAreThoseOfTheirWater) {
  const auto sea = make_environments();
  const auto view = sea.view();
  Random random(302);
  for (int i = 0; i < groups; ++i) {
    Kept path(view);
    Photon<double> after = path.ratios.before = random_photon(sea, random);
    after.direction = random.direction();
    const bool converts = after.line == 0 && random.chance(0.5);
    if (converts) after.line = 1;
    path.ratios.collided(view, after, true);
    const auto ratio = ratios_of(view, path.paths, 0);
    EXPECT_EQ(ratio[0], 1);
    const double x = one_minus_cos(path.ratios.before.direction, after.direction);
    const auto here = static_cast<std::size_t>(view.at(path.ratios.before.line, after.layer));
    const double p = view.phases.value<double>(x, sea.elastic_phase[here]);
    const double molecules = view.phases.value<double>(x, sea.elastic_phase[2]);
    const double expected = converts ? 1.5 : (p + more_molecules * molecules) / p;
    ASSERT_NEAR(ratio[1], expected, 1e-12 * expected);
    ASSERT_NEAR(ratio[2], expected, 1e-12 * expected);
  }
}

// A tangent is a sum, of all that happens, where an environment is a product. Seen red: with the
// product in place of the sum.
TEST(Environments, TangentsAddUp) {
  const auto sea = make_environments();
  const auto view = sea.view();
  Random random(305);
  for (int i = 0; i < groups; ++i) {
    Kept path(view);
    double sum = 0;
    for (int event = 0; event < 4; ++event) {
      Kept alone(view);
      Photon<double> from = random_photon(sea, random), to = random_photon(sea, random);
      to.line = from.line;
      for (Kept* one : {&path, &alone}) {
        one->ratios.before = from;
        if (event % 2 == 0)
          one->ratios.flown(view, to, 3, true);
        else
          one->ratios.collided(view, to, true);
      }
      sum += ratios_of(view, alone.paths, 0)[2] - 1;
    }
    ASSERT_NEAR(ratios_of(view, path.paths, 0)[2], 1 + sum, 1e-12 * (1 + std::abs(sum)));
  }
}

// What no number can hold is no light, and counted. Seen red: with what is not finite left in.
TEST(Environments, LoseWhatIsNotFinite) {
  const auto sea = make_environments();
  const auto view = sea.view();
  estimator::PathRatios<double> paths(view.environments, 1);
  paths.of(0).begin(view.environments);
  paths.of(0).product[1] = 1e300;
  paths.of(0).excess_tau[1] = -100;
  std::vector<double> ratio(static_cast<std::size_t>(view.environments.stride), 7.0);
  const auto lost = estimator::complete<double>(
      view, {}, 0, [&](std::int32_t e) { return paths.at(0, e); }, ratio.data());
  EXPECT_EQ(lost, 1U);
  EXPECT_EQ(ratio[0], 1);
  EXPECT_EQ(ratio[1], 0);
}

TEST(Environments, WhatFreePathsLeaveOfTheAttenuationActsAlongThem) {
  const auto sea = make_environments();
  for (std::size_t i = 0; i < sea.c.size(); ++i) {
    const auto cell = static_cast<std::int32_t>(i);
    const double walk = gather<double>(sea.view().walk_c.first, cell);
    EXPECT_LE(walk, sea.c[i] * (1 + 1e-15));
    EXPECT_NEAR(walk + gather<double>(sea.view().continuous_c.first, cell), sea.c[i], 1e-15);
  }
}

TEST(LanesOf, Ratios) {
  const auto sea = make_environments();
  const auto view = sea.view();
  Random random(303);
  estimator::PathRatios<Lanes4> kept(view.environments, lanes);
  for (int g = 0; g < groups; ++g) {
    const auto start = four([&] { return random_photon(sea, random); });
    auto end = four([&] { return random_photon(sea, random); });
    for (std::size_t i = 0; i < lanes; ++i) end[i].line = start[i].line;
    const auto flying = four([&] { return random.chance(0.7); });
    const auto mask = four([&] { return random.chance(0.7); });
    const auto flight = uniforms4(random);
    estimator::Ratios<Lanes4> packed;
    packed.paths = &kept;
    for (std::size_t i = 0; i < lanes; ++i) kept.of(i).begin(view.environments);
    packed.before = pack(start);
    packed.flown(view, pack(end), pack(flight), pack(flying));
    packed.before = pack(end);
    auto after = end;
    for (std::size_t i = 0; i < lanes; ++i) {
      after[i].direction = random.direction();
      if (after[i].line == 0 && random.chance(0.5)) after[i].line = 1 + random.below(2);
    }
    packed.collided(view, pack(after), pack(mask));
    for (std::size_t i = 0; i < lanes; ++i) {
      Kept one(view);
      one.ratios.before = start[i];
      one.ratios.flown(view, end[i], flight[i], flying[i]);
      one.ratios.before = end[i];
      one.ratios.collided(view, after[i], mask[i]);
      const auto in_lanes = ratios_of(view, kept, i), alone = ratios_of(view, one.paths, 0);
      for (std::size_t e = 0; e <= both; ++e) expect_same(in_lanes[e], alone[e], "ratio");
    }
  }
}

/// The ratios of light that is scattered and goes straight to an instrument.
template <class T>
std::vector<Element<T>> completed(const medium::MediumView& sea, const Photon<T>& at,
                                  const Vec3<T>& direction, const T& length, bool submerged,
                                  bool mirrored, std::size_t lane) {
  estimator::PathRatios<T> kept(sea.environments, 1);
  kept.of(0).begin(sea.environments);
  estimator::Completion<T> completion;
  completion.collide(
      sea, {at.line, at.layer, Mask<T>(false), at.line, one_minus_cos(at.direction, direction)});
  geometry::Sightline<T> way;
  way.direction = direction;
  way.secant_water = T(1) / direction.z;
  way.to = {!submerged, Index<T>(0)};
  way.route = route_of(mirrored);
  completion.pass_flat(sea, geometry::along(sea, way, at.line, geometry::level_of(sea, at), length),
                       direction);
  std::vector<Element<T>> out(static_cast<std::size_t>(sea.environments.stride));
  estimator::complete<T>(
      sea, completion, lane, [&](std::int32_t e) { return kept.at(0, e); }, out.data());
  return out;
}

TEST(LanesOf, RatiosOfWhatCompletesAPath) {
  const auto sea = make_environments();
  const auto view = sea.view();
  Random random(304);
  for (const bool submerged : {false, true}) {
    for (int g = 0; g < groups / 4; ++g) {
      const bool mirrored = submerged && random.chance(0.5);
      const auto at = four([&] { return random_photon(sea, random); });
      const auto direction = four([&] { return random.direction(); });
      const auto length = four([&] { return random.between(1, 20); });
      for (std::size_t i = 0; i < lanes; ++i) {
        const auto packed =
            completed(view, pack(at), pack(direction), pack(length), submerged, mirrored, i);
        const auto alone = completed(view, at[i], direction[i], length[i], submerged, mirrored, 0);
        for (std::size_t e = 0; e <= both; ++e) expect_same(packed[e], alone[e], "ratio");
      }
    }
  }
}

}  // namespace
}  // namespace photic::transport
