// A companion of all light of a world: it is shown every flight, collision and
// crossing of histories, walks and analog photons, one by one and in lanes. It finds what the
// ledger has.
#include "core/pack.hpp"  // before all that is made of lanes

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <string>

#include "estimator/analog/analog.hpp"
#include "estimator/bidirectional/bidirectional.hpp"
#include "estimator/make_world.hpp"
#include "lanes/lane_ledger.hpp"
#include "schedule/one_by_one.hpp"
#include "schedule/pools.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::schedule {
namespace {

using Lanes = Pack<float, native::float_lanes>;

template <class T>
double sum_of(const T& values, const Mask<T>& mask) {
  const auto all = each_lane(values);
  double sum = 0;
  for_each_lane(mask, [&](int lane) { sum += all[static_cast<std::size_t>(lane)]; });
  return sum;
}

template <class T>
struct Counter final : estimator::Companion<T> {
  using Photon = transport::Photon<T>;
  double collisions = 0, crossings = 0;
  double optical_depth = 0;                  ///< of c', all the way
  double at_collisions = 0, at_surface = 0;  ///< lost weight
  const geometry::Slabs& sea;

  explicit Counter(const geometry::Slabs& slabs) : sea(slabs) {}

  void flown(const Photon& after, const T& length, const Mask<T>& mask) override {
    const T c = gather<T>(sea.walk_c.first, sea.at(after.line, Index<T>(0)));
    optical_depth += sum_of<T>(c * length, mask);
  }
  void collided(const Photon& before, const Photon& after, const Mask<T>& mask) override {
    collisions += static_cast<double>(count(mask));
    at_collisions += sum_of<T>(before.weight - after.weight, mask);
  }
  void crossed(const Photon& before, const Photon& after, const Mask<T>& mask,
               const Mask<T>& stay) override {
    crossings += static_cast<double>(count(mask));
    at_surface += sum_of<T>(before.weight, mask) - sum_of<T>(after.weight, stay);
  }
};

template <class T>
struct Engine;
template <>
struct Engine<double> {
  using Histories = HistoriesOneByOne<double>;
  using Ledger = tally::Ledger;
};
template <>
struct Engine<Lanes> {
  using Histories = Pools<Lanes>;
  using Ledger = lanes::LaneLedger<Lanes>;
};

template <class T>
void follow_light(scene::Estimator estimator, const estimator::World<T>& world, std::uint64_t first,
                  tally::BatchTally& tally) {
  const std::uint64_t photons = world.random.batch_photons;
  using Ledger = typename Engine<T>::Ledger;
  estimator::AnalogPassed<T> none;
  switch (estimator) {
    case scene::Estimator::analog:
      estimator::Analog<T, Ledger>(world, tally, none).run(first, photons, [](const auto&...) {});
      break;
    case scene::Estimator::bidirectional:
      estimator::Bidirectional<T, Ledger>(world, 1).run(first, photons, tally, [](const auto&) {});
      break;
    default:
      typename Engine<T>::Histories(world).run(first, photons, tally, nullptr, {});
  }
}

struct Case {
  std::string estimator, surface, height_m;
};
/// Water of one layer without a bed. The gates take all light there is, so that no flight is cut.
scene::Scene scene_of(const Case& c) {
  const std::string instrument =
      std::regex_replace(test::ship_instrument, std::regex("12[.]0]"), c.height_m + "]");
  return test::read(
      instrument + test::channel("elastic") + "[sea]\nsurface = { model = " + c.surface + " }\n" +
      test::water(0.06, 0.10, test::henyey_greenstein_phase) + test::depth_gates(5000, 500) +
      "depth_min_m = 1.0\n" +
      test::simulation(4000, 7, c.estimator == "bidirectional" ? test::no_free_walks : "",
                       c.estimator));
}

template <class T>
void expect_the_ledgers_sums(const Case& c) {
  SCOPED_TRACE(c.estimator + ", " + c.surface + (lanes_of<T> == 1 ? ", scalar" : ", lanes"));
  const auto model = estimator::make_model(scene_of(c), *test::tables());
  auto world = estimator::make_world<T>(model);
  world.walks.receivers.clear();  // the ledger has the laser's light alone
  Counter<T> counter(world.slabs);
  accompany(world, counter);
  tally::BatchTally tally(model.shape, model.gates);
  for (std::uint64_t first = 0; first < 4000; first += world.random.batch_photons)
    follow_light(model.scene.simulation.estimator, world, first, tally);
  const tally::Ledger& ledger = tally.ledger;
  EXPECT_EQ(ledger.cut_by_time, 0);
  EXPECT_GT(counter.crossings, 50);
  EXPECT_EQ(counter.collisions, static_cast<double>(tally.collisions));
  // A free path is an optical depth: so many collisions are expected on the way, give or take the
  // root of their number (five of these are never left by chance).
  EXPECT_LT(std::abs(counter.collisions - counter.optical_depth),
            5 * std::sqrt(counter.collisions));
  if (c.estimator == "analog") return;  // its photons end with the weight that they had
  const double rounded = lanes_of<T> == 1 ? 1e-8 : 0.05;
  EXPECT_NEAR(counter.at_collisions, ledger.absorbed, rounded);
  if (c.surface != "\"flat\"") return;  // facets' gains are in the ledger with roulette's
  EXPECT_NEAR(counter.at_surface, ledger.escaped, rounded);
}

// Seen red: without the call in WalkSteps::fly(); in leave_vertex(); in Companions::flown(); in
// Companions::collided(); in AnalogSteps::collide(); in fly_to_detectors(); in cross_surface().
TEST(Companions, FindTheLedgersSums) {
  const std::string flat = R"("flat")", waves = R"("cox-munk", wind_speed_m_s = 5.0)";
  for (const Case& c : {Case{"forward", flat, "12.0"}, Case{"forward", waves, "12.0"},
                        Case{"bidirectional", flat, "-1.0"}, Case{"bidirectional", waves, "-1.0"},
                        Case{"analog", flat, "12.0"}, Case{"analog", waves, "12.0"}}) {
    expect_the_ledgers_sums<double>(c);
    expect_the_ledgers_sums<Lanes>(c);
  }
}

}  // namespace
}  // namespace photic::schedule
