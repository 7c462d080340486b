#include "optics/phase_table_cache.hpp"

#include <algorithm>

namespace photic::optics {

std::shared_ptr<const PhaseTable> PhaseTableCache::operator()(const PhaseShape& shape) const {
  if (shape.key.empty()) return std::make_shared<const PhaseTable>(shape);
  const auto slot = slot_of(shape.key);
  const std::scoped_lock lock(slot->mutex);
  auto table = slot->table.lock();
  if (!table) {
    // Not make_shared: the memory of that would last as long as the slot.
    table = std::make_unique<const PhaseTable>(shape);
    slot->table = table;
  }
  keep(table);
  return table;
}

std::shared_ptr<PhaseTableCache::Slot> PhaseTableCache::slot_of(const PhaseKey& key) const {
  const std::scoped_lock lock(mutex_);
  if (const auto known = slots_.find(key); known != slots_.end()) return known->second;
  if (slots_.size() >= slots_to_look_through_) forget_ended();
  return slots_.emplace(key, std::make_shared<Slot>()).first->second;
}

void PhaseTableCache::forget_ended() const {
  std::erase_if(slots_, [](const auto& known) {
    const std::shared_ptr<Slot>& slot = known.second;
    return slot.use_count() == 1 && slot->table.expired();  // and no thread is about to fill it
  });
  slots_to_look_through_ = 2 * std::max(slots_.size(), most_kept);
}

void PhaseTableCache::keep(const std::shared_ptr<const PhaseTable>& table) const {
  const std::scoped_lock lock(mutex_);
  const auto known = std::ranges::find(kept_, table);
  if (known != kept_.end()) {
    std::rotate(known, known + 1, kept_.end());
    return;
  }
  if (kept_.size() == most_kept) kept_.erase(kept_.begin());
  kept_.push_back(table);
}

}  // namespace photic::optics
