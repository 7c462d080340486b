// Flights and optical depths through columns of water side by side.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "estimator/forward/escape.hpp"
#include "geometry/segment.hpp"
#include "support/random.hpp"
#include "transport/flight.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using test::Random;
using V = Vec3<double>;

constexpr double bottom_m = 40;

/// The layers of a column, each like one of make_sea()'s: where it begins, and its number there.
using Layers = std::vector<std::pair<double, std::size_t>>;

Sea make_row(const std::vector<Layers>& columns, const std::vector<double>& face_m,
             const std::vector<double>& bed_albedo = {}) {
  const Sea like = make_sea(bottom_m);
  Sea sea = like;
  sea.row.first_layer.clear();
  sea.row.face_m = face_m;
  sea.top.clear();
  std::vector<std::size_t> of;
  for (const Layers& column : columns) {
    sea.row.first_layer.push_back(static_cast<std::int32_t>(sea.top.size()));
    for (const auto& [top, number] : column) {
      sea.top.push_back(top);
      of.push_back(number);
    }
  }
  sea.top.push_back(bottom_m);
  const auto spread = [&](auto& table, const auto& from) {
    table.clear();
    for (std::size_t line = 0; line < 3; ++line)
      for (const std::size_t layer : of) table.push_back(from[3 * line + layer]);
  };
  spread(sea.c, like.c), spread(sea.albedo, like.albedo);
  spread(sea.conversion, like.conversion), spread(sea.absorption, like.absorption);
  spread(sea.elastic_phase, like.elastic_phase);
  sea.bed_albedo = bed_albedo;
  return sea;
}

const Layers all_three{{0, 0}, {5, 1}, {12, 2}};

Sea unlike_columns(double y_min_m = -medium::Row::endless, double y_max_m = medium::Row::endless) {
  Sea sea = make_row({{{0, 2}, {3, 1}}, all_three, {{0, 1}}, {{0, 0}, {9, 2}}},
                     {-medium::Row::endless, -4, 1, 2.5, 20});
  sea.row.y_min_m = y_min_m;
  sea.row.y_max_m = y_max_m;
  sea.finish();
  return sea;
}

Photon<double> photon_in(const Sea& sea, const V& position, const V& direction) {
  Photon<double> photon;
  photon.position = position;
  photon.direction = direction;
  photon.layer = sea.layer_at(-position.z, sea.row.column_at(position.x));
  return photon;
}
Photon<double> photon_somewhere(const Sea& sea, Random& random) {
  const V position{random.between(-12, 15), random.between(-5, 5), random.between(-39, -0.1)};
  return photon_in(sea, position, random.direction());
}

/// The attenuation where a place lies.
double c_at(const Sea& sea, const V& at) {
  return sea.c[static_cast<std::size_t>(sea.layer_at(-at.z, sea.row.column_at(at.x)))];
}
/// Its integral along a ray that the surface reflects, step by step.
double depth_step_by_step(const Sea& sea, const geometry::Ray<double>& ray, double length) {
  constexpr int steps = 20000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    V at = ray.start + (i + 0.5) * (length / steps) * ray.direction;
    at.z = -std::abs(at.z);
    sum += c_at(sea, at) * (length / steps);
  }
  return sum;
}
/// A step too far or too short at each face and edge.
double error_of_steps(double length) { return length / 20000 * 10; }

