// Walks that are put together with four lanes: each lane equals the scalar, bit for bit.
#include "estimator/averaged_phases.hpp"
#include "unit/instrument/telescopes.hpp"
#include "unit/transport/fields.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using instrument::PlanePoint;
using test::Random;
using V = Vec3<double>;

estimator::Samples<double> random_samples(Random& random) {
  return {1, random.uniform(), 5, random.below(3) * 1.0, {random.scale(0.1, 10)}};
}
estimator::InverseConversion<double> random_reversal(Random& random) {
  return {random.uniform(), random.uniform(), random.direction(), random.below(5),
          random.chance(0.5) ? random.between(0, 0.5) : 0.0};
}
estimator::Densities<double> random_densities(Random& random) {
  return {random.scale(1e-3, 1e3), random.scale(1e-3, 1e3), random.scale(1e-3, 1e3)};
}
estimator::RotationAxis<double> random_axis(Random& random) {
  return {random.chance(0.7), random.between(-5, 5), random.between(-5, 5)};
}
estimator::Freedom<double> random_freedom(Random& random) {
  return {random.uniform(), random_axis(random)};
}
estimator::RotatedMeeting<double> random_rotated(Random& random) {
  const auto place = 5 * random.direction();
  return {random.uniform(),
          estimator::rotation_jacobian(place, random.direction(), random.direction())};
}

estimator::Ray<double> random_ray(const Sea& sea, Random& random) {
  estimator::Ray<double> ray{estimator::walk_point(random_photon(sea, random))};
  ray.vertex_chance = random.uniform();
  ray.chance = random.uniform();
  ray.reverse_chance = random.between(0.5, 5);
  ray.per_p = random.scale(1e-3, 1e3);
  ray.last_edge = random.scale(1e-3, 1e3);
  ray.behind = random_densities(random);
  ray.translated = random.between(-1, 1);
  ray.rotated = random_rotated(random);
  return ray;
}

estimator::Vertex<double> random_vertex(const Sea& sea, Random& random) {
  const auto photon = random_photon(sea, random);
  return {
      {photon.position, photon.direction, random.uniform(), photon.path, photon.line, photon.layer},
      random.uniform(),
      random.between(0.5, 5),
      random.chance(0.2) ? 0 : random.uniform(),
      random.between(-1, 1),
      random.uniform(),
      random_rotated(random),
      random_densities(random),
      random_densities(random)};
}

Mask<Lanes4> pack_mask(const Four<bool>& bits) {
  Mask<Lanes4> mask;
  for (std::size_t i = 0; i < lanes; ++i) mask.set(i, bits[i]);
  return mask;
}

TEST(LanesOf, MeetingGrid) {
  Random random(65);
  for (int g = 0; g < groups; ++g) {
    const auto grid = random_samples(random).grid;
    const auto grid4 = in_all_lanes(grid);
    const auto depth = four([&] { return random.between(0, 40); });
    const auto order = four([&] { return random.below(5); });
    const auto number4 = grid4.number(pack(depth), pack(order));
    const auto back4 = grid4.depth(number4, pack(order));
    const auto density4 = grid4.density(pack(order));
    for (std::size_t i = 0; i < lanes; ++i) {
      expect_same(number4[i], grid.number(depth[i], order[i]), "number");
      expect_same(back4[i], grid.depth(grid.number(depth[i], order[i]), order[i]), "depth");
      expect_same(density4[i], grid.density(order[i]), "density");
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
    const auto axis = four([&] { return random_axis(random); });
    auto photon = four([&] { return random_photon(sea, random); });
    Four<estimator::Leg<double>> leg;
    for (auto& one : leg) one.reflected = random.chance(0.3);
    const bool through_surface = random.chance(0.5);
    const auto spread = four([&] {
      return estimator::Spread<double>{through_surface, random.uniform(), random.uniform(),
                                       random.uniform()};
    });
    auto spread4 = pack_fields<estimator::Spread>(spread);
    spread4.through_surface = through_surface;
    const auto first = four([&] { return random.chance(0.5); });
    auto leg4 = pack_fields<estimator::Leg>(leg);
    const auto moved = uniforms4(random);
    estimator::add_flight(sea.view(), pack(before), pack(photon), pack(moved), leg4);
    const auto rest = uniforms4(random);
    Four<estimator::Arrival<double>> arrival;
    for (std::size_t i = 0; i < lanes; ++i) {
      estimator::add_flight(sea.view(), before[i], photon[i], moved[i], leg[i]);
      expect_same_fields(leg4, i, leg[i]);
      arrival[i] = {ray[i], leg[i], first[i], !first[i] && random.chance(0.5), rest[i]};
    }
    const auto vertex4 = estimator::vertex_on(
        sea.view(), pack_fields<estimator::Arrival>(arrival), spread4, pack(photon),
        pack_fields<estimator::RotationAxis>(axis), in_all_lanes(samples));
    for (std::size_t i = 0; i < lanes; ++i)
      expect_same_fields(
          vertex4, i,
          estimator::vertex_on(sea.view(), arrival[i], spread[i], photon[i], axis[i], samples));
  }
}

TEST(LanesOf, DepartAndNextRay) {
  Random random(67);
  const auto sea = make_sea(40);
  int converted = 0, directed = 0;
  for (int g = 0; g < groups; ++g) {
    const auto inverse_conversion = random_reversal(random);
    const auto vertex = four([&] { return random_vertex(sea, random); });
    auto photon = four([&] { return random_photon(sea, random); });
    auto photon4 = pack(photon);
    const auto a = uniforms4(random), b = uniforms4(random), c = uniforms4(random),
               d = uniforms4(random);
    const bool from_telescope = random.chance(0.5);
    const auto departure4 = estimator::depart(sea.view(), photon4, in_all_lanes(inverse_conversion),
                                              {pack(a), pack(b), pack(c), pack(d)}, from_telescope);
    const auto far = four([&] { return random.chance(0.5); });
    const auto ray4 = estimator::next_ray(
        sea.view(), photon4, pack_fields<estimator::Vertex>(vertex), departure4, pack_mask(far));
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto line = photon[i].line;
      const auto departure = estimator::depart(sea.view(), photon[i], inverse_conversion,
                                               {a[i], b[i], c[i], d[i]}, from_telescope);
      expect_same(photon4, i, photon[i]);
      expect_same_fields(departure4, i, departure);
      expect_same_fields(ray4, i,
                         estimator::next_ray(sea.view(), photon[i], vertex[i], departure, far[i]));
      converted += photon[i].line != line;
      directed += photon[i].line != line && d[i] < inverse_conversion.directed;
    }
  }
  EXPECT_GT(converted, groups / 6);
  EXPECT_GT(directed, groups / 12);
}

