// The lane engine against the scalar one.
#include "schedule/engines.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numeric>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "estimator/analog/analog.hpp"
#include "estimator/forward/history.hpp"
#include "estimator/make_world.hpp"
#include "run/batches.hpp"
#include "run/choose.hpp"
#include "run/run.hpp"
#include "support/scalar_engines.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"
#include "unit/schedule/event_log.hpp"

namespace photic::schedule {

// lanes_log.cpp, compiled for each.
namespace baseline {
EventLog log_lanes(const estimator::Model& model, std::uint64_t photons);
}
namespace avx2 {
EventLog log_lanes(const estimator::Model& model, std::uint64_t photons);
EventLog log_contracted_lanes(const estimator::Model& model, std::uint64_t photons);
}  // namespace avx2
namespace avx512 {
EventLog log_lanes(const estimator::Model& model, std::uint64_t photons);
EventLog log_contracted_lanes(const estimator::Model& model, std::uint64_t photons);
}  // namespace avx512

namespace {

/// Everything the estimators have: layers, a sea bed, conversions, telescopes above and below
/// the surface.
scene::Scene rich_scene(const std::string& more = "", const std::string& estimator = "forward") {
  return test::read(test::ship_instrument + test::submerged_telescope + test::channel("elastic") +
                    test::channel("raman") + test::channel("chlorophyll") + test::three_layers +
                    test::depth_gates(12, 1) +
                    test::simulation(estimator == "forward" ? 20000 : 2200, 5, more, estimator));
}
scene::Scene plain_scene(const std::string& more = "", const std::string& estimator = "forward") {
  return test::read(test::ship_instrument + test::channel("elastic") +
                    test::water(0.06, 0.10, test::peaked_phase) + test::depth_gates(50, 1) +
                    test::simulation(estimator == "forward" ? 20000 : 2200, 5, more, estimator));
}
/// Two views one inside the other over the water, and two in it. In so wide gates a single score,
/// which may fall on the other side of a rim where lanes contract, is a small part of an echo.
scene::Scene nested_scene(const std::string& more = "", double photons = 20000,
                          const std::string& settings = "",
                          const std::string& estimator = "forward") {
  const auto view = [](const std::string& lens, double half_field_of_view_mrad) {
    return "[[telescope]]\n" + lens +
           fmt::format("half_field_of_view_mrad = {}\n", half_field_of_view_mrad);
  };
  const std::string above =
      "position_m = [0.0, 0.0, 12.0]\ndirection = [0.0, 0.0, -1.0]\ndiameter_m = 0.40\n"
      "focal_length_m = 2.0\n";
  const std::string below =
      "position_m = [0.3, 0.0, -1.0]\ndirection = [0.0, 0.1, -1.0]\ndiameter_m = 0.10\n"
      "focal_length_m = 0.5\ndetector_shift_m = 0.01\nobstruction_diameter_m = 0.02\n";
  return test::read(test::ship_instrument + view(below, 80) + view(above, 40) + view(below, 20) +
                    view(above, 12) + test::channel("elastic") + test::channel("raman") +
                    test::three_layers + more + test::depth_gates(12, 4) +
                    test::simulation(photons, 5, settings, estimator));
}
const std::string other_water =
    "[[environment]]\nset = { \"sea.layer.0.chlorophyll_mg_m3\" = 0.5 }\n";
/// Over a bed whose albedo depends on the angle.
const std::string beds = "[[environment]]\nset = { \"bottom.albedo\" = 0.1 }\n";
scene::Scene bed_scene(const std::string& estimator = "forward", const std::string& more = "",
                       const std::string& environments = "") {
  return test::read(test::ship_instrument + test::submerged_telescope + test::channel("elastic") +
                    test::channel("raman") + test::three_layers +
                    "[bottom]\nalbedo = { zenith_deg = [0, 40, 90], albedo = [0.2, 0.5, 0.9] }\n" +
                    environments + test::depth_gates(12, 1) +
                    test::simulation(estimator == "forward" ? 20000 : 2200, 5, more, estimator));
}
/// Under a film whose light comes beside the walks, flat or on waves.
scene::Scene oil_scene(const std::string& more, const std::string& surface,
                       const std::string& submerged = "") {
  return test::read(test::ship_instrument + submerged + test::channel("raman") +
                    test::channel("oil") + fmt::format("[sea]\nsurface = {{ {} }}\n", surface) +
                    test::three_layers +
                    "[oil]\nclass = \"weakly-absorbing-crude\"\nthickness_um = 20.0\n" + more +
                    "[gates]\ndepth_min_m = -1.0\ndepth_max_m = 12.0\ndepth_step_m = 1.0\n" +
                    test::simulation(2200, 5, "", "bidirectional"));
}
/// In dense air, which much light passes into, and from there into the water again.
scene::Scene air_scene(const std::string& surface, const std::string& environments,
                       const std::string& estimator = "forward") {
  return test::read(
      test::ship_instrument +
      "[[atmosphere.layer]]\nbottom_height_m = 0\ntop_height_m = 20\niop = [ { wavelength_nm = "
      "400, a_per_m = 0.01, b_per_m = 0.08 }, { wavelength_nm = 700, a_per_m = 0.0, b_per_m = 0.04 "
      "} ]\n" +
      test::channel("elastic") + test::channel("raman") +
      fmt::format("[sea]\nsurface = {{ {} }}\n", surface) + test::three_layers + environments +
      "[gates]\ndepth_min_m = -8.0\ndepth_max_m = 12.0\ndepth_step_m = 2.0\n" +
      test::simulation(estimator == "forward" ? 20000 : 2200, 5,
                       estimator == "forward" ? "" : "walks = 3", estimator));
}
const std::string other_outside =
    "[[environment]]\nset = { \"atmosphere.layer.0.iop.0.b_per_m\" = 0.05 }\n";

const std::string flat = "model = \"flat\"";
const std::string waves = "model = \"cox-munk\", wind_speed_m_s = 5.0";
const std::string clean = "[[environment]]\nset = { \"oil.thickness_um\" = 0.0 }\n";
/// Sets of three walks do not divide a batch.
const std::string few_free_walks = "free_telescope_meetings = 0.4\nfree_laser_meetings = 0.6";
std::vector<scene::Scene> bidirectional_scenes() {
  const std::string name = "bidirectional";
  return {plain_scene("", name),
          plain_scene("walks = 3\nsampling = \"random\"", name),
          rich_scene("max_order = 5\n" + few_free_walks, name),
          nested_scene(other_water, 2200, few_free_walks, name),
          bed_scene(name, "walks = 3\nmax_order = 3\n" + few_free_walks, beds),
          oil_scene("", flat, test::submerged_telescope),
          oil_scene(clean, waves),
          air_scene(flat, other_outside, name),
          air_scene(waves, other_outside, name)};
}

/// All of the forward estimator's tools at once.
const std::string tools = R"([simulation.tools]
forced_collisions = 5
local_forced_collisions = "all"
weight_threshold = 0.3
at_threshold = "analog-absorption"
importance = [ { depth_m = 2.0, value = 2.5 }, { depth_m = 5.0, value = 6 }, { depth_m = 9.0, value = 0.5 } ]
)";

/// Those that go with several points of a flight.
const std::string tools_of_points = R"([simulation.tools]
forced_collisions = 3
importance = [ { depth_m = 2.0, value = 2.5 }, { depth_m = 5.0, value = 0.5 } ]
)";

