// An engine, as what runs it sees it: something that simulates photons by their numbers.
#pragma once

#include <cstdint>
#include <memory>

#include "tally/batch_tally.hpp"

namespace photic::schedule {

/// A simulator that all threads share. Its scores depend on the photons alone.
class Simulator {
 public:
  Simulator() = default;
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;
  virtual ~Simulator() = default;

  /// Fills a clear tally with photons `first` … `first + count - 1`.
  void simulate(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const {
    add(first, count, tally);
    tally.pass_to_wider();
  }
  /// Adds them to a tally. The narrowest of nested views that sees light scores it.
  virtual void add(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const = 0;
};

/// Histories beside the bidirectional estimator's walks, which score what walks leave out. None
/// where walks leave nothing out.
struct BesideWalks {
  std::unique_ptr<Simulator> in_water;  ///< the surface's own echo, the light of a film
  std::unique_ptr<Simulator> in_air;    ///< light that is scattered in both media
};

}  // namespace photic::schedule
