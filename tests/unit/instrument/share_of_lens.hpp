// Through how much of the open lens a detector sees rays of a direction, by quadrature.
#pragma once

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "core/constants.hpp"
#include "instrument/telescope.hpp"

namespace photic::instrument {

/// The open lens' share through which the detector sees rays from infinitely far away that come in
/// by so much aside of the axis, per metre along it: ring by ring, how much of it lies in the disc
/// of the points p with |t + s p| < h, h being the detector's half view.
inline double share_of_lens(const Telescope<double>& t, double aside) {
  const double s = std::abs(t.per_sharp_range);
  if (s == 0) return 1;
  const double disc = t.detector_radius / t.detector_distance / s, off = aside / s;
  const double inner = t.obstruction_radius, outer = t.lens_radius;
  const auto arc = [&](double r) {
    const double cosine = (r * r + off * off - disc * disc) / (2 * r * off);
    return 2 * r * std::acos(std::clamp(cosine, -1.0, 1.0));
  };
  // The arc has square roots where rings touch the disc.
  std::array edges{inner, std::clamp(std::abs(off - disc), inner, outer),
                   std::clamp(off + disc, inner, outer), outer};
  std::ranges::sort(edges);
  using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
  double sum = 0;
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    const double middle = (edges.at(k) + edges.at(k + 1)) / 2, half = middle - edges.at(k);
    if (!(half > 0)) continue;
    // By angles those are smooth.
    sum += Rule::integrate(
        [&](double angle) { return half * std::sin(angle) * arc(middle - half * std::cos(angle)); },
        0.0, pi, 5, 1e-12);
  }
  return sum / (pi * (outer * outer - inner * inner));
}

}  // namespace photic::instrument
