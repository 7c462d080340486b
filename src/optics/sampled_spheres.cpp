#include "optics/sampled_spheres.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <future>
#include <utility>
#include <vector>

#include "core/constants.hpp"
#include "core/stop.hpp"
#include "optics/mie.hpp"
#include "optics/phase_between_angles.hpp"

namespace photic::optics {
namespace {

constexpr double finest_size_step = 0.25;  ///< of size parameters, between large spheres
constexpr double max_size_steps = 4000;    ///< of that kind
constexpr double ratio_step = 0.02;      ///< of the logarithm of the radius, between small spheres
constexpr std::size_t size_blocks = 16;  ///< of sizes, summed side by side

/// Size parameters, each with the width in ln(radius) that it stands for: even steps of
/// t = x / step + ln(x) / ratio.
struct SampledSizes {
  std::vector<double> x, width;

  SampledSizes(double smallest, double largest) {
    const double step = std::max(finest_size_step, (largest - smallest) / max_size_steps);
    const auto t = [step](double at) { return at / step + std::log(at) / ratio_step; };
    const double first = t(smallest), all = t(largest) - first;
    const int count = std::max(2, static_cast<int>(std::ceil(all)));
    for (int i = 0; i <= count; ++i) {
      const bool end = i == 0 || i == count;
      x.push_back(i == 0       ? smallest
                  : i == count ? largest
                               : inverse(t, first + all * i / count, x.back(), largest));
      width.push_back((end ? 0.5 : 1) * all / count / (x.back() / step + 1 / ratio_step));
    }
  }

 private:
  template <class F>
  static double inverse(const F& t, double wanted, double low, double high) {
    std::uintmax_t steps = 100;
    const auto [below, above] =
        boost::math::tools::toms748_solve([&](double x) { return t(x) - wanted; }, low, high,
                                          boost::math::tools::eps_tolerance<double>(40), steps);
    return below;
  }
};

/// SizeSums over some of the sizes.
struct SizeSums {
  double number = 0, extinction = 0, scattering = 0, absorption = 0, forward = 0;
  std::vector<double> s11;

  void operator+=(const SizeSums& other) {
    number += other.number;
    extinction += other.extinction;
    scattering += other.scattering;
    absorption += other.absorption;
    forward += other.forward;
    for (std::size_t i = 0; i < s11.size(); ++i) s11[i] += other.s11[i];
  }
};

/// Adds up spheres whose sizes are equal modulo the number of size_blocks: large and small ones.
SizeSums sum_block(const Spheres& spheres, const SampledSizes& sizes,
                   const std::vector<double>& cosines, std::size_t first,
                   const std::stop_token& stop) {
  const MieContrast contrast({spheres.index, -spheres.absorption_index});
  const double wave_number = 2 * pi / spheres.wavelength_m;
  std::vector<MieAmplitudes> amplitude(cosines.size());
  SizeSums sums;
  sums.s11.assign(cosines.size(), 0.0);
  for (std::size_t i = first; i < sizes.x.size(); i += size_blocks) {
    break_off_if(stop);
    const double radius = sizes.x[i] / wave_number;
    const double n = number_per_log_radius(spheres.sizes, radius) * sizes.width[i];
    const MieSphere sphere(sizes.x[i], contrast.index);
    const MieEfficiencies q = sphere.efficiencies();
    const double area = n * pi * radius * radius;
    sums.number += n;
    sums.extinction += area * q.extinction;
    sums.scattering += area * q.scattering;
    sums.absorption += area * q.absorption;
    sums.forward += area * q.scattering * q.mean_cosine;
    sphere.amplitudes(cosines, amplitude);
    for (std::size_t k = 0; k < amplitude.size(); ++k)
      sums.s11[k] += n * mueller(amplitude[k]).s11 / (wave_number * wave_number);
  }
  return sums;
}

SizeSums sum_over_sizes(const Spheres& spheres, const std::vector<double>& cosines,
                        const std::stop_token& stop) {
  const std::vector<double> ends = smooth_between_m(spheres.sizes);
  const double wave_number = 2 * pi / spheres.wavelength_m;
  const SampledSizes sizes(wave_number * ends.front(), wave_number * ends.back());
  std::vector<std::future<SizeSums>> parts;
  for (std::size_t first = 0; first < size_blocks; ++first)
    parts.push_back(std::async(std::launch::async, [&, first] {
      return sum_block(spheres, sizes, cosines, first, stop);
    }));
  SizeSums sums = parts.front().get();
  for (std::size_t i = 1; i < size_blocks; ++i) sums += parts[i].get();
  return sums;
}

SampledSpheres means_of(const Spheres& spheres, const SizeSums& sums) {
  const MieContrast contrast({spheres.index, -spheres.absorption_index});
  SampledSpheres out;
  out.scattering_m2 = contrast.scattering * sums.scattering / sums.number;
  out.absorption_m2 = contrast.absorption * sums.absorption / sums.number;
  out.extinction_m2 = out.scattering_m2 + out.absorption_m2;
  out.mean_cosine = sums.forward / sums.scattering;
  return out;
}

}  // namespace

SampledSpheres sampled_spheres(const Spheres& spheres, const std::stop_token& stop) {
  const PhaseAngles angles;
  std::vector<double> cosines;
  for (const double degrees : angles.degrees())
    cosines.push_back(std::cos(degrees * radian_per_degree));
  SizeSums sums = sum_over_sizes(spheres, cosines, stop);
  SampledSpheres out = means_of(spheres, sums);
  for (double& p : sums.s11) p /= sums.scattering;
  PhaseBetweenAngles phase = phase_between_angles(sums.s11);
  out.phase = std::move(phase.shape);
  out.integral = phase.integral;
  return out;
}

SampledSpheres sampled_sections(const Spheres& spheres, const std::stop_token& stop) {
  return means_of(spheres, sum_over_sizes(spheres, {}, stop));
}

std::shared_ptr<const SampledSpheres> SampledSpheresCache::operator()(
    const Spheres& spheres, const std::stop_token& stop) const {
  return known_(spheres, [&] {
    return std::make_shared<const SampledSpheres>(sampled_spheres(spheres, stop));
  });
}

std::shared_ptr<const SampledSpheres> SampledSpheresCache::sections(
    const Spheres& spheres, const std::stop_token& stop) const {
  return sections_(spheres, [&] {
    return std::make_shared<const SampledSpheres>(sampled_sections(spheres, stop));
  });
}

}  // namespace photic::optics