EventLog log_scalar(const estimator::Model& model, std::uint64_t photons) {
  const auto world = estimator::make_world<float>(model);
  tally::BatchTally tally(model.shape, model.gates);
  EventLog log;
  estimator::Passed<float> none(world);
  const auto witness = [&log](const auto& t, const auto&...) {
    const auto& p = t.photon;
    LoggedEvent event;
    if (t.on) {
      event = {true,
               {p.position.x, p.position.y, p.position.z, p.direction.x, p.direction.y,
                p.direction.z, p.weight, p.analog_weight, p.path},
               {p.line, p.layer, p.order}};
    }
    log.emplace(std::pair(t.place.photon, t.place.event), event);
  };
  for (std::uint64_t batch = 0; batch < photons; batch += world.random.batch_photons) {
    if (model.scene.simulation.estimator == scene::Estimator::analog) {
      estimator::AnalogPassed<float> none_analog;
      estimator::Analog<float, tally::Ledger>(world, tally, none_analog)
          .run(batch, world.random.batch_photons, witness);
      continue;
    }
    estimator::follow_in(world, tally, none, witness, batch, world.random.batch_photons);
  }
  return log;
}

EventLog log_lanes(const estimator::Model& model, std::uint64_t photons, Isa isa) {
#if defined(PHOTIC_ISA_AVX512)
  if (isa == Isa::avx512) return avx512::log_lanes(model, photons);
#endif
#if defined(PHOTIC_ISA_AVX2)
  if (isa == Isa::avx2) return avx2::log_lanes(model, photons);
#endif
  return isa == Isa::baseline ? baseline::log_lanes(model, photons) : EventLog{};
}

EventLog log_contracted_lanes(const estimator::Model& model, std::uint64_t photons, Isa isa) {
#if defined(PHOTIC_ISA_AVX512)
  if (isa == Isa::avx512) return avx512::log_contracted_lanes(model, photons);
#endif
#if defined(PHOTIC_ISA_AVX2)
  if (isa == Isa::avx2) return avx2::log_contracted_lanes(model, photons);
#endif
  return isa == Isa::baseline ? baseline::log_lanes(model, photons) : EventLog{};
}

