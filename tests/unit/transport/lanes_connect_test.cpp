// The ways to a telescope with four lanes: each lane equals the scalar, bit for bit.
//
// A Connection promises its direction, optical depth and path where light is accepted; elsewhere a
// lane may hold what its neighbours needed. That is what is compared.
#include "transport/connect.hpp"
#include "unit/instrument/telescopes.hpp"
#include "unit/transport/connect_if_seen.hpp"
#include "unit/transport/packs.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using test::Random;

// Seen red: before lanes that are done were kept from Newton's further steps.
TEST(LanesOf, Crossing) {
  Random random(21);
  for (int g = 0; g < groups; ++g) {
    Four<double> n, depth, height, aside;
    for (std::size_t i = 0; i < lanes; ++i) {
      n[i] = random.between(1.3, 1.4);
      depth[i] = random.scale(1e-4, 1e4);
      height[i] = random.scale(1e-4, 1e4);
      aside[i] = random.chance(0.1) ? 0.0 : random.scale(1e-4, 1e4);
    }
    const auto at = [](const auto& n_, const auto& depth_, const auto& height_,
                       const auto& aside_) {
      const auto start =
          geometry::crossing_start(decltype(n_ + n_)(1) / n_, depth_, height_, aside_ * aside_);
      return std::pair(start, geometry::crossing(n_, depth_, height_, aside_ * aside_, start));
    };
    const auto [start, per_rise] = at(pack(n), pack(depth), pack(height), pack(aside));
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto [one_start, one] = at(n[i], depth[i], height[i], aside[i]);
      expect_same(start.per_rise[i], one_start.per_rise, "start");
      expect_same(start.error[i], one_start.error, "its error");
      expect_same(per_rise[i], one, "crossing");
    }
  }
}

TEST(LanesOf, RefractedSolidAnglePerArea) {
  Random random(22);
  for (int g = 0; g < groups; ++g) {
    const auto n = uniforms4(random), l1 = uniforms4(random), c1 = uniforms4(random),
               l2 = uniforms4(random), c2 = uniforms4(random);
    const auto packed =
        geometry::refracted_area_per_solid_angle(pack(n), pack(l1), pack(l2), {pack(c1), pack(c2)});
    for (std::size_t i = 0; i < lanes; ++i) {
      expect_same(packed[i],
                  geometry::refracted_area_per_solid_angle(n[i], l1[i], l2[i], {c1[i], c2[i]}),
                  "factor");
    }
  }
}

/// A point in the view of a telescope in the air, by following a ray of its field back into the
/// water; false if the ray misses the water.
bool move_into_view(const instrument::Telescope<double>& t, Random& random,
                    Photon<double>& photon) {
  const double off = std::atan(t.detector_radius / t.detector_distance) * random.between(0, 1.5);
  const double azimuth = random.between(0, 2 * pi);
  const auto ray = turned(t.axis, 1 - std::cos(off), std::cos(azimuth), std::sin(azimuth));
  if (ray.z > -0.01) return false;
  const double depth = -photon.position.z;
  const double sin_air = std::hypot(ray.x, ray.y);
  const double tan_water = sin_air / std::sqrt(1.34 * 1.34 - sin_air * sin_air);
  const auto foot = t.position + (t.position.z / -ray.z) * ray;
  const double further = sin_air > 0 ? depth * tan_water / sin_air : 0.0;
  photon.position = {foot.x + further * ray.x, foot.y + further * ray.y, -depth};
  return true;
}

void expect_same_connection(const Connection<Lanes4>& packed, std::size_t i,
                            const Connection<double>& scalar) {
  expect_same(packed.acceptance[i], scalar.acceptance, "acceptance");
  if (scalar.acceptance > 0) {
    expect_same(packed.direction, i, scalar.direction, "direction");
    expect_same(packed.optical_depth[i], scalar.optical_depth, "optical depth");
    expect_same(packed.path[i], scalar.path, "path");
  }
}

