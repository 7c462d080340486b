// Snell's law and Fresnel's equations at a plane interface between two transparent media.
// Source: Born & Wolf, Principles of Optics, 7th ed., section 1.5.2, eqs. (32) and (35).
#pragma once

#include <cmath>
#include <limits>

#include "core/lanes.hpp"

namespace photic::optics {

/// The shares of unpolarised light at an interface.
template <class T>
struct Refraction {
  T cos_transmitted;  ///< cosine of the refracted ray to the normal; 0 in total reflection
  T reflectance;      ///< share of the flux that is reflected; 1 in total reflection
};

/// The shares of light polarised across the plane of incidence (s) and in it (p).
template <class T>
struct ByPolarisation {
  T s, p;
  [[nodiscard]] T mean() const { return T(0.5) * (s + p); }
};

/// Reflectances for the cosines of incidence and refraction in media of index n1 and n2.
template <class T>
ByPolarisation<T> fresnel_reflectances(const T& n1, const T& n2, const T& c1, const T& c2) {
  // Equal media at exactly grazing incidence would be 0/0; nothing is reflected there.
  const T tiny = T(std::numeric_limits<Element<T>>::min());
  const T s_sum = n1 * c1 + n2 * c2 + tiny;
  const T p_sum = n2 * c1 + n1 * c2 + tiny;
  const T s = (n1 * c1 - n2 * c2) * p_sum;
  const T p = (n2 * c1 - n1 * c2) * s_sum;
  const T sums = s_sum * p_sum + tiny;
  const T inverse = T(1) / sums;
  return {(s * inverse) * (s * inverse), (p * inverse) * (p * inverse)};
}
/// The same of unpolarised light.
template <class T>
T fresnel_reflectance(const T& n1, const T& n2, const T& c1, const T& c2) {
  return fresnel_reflectances(n1, n2, c1, c2).mean();
}

/// Light in a medium of index n1 meets one of index n2 under an angle of cosine cos_incident, 0
/// to 1.
template <class T>
Refraction<T> refract(const T& n1, const T& n2, const T& cos_incident) {
  using std::sqrt;
  // (n2 cos_transmitted)^2, in a form that keeps its digits at grazing incidence and for n1 near
  // n2.
  const T square = (n2 - n1) * (n2 + n1) + n1 * n1 * cos_incident * cos_incident;
  const Mask<T> total = square < T(0);
  const T c2 = sqrt(select(total, T(0), square)) / n2;
  return {c2, select(total, T(1), fresnel_reflectance(n1, n2, cos_incident, c2))};
}

}  // namespace photic::optics
