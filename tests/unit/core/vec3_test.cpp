// Vectors, and turning a direction by an angle about an azimuth.
#include "core/vec3.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace photic {
namespace {

using V = Vec3<double>;
using test::Random;

TEST(Vec3, Arithmetic) {
  const V a{1, 2, 3};
  const V b{-4, 5, 6};
  EXPECT_EQ(a + b, (V{-3, 7, 9}));
  EXPECT_EQ(a - b, (V{5, -3, -3}));
  EXPECT_EQ(-a, (V{-1, -2, -3}));
  EXPECT_EQ(2.0 * a, (V{2, 4, 6}));
  EXPECT_EQ(dot(a, b), 24);
  EXPECT_EQ(cross(V{1, 0, 0}, V{0, 1, 0}), (V{0, 0, 1}));
  EXPECT_EQ(cross(a, b), (V{-3, -18, 13}));
  EXPECT_EQ(length(V{2, 3, 6}), 7);
  EXPECT_NEAR(length(normalised(b)), 1, 1e-15);
  EXPECT_EQ(select<double>(true, a, b), a);
  EXPECT_EQ(select<double>(false, a, b), b);
  EXPECT_EQ(vec3_cast<float>(a), (Vec3<float>{1, 2, 3}));
}

// Seen red: as 1 - dot(a, b), which has no digits there.
TEST(OneMinusCos, KeepsItsDigitsAtANanoradian) {
  const double angle = 1e-9;
  const V along_z{0, 0, 1};
  EXPECT_NEAR(one_minus_cos(along_z, V{std::sin(angle), 0, std::cos(angle)}) / 5e-19, 1, 1e-12);
  // In general directions the rounding of the vectors themselves, 1e-16 of 1e-9, is left.
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const V a = random.direction();
    const V across = normalised(cross(a, random.direction()));
    ASSERT_NEAR(one_minus_cos(a, std::cos(angle) * a + std::sin(angle) * across) / 5e-19, 1, 2e-6);
  }
}

TEST(OneMinusCos, IsRightAtAllAngles) {
  for (double degrees = 0; degrees <= 180; degrees += 1) {
    const double angle = degrees * radian_per_degree;
    EXPECT_NEAR(one_minus_cos(V{0, 0, 1}, V{0, std::sin(angle), std::cos(angle)}),
                1 - std::cos(angle), 1e-15);
  }
}

/// Directions where a basis is hard to make, and some ordinary ones.
std::vector<V> directions() {
  std::vector<V> out{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {-1, 0, 0}};
  for (const double off : {1e-3, 1e-7, 1e-9, 1e-12, 1e-16, 1e-200}) {
    for (const double z : {1.0, -1.0}) {
      out.push_back(normalised(V{off, 0, z}));
      out.push_back(normalised(V{-off, off, z}));
      out.push_back(normalised(V{1, -1, z * off}));
    }
  }
  Random random(3);
  for (int i = 0; i < 1000; ++i) out.push_back(random.direction());
  return out;
}

const std::vector<double> turns{0.0, 1e-300, 1e-16, 1e-12,     1e-6, 0.01,
                                0.5, 1.0,    1.5,   2 - 1e-12, 2.0};

/// The angle between unit vectors, with all its digits.
double angle_between(const V& a, const V& b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

/// Turns v by an angle about the unit vector w (Rodrigues).
V rotated(const V& v, const V& w, double angle) {
  return std::cos(angle) * v + std::sin(angle) * cross(w, v) +
         ((1 - std::cos(angle)) * dot(w, v)) * w;
}

// Seen red: with the sign of w.z taken as always 1 (then {0, 0, -1} fails); with (1 - x) for the
// sine's (2 - x).
TEST(Turned, ByTheAngleAsked) {
  for (const V& w : directions()) {
    for (const double x : turns) {
      const double asked = 2 * std::asin(std::sqrt(x / 2));
      for (double azimuth = 0; azimuth < 6.3; azimuth += 0.7) {
        const V out = turned(w, x, std::cos(azimuth), std::sin(azimuth));
        ASSERT_NEAR(length(out), 1, 8e-16);
        ASSERT_NEAR(angle_between(w, out), asked, 1e-15)
            << w.x << " " << w.y << " " << w.z << " x " << x;
      }
    }
  }
}

// The azimuth is a right-handed rotation about w, from wherever it is counted. Seen red: with the
// basis left-handed (v turned round); with a basis vector's sign dropped.
TEST(Turned, ToTheAzimuthAsked) {
  for (const V& w : directions()) {
    for (const double x : {1e-12, 1e-3, 0.7, 1.9}) {
      const V zero = turned(w, x, 1.0, 0.0);
      for (double azimuth = 0; azimuth < 6.3; azimuth += 0.7) {
        const V out = turned(w, x, std::cos(azimuth), std::sin(azimuth));
        ASSERT_LT(length(out - rotated(zero, w, azimuth)), 2e-15)
            << w.x << " " << w.y << " " << w.z;
      }
    }
  }
}

// By small angles, as in a forward peak, and by large ones. A turn passes an error of |w|^2 on with
// a factor that is 1 or less in the mean, so that rounding adds up like a random walk. Seen red:
// with 1 + 1e-9 for the 1 in the tilt's divisor.
TEST(Turned, StaysAUnitVectorOverAMillionTurns) {
  for (const double widest : {1e-9, 1e-3, 2.0}) {
    Random random(4);
    V w{0, 0, -1};
    double worst = 0;
    for (int i = 0; i < 1000000; ++i) {
      const double azimuth = random.between(0, 2 * pi);
      w = turned(w, random.scale(1e-12, widest), std::cos(azimuth), std::sin(azimuth));
      worst = std::max(worst, std::abs(dot(w, w) - 1));
    }
    EXPECT_LT(worst, 1e-12) << widest;
  }
}

}  // namespace
}  // namespace photic
