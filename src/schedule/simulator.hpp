// An engine, as what runs it sees it: something that simulates photons by their numbers.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "estimator/plan.hpp"
#include "tally/batch_tally.hpp"

namespace photic::schedule {

/// Photons that have come to a set from another one. What they are is known to the sets' simulators
/// alone, which are of one kind.
class Arrivals {
 public:
  virtual ~Arrivals() = default;
  [[nodiscard]] virtual bool empty() const = 0;
};

/// Simulates one set of a plan. All threads share it. Throws Stopped if it is stopped: then nobody
/// knows how much of its light is in the tally.
class SetSimulator {
 public:
  SetSimulator() = default;
  SetSimulator(const SetSimulator&) = delete;
  SetSimulator& operator=(const SetSimulator&) = delete;
  virtual ~SetSimulator() = default;

  /// An empty list; none if photons never come from another set.
  [[nodiscard]] virtual std::unique_ptr<Arrivals> no_arrivals() const { return nullptr; }
  /// Adds photons `first` … `first + count - 1` of the laser, the first of a batch and up, to a
  /// tally, and those that pass the surface to `passed`, which is there if light goes on.
  virtual void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally,
                   Arrivals* passed, const std::stop_token& stop) const = 0;
  /// The same of photons from another set, which are taken out of their list.
  virtual void run(Arrivals& /*arrivals*/, tally::BatchTally& /*tally*/, Arrivals* /*passed*/,
                   const std::stop_token& /*stop*/) const {}
};

/// Runs a plan. All threads share it. Its scores depend on the photons alone.
class Simulator {
 public:
  using MakeSet = std::function<std::unique_ptr<SetSimulator>(const estimator::HistorySet&)>;
  Simulator(estimator::Plan plan, const MakeSet& make);

  /// Fills a clear tally with photons `first` … `first + count - 1`. The narrowest of nested views
  /// that sees light scores it. Throws Stopped as the simulators of sets do.
  void simulate(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally,
                const std::stop_token& stop) const;

 private:
  estimator::Plan plan_;
  std::vector<std::unique_ptr<SetSimulator>> simulators_;  ///< of each set
};

}  // namespace photic::schedule
