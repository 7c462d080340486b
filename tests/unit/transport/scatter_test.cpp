// Scattering with and without directions to telescopes: whatever the directions are drawn from,
// times its weight the new direction follows the phase function.
#include "transport/scatter.hpp"

#include <gtest/gtest.h>

#include "support/chi_squared.hpp"
#include "support/mean.hpp"
#include "support/random.hpp"
#include "support/scatter.hpp"
#include "support/z_test.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using test::Random;
using V = Vec3<double>;
using Aims = Targets<double, 4>;

constexpr double directed = 0.5;

using test::Mean;

struct Target {
  V direction;
  double weight;
  double cone = 0;  // 1 - cos of the half angle; 0: a lobe
};

struct AimsCase {
  std::string what;
  std::int32_t phase,
      lobe;  // tables of make_sea(): 0 peaked, 1 smooth, 2 molecules, 3 Raman, 4 isotropic
  std::vector<Target> targets;
};

const V old_direction = normalised(V{0.3, -0.4, -0.8});

std::vector<AimsCase> aims_cases() {
  const V aside = normalised(V{0.5, 0.1, -0.8});
  const V up{0, 0.1, std::sqrt(0.99)};
  return {
      {"no target, smooth", 1, 1, {}},
      {"no target, peaked", 0, 0, {}},
      {"no usable target", 0, 0, {{up, 0}, {aside, 0}}},
      {"one target, smooth", 1, 1, {{aside, 1}}},
      {"one target, peaked", 0, 0, {{up, 1}}},
      {"one target straight back", 0, 0, {{-old_direction, 1}}},
      {"one target straight ahead", 1, 0, {{old_direction, 1}}},
      {"three targets, one not usable", 0, 0, {{up, 1}, {aside, 0}, {-aside, 1}}},
      {"targets of unequal weight", 0, 0, {{up, 0.2}, {aside, 1.5}, {-aside, 0.7, 0.3}}},
      {"converted, peaked lobe", 3, 0, {{up, 1}}},
      {"converted, smooth lobe", 4, 1, {{up, 1}, {aside, 1}}},
      {"one cone", 1, 1, {{aside, 1, 0.02}}},
      {"a hemisphere, peaked", 0, 0, {{up, 1, 1.0}}},
      {"lobe and two cones, one not usable", 0, 0, {{up, 1}, {aside, 1, 0.1}, {-aside, 0, 0.5}}}};
}

Aims aims(const AimsCase& c) {
  Aims out;
  out.clear();
  for (const auto& [direction, weight, cone] : c.targets) out.add(direction, cone, weight);
  return out;
}

bool has_usable(const AimsCase& c) {
  return std::any_of(c.targets.begin(), c.targets.end(),
                     [](const Target& t) { return t.weight > 0; });
}

/// Edges in x = 1 - cos of cells that hold known shares of a phase function.
const std::vector<double> shares{0.05, 0.2, 0.4, 0.6, 0.8, 0.9, 0.95, 0.98, 0.99, 0.995};

std::size_t cell_of(const std::vector<double>& edges, double x) {
  return static_cast<std::size_t>(std::upper_bound(edges.begin(), edges.end(), x) - edges.begin());
}

