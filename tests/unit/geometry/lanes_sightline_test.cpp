// Ways between instruments and places with four lanes: each lane equals the scalar, bit for bit.
#include "unit/instrument/telescopes.hpp"
#include "unit/transport/fields.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using instrument::PlanePoint;
using test::Random;
using V = Vec3<double>;

TEST(LanesOf, LensPoints) {
  Random random(61);
  int open = 0, seen = 0, upright = 0;
  for (int g = 0; g < groups; ++g) {
    scene::Telescope scene;
    const auto telescope = instrument::random_telescope(random, scene);
    const auto telescope4 = instrument::make_telescope<Lanes4>(scene);
    const auto u = uniforms4(random), v = uniforms4(random);
    const auto lens4 = lens_point(telescope4, pack(u), pack(v));
    const auto wide = four([&] {
      return instrument::ring_point(0.0, 1.5 * telescope.lens_radius, random.uniform(),
                                    random.uniform());
    });
    const auto image = four([&] {
      return instrument::ring_point(0.0, 1.5 * telescope.detector_radius, random.uniform(),
                                    random.uniform());
    });
    const auto open4 = open_at(telescope4, pack_fields<PlanePoint>(wide));
    const auto place4 = in_space(telescope4, lens4);
    const auto out4 =
        outward(telescope4, outward_slope(telescope4, lens4, pack_fields<PlanePoint>(image)));
    auto arriving = four([&] { return random.direction(); });
    for (std::size_t i = 0; i < lanes; ++i)
      if (random.chance(0.9)) arriving[i] = {-out4.x[i], -out4.y[i], -out4.z[i]};
    const auto seen4 = sight(telescope4, lens4, pack(arriving));
    const auto area4 = translation_area(telescope4, pack(arriving));
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto lens = lens_point(telescope, u[i], v[i]);
      expect_same_fields(lens4, i, lens);
      expect_same(open4[i], open_at(telescope, wide[i]), "open");
      expect_same(place4, i, in_space(telescope, lens), "place");
      expect_same(out4, i, outward(telescope, outward_slope(telescope, lens, image[i])), "outward");
      const auto one = sight(telescope, lens, arriving[i]);
      expect_same_fields(seen4, i, one);
      expect_same(area4[i], translation_area(telescope, arriving[i]), "area");
      open += open_at(telescope, wide[i]);
      seen += one.on_detector;
      upright += area4[i] > 0;
    }
  }
  EXPECT_GT(open, groups);
  EXPECT_GT(seen, groups);
  EXPECT_GT(upright, groups);
}

/// Along the whole of a way from a photon.
template <class T>
geometry::OpticalDepths<T> depths_along(const Sea& sea, const geometry::Sightline<T>& way,
                                        const Photon<T>& from) {
  const auto view = sea.view();
  return geometry::optical_depths(
      view,
      geometry::along(view, way, from.line, geometry::level_of(view, from), way.length_water));
}

TEST(LanesOf, WayThroughSurface) {
  Random random(62);
  const auto sea = make_sea(40);
  for (int g = 0; g < groups; ++g) {
    const auto photon = four([&] { return random_photon(sea, random); });
    const auto to = four([&] {
      return V{random.between(-20, 20), random.between(-20, 20), random.scale(0.1, 1000)};
    });
    const auto wanted = four([&] { return random.chance(0.7); });
    const auto packed = pack(photon);
    const auto way4 =
        geometry::sightline(sea.view(), packed.position, packed.line, pack(to),
                            {true, Index<Lanes4>(0)}, geometry::Route::direct, pack(wanted));
    const auto tau4 = depths_along(sea, way4, packed);
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto& one = photon[i];
      const auto way = geometry::sightline(sea.view(), one.position, one.line, to[i], {true, 0},
                                           geometry::Route::direct, wanted[i]);
      expect_same_fields(way4, i, way);
      if (one.position.z < 0) expect_same_fields(tau4, i, depths_along(sea, way, one));
    }
  }
}

TEST(LanesOf, WayInWater) {
  Random random(63);
  const auto sea = make_sea(40);
  for (int g = 0; g < groups; ++g) {
    const bool mirrored = g % 2 == 0;
    const auto photon = four([&] { return random_photon(sea, random); });
    const auto end = four([&] { return random_photon(sea, random); });
    const auto packed = pack(photon);
    const auto packed_end = pack(end);
    auto to = end;
    if (random.chance(0.1)) to[1].position = photon[1].position;
    const auto route = route_of(mirrored);
    const auto way4 = geometry::sightline(sea.view(), packed.position, packed.line,
                                          pack(to).position, {false, packed_end.layer}, route, {});
    const auto tau4 = depths_along(sea, way4, packed);
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto& one = photon[i];
      const auto way = geometry::sightline(sea.view(), one.position, one.line, to[i].position,
                                           {false, end[i].layer}, route, {});
      expect_same_fields(way4, i, way);
      expect_same_fields(tau4, i, depths_along(sea, way, one));
    }
  }
}

TEST(LanesOf, ConnectRay) {
  Random random(64);
  const auto sea = make_sea(40);
  int seen = 0, unseen = 0;
  for (int g = 0; g < groups; ++g) {
    scene::Telescope scene = instrument::random_telescope(random);
    const bool submerged = random.chance(0.5);
    const bool mirrored = submerged && random.chance(0.5);
    if (submerged) {
      scene.position_m.z = -random.between(0.1, 20);
      scene.direction = random.direction();
    }
    const auto telescope = instrument::make_telescope<double>(scene);
    const auto telescope4 = instrument::make_telescope<Lanes4>(scene);
    const auto region = region_at(sea, scene.position_m);
    const auto u = uniforms4(random), v = uniforms4(random);
    auto photon = four([&] { return random_photon(sea, random); });
    for (auto& one : photon) {
      if (random.chance(0.3)) continue;
      // Along the axis: through the surface with its bend left out, mirrored in it.
      const double length = random.scale(0.01, 30) + (submerged ? 0 : scene.position_m.z);
      one.position = telescope.position + length * telescope.axis;
      one.position.z = -std::min(39.0, std::abs(one.position.z));
      one.layer = sea.layer_at(-one.position.z);
    }
    const auto packed = pack(photon);
    const auto ray4 =
        connect_ray(sea.view(), telescope4, {region.outside, Index4(region.layer)}, packed,
                    packed.line, lens_point(telescope4, pack(u), pack(v)), route_of(mirrored),
                    may_see(sea.view(), telescope4, packed.position, packed.line));
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto ray =
          connect_ray(sea.view(), telescope, region, photon[i], photon[i].line,
                      lens_point(telescope, u[i], v[i]), route_of(mirrored),
                      may_see(sea.view(), telescope, photon[i].position, photon[i].line));
      expect_same(ray4.direction, i, ray.direction, "direction");
      expect_same(ray4.acceptance[i], ray.acceptance, "acceptance");
      (ray.acceptance > 0 ? seen : unseen) += 1;
      if (!(ray.acceptance > 0)) continue;
      expect_same(ray4.optical_depth[i], ray.optical_depth, "optical depth");
      expect_same(ray4.path[i], ray.path, "path");
    }
  }
  EXPECT_GT(seen, groups / 4);
  EXPECT_GT(unseen, groups / 4);
}

}  // namespace
}  // namespace photic::transport
