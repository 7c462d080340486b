// A walk with four lanes: each lane equals the scalar, bit for bit, whichever ways the lanes go.
#include "estimator/forward/forced.hpp"
#include "support/scatter.hpp"
#include "transport/collide.hpp"
#include "transport/cross.hpp"
#include "transport/emit.hpp"
#include "transport/flight.hpp"
#include "unit/transport/enter_water.hpp"
#include "unit/transport/packs.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using test::Random;

Four<Photon<double>> random_photons(const Sea& sea, Random& random) {
  return {random_photon(sea, random), random_photon(sea, random), random_photon(sea, random),
          random_photon(sea, random)};
}

void emit_and_enter(double half_divergence_mrad, std::uint64_t seed,
                    scene::SourceProfile profile = scene::SourceProfile::disc) {
  Random random(seed);
  const auto sea = make_sea(40);
  int flown_away = 0;
  for (int g = 0; g < groups; ++g) {
    scene::Source source;
    source.position_m = {random.between(-1, 1), random.between(-1, 1), random.scale(5, 100)};
    source.direction = {random.between(-1, 1), random.between(-1, 1), -random.uniform()};
    source.diameter_m = random.between(0.001, 0.1);
    source.half_divergence_mrad = half_divergence_mrad;
    source.profile = profile;
    const auto u1 = uniforms4(random);
    const auto u2 = uniforms4(random);
    auto packed = emit(instrument::make_laser<Lanes4>(source), Index4(0), pack(u1), pack(u2));
    Four<Photon<double>> scalar;
    for (std::size_t i = 0; i < lanes; ++i) {
      scalar[i] = emit(instrument::make_laser<double>(source), 0, u1[i], u2[i]);
      expect_same(packed, i, scalar[i]);
    }
    const auto entered = test::enter_water(sea.view(), {true, {}}, packed);
    for (std::size_t i = 0; i < lanes; ++i) {
      expect_same(entered[i], test::enter_water(sea.view(), {true, {}}, scalar[i]), "entered");
      expect_same(packed, i, scalar[i]);
      flown_away += !entered[i];
    }
  }
  if (half_divergence_mrad > 1000) {
    EXPECT_GT(flown_away, groups / 10);
  }
}

TEST(LanesOf, EmitDivergingAndEnterWater) {
  emit_and_enter(5, 11);
  emit_and_enter(1500, 12);
}

TEST(LanesOf, EmitAGaussianAndEnterWater) {
  emit_and_enter(500, 15, scene::SourceProfile::gaussian);
  emit_and_enter(0, 16, scene::SourceProfile::gaussian);
}

TEST(LanesOf, EmitCollimatedAndEnterWater) { emit_and_enter(0, 13); }

// Seen red: with lanes that have found their layer stepping on while others still look for theirs.
TEST(LanesOf, FlyAndReflectDown) {
  Random random(14);
  const auto with_bed = make_sea(40);
  const auto bottomless = make_sea(std::numeric_limits<double>::infinity());
  int up = 0, bed = 0, crossed = 0, total = 0;
  for (int g = 0; g < groups; ++g) {
    const auto& sea = g % 2 == 0 ? with_bed : bottomless;
    auto scalar = random_photons(sea, random);
    auto packed = pack(scalar);
    const auto u = uniforms4(random);
    const auto end = fly(sea.view(), packed, minus_log(pack(u)));
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto layer = scalar[i].layer;
      const auto one = fly(sea.view(), scalar[i], minus_log(u[i]));
      expect_same(end.surface[i], one.surface, "surface");
      expect_same(end.sea_bed[i], one.sea_bed, "sea bed");
      expect_same(packed, i, scalar[i]);
      up += one.surface;
      bed += one.sea_bed;
      crossed += scalar[i].layer != layer;
      // What cannot reflect is turned, so that every lane may be asked.
      if (scalar[i].direction.z < 0) scalar[i].direction.z = -scalar[i].direction.z;
      packed.direction.z.set(i, scalar[i].direction.z);
    }
    const auto leaving = reflect_down(sea.view(), packed).into_air;
    for (std::size_t i = 0; i < lanes; ++i) {
      expect_same(leaving[i], reflect_down(sea.view(), scalar[i]).into_air, "leaving");
      expect_same(packed, i, scalar[i]);
      total += leaving[i] == 0;
    }
  }
  EXPECT_GT(up, groups / 10);
  EXPECT_GT(bed, groups / 50);
  EXPECT_GT(crossed, groups / 4);
  EXPECT_GT(total, groups);
}

using Targets4 = Targets<Lanes4, 8>;
using Targets1 = Targets<double, 8>;

