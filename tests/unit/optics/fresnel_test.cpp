#include "optics/fresnel.hpp"

#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

constexpr double n = 1.34;

TEST(Fresnel, AtNormalIncidence) {
  const auto in = refract(1.0, n, 1.0);
  EXPECT_NEAR(in.reflectance, 0.0211, 5e-5);
  EXPECT_NEAR(in.reflectance, std::pow((n - 1) / (n + 1), 2), 1e-16);
  EXPECT_NEAR(in.cos_transmitted, 1.0, 1e-15);
  EXPECT_NEAR(refract(n, 1.0, 1.0).reflectance, in.reflectance, 1e-16);
}

// The law in Fresnel's own form, with sines and tangents of angles. Seen red: with n1 and n2
// swapped in one of the two amplitudes; with one amplitude left out; with the sign of a difference
// turned.
TEST(Fresnel, AgreesWithTheSineAndTangentLaws) {
  for (double degrees = 1; degrees < 90; degrees += 1) {
    const double i = degrees * radian_per_degree;
    const double t = std::asin(std::sin(i) / n);
    const double s = std::sin(i - t) / std::sin(i + t), p = std::tan(i - t) / std::tan(i + t);
    const auto result = refract(1.0, n, std::cos(i));
    EXPECT_NEAR(result.reflectance, (s * s + p * p) / 2, 1e-13) << degrees;
    EXPECT_NEAR(result.cos_transmitted, std::cos(t), 1e-14) << degrees;
  }
}

TEST(Fresnel, AtBrewstersAngleOnlyOnePolarisationIsReflected) {
  const double square = n * n;
  EXPECT_NEAR(refract(1.0, n, std::cos(std::atan(n))).reflectance,
              0.5 * std::pow((square - 1) / (square + 1), 2), 1e-15);
}

TEST(Fresnel, ReflectsAllBeyondTheCriticalAngle) {
  const double critical = std::sqrt(1 - 1 / (n * n));  // its cosine
  for (const double c : {0.0, 1e-300, 1e-9, 0.3, critical - 1e-12}) {
    EXPECT_EQ(refract(n, 1.0, c).reflectance, 1.0) << c;
    EXPECT_EQ(refract(n, 1.0, c).cos_transmitted, 0.0) << c;
  }
  EXPECT_LT(refract(n, 1.0, critical + 1e-3).reflectance, 0.8);
  EXPECT_NEAR(refract(n, 1.0, critical + 1e-12).reflectance, 1.0, 1e-4);
}

TEST(Fresnel, IsReciprocal) {
  for (double c = 0.001; c <= 1; c += 0.001) {
    const auto down = refract(1.0, n, c);
    const auto up = refract(n, 1.0, down.cos_transmitted);
    EXPECT_NEAR(up.cos_transmitted, c, 1e-12) << c;
    EXPECT_NEAR(up.reflectance, down.reflectance, 1e-12) << c;
  }
}

TEST(Fresnel, ReflectsNothingBetweenEqualMedia) {
  for (const double c : {0.0, 1e-9, 0.5, 1.0}) {
    EXPECT_NEAR(refract(n, n, c).reflectance, 0.0, 1e-15) << c;
    EXPECT_NEAR(refract(n, n, c).cos_transmitted, c, 1e-15) << c;
  }
}

template <class T>
class FresnelOf : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(FresnelOf, Reals);

TYPED_TEST(FresnelOf, IsAShareAtEveryAngle) {
  using T = TypeParam;
  for (const auto& [n1, n2] :
       {std::pair{1.0, 1.34}, {1.34, 1.0}, {1.34, 1.34}, {1.34, 1.3400001}, {1.0, 1.5}}) {
    for (int i = 0; i <= 10000; ++i) {
      const T c = T(i) / T(10000);
      const auto r = refract(T(n1), T(n2), c);
      ASSERT_TRUE(r.reflectance >= T(0) && r.reflectance <= T(1)) << n1 << " " << n2 << " " << c;
      ASSERT_TRUE(r.cos_transmitted >= T(0) && r.cos_transmitted <= T(1.0000001))
          << n1 << " " << n2 << " " << c;
    }
  }
  EXPECT_EQ(refract(T(1), T(1.34), T(0)).reflectance, T(1));
  EXPECT_EQ(refract(T(1.34), T(1), T(0)).reflectance, T(1));
}

}  // namespace
}  // namespace photic::optics
