// Strategies of paths that facets of waves send back between their vertices: all give the same.
#include <gtest/gtest.h>

#include "support/random.hpp"
#include "unit/estimator/same_of_all.hpp"

namespace photic::estimator {
namespace {

using test::Random;

/// Random vertices, with facets on some of the edges between them. What the facets do to light, and
/// how densely walks draw them, may be anything.
Path random_path(Random& random, std::int32_t order, std::int32_t edges) {
  Path path;
  const auto aside = [&] { return random.between(-2, 2); };
  for (std::int32_t i = 0; i < order; ++i)
    path.vertex.push_back({aside(), aside(), -random.between(0.5, 11.9)});
  for (std::int32_t e = 1; e < order; ++e)
    if ((edges >> (e - 1)) % 2 == 1)
      path.by_facets[static_cast<std::size_t>(e)] =
          WayByFacets{{aside(), aside(), 0}, random.between(0.2, 3), random.between(0.3, 2)};
  path.lens = instrument::ring_point(0.05, 0.15, random.uniform(), random.uniform());
  return path;
}

/// Instruments in the water: their walks begin as under a flat surface.
struct SeaUnderWaves : Sea {
  SeaUnderWaves(const scene::Source& source, const scene::Telescope& telescope, bool isotropic,
                const std::vector<double>& bed = {})
      : Sea(source, telescope, transport::make_sea(bed.empty() ? 40 : 15, bed)) {
    begin(false);
    world.slabs.surface = {
        .one_direction_each = false, .leads_anywhere = true, .isotropic = isotropic};
    auto& waves = world.slabs.waves;
    waves.upwind_deviation = 0.1;
    waves.crosswind_deviation = isotropic ? 0.1 : 0.05;
    if (!bed.empty()) world.walks.deepest = 15;
  }
};

struct Looks {
  const char* what;
  V laser, telescope;
};

bool is_before(const V& place, const V& axis, const V& x) {
  return dot(normalised(x - place), normalised(axis)) > 0.64;
}

// Seen red: with all of a leg, or what lies before the facets, for what lies on a meeting's side of
// them, in a vertex's densities, in a ray's, in a meeting; with edges behind facets connected, of
// either walk; with rays of either that do not meet behind them; without the chance to draw facets
// in a vertex's density and in a ray's chance; without the reverse chance in a ray's density and
// its reverse chance. With walks rotated that facets with sides have sent back.
TEST(StrategiesOfPath, OfLightThatFacetsSendBackBetweenCollisionsAgree) {
  Random random(131);
  int met = 0, connected = 0, on_bed = 0, rotated = 0, not_rotated = 0;
  for (const Looks& looks :
       {Looks{"down", {0, 0, -1}, {0, 0, -1}}, Looks{"up", {0, 0, 1}, {0, 0, 1}},
        Looks{"laser up", {0, 0, 1}, {0, 0, -1}},
        Looks{"tilted telescope", {0.1, 0, -1}, {0, 0.1, -1}}}) {
    const auto source = laser_at({0.5, 0, -6}, looks.laser);
    const auto telescope = telescope_at({0, 0, -6.5}, looks.telescope);
    const bool rotates = looks.laser.x == 0;
    Samples<double> samples = rotates ? rotating : translating;
    samples.free_telescope = samples.free_laser = {};
    const std::vector<double> albedo{0.3, 0.2, 0.4};
    SeaUnderWaves black(source, telescope, false), black_isotropic(source, telescope, true),
        bright(source, telescope, false, albedo), bright_isotropic(source, telescope, true, albedo);
    for (int n = 0; n < 480; ++n) {
      const bool bed = n % 4 == 3, isotropic = n / 2 % 2 == 1;
      SeaUnderWaves& sea = bed         ? (isotropic ? bright_isotropic : bright)
                           : isotropic ? black_isotropic
                                       : black;
      auto path = random_path(random, 4, 1 + n % 7);
      path.line = n / 4 % 2;
      if (path.line > 0) path.converted = 1 + n / 8 % 4;
      if (path.line == 0 && n % 3 == 0) path.vertex[3].x = path.vertex[3].y = 0.05;
      if (bed) {
        const auto i = static_cast<std::size_t>(n / 16 % 4);
        if (path.converted == static_cast<std::int32_t>(i) + 1) continue;  // it converts nothing
        path.vertex[i].z = -15;
      }
      // Lit and seen: the first and the last vertex lie within 50 degrees about the axes.
      if (!is_before(source.position_m, looks.laser, path.x(1)) ||
          !is_before(telescope.position_m, looks.telescope, path.x(4)))
        continue;
      SCOPED_TRACE(std::string(looks.what) + ", path " + std::to_string(n));
      const auto counts = expect_same_of_all(sea, path, samples, n % 5 == 4 ? 3 : max_vertices);
      met += counts.met;
      connected += counts.connected;
      on_bed += bed ? counts.met : 0;
      rotated += counts.rotated;
      not_rotated += counts.not_rotated;
    }
  }
  EXPECT_GT(met, 100);
  EXPECT_GT(connected, 100);
  EXPECT_GT(on_bed, 10);
  EXPECT_GT(rotated, 50);
  EXPECT_GT(not_rotated, 20);
}

}  // namespace
}  // namespace photic::estimator