TEST(LanesOf, ScatterWithAndWithoutTargets) {
  Random random(15);
  const auto sea = make_sea(40);
  int without = 0, directed = 0;
  for (int g = 0; g < groups; ++g) {
    auto scalar = random_photons(sea, random);
    auto packed = pack(scalar);
    Targets4 targets4;
    Four<Targets1> targets;
    targets4.clear();
    for (auto& t : targets) t.clear();
    const int count = random.below(5);
    for (int k = 0; k < count; ++k) {
      Four<Vec3<double>> towards;
      Four<double> cone{};
      Four<double> weight{};
      for (std::size_t i = 0; i < lanes; ++i) {
        towards[i] = random.direction();
        weight[i] = random.chance(0.5) ? random.uniform() : 0.0;
        cone[i] = random.chance(0.3) ? random.uniform() : 0.0;
        targets[i].add(towards[i], cone[i], weight[i]);
      }
      targets4.add(pack(towards), pack(cone), pack(weight));
    }
    Four<std::int32_t> phase{}, lobe{};
    for (std::size_t i = 0; i < lanes; ++i) {
      phase[i] = random.below(5);
      lobe[i] = random.below(3);
    }
    const double share = random.uniform();
    const auto a = uniforms4(random), b = uniforms4(random), c = uniforms4(random),
               d = uniforms4(random);
    test::scatter(sea.view(), packed, pack(phase), pack(lobe), targets4, Lanes4(share),
                  {pack(a), pack(b), pack(c), pack(d)});
    for (std::size_t i = 0; i < lanes; ++i) {
      without += targets[i].total_weight == 0;
      directed += targets[i].total_weight > 0 && c[i] < share;
      test::scatter(sea.view(), scalar[i], phase[i], lobe[i], targets[i], share,
                    {a[i], b[i], c[i], d[i]});
      expect_same(packed, i, scalar[i]);
    }
  }
  EXPECT_GT(without, groups / 2);
  EXPECT_GT(directed, groups / 2);
}

TEST(LanesOf, Advance) {
  Random random(17);
  const auto sea = make_sea(40);
  int out = 0;
  for (int g = 0; g < groups; ++g) {
    auto scalar = random_photons(sea, random);
    auto packed = pack(scalar);
    Four<double> distance;
    for (auto& d : distance) d = random.chance(0.1) ? 0.0 : random.scale(0.01, 60);
    const auto in_water = advance(sea.view(), packed, pack(distance));
    for (std::size_t i = 0; i < lanes; ++i) {
      expect_same(in_water[i], advance(sea.view(), scalar[i], distance[i]), "in water");
      expect_same(packed, i, scalar[i]);
      out += !in_water[i];
    }
  }
  EXPECT_GT(out, groups / 4);
}

// Views of two telescopes, above and in the water.
TEST(LanesOf, ForceCollision) {
  Random random(18);
  const auto sea = make_sea(40);
  int reached = 0, left = 0;
  for (int g = 0; g < groups; ++g) {
    std::vector<estimator::ViewCone<double>> views;
    std::vector<estimator::ViewCone<Lanes4>> views4;
    for (int k = random.below(3); k > 0; --k) {
      const Vec3<double> entry{random.between(-20, 20), random.between(-20, 20),
                               -random.between(0, 10)};
      const Vec3<double> axis = random.direction();
      const double rate = random.scale(0.05, 2);
      const double radius = random.scale(0.1, 10),
                   widening = random.chance(0.5) ? 0.0 : random.uniform();
      views.push_back({entry, axis, rate, radius, widening});
      views4.push_back({vec3_cast<Lanes4>(entry), vec3_cast<Lanes4>(axis), Lanes4(rate),
                        Lanes4(radius), Lanes4(widening)});
    }
    auto scalar = random_photons(sea, random);
    auto packed = pack(scalar);
    const auto a = uniforms4(random), b = uniforms4(random), c = uniforms4(random);
    const auto in_water =
        estimator::force_collision(sea.view(), packed, views4, {pack(a), pack(b), pack(c)}).reached;
    for (std::size_t i = 0; i < lanes; ++i) {
      expect_same(
          in_water[i],
          estimator::force_collision(sea.view(), scalar[i], views, {a[i], b[i], c[i]}).reached,
          "reached");
      expect_same(packed, i, scalar[i]);
      (in_water[i] ? reached : left) += 1;
    }
  }
  EXPECT_GT(reached, groups);
  EXPECT_GT(left, groups / 4);
}

TEST(LanesOf, CollideAndRoulette) {
  Random random(16);
  const auto sea = make_sea(40);
  int converted = 0, killed = 0, low = 0;
  for (int g = 0; g < groups; ++g) {
    auto scalar = random_photons(sea, random);
    for (auto& photon : scalar) photon.line = random.chance(0.7) ? 0 : photon.line;
    auto packed = pack(scalar);
    const auto u = uniforms4(random), v = uniforms4(random), w = uniforms4(random);
    const auto branch =
        collide(sea.view(), packed, Index<Lanes4>(0), Lanes4(0.4), pack(u), pack(v));
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto one = collide(sea.view(), scalar[i], 0, 0.4, u[i], v[i]);
      expect_same(branch.converted[i], one.converted, "converted");
      expect_same(branch.phase[i], one.phase, "phase");
      expect_same(branch.lobe[i], one.lobe, "lobe");
      expect_same(packed, i, scalar[i]);
      converted += one.converted;
      low += scalar[i].analog_weight < 1e-2;
    }
    const auto survives = roulette(packed, Lanes4(1e-2), pack(w));
    for (std::size_t i = 0; i < lanes; ++i) {
      expect_same(survives[i], roulette(scalar[i], 1e-2, w[i]), "survives");
      expect_same(packed, i, scalar[i]);
      killed += !survives[i];
    }
  }
  EXPECT_GT(converted, groups / 2);
  EXPECT_GT(low, groups);
  EXPECT_GT(killed, groups / 2);
}

}  // namespace
}  // namespace photic::transport
