// The overlap eta: its parts, and the figures of the paper's Table 1.
#include "instrument/overlap.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "unit/instrument/telescopes.hpp"

namespace photic::instrument {
namespace {

TEST(CirclesOverlap, OfApartTouchingAndNestedCircles) {
  EXPECT_EQ(circles_overlap(1.0, 2.0, 3.5), 0);
  EXPECT_EQ(circles_overlap(1.0, 2.0, 3.0), 0);
  EXPECT_EQ(circles_overlap(1.0, 2.0, 1.0), pi);
  EXPECT_EQ(circles_overlap(2.0, 1.0, 0.3), pi);
  EXPECT_NEAR(circles_overlap(1.0, 1.0, 0.0), pi, 1e-10);
  EXPECT_EQ(circles_overlap(1.0, 0.0, 0.5), 0);
  EXPECT_EQ(circles_overlap(0.0, 0.0, 0.0), 0);
}

// Chords of both circles, integrated across. Seen red: with one of the two segments left out; with
// a and b swapped in one cosine.
TEST(CirclesOverlap, IsTheIntegralOfTheSharedChords) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
  for (const double r2 : {0.2, 0.7, 1.0, 1.6}) {
    for (double d = std::abs(1 - r2) + 0.01; d < 1 + r2; d += 0.05) {
      const auto half_chord = [](double r, double x) {
        return std::sqrt(std::max(0.0, r * r - x * x));
      };
      const auto shared = [&](double x) {
        return 2 * std::min(half_chord(1, x), half_chord(r2, x - d));
      };
      const double kink = (d * d + 1 - r2 * r2) / (2 * d);  // where the chords are equal
      const double expected = Rule::integrate(shared, std::max(-1.0, d - r2), kink, 15, 1e-10) +
                              Rule::integrate(shared, kink, std::min(1.0, d + r2), 15, 1e-10);
      EXPECT_NEAR(circles_overlap(1.0, r2, d), expected, 1e-8) << r2 << " " << d;
      EXPECT_EQ(circles_overlap(1.0, r2, d), circles_overlap(r2, 1.0, d));
    }
  }
}

double on_axis(const scene::Telescope& t, double z) {
  return make_telescope<double>(t).overlap(1 / z, 0.0);
}

// Table 1: 12 m away the blur, 3.33 cm, exceeds the detector's 2 cm: (2 / 3.33)^2. Seen red: with
// the blur's diameter for its radius; with the half field of view for the full one.
TEST(Overlap, OfTable1) {
  EXPECT_NEAR(on_axis(table_1(), 12), 0.36, 1e-12);
  EXPECT_NEAR(on_axis(table_1(), 19.9), 0.990, 1e-3);
  for (const double z : {20.001, 25.0, 40.0, 1e3, 1e6})
    EXPECT_NEAR(on_axis(table_1(), z), 1, 1e-12) << z;
}

// Seen red: with the sign of the shift turned.
TEST(Overlap, OfTable1WithTheDetectorBehindTheFocus) {
  EXPECT_NEAR(on_axis(table_1_shifted(0.2), 12), 1, 1e-12);
  EXPECT_NEAR(on_axis(table_1_shifted(0.2), 40), 1, 1e-12);
  EXPECT_NEAR(on_axis(table_1_shifted(0.4), 40), 0.51, 0.001);
  EXPECT_NEAR(on_axis(table_1_shifted(0.4), 12), 1, 1e-12);  // there it is in focus
}

TEST(Overlap, OfAPointInFocusIsAStep) {
  const auto t = make_telescope<double>(table_1_shifted(0.4));
  const double edge = 0.02 / 2.4;  // the detector's radius over its distance
  EXPECT_NEAR(t.overlap(1 / 12.0, 0.999 * edge), 1, 1e-15);
  EXPECT_EQ(t.overlap(1 / 12.0, 1.001 * edge), 0);
}

TEST(Overlap, OfAFieldOfViewIsThatOfItsDetector) {
  auto by_angle = table_1();
  by_angle.detector_diameter_m.reset();
  by_angle.half_field_of_view_mrad = 1e3 * std::atan(0.01);
  const auto a = make_telescope<double>(by_angle);
  const auto b = make_telescope<double>(table_1());
  EXPECT_NEAR(a.detector_radius, b.detector_radius, 1e-15);
  EXPECT_NEAR(a.overlap(1e-9, 0.0099), 1, 1e-15);  // from far away the half field is where it ends
  EXPECT_EQ(a.overlap(1e-9, 0.0101), 0);
}

TEST(Overlap, IsAShare) {
  test::Random random(5);
  for (int i = 0; i < 1000000; ++i) {
    const auto t = make_telescope<double>(random_telescope(random));
    const double eta = t.overlap(random.scale(1e-4, 100), random.scale(1e-4, 3));
    ASSERT_GE(eta, -1e-9);
    ASSERT_LE(eta, 1 + 1e-9);
  }
}

}  // namespace
}  // namespace photic::instrument
