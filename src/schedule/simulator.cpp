#include "schedule/simulator.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"

namespace photic::schedule {

Simulator::Simulator(estimator::Plan plan, const MakeSet& make) : plan_(std::move(plan)) {
  for (const estimator::HistorySet& set : plan_.sets) simulators_.push_back(make(set));
  for (const estimator::HistorySet& set : plan_.sets)
    expect(!set.passes_to || simulators_[set.passes_to->set]->no_arrivals(),
           "light goes on in sets that take arrivals");
}

void Simulator::simulate(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally,
                         const std::stop_token& stop) const {
  std::vector<std::unique_ptr<Arrivals>> arrivals;
  for (const auto& simulator : simulators_) arrivals.push_back(simulator->no_arrivals());
  const auto waits = [](const auto& list) { return list && !list->empty(); };
  const auto run = [&](std::size_t i, const auto& use) {
    const estimator::HistorySet& set = plan_.sets[i];
    const tally::Ledger before = tally.ledger;
    use(*simulators_[i], set.passes_to ? arrivals[set.passes_to->set].get() : nullptr);
    if (!set.in_ledger) tally.ledger = before;
  };
  for (std::size_t i = 0; i < simulators_.size(); ++i)
    if (plan_.sets[i].from_laser)
      run(i,
          [&](const auto& set, Arrivals* passed) { set.run(first, count, tally, passed, stop); });
  while (std::ranges::any_of(arrivals, waits))
    for (std::size_t i = 0; i < simulators_.size(); ++i)
      if (waits(arrivals[i]))
        run(i,
            [&](const auto& set, Arrivals* passed) { set.run(*arrivals[i], tally, passed, stop); });
  tally.pass_to_wider();
}

}  // namespace photic::schedule
