// Strategies of paths between instruments above waves: all give the same, whatever of its lens a
// detector out of focus sees through.
#include <gtest/gtest.h>

#include <string>

#include "unit/estimator/begun_walks.hpp"
#include "unit/estimator/same_of_all.hpp"

namespace photic::estimator {
namespace {

using test::Random;

scene::Telescope telescope_over_waves(const V& direction, double detector_m, double shift_m) {
  scene::Telescope t;
  t.position_m = {0, 0, 10};
  t.direction = direction;
  t.diameter_m = 1.0;
  t.obstruction_diameter_m = 0.3;
  t.focal_length_m = 1.5;
  t.detector_diameter_m = detector_m;
  t.detector_shift_m = shift_m;
  return t;
}
scene::Source laser_over_waves(const V& position, const V& direction, double half_divergence_mrad) {
  auto source = laser_at(position, direction);
  source.half_divergence_mrad = half_divergence_mrad;
  return source;
}
/// Slopes along the wind and across it.
medium::Waves waves_of(double upwind_variance, double crosswind_variance) {
  medium::Waves waves;
  waves.slopes.upwind_variance = upwind_variance;
  waves.slopes.crosswind_variance = crosswind_variance;
  if (upwind_variance != crosswind_variance && crosswind_variance > 0)
    waves.slopes.series = {.c21 = -0.05, .c03 = -0.10, .c40 = 0.4, .c22 = 0.12, .c04 = 0.23};
  waves.upwind_x = std::cos(0.7), waves.upwind_y = std::sin(0.7);
  return waves;
}

/// How often each strategy was held against the direct sum.
struct Held {
  int own = 0, by_slopes = 0, between = 0, translated = 0, in_part = 0, rotated = 0,
      free_telescope = 0, free_laser = 0;
};

class StrategiesThroughWaves {
 public:
  StrategiesThroughWaves(SeaOfWaves& sea, const Samples<double>& samples, std::int32_t most,
                         const Begun& begun, Random& random, Held& held)
      : sea_(sea),
        world_(sea.world),
        samples_(samples),
        most_(most),
        begun_(begun),
        random_(random),
        held_(held) {
    sea.world.walks.max_vertices = most;
  }

  /// All that can draw a path with vertices at such depths.
  void expect_all_alike(const Path& path) {
    connect_inner(path);
    connect_instruments(path);
    for (std::int32_t i = 1; i <= path.order(); ++i) {
      translate(i, path);
      free_telescope(i, path);
      free_laser(i, path);
      rotate(i, path);
    }
  }

 private:
  [[nodiscard]] StrategiesOfPath sum(const Path& path) const {
    return {world_, sea_.medium, samples_, path, most_};
  }
  [[nodiscard]] Scores scores(const Path& path) const {
    return {world_, samples_, sea_.medium, path, sum(path).group_path()};
  }
  [[nodiscard]] Walks<double> laser_walk(const Path& path, std::int32_t vertices,
                                         bool leaves) const {
    return estimator::laser_walk(world_, samples_, begun_.laser, path, vertices, leaves);
  }
  [[nodiscard]] Walks<double> back_walk(const Path& path, std::int32_t vertices, bool leaves,
                                        double grid_offset = 0) const {
    auto record = begun_.record;
    record.grid_offset = grid_offset;
    return telescope_walk(world_, samples_, begun_.back, record, path, vertices, leaves);
  }
  /// `within`: what rounding leaves.
  static void expect_same(double scored, double expected, int& count, const std::string& what,
                          double within = 1e-10) {
    if (expected == 0) {  // no facet is so steep
      EXPECT_EQ(scored, 0) << what;
      return;
    }
    EXPECT_NEAR(scored / expected, 1, within) << what;
    ++count;
  }

