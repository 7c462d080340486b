// The attenuation c' that free paths are drawn from: layer by layer a share of the true one, c. The
// rest of c is absorbed along the way. The share is an estimator's choice.
#pragma once

#include <span>
#include <vector>

#include "core/twin_table.hpp"
#include "medium/medium.hpp"

namespace photic::geometry {

/// Layers over one another between the surface and the sea bed, as flights see them: the medium,
/// and what free paths through it are drawn from.
struct Slabs : medium::MediumView {
  // Coefficients and their integrals from the surface to a layer's top, [line][layer]:
  ShortPairs walk_c;                 ///< c', what free paths are drawn from
  ShortPairs continuous_c;           ///< c less c', absorbed along the way
  ShortTable walk_mean_path;         ///< 1 / c' [m], [line][layer]
  ShortTable collision_gain;         ///< c / c', [line][layer]
  medium::LayeringView by_walk_tau;  ///< in a row for each line and column, by the
                                     ///< optical depth of c'

  /// Optical depth of c' from the surface straight down to a level.
  template <class T>
  T walk_optical_depth(const Index<T>& line, const medium::Level<T>& at) const {
    return column(walk_c, line, at).integral;
  }
  /// The same of a straight way of the given length between two levels.
  template <class T>
  T walk_slant_optical_depth(const Index<T>& line, const medium::Level<T>& from,
                             const medium::Level<T>& to, const T& length) const {
    return slant(walk_c, line, from, to, length);
  }
  /// Optical depth of the absorption along such a way; `first` at the first level.
  template <class T>
  T continuous_slant_optical_depth(const Index<T>& line, const medium::Level<T>& from,
                                   const medium::Column<T>& first, const medium::Level<T>& to,
                                   const T& length) const {
    if (all(from.layer == to.layer)) return first.coefficient * length;
    return across(from, first, to, continuous_column(line, to), length);
  }
  template <class T>
  medium::Column<T> continuous_column(const Index<T>& line, const medium::Level<T>& at) const {
    return column(continuous_c, line, at);
  }
};

/// Owns what Slabs have besides the medium.
class FreePaths {
 public:
  FreePaths() = default;
  /// `share` of c, 0 to 1, [line][layer].
  FreePaths(const medium::Medium& medium, std::span<const double> share);

  [[nodiscard]] Slabs slabs(const medium::Medium& medium) const;

 private:
  TwinPairs walk_c_, continuous_c_;
  TwinTable walk_mean_path_, collision_gain_, edges_;
  medium::Layering by_walk_tau_;
};

}  // namespace photic::geometry
