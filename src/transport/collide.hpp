// A collision of a photon: it survives as scattered light, or goes on at another wavelength.
#pragma once

#include "medium/medium.hpp"
#include "transport/photon.hpp"
#include "transport/scatter.hpp"

namespace photic::transport {

/// The decision of a collision.
template <class T>
struct Branch {
  Mask<T> converted{};  ///< the photon's line has changed
  Index<T> phase{};     ///< table of the direction it leaves in
  Index<T> lobe{};      ///< elastic table at the line it leaves with: the lobe of directed sampling
};

/// Implicit absorption with a branch into the inelastic processes: with probability `conversion`
/// (where light of the laser's line can be converted at all) the photon becomes one of another
/// band, each of these equally likely, in the line of its spectral_bin; else it is scattered.
/// Weights are multiplied by the physical share over that probability, so that each branch is right
/// in the mean. At most one conversion per photon.
template <class T>
Branch<T> collide(const medium::MediumView& sea, Photon<T>& photon, const Index<T>& spectral_bin,
                  const T& conversion, const T& u_branch, const T& u_band) {
  const Index<T> here = sea.at(photon.line, photon.layer);
  const T albedo = scattered_share(sea, photon.line, photon.layer, T(-photon.direction.z));
  photon.order = photon.order + Index<T>(1);
  Branch<T> branch;
  if (sea.lines == 1) {
    photon.weight = photon.weight * albedo;
    photon.analog_weight = photon.analog_weight * albedo;
    branch.phase = branch.lobe = gather_index<T>(sea.elastic_phase, here);
    return branch;
  }
  const Index<T> choices =
      select(photon.line == Index<T>(0), gather_index<T>(sea.convertible_count, photon.layer),
             Index<T>(0));
  const T probability = select(choices > Index<T>(0), conversion, T(0));
  branch.converted = u_branch < probability;
  const Index<T> pick =
      select(branch.converted, floor_index(u_band * to_real<T>(choices)), Index<T>(0));
  const Index<T> line = sea.emitted_line<T>(photon.layer, pick, spectral_bin);
  const T emitted = gather<T>(sea.conversion, sea.at(line, photon.layer));
  const T scattered_factor = any(choices > Index<T>(0)) ? albedo / (T(1) - probability) : albedo;
  const T converted_factor =
      emitted * to_real<T>(choices) / select(branch.converted, probability, T(1));

  photon.weight = photon.weight * select(branch.converted, converted_factor, scattered_factor);
  photon.analog_weight = photon.analog_weight * select(branch.converted, T(1), albedo);
  photon.line = select(branch.converted, line, photon.line);
  branch.lobe = gather_index<T>(sea.elastic_phase, sea.at(photon.line, photon.layer));
  branch.phase =
      select(branch.converted, gather_index<T>(sea.conversion_phase, photon.line), branch.lobe);
  return branch;
}

/// The chance of photons in Russian roulette.
template <class T>
T survival(const Photon<T>& photon, const T& level) {
  return select(photon.analog_weight < level, photon.analog_weight / level, T(1));
}

/// Russian roulette below a level of the analog weight: survivors are brought back to it. Returns
/// the survivors; the weight of the others is left for the caller to book.
template <class T>
Mask<T> roulette(Photon<T>& photon, const T& level, const T& u) {
  const Mask<T> low = photon.analog_weight < level;
  if (!any(low)) return !low;
  const T chance = survival(photon, level);
  const Mask<T> survives = u < chance;
  const T gain = T(1) / select(chance > T(0), chance, T(1));
  photon.weight = photon.weight * select(survives & low, gain, T(1));
  photon.analog_weight = select(low, level, photon.analog_weight);
  return survives;
}

}  // namespace photic::transport