  void connect_inner(const Path& path) {
    const std::int32_t k = path.order();
    const auto expected = sum(path);
    for (std::int32_t e = 1; e < k; ++e)
      if (expected.connecting(e) > 0)
        expect_same(
            scores(path).connecting(e, laser_walk(path, e, false), back_walk(path, k - e, false)),
            expected.value(), held_.between, "edge " + std::to_string(e));
  }
  /// By own rays, and by slopes. What the walk of the other kind draws leads far away.
  void connect_instruments(const Path& path) {
    const std::int32_t k = path.order();
    for (const std::int32_t instrument : {of_laser, of_telescope(0)}) {
      const bool lit = instrument == of_laser;
      if (k == 1 && !lit) continue;  // the vertex is on the telescope's ray
      for (const bool by_slopes : {false, true}) {
        if (by_slopes && !world_.walks.cone(instrument).enters_by_slopes) continue;
        Begun walks = begun_;
        auto& birth = lit ? walks.laser : walks.back;
        const Path other = by_slopes ? entering_by_slopes(world_, instrument, birth, path) : path;
        if (!reaches(world_, instrument, other)) continue;
        const auto expected = sum(other);
        const std::int32_t e = lit ? 0 : k;
        if (expected.connecting(e) == 0) continue;
        if (by_slopes) {
          birth.entry.at.x += 1e3;
        } else {
          birth.entry.u_slope = 1e-30;
        }
        const StrategiesThroughWaves strategies(sea_, samples_, most_, walks, random_, held_);
        expect_same(
            scores(other).connecting(e, strategies.laser_walk(other, lit ? 0 : k, false),
                                     strategies.back_walk(other, lit ? k : 0, false)),
            expected.value(), by_slopes ? held_.by_slopes : held_.own,
            std::string(lit ? "laser" : "telescope") + (by_slopes ? " by slopes" : " by own ray"));
      }
    }
  }
  /// The walk comes through the lens elsewhere, where the detector sees it too.
  void translate(std::int32_t i, const Path& path) {
    V aside{};
    const Path moved =
        path.order() == 1 ? meeting_first_rays(path, aside) : seen_elsewhere(path, aside);
    if (moved.order() == 0) return;
    const auto expected = sum(moved);
    if (expected.as_long_elsewhere(i) || expected.translated(i) == 0) return;
    auto other = moved_path(moved, -aside.x, -aside.y);
    other.lens = begun_.record.lens;
    auto scores = this->scores(moved);
    expect_same(scores.meeting(laser_walk(moved, i - 1, true),
                               back_walk(other, path.order() - i, true, scores.offset_at(i, grid)),
                               Moves::translations),
                expected.value(), held_.translated, "translated to " + std::to_string(i));
    held_.in_part += sees_in_part(expected);
  }
  [[nodiscard]] bool is_seen(const instrument::PlanePoint<double>& lens) const {
    return open_at(world_.instruments.telescopes[0], lens) &&
           sight(world_.instruments.telescopes[0], lens, -begun_.record.outward).on_detector;
  }
  /// All but the laser's walk moved aside; a path of no vertices if there is none.
  Path seen_elsewhere(Path path, V& aside) {
    const auto lens =
        lens_point(world_.instruments.telescopes[0], random_.uniform(), random_.uniform());
    if (!is_seen(lens)) return {};
    path = through_lens_at(world_, begun_, lens, path, aside);
    path.vertex.back() = path.vertex.back() + aside;
    return path;
  }
  /// With the only vertex on the laser's ray, as deep as it was on the telescope's.
  Path meeting_first_rays(Path path, V& aside) {
    const auto& telescope = world_.instruments.telescopes[0];
    const V met = at_depth(begun_.laser, -path.x(1).z);
    aside = met - path.x(1);
    const auto lens =
        begun_.record.lens +
        lens_translation(telescope, begun_.record.outward, V{aside.x, aside.y, 0}).aside;
    if (!is_seen(lens)) return {};
    path = through_lens_at(world_, begun_, lens, path, aside);
    path.vertex.front() = met;
    return path;
  }
  /// Whether part of the open lens sees the path's last ray.
  [[nodiscard]] bool sees_in_part(const StrategiesOfPath& path) const {
    const double whole =
        instrument::translation_area(world_.instruments.telescopes[0], begun_.record.outward);
    return path.translation_area < 0.99 * whole;
  }
  void free_telescope(std::int32_t i, const Path& path) {
    if (begun_.back.spread.solid_angle == 0 ||
        !world_.walks.telescope_cones[0].frees(begun_.back.photon.direction))
      return;
    const double x = random_.between(-0.4, 0.4), y = random_.between(-0.4, 0.4);
    Path moved = path;
    moved.vertex.back() = moved.vertex.back() + V{x, y, 0};
    moved = entering_by_slopes(world_, of_telescope(0), begun_.back, moved);
    if (!reaches(world_, of_telescope(0), moved)) return;
    const auto expected = sum(moved);
    if (expected.as_long_elsewhere(i) || expected.free_telescope(i) == 0) return;
    auto scores = this->scores(moved);
    expect_same(scores.meeting(laser_walk(moved, i - 1, true),
                               back_walk(moved_path(moved, -x, -y), path.order() - i, true,
                                         scores.offset_at(i, samples_.free_telescope)),
                               Moves::free_telescope),
                expected.value(), held_.free_telescope,
                "a free walk of the telescope at " + std::to_string(i));
    held_.in_part += sees_in_part(expected);
  }
  void free_laser(std::int32_t i, const Path& path) {
    if (!path.laser_entry || begun_.laser.spread.solid_angle == 0 ||
        !world_.walks.laser_cone.frees(begun_.laser.photon.direction))
      return;
    const double x = random_.between(-0.4, 0.4), y = random_.between(-0.4, 0.4);
    Path moved = path;
    moved.vertex.front() = moved.vertex.front() + V{x, y, 0};
    moved = entering_by_slopes(world_, of_laser, begun_.laser, moved);
    if (!reaches(world_, of_laser, moved)) return;
    const auto expected = sum(moved);
    if (expected.as_long_elsewhere(i) || expected.free_laser(i) == 0) return;
    auto scores = this->scores(moved);
    expect_same(
        scores.meeting(
            laser_walk(moved_path(moved, -x, -y), i - 1, true),
            back_walk(moved, path.order() - i, true, scores.offset_at(i, samples_.free_laser)),
            Moves::free_laser),
        expected.value(), held_.free_laser, "a free walk of the laser at " + std::to_string(i));
  }
  void rotate(std::int32_t i, const Path& path) {
    const auto expected = sum(path);
    if (i >= path.pivot() || expected.as_long_elsewhere(i) || expected.rotated(i) == 0) return;
    const Path other = rotated_path(path, 1.0 + i);
    // It is drawn so often, and counts so little.
    const double drawn = expected.drawn_at_pivot() / sum(other).drawn_at_pivot();
    expect_same(scores(path).meeting(laser_walk(path, i - 1, true),
                                     back_walk(other, path.order() - i, true), Moves::rotations),
                drawn * expected.value(), held_.rotated, "rotated to " + std::to_string(i), 1e-8);
  }