TEST(LanesOf, Joints) {
  Random random(68);
  const auto sea = make_sea(40);
  const auto view = sea.view();
  for (int g = 0; g < groups; ++g) {
    const auto inverse_conversion = random_reversal(random);
    const auto reversal4 = in_all_lanes(inverse_conversion);
    const auto vertex = four([&] { return random_vertex(sea, random); });
    const auto vertex4 = pack_fields<estimator::Vertex>(vertex);
    const auto direction = four([&] { return random.direction(); });
    const auto line = four([&] { return random.below(3); });
    const auto before = four([&] { return random.below(6); });
    const auto chance = uniforms4(random), goes_on = uniforms4(random), area = uniforms4(random),
               behind = uniforms4(random), tau = uniforms4(random), walk_tau = uniforms4(random);
    const auto freedom = four([&] { return random_freedom(random); });
    const auto freedom4 = pack_fields<estimator::Freedom>(freedom);
    const auto scattered4 = estimator::scattering_from_laser(
        view, vertex4, pack(behind), pack(direction), reversal4, pack(goes_on), freedom4);
    const auto converted4 = estimator::conversion_from_laser(
        view, vertex4, pack(behind), pack(direction), pack(line), reversal4, pack(before),
        pack(chance), pack(goes_on), freedom4);
    const auto arrived4 = estimator::arrival_from_laser(
        view, vertex4, pack(behind), pack(direction), reversal4, pack(before), freedom4);
    const auto last4 = estimator::scattering_of_converted(view, vertex4, pack(direction));
    const auto balance4 =
        estimator::balance(scattered4.contribution, pack(area), pack(tau), pack(walk_tau),
                           scattered4.densities, arrived4.densities);
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto& v = vertex[i];
      const auto scattered = estimator::scattering_from_laser(
          view, v, behind[i], direction[i], inverse_conversion, goes_on[i], freedom[i]);
      const auto arrived = estimator::arrival_from_laser(view, v, behind[i], direction[i],
                                                         inverse_conversion, before[i], freedom[i]);
      expect_same_fields(scattered4, i, scattered);
      expect_same_fields(converted4, i,
                         estimator::conversion_from_laser(view, v, behind[i], direction[i], line[i],
                                                          inverse_conversion, before[i], chance[i],
                                                          goes_on[i], freedom[i]));
      expect_same_fields(arrived4, i, arrived);
      expect_same_fields(last4, i, estimator::scattering_of_converted(view, v, direction[i]));
      expect_same(balance4[i],
                  estimator::balance(scattered.contribution, area[i], tau[i], walk_tau[i],
                                     scattered.densities, arrived.densities),
                  "balance");
    }
  }
}