// Three columns that are alike are one. Seen red: with flights that end at the first face, and
// with the layers of the first column in all.
TEST(Columns, ThatAreAlikeAreOne) {
  const Sea one = make_sea(bottom_m);
  Sea three = make_row({all_three, all_three, all_three},
                       {-medium::Row::endless, -1, 2, medium::Row::endless});
  three.finish();
  Random random(63);
  int crossed = 0;
  for (int i = 0; i < 20000; ++i) {
    Photon<double> there = photon_somewhere(three, random);
    Photon<double> alone = photon_in(one, there.position, there.direction);
    const double free_path = -std::log(1 - random.uniform());
    const std::int32_t column = three.view().row.column<double>(there.layer);
    const auto end = fly(three.view(), there, free_path);
    const auto expected = fly(one.view(), alone, free_path);
    ASSERT_EQ(end.surface, expected.surface);
    ASSERT_EQ(end.sea_bed, expected.sea_bed);
    ASSERT_FALSE(end.sideways);
    ASSERT_EQ(there.layer % 3, alone.layer);
    ASSERT_NEAR(end.length, expected.length, 1e-9 * (1 + expected.length));
    ASSERT_NEAR(length(there.position - alone.position), 0, 1e-9 * (1 + expected.length));
    ASSERT_NEAR(there.weight, alone.weight, 1e-9 * alone.weight);
    ASSERT_NEAR(there.path, alone.path, 1e-9 * (1 + alone.path));
    if (three.view().row.column<double>(there.layer) != column) ++crossed;
  }
  EXPECT_GT(crossed, 3000);
}

// A free path is as deep as was drawn, and the weight takes what is absorbed along it. Seen red:
// with free paths that forget what they used before a face, and with weights that do.
TEST(Columns, GiveFlightsTheirDepth) {
  const Sea sea = unlike_columns();
  const auto view = sea.view();
  Random random(64);
  int collisions = 0, aside = 0;
  for (int i = 0; i < 20000; ++i) {
    const Photon<double> before = photon_somewhere(sea, random);
    Photon<double> after = before;
    const double free_path = -std::log(1 - random.uniform());
    const auto end = fly(view, after, free_path);
    const V way = after.position - before.position;
    ASSERT_NEAR(length(way), end.length, 1e-9 * (1 + end.length));
    ASSERT_NEAR(dot(way, before.direction), end.length, 1e-9 * (1 + end.length));
    const auto depths = geometry::optical_depths(
        view, geometry::Segment<double>{0,
                                        geometry::level_of(view, before),
                                        geometry::level_of(view, after),
                                        end.length,
                                        {before.position, before.direction}});
    const bool collides = !(end.surface || end.sea_bed || end.sideways);
    const double gain = gather<double>(view.collision_gain, view.at(0, after.layer));
    const double weight = std::exp(depths.walk - depths.all) * (collides ? gain : 1);
    aside += end.sideways ? 1 : 0;
    if (end.sideways) {
      ASSERT_NEAR(after.position.x, 20, 1e-9);
      continue;
    }
    ASSERT_NEAR(after.weight, weight, 1e-9 * weight);
    if (!collides) {
      ASSERT_LE(depths.walk, free_path + 1e-9);
      continue;
    }
    ASSERT_NEAR(depths.walk, free_path, 1e-9 * (1 + free_path));
    ASSERT_EQ(after.layer, sea.layer_at(-after.position.z, sea.row.column_at(after.position.x)));
    ++collisions;
  }
  EXPECT_GT(collisions, 15000);
  EXPECT_GT(aside, 100);
}

// Straight, to the surface, and by way of it. Seen red: with the first column's depth for all, and
// with the ray that is not mirrored below the surface.
TEST(Columns, AddUpAlongStraightWays) {
  const Sea sea = unlike_columns();
  const auto view = sea.view();
  Random random(65);
  for (int i = 0; i < 300; ++i) {
    const Photon<double> from = photon_somewhere(sea, random);
    const auto level = geometry::level_of(view, from);
    const V to{random.between(-12, 15), random.between(-5, 5), random.between(-39, -0.1)};
    const auto to_level = view.level<double>(sea.layer_at(-to.z, sea.row.column_at(to.x)), -to.z);
    const auto check = [&](geometry::Segment<double> way, const V& end) {
      way.ray = {from.position, normalised(end - from.position)};
      const double expected = depth_step_by_step(sea, way.ray, way.length);
      EXPECT_NEAR(geometry::optical_depths(view, way).all, expected, error_of_steps(way.length));
    };
    check({0, level, to_level, length(to - from.position)}, to);
    const V top{to.x, to.y, 0}, image{to.x, to.y, -to.z};
    const double up = length(top - from.position), by = length(image - from.position);
    check(geometry::to_surface(0, level, up,
                               geometry::Slant<double>::of_cosine(-from.position.z / up)),
          top);
    check(geometry::by_surface(0, level, to_level, by,
                               geometry::Slant<double>::of_cosine((-from.position.z - to.z) / by)),
          image);
  }
}