TEST(LanesOf, ConnectThroughSurface) {
  Random random(23);
  const auto sea = make_sea(40);
  int seen = 0, unseen = 0, mixed = 0;
  for (int g = 0; g < groups; ++g) {
    const auto scene = instrument::random_telescope(random);
    const auto telescope = instrument::make_telescope<double>(scene);
    Four<Photon<double>> scalar;
    for (auto& photon : scalar) {
      photon = random_photon(sea, random);
      if (random.chance(0.7)) move_into_view(telescope, random, photon);
      if (random.chance(0.05))
        photon.position = {telescope.position.x, telescope.position.y, photon.position.z};
    }
    const auto packed_photon = pack(scalar);
    const auto packed = connect_if_seen(sea, instrument::make_telescope<Lanes4>(scene),
                                        packed_photon, packed_photon.line);
    int lit = 0;
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto one = connect_if_seen(sea, telescope, scalar[i], scalar[i].line);
      expect_same_connection(packed, i, one);
      lit += one.acceptance > 0;
    }
    seen += lit;
    unseen += 4 - lit;
    mixed += lit > 0 && lit < 4;
  }
  EXPECT_GT(seen, groups);
  EXPECT_GT(unseen, groups);
  EXPECT_GT(mixed, groups / 4);
}

/// A telescope in the water that looks anywhere, or, if asked, into the upper half.
instrument::Telescope<double> random_lens(Random& random, scene::Telescope& scene, double depth,
                                          bool up = false) {
  scene = instrument::random_telescope(random);
  scene.position_m.z = -depth;
  scene.direction = random.direction();
  if (up) scene.direction.z = std::abs(scene.direction.z);
  return instrument::make_telescope<double>(scene);
}

TEST(LanesOf, LensSolidAngle) {
  Random random(24);
  for (int g = 0; g < groups; ++g) {
    scene::Telescope scene;
    const auto telescope = random_lens(random, scene, 3);
    Four<double> distance, cosine;
    for (std::size_t i = 0; i < lanes; ++i) {
      distance[i] = telescope.lens_radius * random.scale(1e-2, 1e4);
      cosine[i] = random.chance(0.1) ? 1.0 + 1e-16 : random.uniform();
    }
    const auto packed =
        lens_solid_angle(instrument::make_telescope<Lanes4>(scene), pack(distance), pack(cosine));
    for (std::size_t i = 0; i < lanes; ++i) {
      expect_same(packed[i], lens_solid_angle(telescope, distance[i], cosine[i]), "solid angle");
    }
  }
}

void connect_in_water_is_the_same(bool mirrored, std::uint64_t seed) {
  Random random(seed);
  const auto sea = make_sea(40);
  int seen = 0, mixed = 0, total = 0, partly = 0, other_layer = 0;
  for (int g = 0; g < groups; ++g) {
    scene::Telescope scene;
    const auto telescope = random_lens(random, scene, random.between(0.1, 20), mirrored);
    const auto layer = sea.layer_at(-telescope.position.z);
    Four<Photon<double>> scalar;
    for (auto& photon : scalar) {
      photon = random_photon(sea, random);
      if (random.chance(0.7)) {  // along the axis, out of the water into its mirror image
        const double z = random.scale(0.01, 30);
        photon.position =
            telescope.position + z * telescope.axis +
            (z * telescope.detector_radius / telescope.detector_distance * random.uniform()) *
                random.direction();
        photon.position.z = -std::min(39.0, std::abs(photon.position.z));
        photon.layer = sea.layer_at(-photon.position.z);
      }
      if (random.chance(0.02)) photon.position = telescope.position;
    }
    const auto packed_photon = pack(scalar);
    const auto packed =
        connect_in_water(sea.view(), instrument::make_telescope<Lanes4>(scene), Index4(layer),
                         packed_photon, packed_photon.line, route_of(mirrored));
    int lit = 0;
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto one = connect_in_water(sea.view(), telescope, layer, scalar[i], scalar[i].line,
                                        route_of(mirrored));
      expect_same_connection(packed, i, one);
      lit += one.acceptance > 0;
      if (!(one.acceptance > 0)) continue;
      other_layer += scalar[i].layer != layer;
      (one.direction.z < std::cos(48.6 * radian_per_degree) ? total : partly) += 1;
    }
    seen += lit;
    mixed += lit > 0 && lit < 4;
  }
  EXPECT_GT(seen, groups / 4);
  EXPECT_GT(mixed, groups / 8);
  EXPECT_GT(other_layer, groups / 10);
  EXPECT_GT(total, groups / 10);
  EXPECT_GT(partly, groups / 10);
}

TEST(LanesOf, ConnectInWaterDirectly) { connect_in_water_is_the_same(false, 25); }
TEST(LanesOf, ConnectInWaterMirrored) { connect_in_water_is_the_same(true, 26); }

}  // namespace
}  // namespace photic::transport