  SeaOfWaves& sea_;
  const World<double>& world_;
  const Samples<double>& samples_;
  std::int32_t most_;
  const Begun& begun_;
  Random& random_;
  Held& held_;
};

/// Depths of so many vertices; if there is a bed, one of them lies there.
std::vector<double> random_depths(std::int32_t order, std::int32_t on_bed, Random& random) {
  std::vector<double> depths;
  for (std::int32_t i = 1; i <= order; ++i)
    depths.push_back(i == on_bed ? 15 : random.between(0.5, 11.9));
  return depths;
}

/// Whether a walk has begun, and by no facets so steep that it is weighed as by others; from an
/// instrument in the water by none at all.
bool is_by_facets_that_are(const Birth<double>& birth) {
  const double least = 1e3 * min_passing * birth.entry.weight * birth.spread.solid_angle;
  return birth.exists && birth.facets == 0 && birth.photon.weight > least;
}

struct Lidar {
  const char* what;
  scene::Source source;
  scene::Telescope telescope;
};

/// Paths of one to four vertices.
void expect_strategies_agree(const Lidar& lidar, const medium::Waves& waves, bool bed,
                             Random& random, Held& held) {
  SeaOfWaves sea(lidar.source, lidar.telescope, waves,
                 bed ? std::vector{0.3, 0.2, 0.4} : std::vector<double>{});
  for (std::int32_t n = 0; n < 64; ++n) {
    SCOPED_TRACE(std::string(lidar.what) + (bed ? ", bed" : "") + ", path " + std::to_string(n));
    const bool frees = n % 2 == 0;
    sea.begin(frees);
    Samples<double> samples = sea.world.walks.uses.rotated_scattered ? rotating : translating;
    if (!frees) samples.free_telescope = samples.free_laser = {};
    const std::int32_t order = 1 + n / 2 % 4, line = n / 8 % 2;
    const auto begun = begin_walks(sea.world, line, n);
    if (!is_by_facets_that_are(begun.laser) || !is_by_facets_that_are(begun.back)) continue;
    const std::int32_t on_bed = bed ? 1 + n / 16 % 4 : 0;
    auto path = path_of(sea.world, begun, random_depths(order, on_bed, random), random);
    path.line = line;
    if (line > 0) path.converted = 1 + random.below(order);
    if (path.converted > 0 && path.converted == on_bed) continue;  // it converts nothing
    StrategiesThroughWaves(sea, samples, n % 5 == 4 ? 3 : max_vertices, begun, random, held)
        .expect_all_alike(path);
  }
}

TEST(StrategiesOfPath, ThroughWavesAgree) {
  Random random(151);
  const V down{0, 0, -1}, tilted{0.15, -0.1, -1};
  const auto narrow = laser_over_waves({0.5, 0, 10}, down, 3),
             wide = laser_over_waves({0.5, 0, 10}, down, 120),
             aslant = laser_over_waves({-0.5, 0, 10}, tilted, 120),
             below = laser_over_waves({0.5, 0, -0.4}, down, 300);
  Held held;
  for (const Lidar& lidar :
       {Lidar{"in focus", narrow, telescope_over_waves(down, 0.06, 0)},
        {"behind the focus", narrow, telescope_over_waves(down, 0.06, 0.05)},
        {"before the focus", wide, telescope_over_waves(down, 0.06, -0.05)},
        {"far behind the focus", narrow, telescope_over_waves(down, 0.06, 0.3)},
        {"a wide view in focus", wide, telescope_over_waves(down, 0.9, 0)},
        {"a wide view out of focus", wide, telescope_over_waves(down, 0.9, 0.6)},
        {"tilted, in focus", aslant, telescope_over_waves(tilted, 0.9, 0)},
        {"tilted, out of focus", aslant, telescope_over_waves(tilted, 0.6, 0.5)},
        {"laser below", below, telescope_over_waves(down, 0.6, -0.4)},
        {"laser below, tilted", below, telescope_over_waves(tilted, 0.06, 0.3)}})
    for (const auto& waves : {waves_of(0.015, 0.015), waves_of(0.03, 0.01), waves_of(0.03, 0)})
      for (const bool bed : {false, true}) expect_strategies_agree(lidar, waves, bed, random, held);
  EXPECT_GT(held.own, 500);
  EXPECT_GT(held.by_slopes, 100);
  EXPECT_GT(held.between, 500);
  EXPECT_GT(held.translated, 500);
  EXPECT_GT(held.in_part, 200);
  EXPECT_GT(held.rotated, 50);
  EXPECT_GT(held.free_telescope, 100);
  EXPECT_GT(held.free_laser, 100);
}

// Seen red: with an even density of the points where the laser's rays come through the surface; of
// one below, with an even density of its rays.
TEST(StrategiesOfPath, OfAGaussianLaserThroughWavesAgree) {
  Random random(152);
  const V down{0, 0, -1}, tilted{0.15, -0.1, -1};
  const auto gaussian = [](scene::Source source) {
    source.profile = scene::SourceProfile::gaussian;
    return source;
  };
  Held held;
  for (const Lidar& lidar : {Lidar{"upright", gaussian(laser_over_waves({0.5, 0, 10}, down, 60)),
                                   telescope_over_waves(down, 0.9, 0)},
                             {"tilted", gaussian(laser_over_waves({-0.5, 0, 10}, tilted, 60)),
                              telescope_over_waves(tilted, 0.9, 0)},
                             {"laser below", gaussian(laser_over_waves({0.5, 0, -0.4}, down, 100)),
                              telescope_over_waves(down, 0.6, -0.4)}})
    expect_strategies_agree(lidar, waves_of(0.03, 0.01), false, random, held);
  EXPECT_GT(held.own, 30);
  EXPECT_GT(held.by_slopes, 10);
  EXPECT_GT(held.translated, 30);
  EXPECT_GT(held.free_laser, 10);
}

}  // namespace
}  // namespace photic::estimator
