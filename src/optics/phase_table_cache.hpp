// Tables of phase functions, each made once and shared.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "optics/phase_table.hpp"

namespace photic::optics {

/// May be used by several threads.
class PhaseTableCache {
 public:
  /// So many of the tables asked for last are kept, 80 MB; others as long as somebody has them.
  static constexpr std::size_t most_kept = 256;

  /// The table of a shape: by its key, the one that is there already. A shape without a key has a
  /// table of its own. Throws as PhaseTable does.
  std::shared_ptr<const PhaseTable> operator()(const PhaseShape& shape) const;

 private:
  /// The place of a table, which one thread makes while others wait for it.
  struct Slot {
    std::mutex mutex;
    std::weak_ptr<const PhaseTable> table;
  };
  std::shared_ptr<Slot> slot_of(const PhaseKey& key) const;
  void forget_ended() const;
  void keep(const std::shared_ptr<const PhaseTable>& table) const;

  mutable std::mutex mutex_;
  mutable std::map<PhaseKey, std::shared_ptr<Slot>> slots_;
  mutable std::size_t slots_to_look_through_ = 2 * most_kept;  ///< for those whose table has ended
  mutable std::vector<std::shared_ptr<const PhaseTable>> kept_;  ///< the last one asked for last
};

}  // namespace photic::optics
