// What the quick test of the field of view leaves out is never seen.
#include <gtest/gtest.h>

#include <algorithm>

#include "instrument/lens.hpp"
#include "unit/instrument/telescopes.hpp"

namespace photic::instrument {
namespace {

constexpr double n = 1.34;

/// A point in the water as a telescope sees it.
struct Sight {
  double x, y, rise;  ///< what the quick test is asked: the way aside, and the paraxial rise
  double overlap;     ///< what is on the detector
  double off_axis;    ///< [rad]
};

/// Follows a ray from the lens, `off` from the axis at some azimuth, back into the water to a
/// depth; its light comes up the same way. False if the ray never gets to the water.
bool look(const Telescope<double>& t, double off, double azimuth, double depth, Sight& sight) {
  const auto ray = turned(t.axis, 1 - std::cos(off), std::cos(azimuth), std::sin(azimuth));
  if (ray.z > -1e-6) return false;
  const double sin_air = std::hypot(ray.x, ray.y);
  const double sin_water = sin_air / n;
  const double cos_water = std::sqrt(1 - sin_water * sin_water);
  const double in_air = t.position.z / -ray.z;
  const double in_water = depth / cos_water;
  const double aside = in_air * sin_air + in_water * sin_water;
  // Towards the telescope.
  sight.x = sin_air > 0 ? -ray.x * aside / sin_air : 0;
  sight.y = sin_air > 0 ? -ray.y * aside / sin_air : 0;
  sight.rise = t.position.z + depth / n;
  const double apparent = in_air + in_water / n;
  sight.overlap = t.overlap(1 / (apparent * std::cos(off)), std::tan(off));
  sight.off_axis = off;
  return true;
}

// A million points about the edge of the view of random telescopes. Seen red: with the blur left
// out of the widest view; with only the far blur in it; without the exception before the extremum;
// with the sign of aside turned.
TEST(MaySeeBeyond, NeverLeavesOutWhatIsSeen) {
  test::Random random(8);
  int seen = 0;
  int asked = 0;
  while (asked < 1000000) {
    const auto scene = random_telescope(random);
    const auto t = make_telescope<double>(scene);
    const double tan_field = t.detector_radius / t.detector_distance;
    for (int i = 0; i < 50; ++i) {
      const double off = std::atan(tan_field * random.between(0, 1) * random.scale(1, 20));
      const double depth = t.position.z * random.scale(1e-3, 100);
      Sight sight{};
      if (!look(t, off, random.between(0, 2 * pi), depth, sight)) continue;
      ++asked;
      const bool kept = t.may_see_beyond(sight.x, sight.y, sight.rise);
      if (sight.overlap > 0) {
        ++seen;
        ASSERT_TRUE(kept) << "off axis " << off << " depth " << depth << " height " << t.position.z;
      }
    }
  }
  EXPECT_GT(seen, asked / 4);
}

// Else a test that keeps everything would pass: of points far outside a narrow vertical view,
// nearly all are left out.
TEST(MaySeeBeyond, LeavesOutMostOfWhatIsNotSeen) {
  test::Random random(9);
  const auto t = make_telescope<double>(table_1());
  for (int i = 0; i < 10000; ++i) {
    Sight sight{};
    ASSERT_TRUE(
        look(t, random.between(0.1, 1), random.between(0, 2 * pi), random.scale(0.1, 50), sight));
    ASSERT_EQ(sight.overlap, 0);
    ASSERT_FALSE(t.may_see_beyond(sight.x, sight.y, sight.rise)) << sight.off_axis;
  }
}

/// The point in the water from which light through a point of the lens falls on one of the
/// detector's plane, at a depth. False if the way back from there never gets to the water.
bool look_through(const Telescope<double>& t, const PlanePoint<double>& lens,
                  const PlanePoint<double>& on_detector, double depth, Vec3<double>& point) {
  const auto ray = outward(t, outward_slope(t, lens, on_detector));
  const auto from = in_space(t, lens);
  if (ray.z > -1e-6 || from.z <= 0) return false;
  const auto at_surface = from + (from.z / -ray.z) * ray;
  const double cos_water = std::sqrt(1 - (1 - ray.z * ray.z) / (n * n));
  point = at_surface + (depth / cos_water) * Vec3<double>{ray.x / n, ray.y / n, -cos_water};
  return true;
}

// By rays, in float too; beyond the detector's edge an upright telescope keeps nearly none. Seen
// red: with the blur's sign turned; without the point of the lens; with the half view of a tenth
// more, or of a thousandth less.
TEST(MaySeeByRay, KeepsWhatIsSeenAndLittleElse) {
  test::Random random(10);
  int seen = 0, beyond = 0, kept_beyond = 0;
  while (seen < 200000) {
    scene::Telescope scene;
    const auto t = random_telescope(random, scene);
    const auto narrow = make_telescope<float>(scene);
    const double widest = t.detector_radius / t.detector_distance;
    for (int i = 0; i < 50; ++i) {
      const auto lens = lens_point(t, random.uniform(), random.uniform());
      const double edges = random.scale(0.01, 1.5);
      const double azimuth = random.between(0, 2 * pi);
      const double depth = t.position.z * random.scale(1e-3, 100);
      Vec3<double> point{};
      if (!look_through(t, lens,
                        {edges * t.detector_radius * std::cos(azimuth),
                         edges * t.detector_radius * std::sin(azimuth)},
                        depth, point))
        continue;
      const double x = t.position.x - point.x, y = t.position.y - point.y;
      const double rise = t.position.z + depth / n;
      const bool kept = may_see_by_ray(t, lens, x, y, rise);
      if (edges < 1) {
        ++seen;
        ASSERT_TRUE(kept) << edges << " of the half view, depth " << depth;
        const PlanePoint<float> lens_narrow{static_cast<float>(lens.x), static_cast<float>(lens.y)};
        ASSERT_TRUE(edges > 1 - 1e-4 ||
                    may_see_by_ray(narrow, lens_narrow, static_cast<float>(x),
                                   static_cast<float>(y), static_cast<float>(rise)));
      } else if (edges > 1.05 && t.upright && widest < 0.1 &&
                 std::abs(scene.detector_shift_m) == 0) {
        ++beyond;
        kept_beyond += kept ? 1 : 0;
      }
    }
  }
  EXPECT_GT(beyond, 100);
  EXPECT_EQ(kept_beyond, 0) << "of " << beyond;
}

// Where light is expected for any point of the lens: nearly all that is kept of an upright
// telescope is seen. Seen red: with twice the blur.
TEST(MaySeeBeyond, OfAnUprightTelescopeKeepsLittleElse) {
  test::Random random(11);
  const auto t = make_telescope<double>(table_1());
  int kept = 0, seen = 0;
  for (int i = 0; i < 100000; ++i) {
    Sight sight{};
    ASSERT_TRUE(look(t, 0.06 * std::sqrt(random.uniform()), random.between(0, 2 * pi),
                     random.between(0, 50), sight));
    if (!t.may_see_beyond(sight.x, sight.y, sight.rise)) continue;
    ++kept;
    seen += sight.overlap > 0 ? 1 : 0;
  }
  EXPECT_GT(kept, 1000);
  EXPECT_GT(seen, 0.99 * kept);
}

}  // namespace
}  // namespace photic::instrument
