// Values that take long to make, kept for those who ask for them again.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <utility>

namespace photic {

/// May be used by several threads. Those that ask for the same at once may each make it, so that
/// none waits for another's work. Where that is broken off nothing is kept.
template <class Key, class Value>
class Kept {
 public:
  /// The value of a key: make(), unless it is known.
  template <class Make>
  Value operator()(const Key& key, Make make) const {
    if (auto known = find(key)) return *std::move(known);
    Value made = make();
    const std::scoped_lock lock(mutex_);
    return known_.emplace(key, std::move(made)).first->second;
  }

 private:
  std::optional<Value> find(const Key& key) const {
    const std::scoped_lock lock(mutex_);
    const auto known = known_.find(key);
    return known == known_.end() ? std::nullopt : std::optional(known->second);
  }

  mutable std::mutex mutex_;
  mutable std::map<Key, Value> known_;
};

}  // namespace photic
