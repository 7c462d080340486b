// Connections of walks: for one and the same path every strategy must give the same, its
// contribution over the sum of all strategies' densities. Else the balance heuristic's weights do
// not add up to 1.
#include "estimator/bidirectional/connections.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "unit/estimator/same_of_all.hpp"

namespace photic::estimator {
namespace {

using test::Random;

/// Random vertices between two depths that the laser's cone and the telescope's view hold.
Path random_path(Random& random, std::int32_t order, double upper, double lower) {
  Path path;
  for (std::int32_t i = 0; i < order; ++i)
    path.vertex.push_back(
        {random.between(-2, 2), random.between(-2, 2), -random.between(upper, lower)});
  path.lens = instrument::ring_point(0.05, 0.15, random.uniform(), random.uniform());
  return path;
}

struct Place {
  const char* what;
  scene::Source source;
  scene::Telescope telescope;
  bool mirrored_out = false, mirrored_back = false;
};

std::vector<Place> above_water() {
  const V down{0, 0, -1};
  return {
      {"upright", laser_at({0.5, 0, 8}, down), telescope_at({0, 0, 10}, down)},
      {"tilted", laser_at({0.5, 0, 8}, {0.1, 0, -1}), telescope_at({0, 0, 10}, {0.1, 0.2, -1})},
      {"tilted telescope", laser_at({0.5, 0, 8}, down), telescope_at({0, 0, 10}, {0.2, 0, -1})}};
}

/// In the water at 4 or 10 m, above or below the vertices; or one of both above it.
std::vector<Place> submerged() {
  const V down{0, 0, -1};
  const V up{0, 0, 1};
  return {
      {"down", laser_at({0.5, 0, -4}, down), telescope_at({0, 0, -4.5}, down)},
      {"up", laser_at({0.5, 0, -10}, up), telescope_at({0, 0, -9}, up)},
      {"laser up, telescope down", laser_at({0.5, 0, -10}, up), telescope_at({0, 0, -4}, down)},
      {"laser alone", laser_at({0.5, 0, -4}, down), telescope_at({0, 0, 10}, down)},
      {"telescope alone", laser_at({0.5, 0, 8}, down), telescope_at({0, 0, -4}, down)},
      {"tilted", laser_at({0.5, 0, -4}, {0.1, 0, -1}), telescope_at({0, 0, -4}, {0, 0.1, -1})},
      {"tilted telescope", laser_at({0.5, 0, -4}, down), telescope_at({0, 0, -4}, {0.1, 0.2, -1})}};
}

/// The first edge, or the last, or both by way of the surface.
std::vector<Place> looking_at_the_surface() {
  const V down{0, 0, -1};
  const V up{0, 0, 1};
  return {{"both", laser_at({0.5, 0, -4}, up), telescope_at({0, 0, -4.5}, up), true, true},
          {"laser", laser_at({0.5, 0, -4}, up), telescope_at({0, 0, -4.5}, down), true, false},
          {"telescope", laser_at({0.5, 0, -4}, down), telescope_at({0, 0, -4.5}, up), false, true},
          {"tilted", laser_at({0.5, 0, -4}, {0.1, 0, 1}), telescope_at({0, 0, -4}, {0, 0.1, 1}),
           true, true},
          {"tilted telescope", laser_at({0.5, 0, -4}, up), telescope_at({0, 0, -4}, {0, 0.1, 1}),
           true, true}};
}

// In one layer and through all three. Seen red: with n for n^2 in the spread of a ray through the
// surface; with the way in the air left out of it; with the sign in if_reversed() lost. And of what
// telescopes' walks draw about the beam: without it where a connection arrives, where it leaves, at
// a meeting; without the reverse chance, behind a ray, behind a vertex, in an edge. And of walks
// that are rotated: without either edge or the meeting near the pivot, or what a rotation does to
// them; without the phase function's gain; with the pivot forgotten where a walk has one vertex
// alone; with leaving for arriving in what leads aside. With the number of meetings in paths of one
// vertex more, at each of the places that know it. And of tilted lenses: with the way from the lens
// as long as before a translation, in time, in the spread of a first ray, in the edge behind a
// later one.
TEST(StrategiesOfPath, OfElasticLightAgree) {
  Random random(101);
  int met = 0, rotated = 0, of_telescope = 0, of_laser = 0;
  for (const Place& place : above_water()) {
    Sea sea(place.source, place.telescope);
    for (int n = 0; n < 300; ++n) {
      const auto path = random_path(random, 1 + n % 3, 1, n % 2 == 0 ? 4.9 : 25);
      SCOPED_TRACE(std::string(place.what) + ", path " + std::to_string(n));
      const auto counts = expect_same_of_all(sea, path);
      EXPECT_EQ(counts.connected, path.order() + 1);
      met += counts.met;
      rotated += counts.rotated;
      of_telescope += counts.free_telescope;
      of_laser += counts.free_laser;
    }
  }
  EXPECT_GT(met, 200);
  EXPECT_GT(rotated, 50);
  EXPECT_GT(of_telescope, 200);
  EXPECT_GT(of_laser, 200);
}

// Where nothing is drawn about the beam, walks are rotated that look for a tilted one, too.
TEST(StrategiesOfPath, OfATiltedLaserInWaterThatConvertsNothingAgree) {
  Random random(109);
  int rotated = 0;
  const Place place = above_water()[1];
  Sea sea(place.source, place.telescope);
  sea.world.walks.inverse_conversion.scattered = 0;
  sea.world.walks.uses.rotated_scattered = true;
  for (int n = 0; n < 300; ++n) {
    const auto path = random_path(random, 1 + n % 3, 1, n % 2 == 0 ? 4.9 : 25);
    SCOPED_TRACE("path " + std::to_string(n));
    rotated += expect_same_of_all(sea, path).rotated;
  }
  EXPECT_GT(rotated, 30);
}

// Seen red: with the way from the fictitious vertex to the disc left out of the laser's spread. And
// of tilted lenses: with a first ray that begins where it did before a translation; with the light
// as it was; without what walks draw of the way, in edges, in meetings at its end or behind it.
TEST(StrategiesOfPath, InTheWaterAgree) {
  Random random(102);
  int met = 0;
  for (const Place& place : submerged()) {
    Sea sea(place.source, place.telescope);
    for (int n = 0; n < 300; ++n) {
      const auto path = random_path(random, 1 + n % 3, 6, 7.5);
      SCOPED_TRACE(std::string(place.what) + ", path " + std::to_string(n));
      const auto counts = expect_same_of_all(sea, path);
      EXPECT_EQ(counts.connected, path.order() + 1);
      met += counts.met;
    }
  }
  EXPECT_GT(met, 100);
}

// Connections need a straight edge or an instrument, meetings do not. Seen red: without the
// meetings behind a mirrored way to an instrument; without those at such a way's vertex; with a
// mirrored leg taken for a straight one; with no connection of a mirrored first edge; with
// translations to last vertices between the levels of a tilted lens' points, at each of the places
// that know them.
TEST(StrategiesOfPath, ByWayOfTheSurfaceAgree) {
  Random random(103);
  int met = 0;
  for (const Place& place : looking_at_the_surface()) {
    Sea sea(place.source, place.telescope);
    for (int n = 0; n < 100; ++n) {
      auto path = random_path(random, 3, 6, 20);
      path.mirrored[0] = place.mirrored_out;
      path.mirrored[3] = place.mirrored_back;
      if (place.mirrored_back && n % 4 == 0) path.vertex[2].z = -4 + random.between(-0.02, 0.02);
      if (n % 8 == 0) path.vertex[1].z = -random.between(1, 3);  // then light turns back at both
      if (n % 2 == 1 && path.x(1 + n / 2 % 3).z > -12) {
        path.converted = 1 + n / 2 % 3;
        path.line = 1 + n / 6 % 2;
      }
      SCOPED_TRACE(std::string(place.what) + ", path " + std::to_string(n));
      const auto counts = expect_same_of_all(sea, path);
      EXPECT_EQ(counts.connected, path.line > 0 ? path.converted + 1 : 4);
      met += counts.met;
    }
  }
  EXPECT_GT(met, 100);
}

// In layers of the air, each with a group index of its own. Seen red: with the delay left out of
// the way to the laser, to the telescope, each by way of the surface, between two vertices, and to
// where rays meet, straight or by way of the surface.
TEST(StrategiesOfPath, InTheAirAgree) {
  auto air = transport::make_sea(40);
  air.kind = medium::MediumKind::air;
  air.air_m = 40;
  for (auto& line : air.line) line.group_index = 1;
  air.delay = {0.3, 0.1, 0.02, 0.31, 0.11, 0.03, 0.32, 0.12, 0.04};
  air.finish();
  Random random(110);
  int met = 0, by_surface = 0;
  auto places = submerged();
  std::erase_if(places, [](const Place& place) {
    return place.source.position_m.z > 0 || place.telescope.position_m.z > 0;
  });
  for (const Place& place : looking_at_the_surface()) places.push_back(place);
  for (const Place& place : places) {
    Sea sea(place.source, place.telescope, air);
    const bool mirrored = place.mirrored_out || place.mirrored_back;
    for (int n = 0; n < 100; ++n) {
      const std::int32_t order = 1 + n % 3;
      auto path = mirrored ? random_path(random, order, 6, 20) : random_path(random, order, 6, 7.5);
      path.mirrored[0] = place.mirrored_out;
      path.mirrored[static_cast<std::size_t>(order)] = place.mirrored_back;
      if (order == 3) path.mirrored[1 + static_cast<std::size_t>(n / 3 % 3)] |= n / 3 % 3 < 2;
      SCOPED_TRACE(std::string(place.what) + ", path " + std::to_string(n));
      met += expect_same_of_all(sea, path).met;
      by_surface += mirrored;
    }
  }
  EXPECT_GT(met, 200);
  EXPECT_GT(by_surface, 300);
}

// As wide as the others, out to its cut. Seen red: with an even density at the birth, or in
// connections.
TEST(StrategiesOfPath, OfAGaussianLaserAgree) {
  Random random(111);
  int met = 0, of_laser = 0;
  auto places = above_water();
  for (const Place& place : submerged()) places.push_back(place);
  for (Place& place : places) {
    place.source.half_divergence_mrad = 400;
    place.source.profile = scene::SourceProfile::gaussian;
    Sea sea(place.source, place.telescope);
    ASSERT_EQ(sea.world.walks.laser_cone.rings, 8U);
    for (int n = 0; n < 100; ++n) {
      const auto path = random_path(random, 1 + n % 3, 6, 7.5);
      SCOPED_TRACE(std::string(place.what) + ", path " + std::to_string(n));
      const auto counts = expect_same_of_all(sea, path);
      EXPECT_EQ(counts.connected, path.order() + 1);
      met += counts.met;
      of_laser += counts.free_laser;
    }
  }
  EXPECT_GT(met, 100);
  EXPECT_GT(of_laser, 100);
}

// No connection can meet parallel light.
TEST(StrategiesOfPath, OfACollimatedLaserAgree) {
  Random random(107);
  int met = 0;
  auto source = laser_at({0.5, 0, 8}, {0, 0, -1});
  source.half_divergence_mrad = 0;
  Sea sea(source, telescope_at({0, 0, 10}, {0, 0, -1}));
  for (int n = 0; n < 100; ++n) {
    auto path = random_path(random, 3, 1, 20);
    path.vertex[0].x = 0.5;
    path.vertex[0].y = 0;
    SCOPED_TRACE("path " + std::to_string(n));
    const auto counts = expect_same_of_all(sea, path);
    EXPECT_EQ(counts.connected, 3);
    met += counts.met;
  }
  EXPECT_GT(met, 50);
}

// Seen red: with a mirrored leg taken for a straight one; without the reflectance of an image; with
// its way taken for a straight one; with a meeting before a mirrored leg judged by the direction
// behind it; with an edge by way of the surface connected beside a meeting.
TEST(StrategiesOfPath, OfLightThatTheSurfaceTurnsBackBetweenCollisionsAgree) {
  Random random(106);
  int met = 0, rotated = 0;
  for (const Place& place : above_water()) {
    Sea sea(place.source, place.telescope);
    for (int n = 0; n < 100; ++n) {
      auto path = random_path(random, 4, 1, 20);
      path.mirrored[static_cast<std::size_t>(1 + n % 3)] = true;
      path.line = n / 2 % 2;
      if (path.line > 0) path.converted = 1 + n / 4 % 4;
      SCOPED_TRACE(std::string(place.what) + ", path " + std::to_string(n));
      if (path.line > 0 && path.x(path.converted).z < -12) continue;
      const auto counts = expect_same_of_all(sea, path);
      met += counts.met;
      rotated += counts.rotated;
    }
  }
  EXPECT_GT(met, 100);
  EXPECT_GT(rotated, 20);
}

// Each vertex converts in turn. Seen red: without a departure's ratio of coefficients; with the
// chance of a ray for that of a walk that ends at its vertex, in edges and in meetings; with
// meetings behind a scattering of converted light; without the ratio of walk coefficients in a
// connection, in a meeting behind it; without the telescope's chance, or where it inverts
// conversions; with the last scattering of converted light taken for certain; with translated rays
// where light goes on; without the reverse chance in the last rotations; with what lies behind a
// tilted lens' first vertex kept only of the laser's light.
TEST(StrategiesOfPath, OfConvertedLightAgree) {
  Random random(104);
  int met = 0;
  for (const Place& place : above_water()) {
    Sea sea(place.source, place.telescope);
    for (int n = 0; n < 120; ++n) {
      auto path = random_path(random, 3, n % 2 == 0 ? 5.1 : 0.5, 20);
      path.line = 1 + n / 2 % 2;
      path.converted = 1 + n / 4 % 3;
      // Where the line is emitted: the first only there, in the second layer.
      V& x = path.vertex[static_cast<std::size_t>(path.converted - 1)];
      x.z = -random.between(path.line == 1 ? 0.5 : 5.1, 11.9);
      SCOPED_TRACE(std::string(place.what) + ", path " + std::to_string(n));
      const auto counts = expect_same_of_all(sea, path);
      EXPECT_EQ(counts.connected, path.converted + 1);
      met += counts.met;
    }
  }
  EXPECT_GT(met, 100);
}

/// The albedo at even steps of sqrt(1 - cos), of three lines.
std::vector<double> bed_by_angle() {
  std::vector<double> out;
  for (const double at_zenith : {0.1, 0.3, 0.2})
    for (int k = 0; k <= 8; ++k) out.push_back(at_zenith + 0.07 * k);
  return out;
}

// Each vertex lies on the bed in turn, or two do; half of the paths convert. Their light counts as
// the bed's, whatever it touched before or after. Seen red: with the albedo of the way to the
// telescope, where walks are connected and where they meet; with the cosine of both rays in
// meetings on the bed, and with such meetings taken for ones in the water alone; with the density
// of the edge that is left for that of the edge that arrives, in a walk, at its end, at a meeting;
// with what walks draw about the beam there.
TEST(StrategiesOfPath, OfLightThatTheBedReflectsAgree) {
  Random random(110);
  int met = 0, rotated = 0;
  auto places = above_water();
  for (const Place& place : submerged()) places.push_back(place);
  for (const Place& place : places) {
    Sea sea(place.source, place.telescope, transport::make_sea(13, bed_by_angle()));
    sea.world.walks.deepest = 13;
    const auto looks = [](const auto& instrument) {
      return instrument.position_m.z > 0 || instrument.direction.z < 0;
    };
    for (int n = 0; n < 120; ++n) {
      const std::int32_t order = 1 + n % 4;
      const bool in_air = place.telescope.position_m.z > 0 && place.source.position_m.z > 0;
      const double upper = in_air ? 5.1 : 6, lower = in_air ? 11.9 : 7.5;
      auto path = random_path(random, order, in_air ? 1 : upper, lower);
      if (n % 2 == 1) {
        path.converted = 1 + n / 8 % order;
        path.line = 1 + n / 2 % 2;
        V& x = path.vertex[static_cast<std::size_t>(path.converted - 1)];
        x.z = -random.between(upper, lower);
      }
      std::vector<std::int32_t> on_bed = {1 + n / 4 % order};
      if (order == 4) on_bed.push_back(1 + (on_bed[0] + 1) % order);
      for (const auto i : on_bed) path.vertex[static_cast<std::size_t>(i - 1)].z = -13;
      if (path.converted > 0 && path.x(path.converted).z == -13) continue;
      const bool seen = (path.x(1).z != -13 || looks(place.source)) &&
                        (path.x(order).z != -13 || looks(place.telescope));
      if (!seen) continue;
      SCOPED_TRACE(std::string(place.what) + ", path " + std::to_string(n));
      const auto counts = expect_same_of_all(sea, path, n % 5 == 0 ? 2 : max_vertices);
      met += counts.met;
      rotated += counts.rotated;
    }
  }
  EXPECT_GT(met, 200);
  EXPECT_GT(rotated, 20);
}

// Seen red: with a walk that sets out from its last vertex; with edges that no two walks reach;
// with the last vertex' densities left out; with unusable meetings beside a connection, beside a
// meeting; with unusable edges or meetings near the pivot of a walk that is rotated; with an
// unusable meeting at the end of a longer way from a tilted lens.
TEST(StrategiesOfPath, OfWalksThatEndEarlyAgree) {
  Random random(105);
  int met = 0;
  std::vector<Place> places = above_water();
  places.push_back(submerged().back());
  for (const Place& place : places) {
    Sea sea(place.source, place.telescope);
    for (int n = 0; n < 200; ++n) {
      const std::int32_t order = 3 + n % 3;
      auto path = random_path(random, order, place.telescope.position_m.z < 0 ? 6 : 0.5, 11.9);
      path.line = n / 3 % 2;
      if (path.line > 0) path.converted = 1 + n / 6 % order;
      const std::int32_t most = 2 + n / 2 % 2;
      SCOPED_TRACE(std::string(place.what) + ", path " + std::to_string(n));
      met += expect_same_of_all(sea, path, most).met;
    }
  }
  EXPECT_GT(met, 30);
}

// What a walk does beyond a path's vertices is no part of the path. Seen red: with the axis of
// the telescope's walk for that of the path, where the laser's light arrives.
TEST(StrategiesOfPath, OfPathsThatAWalkGoesBeyondAgree) {
  Random random(108);
  const Place place = above_water()[0];
  Sea sea(place.source, place.telescope);
  for (int n = 0; n < 100; ++n) {
    auto path = random_path(random, 2, 5.1, 11.9);
    path.line = 2;
    path.converted = 1 + n % 2;
    auto longer = path;
    const auto beyond = random_path(random, 2, 5.1, 11.9);
    longer.vertex.insert(longer.vertex.begin(), beyond.vertex.begin(), beyond.vertex.end());
    longer.converted = n % 2 == 0 ? 2 : 4;
    SCOPED_TRACE("path " + std::to_string(n));
    sea.world.walks.max_vertices = max_vertices;
    const StrategiesOfPath expected(sea.world, sea.medium, rotating, path, max_vertices);
    Scores scores(sea.world, rotating, sea.medium, path, expected.group_path());
    EXPECT_NEAR(scores.connecting_first_of_a_longer(longer) / expected.value(), 1, 1e-10);
  }
}

}  // namespace
}  // namespace photic::estimator
