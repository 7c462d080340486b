// What a path's weight becomes in other water: against that water itself, and lane by lane.
#include "transport/environments.hpp"

#include <cmath>

#include "unit/instrument/telescopes.hpp"
#include "unit/transport/packs.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using test::Random;

constexpr double more_molecules = 0.3;  // of all scattering, in environment 1

/// The sea with two environments: itself, and one with other attenuation and emission everywhere
/// and more scattering by molecules.
medium::Medium make_environments() {
  medium::Medium sea = make_sea(60);
  auto& e = sea.environments;
  e.count = 2;
  e.parts = 1;
  e.part_phase.assign(sea.c.size(), sea.elastic_phase[2]);
  for (int environment = 0; environment < 2; ++environment) {
    for (std::size_t i = 0; i < sea.c.size(); ++i) {
      const double other = environment;
      e.excess_c.push_back(other * (i % 2 == 0 ? 0.1 : -0.5) * sea.c[i]);
      e.excess_emitted.push_back(other * (i < 3 ? 0.1 : 0.5));
      e.excess_part.push_back(other * more_molecules);
    }
  }
  sea.finish();
  return sea;
}

/// The water of environment 1, on its own.
medium::Medium make_other() {
  medium::Medium sea = make_environments();
  for (std::size_t i = 0; i < sea.c.size(); ++i)
    sea.c[i] += sea.environments.excess_c[sea.c.size() + i];
  sea.environments = {};
  sea.finish();
  return sea;
}

double depth_of_way(const medium::Medium& sea, const Photon<double>& a, const Photon<double>& b) {
  return sea.view().slant_optical_depth<double>(a.line, a.layer, -a.position.z, b.layer,
                                                -b.position.z, length(b.position - a.position));
}

// Seen red: with the depths of the medium in place of what they have in excess; with the sign of
// the way up lost; with the line of the first environment for all.
TEST(Environments, WaysAreDeeperByWhatTheirWaterAttenuatesMore) {
  const auto sea = make_environments(), other = make_other();
  Random random(301);
  for (int i = 0; i < groups; ++i) {
    Photon<double> from = random_photon(sea, random), to = random_photon(sea, random);
    to.line = from.line;
    Ratios<double> ratios;
    ratios.begin(sea.view());
    ratios.before = from;
    ratios.flown(sea.view(), to, length(to.position - from.position));
    EXPECT_EQ(ratios.of_path[0], 1);
    const double deeper = depth_of_way(other, from, to) - depth_of_way(sea, from, to);
    ASSERT_NEAR(std::log(ratios.of_path[1]), -deeper, 1e-11 * (1 + std::abs(deeper)));
  }
}

// Seen red: without the scene's own scattering; with the emission of the
// line before.
TEST(Environments, CollisionsAreThoseOfTheirWater) {
  const auto sea = make_environments();
  const auto view = sea.view();
  Random random(302);
  for (int i = 0; i < groups; ++i) {
    Ratios<double> ratios;
    ratios.begin(view);
    Photon<double> after = ratios.before = random_photon(sea, random);
    after.direction = random.direction();
    const bool converts = after.line == 0 && random.chance(0.5);
    if (converts) after.line = 1;
    ratios.collided(view, after, true);
    EXPECT_EQ(ratios.of_path[0], 1);
    const double x = one_minus_cos(ratios.before.direction, after.direction);
    const auto here = static_cast<std::size_t>(view.at(ratios.before.line, after.layer));
    const double p = view.phases.value<double>(x, sea.elastic_phase[here]);
    const double molecules = view.phases.value<double>(x, sea.elastic_phase[2]);
    const double expected = converts ? 1.5 : (p + more_molecules * molecules) / p;
    ASSERT_NEAR(ratios.of_path[1], expected, 1e-12 * expected);
  }
}

/// No walk may draw longer ways than an environment lets pass. Seen red: with the scene's alone.
TEST(Environments, FreePathsAreNoLongerThanInTheClearestWater) {
  const auto sea = make_environments();
  for (std::size_t i = 0; i < sea.c.size(); ++i) {
    const auto cell = static_cast<std::int32_t>(i);
    const double walk = gather<double>(sea.view().walk_c, cell);
    EXPECT_LE(walk, sea.c[i] * (1 + 1e-15));
    EXPECT_LE(walk, (sea.c[i] + sea.environments.excess_c[sea.c.size() + i]) * (1 + 1e-15));
    EXPECT_NEAR(walk + gather<double>(sea.view().continuous_c, cell), sea.c[i], 1e-15);
  }
}

TEST(LanesOf, Ratios) {
  const auto sea = make_environments();
  const auto view = sea.view();
  Random random(303);
  for (int g = 0; g < groups; ++g) {
    const auto start = four([&] { return random_photon(sea, random); });
    auto end = four([&] { return random_photon(sea, random); });
    for (std::size_t i = 0; i < lanes; ++i) end[i].line = start[i].line;
    const auto mask = four([&] { return random.chance(0.7); });
    const auto flight = uniforms4(random);
    Ratios<Lanes4> packed;
    packed.begin(view);
    packed.before = pack(start);
    packed.flown(view, pack(end), pack(flight));
    packed.before = pack(end);
    auto after = end;
    for (std::size_t i = 0; i < lanes; ++i) {
      after[i].direction = random.direction();
      if (after[i].line == 0 && random.chance(0.5)) after[i].line = 1 + random.below(2);
    }
    packed.collided(view, pack(after), pack(mask));
    for (std::size_t i = 0; i < lanes; ++i) {
      Ratios<double> one;
      one.begin(view);
      one.before = start[i];
      one.flown(view, end[i], flight[i]);
      one.before = end[i];
      one.collided(view, after[i], mask[i]);
      for (std::size_t e = 0; e < 2; ++e)
        expect_same(packed.of_path[e][i], one.of_path[e], "ratio");
    }
  }
}

TEST(LanesOf, WayRatio) {
  const auto sea = make_environments();
  const auto view = sea.view();
  Random random(304);
  for (const bool submerged : {false, true}) {
    instrument::Telescope<double> telescope;
    telescope.submerged = submerged;
    instrument::Telescope<Lanes4> telescopes;
    telescopes.submerged = submerged;
    for (int g = 0; g < groups; ++g) {
      const bool mirrored = submerged && random.chance(0.5);
      const auto at = four([&] { return random_photon(sea, random); });
      Four<Connection<double>> way;
      Four<double> length_water{};
      Four<Vec3<double>> direction;
      for (std::size_t i = 0; i < lanes; ++i) {
        way[i].direction = direction[i] = random.direction();
        way[i].length_water = length_water[i] = random.between(1, 20);
      }
      Connection<Lanes4> ways;
      ways.direction = pack(direction);
      ways.length_water = pack(length_water);
      const auto packed = way_ratio<Lanes4>(view, 1, pack(at).line, pack(at), ways, telescopes,
                                            Index4(0), mirrored);
      for (std::size_t i = 0; i < lanes; ++i) {
        expect_same(packed[i],
                    way_ratio<double>(view, 1, at[i].line, at[i], way[i], telescope, 0, mirrored),
                    "ratio of a way");
      }
    }
  }
}

}  // namespace
}  // namespace photic::transport
