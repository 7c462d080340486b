// An engine, as what runs it sees it: something that simulates photons by their numbers.
#pragma once

#include <cstdint>
#include <memory>

#include "tally/batch_tally.hpp"

namespace photic::schedule {

/// Shared by all threads. What it scores depends on the photons alone.
class Simulator {
 public:
  Simulator() = default;
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;
  virtual ~Simulator() = default;

  /// Fills a clear tally with photons `first` … `first + count - 1`.
  void simulate(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const {
    run(first, count, tally);
    tally.pass_to_wider();
  }

 private:
  /// Of nested views the narrowest that sees light scores it.
  virtual void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const = 0;
};

}  // namespace photic::schedule
