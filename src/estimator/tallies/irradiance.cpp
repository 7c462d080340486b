#include "estimator/tallies/irradiance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace photic::estimator {

Irradiance::Irradiance(const std::vector<Level>& levels, ContinuousAbsorption absorption,
                       double end, const Cells& away, const Cells& towards)
    : absorption_(std::move(absorption)), away_(away), towards_(towards) {
  constexpr double within_end = 1e-6;  // more than floats round off
  for (Level level : levels) {
    // Light that ends where the medium does, or begins there, is to pass a level there.
    if (level.distance >= end) level.distance = end * (1 - within_end);
    const std::size_t layer = absorption_.layer_of(level.distance);
    const double begin_of_slab =
        std::max(level.distance - level.slab_m / 2, absorption_.begin_of(layer));
    const double end_of_slab =
        std::min(level.distance + level.slab_m / 2, absorption_.end_of(layer));
    slabs_.push_back({level, begin_of_slab, end_of_slab, layer});
  }
  std::ranges::sort(slabs_, {}, &Slab::begin);
}

void Irradiance::add_track(const Flight& flight, const Slab& slab, std::size_t cell,
                           tally::TallyScores& scores) const {
  const double near = std::max(flight.near(), slab.begin), far = std::min(flight.far(), slab.end);
  const bool level = flight.near() == flight.far();
  if (level ? near > far : near >= far) return;
  const double first = flight.leads_away() ? near : far;
  const double length =
      level ? flight.length : flight.length * (far - near) / (flight.far() - flight.near());
  const double weight = absorption_.weight_at(flight, first);
  scores.add(cell, absorption_.track(slab.layer, weight, length) / (slab.end - slab.begin));
}

/// A flight passes the levels from the nearer of its ends up to the farther one, which is none of
/// them: light that ends at a level, and sets out from there, is counted once.
void Irradiance::add(const Flight& flight, tally::TallyScores& scores) const {
  const double near = flight.near(), far = flight.far();
  const Cells& cells = flight.leads_away() ? away_ : towards_;
  for (const Slab& slab : slabs_) {
    if (far < slab.begin) break;
    if (near > slab.end) continue;
    const double at = slab.level.distance;
    if (near <= at && at < far)
      scores.add(cells.plane + slab.level.index, absorption_.weight_at(flight, at));
    add_track(flight, slab, cells.scalar + slab.level.index, scores);
  }
}

}  // namespace photic::estimator