// Nothing comes on that leaves the row.
TEST(Columns, EndWhereTheRowDoes) {
  const Sea sea = unlike_columns(-2, 3);
  const auto view = sea.view();
  const auto leaves = [&](const V& direction) {
    Photon<double> photon = photon_in(sea, {19.9, 2.9, -20}, normalised(direction));
    return fly(view, photon, 1.0).sideways;
  };
  EXPECT_TRUE(leaves({1, 0, 0}));
  EXPECT_TRUE(leaves({0, 1, 0.1}));
  EXPECT_FALSE(leaves({-1, 0, 0}));
  EXPECT_FALSE(leaves({0, 0, -1}));
  Photon<double> photon = photon_in(sea, {0, -1.9, -20}, normalised(V{0, -1, 0}));
  EXPECT_TRUE(fly(view, photon, 1.0).sideways);
  EXPECT_NEAR(photon.position.y, -2, 1e-12);
  const auto up = geometry::to_surface(0, geometry::level_of(view, photon), 30.0,
                                       geometry::Slant<double>::of_cosine(20.0 / 30),
                                       {{19, 0, -20}, normalised(V{2, 0, 1})});
  EXPECT_EQ(std::exp(-geometry::optical_depths(view, up).all), 0);
}

// The chance to leave the water on the next flight is the share of flights that do. Seen red: with
// the depth to the surface where the way leads out by a side.
TEST(Columns, AreLeftAsOftenAsExpected) {
  const Sea sea = unlike_columns(-2, 3);
  const auto view = sea.view();
  Random random(66);
  for (const V& direction :
       {V{3, 0, 1}, V{-2, 0.1, -1}, V{0.4, 0.1, 1}, V{1, 0, 0}, V{-0.2, -3, 1}}) {
    const auto photon = photon_in(sea, {15, 0.5, -6}, normalised(direction));
    const auto away = estimator::escape(view, photon);
    constexpr int flights = 40000;
    int left = 0;
    for (int i = 0; i < flights; ++i) {
      Photon<double> flown = photon;
      const auto end = fly(view, flown, -std::log(1 - random.uniform()));
      left += end.surface || end.sea_bed || end.sideways ? 1 : 0;
      if (end.surface) {
        ASSERT_TRUE(away.surface);
      }
      ASSERT_EQ(end.sideways, end.sideways && away.sideways);
    }
    const double share = left / double{flights};
    const double reflectance =
        away.surface ? surface::flat_surface<double>(view, 0).reflectance(photon.direction.z) : 0;
    const double expected = away.probability / (1 - reflectance);
    EXPECT_NEAR(share, expected, 4.5 * std::sqrt(expected / flights));
  }
}

// Beds that reflect are below each column. Seen red: with the first column's albedo.
TEST(Columns, HaveABedEach) {
  Sea sea = make_row({all_three, {{0, 1}}}, {-medium::Row::endless, 0, medium::Row::endless},
                     {0.3, 0.4, 0.5, 0.6, 0.7, 0.8});
  sea.finish();
  const auto view = sea.view();
  EXPECT_EQ(view.places, 6);
  for (const double x : {-1.0, 1.0}) {
    Photon<double> photon = photon_in(sea, {x, 0, -39.99}, {0, 0, -1});
    const std::int32_t layer = photon.layer;
    fly(view, photon, 5.0);
    EXPECT_EQ(photon.layer, view.bed_below<double>(layer));
    EXPECT_TRUE(surface::on_bed<double>(view, photon.layer));
    EXPECT_EQ(view.layer_of<double>(photon.layer), layer);
    EXPECT_EQ(gather<double>(view.albedo, view.at(1, photon.layer)), 1);
    EXPECT_EQ(surface::bed_albedo<double>(view, 1, photon.layer, 0.5), x < 0 ? 0.5 : 0.6);
  }
}

}  // namespace
}  // namespace photic::transport
