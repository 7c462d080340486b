// The operations of a simulation, by kind: its price follows from them and not from a clock. They
// are counted by photons, rays and paths, and so are the same on any number of threads and with any
// instructions.
#pragma once

#include <cstdint>

namespace photic::tally {

struct Operations {
  std::uint64_t local_estimates = 0;    ///< ways looked for from a collision to a telescope
  std::uint64_t facets = 0;             ///< met by histories
  std::uint64_t vertex_pairs = 0;       ///< a vertex with an instrument, or two vertices of walks
  std::uint64_t ray_pairs = 0;          ///< looked at, whether rays of walks can be made to meet
  std::uint64_t meetings = 0;           ///< of rays
  std::uint64_t free_meetings = 0;      ///< for which an end of a walk is sought anew
  std::uint64_t meetings_by_waves = 0;  ///< whose ways through waves have other densities

  /// Calls f(name, count) for each kind.
  template <class F, class Self>
  static void each(F f, Self& self) {
    f("local_estimates", self.local_estimates);
    f("facets", self.facets);
    f("vertex_pairs", self.vertex_pairs);
    f("ray_pairs", self.ray_pairs);
    f("meetings", self.meetings);
    f("free_meetings", self.free_meetings);
    f("meetings_by_waves", self.meetings_by_waves);
  }
  Operations& operator+=(const Operations& others) {
    local_estimates += others.local_estimates;
    facets += others.facets;
    vertex_pairs += others.vertex_pairs;
    ray_pairs += others.ray_pairs;
    meetings += others.meetings;
    free_meetings += others.free_meetings;
    meetings_by_waves += others.meetings_by_waves;
    return *this;
  }
  friend bool operator==(const Operations&, const Operations&) = default;
};

}  // namespace photic::tally