/// Whether lanes round a product and a sum once: where instructions do both.
bool contracts(Isa isa) { return isa != Isa::baseline; }

/// Whether two states of a photon are the same but for rounding, which a history of some ten
/// flights adds up to less than 1e-4 m and 1e-4 of what a weight is: a lane that goes wrong differs
/// by as much as photons do.
bool close(const LoggedEvent& a, const LoggedEvent& b) {
  const auto differs = [](float x, float y) {
    return std::abs(x - y) > 1e-4F * std::max(1.0F, std::abs(y));
  };
  return a.on == b.on && a.kind == b.kind &&
         std::equal(a.state.begin(), a.state.end(), b.state.begin(), std::not_fn(differs));
}

/// Photons whose histories are other ones: that took another branch, or differ by more.
std::size_t other_histories(const EventLog& lanes, const EventLog& scalar) {
  std::set<std::uint64_t> others;
  for (const auto& [from, to] : {std::pair(&lanes, &scalar), std::pair(&scalar, &lanes)}) {
    for (const auto& [place, event] : *from) {
      const auto same = to->find(place);
      if (same == to->end() || !close(event, same->second)) others.insert(place.first);
    }
  }
  return others.size();
}

// Without contraction lanes of every width round as scalars do: histories are not merely close,
// they are the same. As the engine's lanes round, fewer than one in a thousand may take another
// branch. Seen red: with the last photon of a pool not moved into a slot that is free; with lanes
// that were reflected going on as if they had collided with the others; with copies that keep the
// number of their photon.
TEST(Lanes, HistoriesAreThoseOfTheScalarEngineInFloat) {
  constexpr std::uint64_t photons = 16000;
  for (const auto& scene :
       {plain_scene(), plain_scene("directed_fraction = 0"), rich_scene(),
        rich_scene("reception = \"overlap\"\nmax_order = 4"), rich_scene(tools),
        plain_scene("[simulation.tools]\nweight_threshold = 0.5\nat_threshold = \"end\""),
        bed_scene(), bed_scene("analog", "max_order = 4")}) {
    const estimator::Model model = estimator::make_model(scene, *test::tables());
    const EventLog scalar = log_scalar(model, photons);
    const scene::Simulation& run = model.scene.simulation;
    const bool plain = run.estimator == scene::Estimator::forward && run.tools == scene::Tools{};
    // The last flight of each photon, but of analog ones, ends no event.
    const std::size_t last_flights = run.estimator == scene::Estimator::analog ? 0 : photons;
    EXPECT_GT(scalar.size() + last_flights, (plain ? 4 : 2) * photons);
    for (const Isa isa : isas_here()) {
      const EventLog lanes = log_lanes(model, photons, isa);
      ASSERT_EQ(lanes.size(), scalar.size()) << isa_name(isa);
      std::size_t different = 0;
      for (auto a = lanes.begin(), b = scalar.begin(); a != lanes.end(); ++a, ++b)
        different += *a != *b ? 1 : 0;
      EXPECT_EQ(different, 0U) << isa_name(isa) << ", of " << lanes.size();
      const std::size_t others = other_histories(log_contracted_lanes(model, photons, isa), scalar);
      std::printf("%s: %zu of %zu histories are other ones\n", std::string(isa_name(isa)).c_str(),
                  others, static_cast<std::size_t>(photons));
      EXPECT_LT(others, photons / 1000) << isa_name(isa);
    }
  }
}

tally::Result run_on(int threads, const scene::Scene& scene, Isa isa) {
  run::RunOptions options;
  options.threads = threads;
  options.lanes = isa;
  return run::run(scene, *test::tables(), options);
}

/// The sum of differences, as a share of the sum.
double difference(std::span<const double> lanes, std::span<const double> scalar) {
  const auto off = [](double a, double b) { return std::abs(a - b); };
  return std::transform_reduce(lanes.begin(), lanes.end(), scalar.begin(), 0.0, std::plus(), off) /
         std::reduce(scalar.begin(), scalar.end());
}
void expect_near(std::span<const double> lanes, std::span<const double> scalar, double part) {
  for (std::size_t i = 0; i < scalar.size(); ++i)
    ASSERT_NEAR(lanes[i], scalar[i], part * scalar[i]);
}

