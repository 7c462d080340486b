// A constituent of the water against depth.
#pragma once

#include <vector>

namespace photic::scene {

/// The least and the greatest of some values.
struct Extremes {
  double least, greatest;
};

/// Known at depths, with straight lines between them.
class LinearProfile {
 public:
  /// As many depths, strictly ascending, as values; two or more.
  LinearProfile(std::vector<double> depth_m, std::vector<double> value);

  [[nodiscard]] double first_m() const { return depth_m_.front(); }
  [[nodiscard]] double last_m() const { return depth_m_.back(); }
  /// Makes it known from one depth to another at least, constant beyond its ends.
  void reach(double from_m, double to_m);
  /// Over a - b, which the depths cover.
  [[nodiscard]] double integral(double a_m, double b_m) const;
  [[nodiscard]] Extremes extremes(double a_m, double b_m) const;

 private:
  [[nodiscard]] double at(double depth_m) const;

  std::vector<double> depth_m_, value_;
};

/// A maximum on a background, B + (M - B) exp(-(z - z_m)^2 / (2 s^2)): Lewis, Cullen & Platt 1983,
/// J. Geophys. Res. 88, 2565, and Platt & Sathyendranath 1988, Science 241, 1613, whose
/// h = (M - B) s sqrt(2 pi).
struct GaussianProfile {
  double background{};
  double maximum{};  ///< the value at its depth
  double depth_m{};
  double width_m{};  ///< the standard deviation

  [[nodiscard]] double integral(double a_m, double b_m) const;
  [[nodiscard]] Extremes extremes(double a_m, double b_m) const;
};

}  // namespace photic::scene
