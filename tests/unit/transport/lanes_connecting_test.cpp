// The parts of the bidirectional estimator with four lanes: each lane equals the scalar, bit for
// bit.
#include "unit/instrument/telescopes.hpp"
#include "unit/transport/fields.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using instrument::PlanePoint;
using test::Random;
using V = Vec3<double>;

/// Four of what `make` makes.
template <class F>
auto four(F make) {
  return Four<decltype(make())>{make(), make(), make(), make()};
}

instrument::Telescope<double> random_telescope(Random& random, scene::Telescope& scene) {
  scene = instrument::random_telescope(random);
  if (random.chance(0.5)) scene.direction = {0, 0, -1};
  return instrument::make_telescope<double>(scene);
}

TEST(LanesOf, LensPoints) {
  Random random(61);
  int open = 0, seen = 0, upright = 0;
  for (int g = 0; g < groups; ++g) {
    scene::Telescope scene;
    const auto telescope = random_telescope(random, scene);
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
    const auto out4 = outward(telescope4, lens4, pack_fields<PlanePoint>(image));
    auto arriving = four([&] { return random.direction(); });
    for (std::size_t i = 0; i < lanes; ++i)
      if (random.chance(0.7)) arriving[i] = {-out4.x[i], -out4.y[i], -out4.z[i]};
    const auto seen4 = sight(telescope4, lens4, pack(arriving));
    const auto angle4 = detector_solid_angle(telescope4, seen4.cos_off_axis);
    const auto area4 = shift_area(telescope4, seen4.cos_off_axis);
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto lens = lens_point(telescope, u[i], v[i]);
      expect_same_fields(lens4, i, lens);
      expect_same(open4[i], open_at(telescope, wide[i]), "open");
      expect_same(place4, i, in_space(telescope, lens), "place");
      expect_same(out4, i, outward(telescope, lens, image[i]), "outward");
      const auto one = sight(telescope, lens, arriving[i]);
      expect_same_fields(seen4, i, one);
      expect_same(angle4[i], detector_solid_angle(telescope, one.cos_off_axis), "solid angle");
      expect_same(area4[i], shift_area(telescope, one.cos_off_axis), "area");
      open += open_at(telescope, wide[i]);
      seen += one.on_detector;
      upright += area4[i] > 0;
    }
  }
  EXPECT_GT(open, groups);
  EXPECT_GT(seen, groups);
  EXPECT_GT(upright, groups);
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
        way_through_surface(sea.view(), packed.position, packed.line, pack(to), pack(wanted));
    const Lanes4 depth4 = Lanes4(0) - packed.position.z;
    const auto tau4 = depths_through_surface(sea.view(), way4, packed.line, packed.layer, depth4);
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto& one = photon[i];
      const auto way = way_through_surface(sea.view(), one.position, one.line, to[i], wanted[i]);
      expect_same_fields(way4, i, way);
      if (one.position.z < 0)
        expect_same_fields(
            tau4, i,
            depths_through_surface(sea.view(), way, one.line, one.layer, 0 - one.position.z));
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
    const auto way4 =
        way_in_water(sea.view(), packed.position, packed.line, pack(to).position, mirrored);
    const auto tau4 =
        depths_in_water(sea.view(), way4, packed.line, packed.layer, Lanes4(0) - packed.position.z,
                        packed_end.layer, way4.length_water, mirrored);
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto& one = photon[i];
      const auto way = way_in_water(sea.view(), one.position, one.line, to[i].position, mirrored);
      expect_same_fields(way4, i, way);
      expect_same_fields(tau4, i,
                         depths_in_water(sea.view(), way, one.line, one.layer, 0 - one.position.z,
                                         end[i].layer, way.length_water, mirrored));
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
    const std::int32_t layer = sea.layer_at(std::max(0.0, -scene.position_m.z));
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
    const auto ray4 = connect_ray(sea.view(), telescope4, Index4(layer), packed, packed.line,
                                  lens_point(telescope4, pack(u), pack(v)), mirrored, true);
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto ray = connect_ray(sea.view(), telescope, layer, photon[i], photon[i].line,
                                   lens_point(telescope, u[i], v[i]), mirrored, true);
      expect_same(ray4.direction, i, ray.direction, "direction");
      expect_same(ray4.in_front[i], ray.in_front, "in front");
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

