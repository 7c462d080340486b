// Light that water gives back at other wavelengths than the laser's.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace photic::optics {

/// All light of a process at one wavelength.
struct EmissionLine {
  double wavelength_nm = 0;
  double coefficient = 0;  ///< photons emitted, per photon and what the process says
};

/// The distribution of the light of a process over wavelength: straight lines between wavelengths,
/// nothing outside.
class EmissionSpectrum {
 public:
  EmissionSpectrum() = default;
  /// Ascending wavelengths, and photons emitted per nm, and per photon and what the process says.
  EmissionSpectrum(std::vector<double> wavelength_nm, std::vector<double> per_nm);

  [[nodiscard]] bool empty() const { return nm_.size() < 2; }
  [[nodiscard]] double min_nm() const { return nm_.front(); }
  [[nodiscard]] double max_nm() const { return nm_.back(); }
  /// The photons between two wavelengths, each counted as often as `weight` of its wavelength says.
  [[nodiscard]] double photons(double from_nm, double to_nm,
                               const std::function<double(double)>& weight) const;
  [[nodiscard]] double photons(double from_nm, double to_nm) const;

 private:
  std::vector<double> nm_, per_nm_;
};

/// The emission by a process.
struct Emission {
  std::optional<EmissionLine> line;  ///< all of it where its centre is, for those that have one
  EmissionSpectrum spectrum;         ///< empty: nothing is emitted
  std::string source;
};

}  // namespace photic::optics
