// Spherical air: its layers are shells about the centre of a planet.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace photic::medium {

/// Shells as flights see them, in double. Number 0 is the uppermost, and begins at sphere 0.
struct ShellsView {
  double planet_m = 0;             ///< radius of the ground
  std::span<const double> height;  ///< of the spheres above the ground, from the top down to 0 [m]
  /// 1 - (n / n')^2 of light that goes up from an index of n to n', and of light that goes down, by
  /// sphere; none where spheres do not bend light.
  std::span<const double> upwards, downwards;
  bool mirrors = false;         ///< the ground reflects like a mirror, else evenly
  bool source_outside = false;  ///< light comes from above the air

  [[nodiscard]] bool exist() const { return !height.empty(); }
  [[nodiscard]] bool bend() const { return !upwards.empty(); }
  [[nodiscard]] std::size_t ground() const { return height.size() - 1; }
  [[nodiscard]] double top_m() const { return height.front(); }
};

/// Owns what a view points to.
class Shells {
 public:
  /// `edges`: of the layers, heights from the ground up; `index`: of the shells, from the lowest
  /// up, where they bend light, else none. Above them is a vacuum.
  Shells(double planet_m, const std::vector<double>& edges, const std::vector<double>& index);

  bool mirrors = false, source_outside = false;  ///< as in the view

  [[nodiscard]] ShellsView view() const {
    return {planet_m_, height_, upwards_, downwards_, mirrors, source_outside};
  }

 private:
  double planet_m_;
  std::vector<double> height_, upwards_, downwards_;
};

}  // namespace photic::medium
