// The events of a pool of lanes. Compiled for each instruction set.
#include "core/pack.hpp"
#include "estimator/analog/analog.hpp"
#include "estimator/make_world.hpp"
#include "lanes/lane_ledger.hpp"
#include "schedule/pool.hpp"
#include "unit/schedule/event_log.hpp"

namespace photic::schedule {
namespace {

using Lanes = Pack<float, native::float_lanes>;

LoggedEvent event_of(const transport::Photon<Lanes>& p, std::size_t i) {
  return {true,
          {p.position.x[i], p.position.y[i], p.position.z[i], p.direction.x[i], p.direction.y[i],
           p.direction.z[i], p.weight[i], p.analog_weight[i], p.path[i]},
          {p.line[i], p.layer[i], p.order[i]}};
}

}  // namespace

namespace PHOTIC_ISA {
EventLog log_lanes(const estimator::Model& model, std::uint64_t photons);
EventLog log_lanes(const estimator::Model& model, std::uint64_t photons) {
  const auto world = estimator::make_world<Lanes>(model);
  tally::BatchTally tally(model.shape, model.gates);
  EventLog log;
  const auto witness = [&log](const auto& t, const Mask<Lanes>& before) {
    for_each_lane(before, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      LoggedEvent event = t.on[i] ? event_of(t.photon, i) : LoggedEvent{};
      log.emplace(std::pair(t.place.photon[i], t.place.event[i]), event);
    });
  };
  for (std::uint64_t batch = 0; batch < photons; batch += world.random.batch_photons) {
    estimator::AnalogPassed<Lanes> none;
    if (model.scene.simulation.estimator == scene::Estimator::analog)
      estimator::Analog<Lanes, lanes::LaneLedger<Lanes>>(world, tally, none)
          .run(batch, world.random.batch_photons, witness);
    else
      Pool<Lanes>(world).run(batch, world.random.batch_photons, tally, witness);
  }
  return log;
}
}  // namespace PHOTIC_ISA

}  // namespace photic::schedule
