// What happens to photons, event by event, for comparing one engine with another.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "estimator/model.hpp"

namespace photic::schedule {

/// A photon after an event.
struct LoggedEvent {
  bool on = false;                     ///< whether it goes on
  std::array<float, 9> state{};        ///< position, direction, weight, analog weight, path
  std::array<std::int32_t, 3> kind{};  ///< line, layer, order
  friend bool operator==(const LoggedEvent&, const LoggedEvent&) = default;
};

/// By photon and event.
using EventLog = std::map<std::pair<std::uint64_t, std::int32_t>, LoggedEvent>;

}  // namespace photic::schedule
