#include "optics/emission.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <utility>

#include "core/error.hpp"

namespace photic::optics {

EmissionSpectrum::EmissionSpectrum(std::vector<double> wavelength_nm, std::vector<double> per_nm)
    : nm_(std::move(wavelength_nm)), per_nm_(std::move(per_nm)) {
  expect(nm_.size() == per_nm_.size(), "a spectrum has a number for each wavelength");
}

double EmissionSpectrum::photons(double from_nm, double to_nm,
                                 const std::function<double(double)>& weight) const {
  double sum = 0;
  const auto first = std::ranges::upper_bound(nm_, from_nm) - nm_.begin();
  for (auto i = std::max<std::size_t>(1, first); i < nm_.size() && nm_[i - 1] < to_nm; ++i) {
    const double low = std::max(from_nm, nm_[i - 1]);
    const double high = std::min(to_nm, nm_[i]);
    if (low >= high) continue;
    const auto density = [&](double nm) {
      return weight(nm) *
             std::lerp(per_nm_[i - 1], per_nm_[i], (nm - nm_[i - 1]) / (nm_[i] - nm_[i - 1]));
    };
    sum += boost::math::quadrature::gauss<double, 7>::integrate(density, low, high);
  }
  return sum;
}

double EmissionSpectrum::photons(double from_nm, double to_nm) const {
  return photons(from_nm, to_nm, [](double) { return 1.0; });
}

}  // namespace photic::optics