/// In float but for the sums, which are taken in another order. Where lanes contract, single scores
/// near the peak of a phase function, which falls by its size within some 1e-4, differ by more than
/// rounding, some fall on the other side of a depth's edge, and the few histories that take another
/// branch (see above) have some collisions more or less.
void expect_echoes_of_the_scalar_engine(const scene::Scene& asked) {
  scene::Scene scene = asked;
  scene.simulation =
      run::choose_estimator(asked, estimator::make_model(asked, *test::tables()), {});
  scene.simulation.batch_photons = 2000;
  const estimator::Model model = estimator::make_model(scene, *test::tables());
  const run::RunOptions options;
  run::RunControl control(model.scene.simulation, options);
  tally::Result scalar = estimator::describe(model);
  const auto simulator = test::scalar_engine<float>(model);
  run::BatchRunner(model, *simulator, control).run().fill(scalar);
  EXPECT_GT(std::reduce(scalar.echo.mean.begin(), scalar.echo.mean.end()), 0);
  for (const Isa isa : isas_here()) {
    SCOPED_TRACE(isa_name(isa));
    const tally::Result lanes = run_on(1, scene, isa);
    const auto collisions = static_cast<double>(scalar.collisions);
    EXPECT_NEAR(static_cast<double>(lanes.collisions), collisions,
                contracts(isa) ? 1e-4 * collisions : 0);
    EXPECT_EQ(lanes.lost_not_finite, 0U);
    expect_near(lanes.echo.mean, scalar.echo.mean, contracts(isa) ? 1e-3 : 1e-13);
    const auto& other = scalar.environment_echo.mean;
    if (!contracts(isa)) {
      expect_near(lanes.environment_echo.mean, other, 1e-5);
    } else if (!other.empty()) {
      EXPECT_LT(difference(lanes.environment_echo.mean, other), 2e-3);
    }
    if (contracts(isa)) {
      EXPECT_LT(difference(lanes.echo.mean, scalar.echo.mean), 1e-5);
      EXPECT_LT(difference(lanes.grid("echo_by_depth").mean, scalar.grid("echo_by_depth").mean),
                1e-5);
      EXPECT_LT(difference(lanes.grid("echo_by_order").mean, scalar.grid("echo_by_order").mean),
                1e-5);
      EXPECT_LT(difference(lanes.grid("echo_by_process").mean, scalar.grid("echo_by_process").mean),
                1e-5);
    } else {
      expect_near(lanes.grid("echo_by_depth").mean, scalar.grid("echo_by_depth").mean, 1e-13);
      expect_near(lanes.grid("echo_by_order").mean, scalar.grid("echo_by_order").mean, 1e-13);
      expect_near(lanes.grid("echo_by_process").mean, scalar.grid("echo_by_process").mean, 1e-13);
    }
    const double of_weight = contracts(isa) ? 1e-6 : 1e-12;
    EXPECT_NEAR(lanes.ledger.absorbed, scalar.ledger.absorbed, of_weight);
    EXPECT_NEAR(lanes.ledger.escaped, scalar.ledger.escaped, of_weight);
    EXPECT_NEAR(lanes.ledger.sea_bed, scalar.ledger.sea_bed, of_weight);
    EXPECT_NEAR(lanes.ledger.cut_by_time, scalar.ledger.cut_by_time, of_weight);
    EXPECT_NEAR(lanes.ledger.cut_by_order, scalar.ledger.cut_by_order, of_weight);
    EXPECT_NEAR(lanes.ledger.cut_by_weight, scalar.ledger.cut_by_weight, of_weight);
    EXPECT_NEAR(lanes.ledger.roulette, scalar.ledger.roulette, of_weight);
  }
}

// Seen red: as above, with what waits at the end of a batch forgotten, and with photons that have
// moved to another pack colliding where they were, too.
TEST(Lanes, EchoesAreThoseOfTheScalarEngineInFloat) {
  for (const auto& scene :
       {plain_scene(), plain_scene("directed_fraction = 0"), rich_scene(), rich_scene(tools),
        bed_scene(), bed_scene("forward", tools_of_points, beds), nested_scene(),
        nested_scene(other_water)})
    expect_echoes_of_the_scalar_engine(scene);
}
TEST(Lanes, BidirectionalEchoesAreThoseOfTheScalarEngineInFloat) {
  for (const auto& scene : bidirectional_scenes()) expect_echoes_of_the_scalar_engine(scene);
}

TEST(Lanes, ThreadsChangeNoBit) {
  const Isa isa = isas_here().back();
  const std::string name = "bidirectional";
  for (const auto& scene : {rich_scene(), rich_scene(tools), nested_scene(),
                            bed_scene(name, few_free_walks, beds), oil_scene(clean, flat)}) {
    const auto one = run_on(1, scene, isa), three = run_on(3, scene, isa);
    EXPECT_EQ(one.echo.mean, three.echo.mean);
    EXPECT_EQ(one.echo.standard_error, three.echo.standard_error);
    EXPECT_EQ(one.grid("echo_by_depth").mean, three.grid("echo_by_depth").mean);
    EXPECT_EQ(one.ledger, three.ledger);
  }
}

}  // namespace
}  // namespace photic::schedule
