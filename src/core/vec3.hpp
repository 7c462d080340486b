// Three-dimensional vectors over a lane type. z is up; directions are propagation directions.
#pragma once

#include <cmath>
#include <limits>

#include "core/lanes.hpp"

namespace photic {

template <class T>
struct Vec3 {
  T x, y, z;

  friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend constexpr Vec3 operator*(const T& s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

template <class T>
constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
T length(const Vec3<T>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// By how much a + d is longer than a, to the last digits of d, however much longer a is.
/// `lengths`: of both.
template <class T>
T longer_by(const Vec3<T>& a, const Vec3<T>& d, const T& lengths) {
  return dot(d, a + (a + d)) / (lengths + T(std::numeric_limits<Element<T>>::min()));
}

/// a / |a|; a must not be zero.
template <class T>
Vec3<T> normalised(const Vec3<T>& a) {
  return (T(1) / length(a)) * a;
}

template <class T>
constexpr Vec3<T> select(const Mask<T>& mask, const Vec3<T>& yes, const Vec3<T>& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

/// Vectors of another element type (a scene is written in double, a walk may run in float).
template <class T, class U>
constexpr Vec3<T> vec3_cast(const Vec3<U>& a) {
  return {T(a.x), T(a.y), T(a.z)};
}

/// 1 - cos of the angle between two unit vectors, exact near zero (where 1 - dot(a, b) has no
/// digits).
template <class T>
constexpr T one_minus_cos(const Vec3<T>& a, const Vec3<T>& b) {
  const Vec3<T> d = a - b;
  return T(0.5) * dot(d, d);
}

/// The unit vector at 1 - cos(angle) = x and azimuth given by its cosine and sine about the unit
/// vector w. Source: the branch-free orthonormal basis of Duff et al., J. Comput. Graph. Tech.
/// 6(1), 1 (2017), multiplied out.
template <class T>
Vec3<T> turned(const Vec3<T>& w, const T& x, const T& cos_azimuth, const T& sin_azimuth) {
  using std::abs;
  using std::copysign;
  using std::sqrt;
  const T sine = sqrt(x * (T(2) - x));
  const T a = sine * cos_azimuth;
  const T b = copysign(sine, w.z) * sin_azimuth;
  const T tilt = (a * w.x + b * w.y) / (T(1) + abs(w.z));
  const T cosine = T(1) - x;
  const T along = cosine - tilt;
  const Vec3<T> out{a + along * w.x, b + along * w.y, along * w.z - copysign(T(1), w.z) * tilt};
  return out;
}

}  // namespace photic
