// What becomes of a path's weight in other waters than those it was drawn in: the ratio of the
// path's density there to that here, factor by factor (docs/theory.md, "Environments").
#pragma once

#include <cmath>
#include <vector>

#include "core/elementary.hpp"
#include "core/flatten.hpp"
#include "instrument/telescope.hpp"
#include "medium/medium.hpp"
#include "optics/phase_table.hpp"
#include "transport/connect.hpp"

namespace photic::transport {

/// A straight piece of a way in the water, from one depth to another.
template <class T>
struct Passage {
  Index<T> layer1{};
  T depth1{};
  Index<T> layer2{};
  T depth2{}, length{};
};

/// Of light of a line that passes it.
template <class T>
T passage_ratio(const medium::MediumView& sea, std::int32_t environment, const Index<T>& line,
                const Passage<T>& s) {
  const T deeper = sea.excess_slant_optical_depth<T>(environment, line, s.layer1, s.depth1,
                                                     s.layer2, s.depth2, s.length);
  // No more than a number can say: the light itself is gone by then.
  const T least(sizeof(Element<T>) == sizeof(double) ? -600 : -80);
  return exp_minus(select(deeper > least, deeper, least));
}

/// Of light of a line on a way from a photon's position to a telescope.
template <class T>
T way_ratio(const medium::MediumView& sea, std::int32_t environment, const Index<T>& line,
            const Photon<T>& at, const Connection<T>& way,
            const instrument::Telescope<T>& telescope, const Index<T>& telescope_layer,
            bool mirrored) {
  using std::abs;
  const T depth = -at.position.z;
  const auto ratio = [&](const Passage<T>& s) { return passage_ratio(sea, environment, line, s); };
  if (!telescope.submerged) return ratio({at.layer, depth, Index<T>(0), T(0), way.length_water});
  if (!mirrored) {
    const T end_depth = depth - way.length_water * way.direction.z;
    return ratio({at.layer, depth, telescope_layer, end_depth, way.length_water});
  }
  const T steep = abs(way.direction.z);
  const T end_depth = way.length_water * steep - depth;
  return ratio({at.layer, depth, Index<T>(0), T(0), depth / steep}) *
         ratio({telescope_layer, end_depth, Index<T>(0), T(0), end_depth / steep});
}

/// Phase functions of the parts of the scattering that vary, over that of all scattering, at an
/// angle given as 1 - cos.
template <class T>
void part_values(const medium::MediumView& sea, const Index<T>& line, const Index<T>& layer,
                 const T& x, std::vector<T>& values) {
  const Index<T> here = sea.at(line, layer);
  const T all = sea.phases.template value<T>(x, gather_index<T>(sea.elastic_phase, here));
  const Mask<T> scatters = all > T(0);
  const Index<T> row = here * Index<T>(sea.environments.parts);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto phase =
        gather_index<T>(sea.environments.part_phase, row + Index<T>(static_cast<std::int32_t>(k)));
    const T part = sea.phases.template value<T>(x, phase);
    values[k] = select(scatters, part / select(scatters, all, T(1)), T(0));
  }
}

/// Of light that is scattered, at the angle that the parts' values are for.
template <class T>
T scattering_ratio(const medium::MediumView& sea, std::int32_t environment, const Index<T>& line,
                   const Index<T>& layer, const std::vector<T>& values) {
  const Index<T> row =
      sea.at(line + Index<T>(environment * sea.lines), layer) * Index<T>(sea.environments.parts);
  T excess(0);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const Index<T> i = row + Index<T>(static_cast<std::int32_t>(k));
    excess = excess + gather<T>(sea.environments.excess_part, i) * values[k];
  }
  return T(1) + excess;
}

/// Of photons that leave a collision at a line: those of a mask converted to it, the others
/// scattered at the angle that the parts' values are for.
template <class T>
T collision_ratio(const medium::MediumView& sea, std::int32_t environment, const Photon<T>& before,
                  const Index<T>& line, const Mask<T>& converted, const std::vector<T>& values) {
  const T scattered = scattering_ratio(sea, environment, before.line, before.layer, values);
  if (!any(converted)) return scattered;
  const Index<T> i = sea.at(line + Index<T>(environment * sea.lines), before.layer);
  return select(converted, T(1) + gather<T>(sea.environments.excess_emitted, i), scattered);
}

/// The ratios of photons on their walk, and what is needed to keep them. What is handed over by
/// value stays in the registers of scenes that have no environments.
template <class T>
struct Ratios {
  std::vector<T> of_path;  ///< [environment]
  std::vector<T> part;     ///< values of the parts of the scattering that vary, at some angle
  Photon<T> before;        ///< what happens to them

  PHOTIC_APART void begin(const medium::MediumView& sea) {
    of_path.assign(static_cast<std::size_t>(sea.environments.count), T(1));
    part.assign(static_cast<std::size_t>(sea.environments.parts), T(0));
  }

  /// The photons have flown so far.
  PHOTIC_APART void flown(const medium::MediumView& sea, Photon<T> after, T length) {
    const Passage<T> way{before.layer, -before.position.z, after.layer, -after.position.z, length};
    for (std::size_t e = 0; e < of_path.size(); ++e)
      of_path[e] = of_path[e] * passage_ratio(sea, static_cast<std::int32_t>(e), before.line, way);
  }

  /// Those of a mask were scattered or converted where they stand.
  PHOTIC_APART void collided(const medium::MediumView& sea, Photon<T> after, Mask<T> mask) {
    const Mask<T> converted = mask & !(before.line == after.line);
    part_values(sea, before.line, before.layer, one_minus_cos(before.direction, after.direction),
                part);
    for (std::size_t i = 0; i < of_path.size(); ++i) {
      const T ratio =
          collision_ratio(sea, static_cast<std::int32_t>(i), before, after.line, converted, part);
      of_path[i] = of_path[i] * select(mask, ratio, T(1));
    }
  }
};

}  // namespace photic::transport