Samples<double> random_samples(Random& random) {
  return {1,
          random.uniform(),
          5,
          random.below(3) * 1.0,
          {random.between(0, 5), 30, random.scale(1, 100)}};
}
Reversal<double> random_reversal(Random& random) {
  return {random.uniform(), random.uniform(), random.direction(), random.below(5)};
}
Densities<double> random_densities(Random& random) {
  return {random.scale(1e-3, 1e3), random.scale(1e-3, 1e3), random.scale(1e-3, 1e3)};
}
Vertical<double> random_vertical(Random& random) {
  return {random.chance(0.7), random.between(-5, 5), random.between(-5, 5)};
}
Freedom<double> random_freedom(Random& random) {
  return {random.uniform(), random_vertical(random)};
}
Turn<double> random_turn(Random& random) {
  const auto place = 5 * random.direction();
  return {random.uniform(), sweep(place, random.direction(), random.direction())};
}

Ray<double> random_ray(const medium::Medium& sea, Random& random) {
  Ray<double> ray{walk_point(random_photon(sea, random))};
  ray.left_chance = random.uniform();
  ray.chance = random.uniform();
  ray.per_p = random.scale(1e-3, 1e3);
  ray.last = random_densities(random);
  ray.behind = random_densities(random);
  ray.meeting = random.between(-1, 1);
  ray.turn = random_turn(random);
  return ray;
}

Vertex<double> random_vertex(const medium::Medium& sea, Random& random) {
  const auto photon = random_photon(sea, random);
  return {photon.position,
          photon.direction,
          random.uniform(),
          photon.path,
          photon.line,
          photon.layer,
          random.uniform(),
          random.chance(0.2) ? 0 : random.uniform(),
          random.between(-1, 1),
          random.uniform(),
          random_turn(random),
          random_densities(random),
          random_densities(random)};
}

TEST(LanesOf, MeetingGrid) {
  Random random(65);
  for (int g = 0; g < groups; ++g) {
    const auto grid = random_samples(random).grid;
    const auto grid4 = in_all_lanes(grid);
    const auto depth = four([&] { return random.between(0, 40); });
    const auto number4 = grid4.number(pack(depth));
    const auto back4 = grid4.depth(number4);
    const auto density4 = grid4.density(pack(depth));
    for (std::size_t i = 0; i < lanes; ++i) {
      expect_same(number4[i], grid.number(depth[i]), "number");
      expect_same(back4[i], grid.depth(grid.number(depth[i])), "depth");
      expect_same(density4[i], grid.density(depth[i]), "density");
    }
  }
}

TEST(LanesOf, VertexOn) {
  Random random(66);
  const auto sea = make_sea(40);
  for (int g = 0; g < groups; ++g) {
    const auto samples = random_samples(random);
    const auto ray = four([&] { return random_ray(sea, random); });
    const auto before = four([&] { return random_photon(sea, random); });
    const auto axis = four([&] { return random_vertical(random); });
    auto photon = four([&] { return random_photon(sea, random); });
    Four<Leg<double>> leg;
    for (auto& one : leg) one.mirrored = random.chance(0.3);
    const bool through_surface = random.chance(0.5);
    const auto spread = four([&] {
      return Spread<double>{through_surface, random.uniform(), random.uniform(), random.uniform()};
    });
    auto spread4 = pack_fields<Spread>(spread);
    spread4.through_surface = through_surface;
    const bool first = random.chance(0.5);
    auto leg4 = pack_fields<Leg>(leg);
    add_flight(sea.view(), pack(before), pack(photon), leg4);
    const auto vertex4 =
        vertex_on(sea.view(), pack_fields<Ray>(ray), first ? &spread4 : nullptr, pack(photon), leg4,
                  pack_fields<Vertical>(axis), in_all_lanes(samples));
    for (std::size_t i = 0; i < lanes; ++i) {
      add_flight(sea.view(), before[i], photon[i], leg[i]);
      expect_same_fields(leg4, i, leg[i]);
      expect_same_fields(vertex4, i,
                         vertex_on(sea.view(), ray[i], first ? &spread[i] : nullptr, photon[i],
                                   leg[i], axis[i], samples));
    }
  }
}

