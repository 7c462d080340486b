// Time of the parts of a collision, alone, and of Mie theory: build/dev/benchmarks/kernels
#include <benchmark/benchmark.h>

#include "core/random.hpp"
#include "estimator/make_world.hpp"
#include "estimator/model.hpp"
#include "optics/mie.hpp"
#include "scene/read.hpp"
#include "support/tables.hpp"
#include "transport/connect.hpp"
#include "transport/flight.hpp"
#include "transport/scatter.hpp"

namespace photic {
namespace {

/// The benchmark scene and a photon 10 m deep, a little aside, going down.
struct Setting {
  estimator::Model model = estimator::make_model(
      scene::read_scene_text(scene::starter_scene("ship"), "ship", ".").scene, *test::tables());
  estimator::World<double> world = estimator::make_world<double>(model);
  transport::Photon<double> photon;
  RandomPlace<double> place{1, 0, 0};

  Setting() {
    photon.position = {0.05, 0.02, -10.0};
    photon.direction = normalised(Vec3<double>{0.01, 0.02, -1.0});
  }
  std::array<double, 4> draw() {
    ++place.photon;
    return uniforms(place, 0);
  }
};

void philox(benchmark::State& state) {
  Setting s;
  for (auto _ : state) benchmark::DoNotOptimize(s.draw());
}
BENCHMARK(philox);

void phase_sample(benchmark::State& state) {
  Setting s;
  for (auto _ : state) benchmark::DoNotOptimize(s.world.slabs.phases.sample<double>(s.draw()[0]));
}
BENCHMARK(phase_sample);

void phase_value(benchmark::State& state) {
  Setting s;
  for (auto _ : state)
    benchmark::DoNotOptimize(s.world.slabs.phases.value<double>(2 * s.draw()[0]));
}
BENCHMARK(phase_value);

void free_flight(benchmark::State& state) {
  Setting s;
  for (auto _ : state) {
    auto photon = s.photon;
    benchmark::DoNotOptimize(transport::fly(s.world.slabs, photon, minus_log(s.draw()[0])));
    benchmark::DoNotOptimize(photon);
  }
}
BENCHMARK(free_flight);

void turn(benchmark::State& state) {
  Setting s;
  for (auto _ : state) {
    const auto u = s.draw();
    benchmark::DoNotOptimize(
        turned(s.photon.direction, 2 * u[0], u[1], std::sqrt(1 - u[1] * u[1])));
  }
}
BENCHMARK(turn);

/// Argument: how far aside of the axis, in units of 0.1 m.
void connection(benchmark::State& state) {
  Setting s;
  s.photon.position.x = 0.1 * static_cast<double>(state.range(0));
  for (auto _ : state) {
    const bool may_be_seen =
        transport::may_see(s.world.slabs, s.world.instruments.telescopes[0], s.photon.position, 0);
    benchmark::DoNotOptimize(transport::connect_through_surface(
        s.world.slabs, s.world.instruments.telescopes[0], s.photon, 0, may_be_seen));
  }
}
BENCHMARK(connection)->Arg(0)->Arg(2)->Arg(50);

/// 1000 spheres of size parameters from 0.1 to 1e4, as many in each decade, at 180 angles each.
void mie(benchmark::State& state) {
  constexpr int sizes = 1000, angles = 180;
  std::vector<double> cosines;
  for (int i = 0; i < angles; ++i) cosines.push_back(std::cos(pi * i / (angles - 1)));
  std::vector<optics::MieAmplitudes> amplitudes(angles);
  for (auto _ : state) {
    for (int i = 0; i < sizes; ++i) {
      const optics::MieSphere sphere(0.1 * std::pow(1e5, i / (sizes - 1.0)), {1.33, -1e-3});
      sphere.amplitudes(cosines, amplitudes);
      benchmark::DoNotOptimize(sphere.efficiencies());
      benchmark::DoNotOptimize(amplitudes.data());
    }
  }
}
BENCHMARK(mie)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace photic
