// Single rays through the lens against the formula of the image, and their mean against the
// overlap.
#include "instrument/lens.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "instrument/disc.hpp"
#include "support/chi_squared.hpp"
#include "support/mean.hpp"
#include "support/z_test.hpp"
#include "unit/instrument/share_of_lens.hpp"
#include "unit/instrument/telescopes.hpp"

namespace photic::instrument {
namespace {

using test::Random;
using V = Vec3<double>;
using Point = PlanePoint<double>;

Point random_lens_point(const Telescope<double>& t, Random& random) {
  return lens_point(t, random.uniform(), random.uniform());
}

/// 1 over the focal length.
double power(const Telescope<double>& t) { return t.per_sharp_range + 1 / t.detector_distance; }

/// Light that moves aside by `t` per metre of its way to the detector.
V moving_aside(const Telescope<double>& telescope, const Point& t) {
  return normalised(t.x * telescope.across + t.y * telescope.up - telescope.axis);
}

// Ten rings of equal area times eight sectors, at 0.1 %. Seen red: with the radius even.
TEST(RingPoint, IsEvenInArea) {
  Random random(61);
  constexpr int samples = 100000;
  for (const double inner : {0.0, 0.3, 0.9}) {
    constexpr double outer = 1.5;
    std::vector<double> count(80, 0.0);
    for (int i = 0; i < samples; ++i) {
      const auto p = ring_point(inner, outer, random.uniform(), random.uniform());
      const double share =
          (p.x * p.x + p.y * p.y - inner * inner) / (outer * outer - inner * inner);
      const double azimuth = std::atan2(p.y, p.x) / (2 * pi) + 0.5;
      ASSERT_GT(share, -1e-12);
      ASSERT_LT(share, 1 + 1e-12);
      const auto ring = static_cast<std::size_t>(std::clamp(share * 10, 0.0, 9.5));
      count[ring * 8 + static_cast<std::size_t>(std::min(azimuth * 8, 7.5))] += 1;
    }
    test::expect_uniform(count, samples, 0.001, "ring from " + std::to_string(inner));
  }
}

// Seen red: with points behind the obstruction; with the
// obstruction open.
TEST(LensPoint, LiesWhereTheLensIsOpen) {
  Random random(62);
  for (int i = 0; i < 10000; ++i) {
    const auto t = make_telescope<double>(random_telescope(random));
    const Point p = random_lens_point(t, random);
    ASSERT_TRUE(open_at(t, p));
    const double radius = std::hypot(p.x, p.y);
    const double out = 1.0001 * t.lens_radius / radius;
    const double in = 0.9999 * t.obstruction_radius / radius;
    ASSERT_FALSE(open_at(t, Point{p.x * out, p.y * out}));
    ASSERT_EQ(open_at(t, Point{p.x * in, p.y * in}), t.obstruction_radius == 0);
    const V aside = in_space(t, p) - t.position;
    ASSERT_NEAR(dot(aside, t.axis), 0, 1e-12);
    ASSERT_NEAR(dot(aside, t.across), p.x, 1e-12);
    ASSERT_NEAR(dot(aside, t.up), p.y, 1e-12);
  }
}

// Rays that fall just inside and just outside the detector's rim by p + x_d (t - p / f). Seen red:
// with the sign of the power; without the division by the cosine; with light from behind.
TEST(Sight, EndsAtTheDetectorsRim) {
  Random random(63);
  for (int i = 0; i < 10000; ++i) {
    const auto t = make_telescope<double>(random_telescope(random));
    const Point p = random_lens_point(t, random);
    const double azimuth = random.between(0, 2 * pi);
    for (const double side : {1 - 1e-7, 1 + 1e-7}) {
      const double radius = side * t.detector_radius;
      const auto aside = [&](double image, double lens) {
        return (image - lens) / t.detector_distance + lens * power(t);
      };
      const V arriving = moving_aside(
          t, {aside(radius * std::cos(azimuth), p.x), aside(radius * std::sin(azimuth), p.y)});
      const auto seen = sight(t, p, arriving);
      ASSERT_EQ(seen.on_detector, side < 1);
      ASSERT_NEAR(seen.cos_off_axis, -dot(arriving, t.axis), 1e-15);
      ASSERT_FALSE(sight(t, p, -arriving).on_detector) << "from behind";
    }
  }
}

// Seen red: with the directions of the plane swapped; without the lens point in the slope; in
// sight(), with the sign of the power.
TEST(Outward, IsTheWayBackOfWhatFallsOnADetectorPoint) {
  Random random(64);
  for (int i = 0; i < 10000; ++i) {
    const auto t = make_telescope<double>(random_telescope(random));
    const Point p = random_lens_point(t, random);
    const auto on_detector =
        ring_point(0.0, 1.4 * t.detector_radius, random.uniform(), random.uniform());
    const V out = outward(t, outward_slope(t, p, on_detector));
    ASSERT_NEAR(length(out), 1, 1e-14);
    const auto seen = sight(t, p, -out);
    ASSERT_NEAR(seen.cos_off_axis, dot(out, t.axis), 1e-14);
    ASSERT_EQ(seen.on_detector, std::hypot(on_detector.x, on_detector.y) < t.detector_radius);
    const auto along = sight_along(t, p, outward_slope(t, p, on_detector));
    ASSERT_EQ(along.on_detector, seen.on_detector);
    ASSERT_EQ(along.falls_within(0.4 * t.detector_radius),
              seen.falls_within(0.4 * t.detector_radius));
    // And to the very point.
    const double per_axis = 1 / dot(out, t.axis);
    const double x = p.x + t.detector_distance * (-per_axis * dot(out, t.across) - p.x * power(t));
    const double y = p.y + t.detector_distance * (-per_axis * dot(out, t.up) - p.y * power(t));
    ASSERT_NEAR(x, on_detector.x, 1e-12 * (t.detector_radius + t.lens_radius));
    ASSERT_NEAR(y, on_detector.y, 1e-12 * (t.detector_radius + t.lens_radius));
  }
}

/// The share of rays from even lens points that the detector sees.
template <class Arriving>
test::Mean seen_share(const Telescope<double>& t, Random& random, Arriving arriving) {
  test::Mean mean;
  for (int i = 0; i < 4000; ++i) {
    const Point p = random_lens_point(t, random);
    mean.add(sight(t, p, arriving(p)).on_detector ? 1 : 0);
  }
  return mean;
}

/// Judges a share where it is one, and that it is exact where all or nothing is seen.
void compare(test::ZFamily& family, const test::Mean& mean, double share, const std::string& what) {
  if (share < 1e-9 || share > 1 - 1e-9) {
    EXPECT_EQ(mean.value(), std::round(share)) << what;
  } else if (share > 0.02 && share < 0.98) {
    family.add(mean.value(), share, std::sqrt(share * (1 - share) / mean.count), what);
  }
}

/// Off the axis by an angle at which the image of a point is cut by the detector's rim, or nearly.
double random_tangent(const Telescope<double>& t, double per_range, Random& random) {
  const double blur = t.lens_radius * std::abs(1 - t.detector_distance * (power(t) - per_range));
  return random.between(0.9 * std::abs(t.detector_radius - blur),
                        1.1 * (t.detector_radius + blur)) /
         t.detector_distance;
}

// Light of points at random ranges and angles, in focus and out of it; z-tests, 1 % for the family.
// Seen red: with x and y of the lens swapped in space; with lens points even in radius; with the
// sign of the power.
TEST(Sight, OverTheLensIsTheOverlap) {
  Random random(65);
  test::ZFamily family(0.01);
  for (int n = 0; n < 1000; ++n) {
    const auto t = make_telescope<double>(random_telescope(random));
    const double range = random.scale(0.1, 1000);
    const double tangent = random_tangent(t, 1 / range, random);
    const double azimuth = random.between(0, 2 * pi);
    const V from =
        t.position +
        range * (t.axis + tangent * (std::cos(azimuth) * t.across + std::sin(azimuth) * t.up));
    const auto mean =
        seen_share(t, random, [&](const Point& p) { return normalised(in_space(t, p) - from); });
    compare(family, mean, t.overlap(1 / range, tangent), "telescope " + std::to_string(n));
  }
  EXPECT_GT(family.size(), 200);
  family.judge();
}

// Of rays of one direction: against rings of the lens, and rays from even points of it; z-tests, 1
// % for the family. Seen red: with an angle that is 1 % wider; with the lens for what sees.
TEST(ShareThatSees, IsThatOfTheOpenLens) {
  Random random(71);
  test::ZFamily family(0.01);
  int in_part = 0, in_focus = 0;
  for (int n = 0; n < 1000; ++n) {
    const auto t = make_telescope<double>(random_telescope(random));
    const double tangent = random_tangent(t, 0, random), azimuth = random.between(0, 2 * pi);
    const V arriving = moving_aside(t, {tangent * std::cos(azimuth), tangent * std::sin(azimuth)});
    if (t.per_sharp_range == 0) {
      ASSERT_EQ(share_that_sees(t, arriving), 1);
      ++in_focus;
      continue;
    }
    const double share = share_of_lens(t, tangent);
    // What is seen by a point or two counts as more than nothing.
    ASSERT_NEAR(share_that_sees(t, arriving), std::max(share, 1e-6), 1e-9) << n;
    ASSERT_EQ(share_that_sees(t, -arriving), share_that_sees(t, arriving)) << "either way";
    if (share < 0.02 || share > 0.98) continue;  // too few rays of one kind for a normal variate
    compare(family, seen_share(t, random, [&](const Point&) { return arriving; }), share,
            "telescope " + std::to_string(n));
    ++in_part;
  }
  EXPECT_GT(in_part, 200);
  EXPECT_GT(in_focus, 200);
  family.judge();
}

/// Where a ray from a point of the lens comes through the sea's surface.
V at_surface(const Telescope<double>& t, const Point& p, const V& outward) {
  const V lens = in_space(t, p);
  return lens - lens.z / outward.z * outward;
}

// A tilted lens lets rays of a direction through an area that is larger or smaller on a horizontal
// plane: by finite differences. Seen red: with the inverse of that; with the tilt of the lens for
// the angle of the ray.
TEST(TranslationArea, IsThatOfALevelPlane) {
  Random random(68);
  int tilted = 0, flat = 0;
  for (int n = 0; n < 500; ++n) {
    const auto t = make_telescope<double>(random_telescope(random));
    const double tangent = random_tangent(t, 0, random);
    const double azimuth = random.between(0, 2 * pi);
    const V outward = -moving_aside(t, {tangent * std::cos(azimuth), tangent * std::sin(azimuth)});
    const double area = translation_area(t, outward);
    if (std::abs(outward.z) < flattest_translated) {
      ++flat;
      ASSERT_EQ(area, 0);
      continue;
    }
    const double h = 1e-3;
    const auto step = [&](const Point& p) {
      return at_surface(t, h * p, outward) - at_surface(t, -h * p, outward);
    };
    const V x = step({1, 0}), y = step({0, 1});
    const double level = std::abs(x.x * y.y - x.y * y.x) / (4 * h * h);
    ASSERT_NEAR(area, t.area() * level, 2e-6 * t.area() * level);
    tilted += area > 0;
  }
  EXPECT_GT(tilted, 200);
  EXPECT_GT(flat, 2);
}

// Light goes the same way beyond the lens, translated. Seen red: with the way as long as before;
// with the translation's part in the lens' plane alone.
TEST(LensTranslation, IsAPointOfTheSameRay) {
  Random random(69);
  for (int n = 0; n < 500; ++n) {
    scene::Telescope scene;
    const auto t = random_telescope(random, scene);
    const V outward =
        instrument::outward(t, ring_point(0.0, 0.3, random.uniform(), random.uniform()));
    const Point p = random_lens_point(t, random);
    const V by{random.between(-1, 1), random.between(-1, 1), 0};
    const auto lens = lens_translation(t, outward, by);
    const Point q = p + lens.aside;
    const V apart = in_space(t, q) + lens.longer * outward - (in_space(t, p) + by);
    ASSERT_LT(length(apart), 1e-12 * t.distance);
    if (!open_at(t, q) || std::abs(outward.z) < flattest_translated) continue;
    ASSERT_LT(std::abs(lens.longer), max_longer(scene) * (1 + 1e-12) + 1e-300);
  }
}

// Lenses in the water. Seen red: with twice the rise; with none.
TEST(AllPointsReach, WhereNoPointOfTheLensIsAsDeep) {
  Random random(70);
  for (int n = 0; n < 500; ++n) {
    scene::Telescope scene;
    random_telescope(random, scene);
    scene.position_m.z = -random.between(1, 20);
    const auto t = make_telescope<double>(scene);
    double highest = -1e9, lowest = 1e9;
    for (int step = 0; step < 100; ++step) {
      const double angle = 2 * pi * step / 100;
      const Point p{t.lens_radius * std::cos(angle), t.lens_radius * std::sin(angle)};
      highest = std::max(highest, in_space(t, p).z);
      lowest = std::min(lowest, in_space(t, p).z);
    }
    const double most = 0.001 * (highest - lowest);  // by which the points miss the rim's ends
    for (const double z : {highest + most + 1e-9, lowest - most - 1e-9}) {
      ASSERT_TRUE(all_points_reach(t, -z));
    }
    if (highest - lowest < 1e-6) continue;
    for (const double z : {highest - most, lowest + most, t.position.z}) {
      ASSERT_FALSE(all_points_reach(t, -z));
    }
  }
}

}  // namespace
}  // namespace photic::instrument