TEST(LanesOf, DepartAndNextRay) {
  Random random(67);
  const auto sea = make_sea(40);
  int converted = 0, directed = 0;
  for (int g = 0; g < groups; ++g) {
    const auto reversal = random_reversal(random);
    const auto vertex = four([&] { return random_vertex(sea, random); });
    auto photon = four([&] { return random_photon(sea, random); });
    auto photon4 = pack(photon);
    const auto a = uniforms4(random), b = uniforms4(random), c = uniforms4(random),
               d = uniforms4(random);
    const auto departure4 =
        depart(sea.view(), photon4, in_all_lanes(reversal), {pack(a), pack(b), pack(c), pack(d)});
    const auto ray4 = next_ray(photon4, pack_fields<Vertex>(vertex), departure4);
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto line = photon[i].line;
      const auto departure = depart(sea.view(), photon[i], reversal, {a[i], b[i], c[i], d[i]});
      expect_same(photon4, i, photon[i]);
      expect_same_fields(departure4, i, departure);
      expect_same_fields(ray4, i, next_ray(photon[i], vertex[i], departure));
      converted += photon[i].line != line;
      directed += photon[i].line != line && d[i] < reversal.directed;
    }
  }
  EXPECT_GT(converted, groups / 4);
  EXPECT_GT(directed, groups / 8);
}

TEST(LanesOf, Joints) {
  Random random(68);
  const auto sea = make_sea(40);
  const auto view = sea.view();
  for (int g = 0; g < groups; ++g) {
    const auto reversal = random_reversal(random);
    const auto reversal4 = in_all_lanes(reversal);
    const auto vertex = four([&] { return random_vertex(sea, random); });
    const auto vertex4 = pack_fields<Vertex>(vertex);
    const auto direction = four([&] { return random.direction(); });
    const auto line = four([&] { return random.below(3); });
    const auto chance = uniforms4(random), goes_on = uniforms4(random), area = uniforms4(random),
               behind = uniforms4(random), tau = uniforms4(random), walk_tau = uniforms4(random);
    const auto freedom = four([&] { return random_freedom(random); });
    const auto freedom4 = pack_fields<Freedom>(freedom);
    const auto scattered4 = scattering_from_laser(view, vertex4, pack(behind), pack(direction),
                                                  pack(goes_on), freedom4);
    const auto converted4 =
        conversion_from_laser(view, vertex4, pack(behind), pack(direction), pack(line), reversal4,
                              pack(chance), pack(goes_on), freedom4);
    const auto arrived4 = arrival_from_laser(view, vertex4, pack(direction), reversal4, freedom4);
    const auto last4 = scattering_of_converted(view, vertex4, pack(direction));
    const auto balance4 =
        balance(pack(area), pack(tau), pack(walk_tau), scattered4.end, arrived4.end);
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto& v = vertex[i];
      const auto scattered =
          scattering_from_laser(view, v, behind[i], direction[i], goes_on[i], freedom[i]);
      const auto arrived = arrival_from_laser(view, v, direction[i], reversal, freedom[i]);
      expect_same_fields(scattered4, i, scattered);
      expect_same_fields(converted4, i,
                         conversion_from_laser(view, v, behind[i], direction[i], line[i], reversal,
                                               chance[i], goes_on[i], freedom[i]));
      expect_same_fields(arrived4, i, arrived);
      expect_same_fields(last4, i, scattering_of_converted(view, v, direction[i]));
      expect_same(balance4[i], balance(area[i], tau[i], walk_tau[i], scattered.end, arrived.end),
                  "balance");
    }
  }
}

