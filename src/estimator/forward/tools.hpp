// The forward estimator's tools beyond the plain walk: forced collisions, splitting, the end of
// light photons (docs/theory.md, "The paper's tools"). Each leaves the mean as it is, but for
// scene::AtThreshold::end.
#pragma once

#include <cstdint>

#include "core/random.hpp"
#include "estimator/forward/companions.hpp"
#include "estimator/forward/escape.hpp"
#include "estimator/forward/estimate.hpp"
#include "estimator/forward/passing.hpp"
#include "estimator/random_blocks.hpp"
#include "estimator/termination.hpp"
#include "surface/flat.hpp"
#include "transport/cross.hpp"

namespace photic::estimator {

/// The number of copy 0, 1 … of a photon that was split at an event, which it draws its random
/// numbers by. No photon of the laser has such a one; of two copies with probability 2^-63.
inline std::uint64_t copy_number(const RandomKey& key, std::uint64_t photon, std::int32_t event,
                                 std::int32_t copy) {
  const auto word = philox_words(key, photon, static_cast<std::uint32_t>(event),
                                 copy_blocks[static_cast<std::uint32_t>(copy)]);
  return std::uint64_t{1} << 63 | std::uint64_t{word[1]} << 32 | word[0];
}

template <class T>
T importance_at(const Tools<T>& tools, const T& depth) {
  T value(1);
  for (std::size_t i = 0; i < tools.importance.size(); ++i)
    value = select(depth >= tools.importance_depth[i], tools.importance[i], value);
  return value;
}

/// Returns which photons fly so that they do not leave the water.
template <class T>
Mask<T> are_forced(const Tools<T>& tools, const RandomPlace<T>& place) {
  return place.event <= tools.forced_flights;
}

/// Has light that would leave the water on a forced flight go on in the air: a weight of each
/// photon of a mask, by the flat surface, which is all that forced flights know.
template <class Events, class T>
void pass_forced(const World<T>& world, const ForwardTracks<T>& tracks, const Mask<T>& leaves,
                 const T& weight, const Leave<T>& leave) {
  ForwardTracks<T> gone = tracks;
  const auto companions = companions_of<Events>(world, gone);
  const Vec3<T> up = surface::flat_surface<T>(world.slabs, gone.photon.line)
                         .from_below(select(leaves, gone.photon.direction, {T(0), T(0), T(1)}))
                         .transmitted;
  companions.before(gone.photon);
  const auto came = transport::come_up(world.slabs, gone.photon);
  companions.apart(
      leaves, [&] { companions.flown(gone.photon, came.way.length, leaves); },
      [&] { pass_surface(world, gone, leaves, up, weight, forced_passing, leave); });
}

/// Before the flight of photons that are `on` their way. `leave`: see pass_surface().
template <class Events, class T, class Ledger>
void begin_with_tools(const World<T>& world, ForwardTracks<T>& tracks, const Mask<T>& on,
                      Ledger& ledger, const Leave<T>& leave) {
  transport::Photon<T>& photon = tracks.photon;
  tracks.analog_before = photon.analog_weight;
  tracks.importance_before =
      importance_at(world.forward.tools, geometry::depth_of(photon.position));
  tracks.stays = T(1);
  const Mask<T> forced = are_forced(world.forward.tools, tracks.place);
  if (!any(forced)) return;
  const auto away = escape(world.slabs, photon);
  const Mask<T> into_bed = !(away.surface | away.sideways);
  book(ledger.escaped, on & forced & !into_bed, away.weight);
  book(ledger.sea_bed, on & forced & into_bed, away.weight);
  if (world.part.beyond.exists)
    pass_forced<Events>(world, tracks, on & forced & away.surface & (away.weight > T(0)),
                        away.weight, leave);
  const T& stays = tracks.stays = select(forced, T(1) - away.probability, T(1));
  photon.weight = photon.weight * stays;
  photon.analog_weight = photon.analog_weight * stays;
}

/// Splits photons on their way to where they are worth more, and kills some of those on their way
/// to where they are worth less. Returns which go on, and the number of copies besides.
template <class T, class Ledger>
Mask<T> split(const World<T>& world, ForwardTracks<T>& tracks, const Mask<T>& on, Ledger& ledger) {
  transport::Photon<T>& photon = tracks.photon;
  tracks.copies = Index<T>(0);
  const T ratio = importance_at(world.forward.tools, geometry::depth_of(photon.position)) /
                  tracks.importance_before;
  const Mask<T> changes = on & !(ratio == T(1));
  if (!any(changes)) return on;
  const T u = uniforms(tracks.place, split_blocks[0])[0];
  const Index<T> whole = floor_index(ratio);
  const Index<T> all_of_them =
      whole + select(u < ratio - to_real<T>(whole), Index<T>(1), Index<T>(0));
  const T each = photon.weight / ratio;
  book(ledger.roulette, changes, photon.weight - to_real<T>(all_of_them) * each);
  photon.weight = select(changes, each, photon.weight);
  tracks.copies =
      select(changes & (all_of_them > Index<T>(1)), all_of_them - Index<T>(1), Index<T>(0));
  return on & !(changes & (all_of_them == Index<T>(0)));
}

/// At the end of an event, in place of play_roulette.
template <class T, class Ledger>
Mask<T> end_with_tools(const World<T>& world, ForwardTracks<T>& tracks, Mask<T> on, const T& u,
                       Ledger& ledger) {
  transport::Photon<T>& photon = tracks.photon;
  const T& threshold = world.forward.weight_threshold;
  const T& before = tracks.analog_before;
  switch (world.forward.tools.at_threshold) {
    case scene::AtThreshold::roulette:
      on = play_roulette(photon, threshold, u, on, ledger);
      break;
    case scene::AtThreshold::analog_absorption:
      // Below the threshold the weight stays what it was: what was lost of it is the chance that
      // all is.
      on = play_roulette(photon, select(before <= threshold, before, T(0)), u, on, ledger);
      break;
    case scene::AtThreshold::end:
      const Mask<T> low = photon.analog_weight < threshold;
      book(ledger.cut_by_weight, on & low, photon.weight);
      on = on & !low;
  }
  return split(world, tracks, on, ledger);
}

}  // namespace photic::estimator