TEST(LanesOf, Chord) {
  Random random(69);
  const auto sea = make_sea(40);
  int exists = 0;
  for (int g = 0; g < groups; ++g) {
    scene::Telescope scene;
    const auto telescope = instrument::random_telescope(random, scene);
    auto laser = four([&] { return random_ray(sea, random); });
    auto back = four([&] { return random_ray(sea, random); });
    for (std::size_t i = 0; i < lanes; ++i) {  // mostly they come close
      laser[i].line = 0;
      if (random.chance(0.8)) back[i].direction.z = laser[i].direction.z;
      if (random.chance(0.8)) back[i].position = laser[i].position;
      back[i].layer = sea.layer_at(-back[i].position.z);
      laser[i].layer = sea.layer_at(-laser[i].position.z);
    }
    const auto start = four([&] {
      const auto slope = instrument::ring_point(0.0, 0.5, random.uniform(), random.uniform());
      return estimator::AtLens<double>{lens_point(telescope, random.uniform(), random.uniform()),
                                       outward(telescope, slope), random.between(1, 1.4)};
    });
    const auto laser4 = pack_fields<estimator::Ray>(laser);
    const auto back4 = pack_fields<estimator::Ray>(back);
    const auto chord4 = estimator::chord(estimator::depth_line(sea.view(), laser4, Lanes4(40)),
                                         estimator::depth_line(sea.view(), back4, Lanes4(40)),
                                         instrument::make_telescope<Lanes4>(scene),
                                         pack_fields<estimator::AtLens>(start), Lanes4(250));
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto c = estimator::chord(estimator::depth_line(sea.view(), laser[i], 40.0),
                                      estimator::depth_line(sea.view(), back[i], 40.0), telescope,
                                      start[i], 250.0);
      expect_same_fields(chord4, i, c);
      exists += c.exists;
    }
  }
  EXPECT_GT(exists, groups / 4);
}

// Of telescopes in the air and in the water, upright and tilted, and means over their cones.
TEST(LanesOf, EntryRays) {
  Random random(71);
  const auto sea = make_sea(40);
  for (int g = 0; g < groups / 10; ++g) {
    scene::Telescope scene;
    instrument::random_telescope(random, scene);
    if (random.chance(0.3)) scene.position_m.z = -1;
    const auto cone = random.chance(0.5) ? estimator::entry_cone(scene, sea, 40)
                                         : estimator::cone_of_own_rays(scene, sea);
    const auto cone4 = estimator::cone_cast<Lanes4>(cone);
    const auto u = uniforms4(random), v = uniforms4(random), tau = uniforms4(random);
    const double n = sea.line[1].refractive_index, n_axis = sea.line[0].refractive_index;
    const auto ray4 = draw_entry(cone4, Lanes4(n), Lanes4(n_axis), pack(u), pack(v));
    const auto bed = four([&] { return random.chance(0.3); });
    const auto first = four([&] { return random.chance(0.5); });
    const auto reach4 = cone4.reach(pack_mask(first), pack(tau), ray4.direction.z, pack_mask(bed));
    const auto over4 = cone4.over_reach(pack(tau), ray4.direction.z, pack_mask(bed));
    const auto longer4 = cone4.longer_free_path(ray4.direction.z);
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto ray = draw_entry(cone, n, n_axis, u[i], v[i]);
      expect_same_fields(ray4, i, ray);
      expect_same(reach4[i], cone.reach(first[i], tau[i], ray.direction.z, bed[i]), "reach");
      expect_same(over4[i], cone.over_reach(tau[i], ray.direction.z, bed[i]), "over reach");
      expect_same(longer4[i], cone.longer_free_path(ray.direction.z), "longer");
    }
  }
  const estimator::AveragedPhaseTables tables(
      sea, {estimator::entry_cone(instrument::table_1(), sea, 40)}, {});
  const auto averaged = tables.view();
  for (int g = 0; g < groups; ++g) {
    const auto x = four([&] { return random.scale(1e-12, 2); });
    const auto phase = four([&] { return random.below(sea.phase_count()); });
    const auto value4 = averaged.value(0, pack(x), pack(phase));
    for (std::size_t i = 0; i < lanes; ++i)
      expect_same(value4[i], averaged.value(0, x[i], phase[i]), "mean over a cone");
  }
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
    const auto axis = four([&] { return random_axis(random); });
    const auto depth = four([&] { return random.between(0, 39); });
    const auto laser4 = pack_fields<estimator::Ray>(laser),
               back4 = pack_fields<estimator::Ray>(back);
    const auto axis4 = pack_fields<estimator::RotationAxis>(axis);
    const auto line4 = estimator::depth_line(sea.view(), laser4, Lanes4(40));
    const auto depths4 = estimator::equidistant_depths(
        line4, estimator::depth_line(sea.view(), back4, Lanes4(40)), axis4, Lanes4(250));
    const auto rotation4 = estimator::rotation_to_meet(laser4, back4, axis4, pack(depth));
    const auto place4 = rotation4.of_place(back4.position);
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto line = estimator::depth_line(sea.view(), laser[i], 40.0);
      expect_same_fields(line4, i, line);
      const auto c = estimator::equidistant_depths(
          line, estimator::depth_line(sea.view(), back[i], 40.0), axis[i], 250.0);
      for (std::size_t n = 0; n < 2; ++n) {
        expect_same(depths4.exists[n][i], c.exists[n], "crosses");
        if (!c.exists[n]) continue;
        expect_same(depths4.depth[n][i], c.depth[n], "depth");
        ++crossed;
      }
      const auto rotation = estimator::rotation_to_meet(laser[i], back[i], axis[i], depth[i]);
      expect_same_fields(rotation4, i, rotation);
      expect_same(place4, i, rotation.of_place(back[i].position), "place");
    }
  }
  EXPECT_GT(crossed, groups / 4);
}

}  // namespace
}  // namespace photic::transport