// Weighted shares of the cells, mean weight, mean cosine and mean azimuth: z-tests, 1 % for the
// family. Seen red: with the weight left alone; with the lobe left out of the density; with
// targets without weight counted; with the phase function's own table for the lobe's density; with
// the share of the targets not split by their weights; with the density of a cone over 4 pi.
TEST(Scatter, TimesItsWeightFollowsThePhaseFunction) {
  constexpr int samples = 200000;
  const auto sea = make_sea(40);
  const auto phases = sea.view().phases;
  test::ZFamily family(0.01);
  Random random(71);
  for (const AimsCase& c : aims_cases()) {
    const Aims targets = aims(c);
    std::vector<double> edges;
    for (const double share : shares) edges.push_back(phases.sample<double>(share, c.phase));
    std::vector<Mean> cell(shares.size() + 1);
    Mean weight, cosine, aside;
    double expected_cosine = 0;
    constexpr int steps = 1000000;
    for (int i = 0; i < steps; ++i)
      expected_cosine += 1 - phases.sample<double>((i + 0.5) / steps, c.phase);
    expected_cosine /= steps;
    const V across = normalised(cross(old_direction, V{0, 0, 1}));
    for (int i = 0; i < samples; ++i) {
      Photon<double> photon;
      photon.direction = old_direction;
      test::scatter(sea.view(), photon, c.phase, c.lobe, targets, directed,
                    {random.uniform(), random.uniform(), random.uniform(), random.uniform()});
      const double w = photon.weight;
      ASSERT_LE(w, 1 / (1 - directed) * (1 + 1e-12));
      ASSERT_NEAR(length(photon.direction), 1, 1e-15);
      const double x = one_minus_cos(old_direction, photon.direction);
      const std::size_t at = cell_of(edges, x);
      for (std::size_t k = 0; k < cell.size(); ++k) cell[k].add(k == at ? w : 0);
      weight.add(w);
      cosine.add(w * (1 - x));
      aside.add(w * dot(photon.direction, across));
    }
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const double below = k == 0 ? 0 : shares[k - 1];
      const double above = k == shares.size() ? 1 : shares[k];
      family.add(cell[k].value(), above - below, cell[k].error(),
                 c.what + ", cell " + std::to_string(k));
    }
    if (has_usable(c)) {
      family.add(weight.value(), 1, weight.error(), c.what + ", weight");
    } else {
      EXPECT_EQ(weight.sum, samples) << c.what;  // a plain walk, to the last bit
    }
    family.add(cosine.value(), expected_cosine, cosine.error(), c.what + ", cosine");
    family.add(aside.value(), 0, aside.error(), c.what + ", azimuth");
  }
  family.judge();
}

TEST(Scatter, HasTheMeanCosineOfHenyeyAndGreenstein) {
  const auto sea = make_sea(40);
  Random random(72);
  Mean cosine;
  for (int i = 0; i < 200000; ++i) {
    Photon<double> photon;
    photon.direction = old_direction;
    Aims targets;
    targets.clear();
    targets.add({0, 0, 1}, 0.0, 1.0);
    test::scatter(sea.view(), photon, 1, 1, targets, directed,
                  {random.uniform(), random.uniform(), random.uniform(), random.uniform()});
    cosine.add(photon.weight * dot(old_direction, photon.direction));
  }
  EXPECT_LT(std::abs(cosine.value() - 0.8), 3.3 * cosine.error());  // 0.1 %
  EXPECT_LT(cosine.error(), 0.005);
}

// What directed sampling is for: half of the directions follow the lobe about the targets, each
// of equal weight alike. At 0.1 %.
TEST(Scatter, AimsAtTargetsByTheirWeight) {
  constexpr int samples = 100000;
  const auto sea = make_sea(40);
  const AimsCase c{"", 0, 0, {{{0, 0, 1}, 1}, {{1, 0, 0}, 0}, {{0, 0.6, 0.8}, 1}}};
  const Aims targets = aims(c);
  const double near = sea.view().phases.sample<double>(0.4, 0);  // 40 % of the lobe
  Random random(73);
  std::vector<int> hits(3, 0);
  for (int i = 0; i < samples; ++i) {
    Photon<double> photon;
    photon.direction = old_direction;
    test::scatter(sea.view(), photon, 0, 0, targets, directed,
                  {random.uniform(), random.uniform(), random.uniform(), random.uniform()});
    for (std::size_t k = 0; k < 3; ++k)
      hits[k] += one_minus_cos(c.targets[k].direction, photon.direction) < near;
  }
  const double expected = samples * directed / 2 * 0.4;
  EXPECT_NEAR(hits[0], expected, 3.3 * std::sqrt(expected));
  EXPECT_NEAR(hits[2], expected, 3.3 * std::sqrt(expected));
  EXPECT_LT(hits[1], 20);
}

TEST(Scatter, FillsAConeEvenly) {
  constexpr int samples = 100000;
  const auto sea = make_sea(40);
  const V axis = normalised(V{1, 1, -0.2});
  Aims targets;
  targets.clear();
  targets.add(axis, 0.05, true);
  Random random(74);
  std::vector<double> ring(10, 0.0);
  for (int i = 0; i < samples; ++i) {
    Photon<double> photon;
    photon.direction = {0, 0, 1};
    test::scatter(sea.view(), photon, 0, 0, targets, 1 - 1e-12,
                  {random.uniform(), random.uniform(), random.uniform(), random.uniform()});
    ring.at(static_cast<std::size_t>(one_minus_cos(axis, photon.direction) / 0.05 * 10)) += 1;
  }
  test::expect_uniform(ring, samples, 0.001);
}

}  // namespace
}  // namespace photic::transport