TEST(LanesOf, ChordAndMeet) {
  Random random(69);
  const auto sea = make_sea(40);
  int exists = 0, met = 0;
  for (int g = 0; g < groups; ++g) {
    scene::Telescope scene;
    const auto telescope = random_telescope(random, scene);
    const auto samples = random_samples(random);
    const auto reversal = random_reversal(random);
    auto laser = four([&] { return random_ray(sea, random); });
    auto back = four([&] { return random_ray(sea, random); });
    Four<std::int32_t> layer{};
    Four<double> depth{};
    for (std::size_t i = 0; i < lanes; ++i) {  // mostly they come close
      laser[i].line = 0;
      if (random.chance(0.8)) back[i].direction.z = laser[i].direction.z;
      if (random.chance(0.8)) back[i].position = laser[i].position;
      back[i].layer = sea.layer_at(-back[i].position.z);
      laser[i].layer = sea.layer_at(-laser[i].position.z);
      depth[i] = random.between(0, 39);
      layer[i] = sea.layer_at(depth[i]);
    }
    const auto lens =
        four([&] { return lens_point(telescope, random.uniform(), random.uniform()); });
    const auto laser4 = pack_fields<Ray>(laser);
    const auto back4 = pack_fields<Ray>(back);
    const auto chord4 = chord(laser4, back4, instrument::make_telescope<Lanes4>(scene),
                              pack_fields<PlanePoint>(lens), Lanes4(40));
    const bool first = random.chance(0.5), last = random.chance(0.5);
    const auto spread = four([&] {
      return Spread<double>{true, random.uniform(), random.uniform(), 1};
    });
    auto spread4 = pack_fields<Spread>(spread);
    spread4.through_surface = true;
    const auto a = uniforms4(random), a_last = uniforms4(random), b = uniforms4(random),
               b_last = uniforms4(random);
    const auto freedom = four([&] { return random_freedom(random); });
    const auto meeting4 = meet<Lanes4>(
        sea.view(), {laser4, first ? &spread4 : nullptr, pack(a), pack(a_last)},
        {back4, last ? &spread4 : nullptr, pack(b), pack(b_last)}, pack(depth), pack(layer),
        pack_fields<Freedom>(freedom), in_all_lanes(reversal), in_all_lanes(samples));
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto c = chord(laser[i], back[i], telescope, lens[i], 40.0);
      expect_same_fields(chord4, i, c);
      exists += c.exists;
      const auto meeting =
          meet<double>(sea.view(), {laser[i], first ? &spread[i] : nullptr, a[i], a_last[i]},
                       {back[i], last ? &spread[i] : nullptr, b[i], b_last[i]}, depth[i], layer[i],
                       freedom[i], reversal, samples);
      // A meeting is promised ahead of both rays alone, none of them level.
      const auto ahead = [&](const Ray<double>& r) {
        return r.direction.z != 0 && (-depth[i] - r.position.z) / r.direction.z > 0;
      };
      if (!ahead(laser[i]) || !ahead(back[i])) continue;
      expect_same_fields(meeting4, i, meeting);
      ++met;
    }
  }
  EXPECT_GT(exists, groups / 4);
  EXPECT_GT(met, groups / 4);
}

TEST(LanesOf, CrossingsAndTurns) {
  Random random(70);
  const auto sea = make_sea(40);
  int crossed = 0;
  for (int g = 0; g < groups; ++g) {
    auto laser = four([&] { return random_ray(sea, random); });
    auto back = four([&] { return random_ray(sea, random); });
    for (std::size_t i = 0; i < lanes; ++i)
      if (random.chance(0.8)) back[i].direction.z = laser[i].direction.z;
    const auto axis = four([&] { return random_vertical(random); });
    const auto depth = four([&] { return random.between(0, 39); });
    const auto laser4 = pack_fields<Ray>(laser), back4 = pack_fields<Ray>(back);
    const auto axis4 = pack_fields<Vertical>(axis);
    const auto crossings4 = crossings(laser4, back4, axis4, Lanes4(40));
    const auto turn4 = turn_to_meet(laser4, back4, axis4, pack(depth));
    const auto place4 = turn4.of_place(back4.position);
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto c = crossings(laser[i], back[i], axis[i], 40.0);
      for (std::size_t n = 0; n < 2; ++n) {
        expect_same(crossings4.exists[n][i], c.exists[n], "crosses");
        if (!c.exists[n]) continue;
        expect_same(crossings4.depth[n][i], c.depth[n], "depth");
        ++crossed;
      }
      const auto turn = turn_to_meet(laser[i], back[i], axis[i], depth[i]);
      expect_same_fields(turn4, i, turn);
      expect_same(place4, i, turn.of_place(back[i].position), "place");
    }
  }
  EXPECT_GT(crossed, groups / 4);
}

}  // namespace
}  // namespace photic::transport
