// Rays through shells by the steps of flights, against Bouguer's law and against geometry.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "geometry/shells.hpp"
#include "medium/shells.hpp"

namespace photic::geometry {
namespace {

/// A ray's sums from sphere to sphere, until it has left the air or come to the ground.
struct Through {
  ShellRay ray;
  double angle = 0, length = 0, optical_path = 0;
  std::vector<std::int32_t> shells = {};
};
/// `index`: of the shells from the uppermost down; none: 1.
Through through(const ShellsView& shells, ShellRay ray, const std::vector<double>& index = {}) {
  Through out{ray};
  Turn turn;
  while (out.ray.shell >= 0) {
    const Leg leg = leg_ahead(shells, out.ray);
    const ShellRay end = end_of(shells, out.ray, leg);
    out.shells.push_back(out.ray.shell);
    out.length += leg.length;
    if (!index.empty())
      out.optical_path += index.at(static_cast<std::size_t>(out.ray.shell)) * leg.length;
    turn = turn.by(turn_of(out.ray, leg.length, end.radius));
    out.ray = end;
    if (leg.sphere == shells.ground()) break;
    cross_sphere(shells, out.ray, leg.sphere);
  }
  out.angle = std::atan2(turn.sine, turn.cosine);
  return out;
}

constexpr std::int32_t lowest_of_three = 2;
const medium::Shells three_that_bend(1, {0, 0.5, 1, 3}, {1.2, 1.1, 1.0});
const std::vector<double> their_index{1.0, 1.1, 1.2};

struct Bouguer {
  double launch, angle, optical_path, exit;
};
/// Central angle, optical path and exit angle by Bouguer's law, n r sin = const (Born & Wolf,
/// Principles of Optics, 3.2.1), with the radii 1, 1.5, 2, 4 and the indices 1.2, 1.1, 1.0.
const std::vector<Bouguer> by_bouguer{{0.1, 0.08156510, 3.15489133, 0.02995450},
                                      {0.5, 0.41369832, 3.27241970, 0.14432821},
                                      {0.8, 0.67623136, 3.46272116, 0.21690361}};

// Seen red: with 1 - (n'/n)^2 at spheres.
TEST(ShellRay, ObeysBouguersLaw) {
  const auto shells = three_that_bend.view();
  for (const Bouguer& b : by_bouguer) {
    const auto up = through(shells, {0, 1, std::cos(b.launch), lowest_of_three}, their_index);
    EXPECT_NEAR(up.angle, b.angle, 1e-8);
    EXPECT_NEAR(up.optical_path, b.optical_path, 1e-8);
    EXPECT_NEAR(std::acos(up.ray.cosine()), b.exit, 1e-8);
  }
}

// Seen red: with a sphere crossed downwards as if upwards.
TEST(ShellRay, GoesTheSameWayBack) {
  const auto shells = three_that_bend.view();
  for (const Bouguer& b : by_bouguer) {
    const auto down = through(shells, {3, 4, -4 * std::cos(b.exit), 0}, their_index);
    EXPECT_NEAR(down.angle, b.angle, 1e-7);
    EXPECT_NEAR(down.optical_path, b.optical_path, 1e-7);
    EXPECT_NEAR(std::acos(-down.ray.cosine()), b.launch, 1e-7);
    EXPECT_EQ(down.ray.height, 0);
  }
}

// A chord is twice as long as the way from the nearest point: sqrt(r^2 - b^2). Rays that just meet
// a sphere, or just miss it, pass the shells of their chord alone. Seen red: with the formula
// of the way down taken for the way up.
TEST(ShellRay, PassesItsLowestPointAndGoesOut) {
  const double planet = 6.4e6, top = 6e4;
  const medium::Shells straight(planet, {0, 1.5e4, 3e4, 4.5e4, top}, {});
  for (const double nearest : {1e3, 1.5e4 - 1e-3, 1.5e4 + 1e-3, 2e4, 4.4e4, top - 1e-3}) {
    const double half = std::sqrt((top - nearest) * (2 * planet + top + nearest));
    const auto chord = through(straight.view(), {top, planet + top, -half, 0});
    EXPECT_NEAR(chord.length, 2 * half, 1e-9 * half) << nearest;
    EXPECT_EQ(chord.ray.shell, -1);
    const auto deepest = static_cast<std::size_t>(3 - std::floor(nearest / 1.5e4));
    EXPECT_EQ(chord.shells.size(), 2 * deepest + 1) << nearest;
    EXPECT_NEAR(chord.ray.rise, half, 1e-9 * half);
    EXPECT_NEAR(std::sin(chord.angle / 2), half / (planet + top), 1e-9);
  }
}

// By the critical angle of an index of 1.2 against 1.1, 66.44 degrees at the sphere. Seen red: with
// rays that go on horizontally.
TEST(ShellRay, IsReflectedInTotalAndStaysInItsShell) {
  const auto shells = three_that_bend.view();
  // sin = sin(launch) / 1.5 at the sphere above: such angles are met from within the shell alone.
  ShellRay ray{0.4, 1.4, 1.4 * std::cos(1.4), lowest_of_three};
  const double sine = 1.4 * std::sin(1.4) / 1.5;
  ASSERT_GT(sine, 1.1 / 1.2);
  const Leg leg = leg_ahead(shells, ray);
  ray = end_of(shells, ray, leg);
  const double rise = ray.rise;
  cross_sphere(shells, ray, leg.sphere);
  EXPECT_EQ(ray.shell, lowest_of_three);
  EXPECT_EQ(ray.rise, -rise);
}

// A planet of 1e9 m: heights keep their digits, where radii would have lost seven of them. The way
// between two spheres is that between planes, but for a share tan^2 H / R of it. Seen red: with
// differences of squares of radii.
TEST(ShellRay, IsStraightThroughPlanesOfAHugePlanet) {
  const double planet = 1e9, top = 1e5;
  const medium::Shells shells(planet, {0, 1e-3, 1.0, 1e3, top}, {});
  const double cosine = 0.5;
  ShellRay ray{0, planet, planet * cosine, 3};
  double below = 0;
  for (const double height : {1e-3, 1.0, 1e3, top}) {
    const Leg leg = leg_ahead(shells.view(), ray);
    const double plane = (height - below) / cosine;
    EXPECT_NEAR(leg.length, plane, (3 * height / planet + 1e-9) * plane);
    ray = end_of(shells.view(), ray, leg);
    EXPECT_EQ(ray.height, height);
    cross_sphere(shells.view(), ray, leg.sphere);
    below = height;
  }
  EXPECT_EQ(ray.shell, -1);
}

// Within a shell, heights are those of places in space, which are known to some 1e-9 m.
TEST(ShellRay, IsWhereItsPlaceIs) {
  const double planet = 6.371e6, top = 1e5;
  const medium::Shells owner(planet, {0, top}, {});
  const auto shells = owner.view();
  for (const double rise : {-0.6, -1e-3, 0.0, 0.3}) {
    const Vec3<double> direction = normalised(Vec3<double>{1, 0.2, rise});
    const Vec3<double> position{300, -4000, -2e4};
    const ShellRay ray = ray_in(shells, place_in(shells, position), direction, 0);
    for (const double length : {1.0, 1e3, 5e4}) {
      const auto there = place_in(shells, position + length * direction);
      EXPECT_NEAR(farther(ray, length).height, there.height, 1e-8);
      const auto plane = plane_of(place_in(shells, position).from_centre, direction);
      const ShellRay end = farther(ray, length);
      const Vec3<double> turned = end.radius * plane.vertical(turn_of(ray, length, end.radius));
      EXPECT_NEAR(photic::length(turned - there.from_centre), 0, 1e-7);
      EXPECT_NEAR(
          one_minus_cos(plane.direction(turn_of(ray, length, end.radius), end.cosine()), direction),
          0, 1e-20);
    }
  }
}

// Its axes are those of a right-handed frame, and directions come back.
TEST(LocalFrame, IsThatOfThePlace) {
  for (const Vec3<double>& up :
       {Vec3<double>{0, 0, 1}, Vec3<double>{0, 0, -1}, normalised(Vec3<double>{3, -2, -0.5})}) {
    const LocalFrame frame(up);
    EXPECT_NEAR(length(cross(frame.x, frame.y) - up), 0, 1e-15);
    const Vec3<double> direction = normalised(Vec3<double>{0.3, -0.5, 0.2});
    const Vec3<double> local = in_local_frame(up, direction);
    EXPECT_NEAR(local.z, dot(up, direction), 1e-15);
    EXPECT_NEAR(length(from_local_frame(up, local) - direction), 0, 1e-15);
  }
}

}  // namespace
}  // namespace photic::geometry
