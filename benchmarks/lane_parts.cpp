// Time of the parts of an event for a pack of lanes, eight packs in turn, as a pool has them:
// build/dev/benchmarks/lane_parts_avx512 (or _avx2). The clock of the processor turns it into
// cycles.
#include <benchmark/benchmark.h>

#include <array>

#include "core/pack.hpp"
#include "estimator/forward/history.hpp"
#include "estimator/make_world.hpp"
#include "estimator/model.hpp"
#include "scene/read.hpp"
#include "support/tables.hpp"

namespace photic::estimator {
namespace {

using Lanes = Pack<float, native::float_lanes>;
constexpr std::size_t packs = 8;

/// The starter scene, and photons that go down in its water.
struct Setting {
  Model model = [] {
    auto scene = scene::read_scene_text(scene::starter_scene("ship"), "ship", ".").scene;
    scene.simulation.estimator = scene::Estimator::forward;
    return make_model(scene, *test::tables());
  }();
  World<Lanes> world = make_world<Lanes>(model);
  const geometry::Slabs& sea = world.slabs;
  Draws<Lanes> draws = draws_of_laser<Lanes>(world.random, 0);
  std::array<Index<Lanes>, packs> n;
  std::array<std::array<Lanes, 4>, packs> u;
  std::array<transport::Photon<Lanes>, packs> photon;
  Index<Lanes> zero{0};

  Setting() {
    for (std::size_t k = 0; k < packs; ++k) {
      n[k] = Index<Lanes>(lanes_of<Lanes> * k) + lane_numbers<Lanes>();
      u[k] = uniforms<Lanes>(world.random.key, draws.photon(n[k]), Index<Lanes>(1), 0);
      photon[k].position = {Lanes(0.1), Lanes(0.1), Lanes(-5) + u[k][0]};
      photon[k].direction = turned(Vec3<Lanes>{Lanes(0), Lanes(0), Lanes(-1)}, Lanes(0.3) * u[k][0],
                                   Lanes(0.6), Lanes(0.8));
    }
  }
};

/// Time of part(setting, k), whose result is kept, for each pack k.
template <class Part>
void parts(benchmark::State& state, Part part) {
  Setting s;
  std::array<decltype(part(s, 0)), packs> results;
  for (auto _ : state) {
    for (std::size_t k = 0; k < packs; ++k) results[k] = part(s, k);
    benchmark::DoNotOptimize(results.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(packs) * state.iterations());
}

void register_parts() {
  const auto add = [](const char* name, auto part) {
    benchmark::RegisterBenchmark(name, [part](benchmark::State& state) { parts(state, part); });
  };
  add("philox", [](Setting& s, std::size_t k) {
    return uniforms<Lanes>(s.world.random.key, s.draws.photon(s.n[k]), Index<Lanes>(1), 0);
  });
  add("spread_points", [](Setting& s, std::size_t k) {
    return s.draws.together(static_cast<std::int32_t>(lanes_of<Lanes> * k), 1, 0);
  });
  add("minus_log", [](Setting& s, std::size_t k) { return minus_log(s.u[k][0]); });
  add("exp_minus", [](Setting& s, std::size_t k) { return exp_minus(s.u[k][0]); });
  add("cos_sin", [](Setting& s, std::size_t k) { return cos_sin_of_turns(s.u[k][2]); });
  add("phase_sample",
      [](Setting& s, std::size_t k) { return s.sea.phases.sample<Lanes>(s.u[k][1], s.zero); });
  add("phase_value",
      [](Setting& s, std::size_t k) { return s.sea.phases.value<Lanes>(s.u[k][1], s.zero); });
  add("turned", [](Setting& s, std::size_t k) {
    return turned(s.photon[k].direction, s.u[k][1], Lanes(0.6), Lanes(0.8));
  });
  add("flight", [](Setting& s, std::size_t k) {
    auto photon = s.photon[k];
    transport::fly(s.sea, photon, minus_log(s.u[k][0]));
    return photon;
  });
  add("local_estimate", [](Setting& s, std::size_t k) {
    return transport::connect_ray(s.sea, s.world.instruments.telescopes[0],
                                  s.world.instruments.telescope_region[0], s.photon[k], s.zero,
                                  {Lanes(0.05), Lanes(0.02)}, geometry::Route::direct,
                                  Mask<Lanes>(true));
  });
}

}  // namespace
}  // namespace photic::estimator

int main(int argc, char** argv) {
  photic::estimator::register_parts();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
