// The yardstick: scenes/benchmark-hg.toml, or benchmark-peaked.toml, as plain published codes do
// it. One loop in double with a Mersenne twister and libm, nothing shared with src/: a measure of
// speed, and an independent check of the physics. Prints collisions/s and the echo of a few gates.
//   build/dev/benchmarks/yardstick [photons [peaked]]
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string_view>
#include <vector>

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double n = 1.34147,
                 n_group = 1.36377;  // sea water at 532 nm, as `photic show` gives them
constexpr double a = 0.06, b = 0.10, c = a + b;
constexpr double height = 12, lens = 0.2, focal = 2, detector = 0.02;
constexpr double laser_radius = 0.02, laser_angle = 5e-3;  // half the divergence [rad]
constexpr int gates = 100;
constexpr double gate_step = 0.5;

struct HenyeyGreenstein {
  static constexpr double g = 0.924;
  static double p(double cosine) {
    return (1 - g * g) / (4 * pi * std::pow(1 + g * g - 2 * g * cosine, 1.5));
  }
  static double sample(double u) {
    const double s = (1 - g * g) / (1 - g + 2 * g * u);
    return (1 + g * g - s * s) / (2 * g);
  }
};

/// As a table of angles, straight between them, as measured functions are given. The formula is
/// that of Fournier and Jonasz (Proc. SPIE 3761, 62, 1999), the cumulative a sum of trapezia.
class FournierForand {
 public:
  FournierForand() {
    constexpr int angles = 4000;
    constexpr double first = 1e-10;  // 1 - cos
    for (int i = 0; i < angles; ++i) {
      x_.push_back(first * std::pow(2 / first, i / (angles - 1.0)));
      p_.push_back(formula(x_.back()));
    }
    // Inside the first angle a power of x.
    const double power = std::log(p_[1] / p_[0]) / std::log(x_[1] / x_[0]);
    below_.push_back(2 * pi * p_[0] * x_[0] / (1 + power));
    for (std::size_t i = 1; i < x_.size(); ++i)
      below_.push_back(below_[i - 1] + pi * (p_[i] + p_[i - 1]) * (x_[i] - x_[i - 1]));
    for (std::size_t i = 0; i < x_.size(); ++i) p_[i] /= below_.back();
    const double all = below_.back();
    for (double& share : below_) share /= all;
  }
  [[nodiscard]] double p(double cosine) const { return between(x_, p_, 1 - cosine); }
  [[nodiscard]] double sample(double u) const { return 1 - between(below_, x_, u); }

 private:
  static double formula(double x) {
    const double index = 1.10, slope = 3.5835, v = (3 - slope) / 2;
    const double sine_squared = x / 2;
    const double delta_180 = 4 / (3 * (index - 1) * (index - 1));
    const double d = delta_180 * sine_squared, dv = std::pow(d, v), dv_180 = std::pow(delta_180, v);
    const double cosine = 1 - x;
    return (v * (1 - d) - (1 - dv) + (d * (1 - dv) - v * (1 - d)) / sine_squared) /
               (4 * pi * (1 - d) * (1 - d) * dv) +
           (1 - dv_180) / (16 * pi * (delta_180 - 1) * dv_180) * (3 * cosine * cosine - 1);
  }
  static double between(const std::vector<double>& at, const std::vector<double>& y, double place) {
    const auto above = std::upper_bound(at.begin() + 1, at.end() - 1, place);
    const auto i = static_cast<std::size_t>(above - at.begin());
    const double t = std::max(0.0, (place - at[i - 1]) / (at[i] - at[i - 1]));
    return y[i - 1] + t * (y[i] - y[i - 1]);
  }
  std::vector<double> x_, p_, below_;
};

double fresnel(double n1, double n2, double c1, double c2) {
  const double s = (n1 * c1 - n2 * c2) / (n1 * c1 + n2 * c2);
  const double p = (n2 * c1 - n1 * c2) / (n2 * c1 + n1 * c2);
  return (s * s + p * p) / 2;
}

double common_area(double r1, double r2, double d) {
  if (d >= r1 + r2) return 0;
  if (d <= std::abs(r1 - r2)) return pi * std::min(r1, r2) * std::min(r1, r2);
  const double c1 = (d * d + r1 * r1 - r2 * r2) / (2 * d * r1);
  const double c2 = (d * d + r2 * r2 - r1 * r1) / (2 * d * r2);
  return r1 * r1 * (std::acos(c1) - c1 * std::sqrt(1 - c1 * c1)) +
         r2 * r2 * (std::acos(c2) - c2 * std::sqrt(1 - c2 * c2));
}

struct Photon {
  double x, y, z, u, v, w, weight, path;
};

/// The local estimate to a telescope that looks straight down, and the group path there.
template <class PhaseFunction>
double local_estimate(const PhaseFunction& phase, const Photon& p, double& path) {
  const double depth = -p.z;
  const double aside = std::hypot(p.x, p.y);
  double t = aside / (height + depth / n);  // tangent in air
  for (int i = 0; i < 4; ++i) {
    const double root = std::sqrt(n * n + (n * n - 1) * t * t);
    t -= (height * t + depth * t / root - aside) / (height + depth * n * n / (root * root * root));
  }
  const double cos_air = 1 / std::sqrt(1 + t * t);
  const double sin_water = t * cos_air / n;
  const double cos_water = std::sqrt(1 - sin_water * sin_water);
  const double l1 = depth / cos_water, l2 = height / cos_air;
  const double z = (l2 + l1 / n) * cos_air;
  const double blur = lens * std::abs(1 - focal * (1 / focal - 1 / z));
  const double lit = common_area(detector, blur, focal * t);
  if (lit == 0) return 0;
  const double ex = aside > 0 ? -p.x / aside : 0, ey = aside > 0 ? -p.y / aside : 0;
  const double cosine = p.u * ex * sin_water + p.v * ey * sin_water + p.w * cos_water;
  const double ratio = cos_air / cos_water;
  const double per_area = ratio / (n * n * (l2 + l1 / n) * (l2 + l1 / n * ratio * ratio));
  path = p.path + l2 + n_group * l1;
  return p.weight * (b / c) * phase.p(cosine) * per_area * pi * lens * lens * cos_air * lit /
         (pi * blur * blur) * (1 - fresnel(n, 1, cos_water, cos_air)) * std::exp(-c * l1);
}

template <class PhaseFunction>
void measure(double photons, const PhaseFunction& phase) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> uniform;
  std::array<double, gates> echo{}, squares{};
  double collisions = 0;
  const double last = 2 * height + 2 * n_group * gates * gate_step;
  const auto start = std::chrono::steady_clock::now();
  for (double k = 0; k < photons; ++k) {
    // The laser: even in solid angle about the fictitious vertex; refraction at the surface.
    const double cos_beam = 1 - uniform(engine) * (1 - std::cos(laser_angle));
    const double sin_beam = std::sqrt(1 - cos_beam * cos_beam);
    const double azimuth = 2 * pi * uniform(engine);
    const double r = (laser_radius / std::tan(laser_angle) + height) * sin_beam / cos_beam;
    const double cos_in = std::sqrt(1 - sin_beam * sin_beam / (n * n));
    Photon p{r * std::cos(azimuth),
             r * std::sin(azimuth),
             0,
             sin_beam / n * std::cos(azimuth),
             sin_beam / n * std::sin(azimuth),
             -cos_in,
             1 - fresnel(1, n, cos_beam, cos_in),
             height / cos_beam};
    while (p.weight > 1e-8) {
      const double s = -std::log(1 - uniform(engine)) / c;
      const double to_surface = p.w > 0 ? -p.z / p.w : 2 * s;
      const double l = std::min(s, to_surface);
      p.x += l * p.u, p.y += l * p.v, p.z += l * p.w, p.path += n_group * l;
      if (p.path + height - n_group * p.z > last) break;
      if (l < s) {  // reflected in the surface
        const double sine = n * std::sqrt(1 - p.w * p.w);
        if (sine < 1) p.weight *= fresnel(n, 1, p.w, std::sqrt(1 - sine * sine));
        p.z = 0, p.w = -p.w;
        continue;
      }
      ++collisions;
      double path = 0;
      const double score = local_estimate(phase, p, path);
      const double gate = (path - 2 * height) / (2 * n_group * gate_step);
      if (score > 0 && gate < gates) {
        echo[static_cast<std::size_t>(gate)] += score;
        squares[static_cast<std::size_t>(gate)] += score * score;
      }
      p.weight *= b / c;
      const double cosine = phase.sample(uniform(engine));
      const double sine = std::sqrt(1 - cosine * cosine);
      const double phi = 2 * pi * uniform(engine);
      const double cp = std::cos(phi), sp = std::sin(phi);
      const double across = std::sqrt(1 - p.w * p.w);
      const Photon q = p;
      if (across < 1e-8) {
        p.u = sine * cp, p.v = sine * sp, p.w = std::copysign(cosine, q.w);
      } else {
        p.u = sine * (q.u * q.w * cp - q.v * sp) / across + q.u * cosine;
        p.v = sine * (q.v * q.w * cp + q.u * sp) / across + q.v * cosine;
        p.w = -sine * cp * across + q.w * cosine;
      }
    }
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf("%.3g photons/s, %.3g collisions/s\n", photons / seconds, collisions / seconds);
  for (const std::size_t i : {1U, 5U, 10U, 20U, 40U}) {
    const double mean = echo[i] / photons;
    const double error = std::sqrt(squares[i]) / photons;
    std::printf("%5.2f m  echo %.4e +- %.1f %%\n", gate_step * static_cast<double>(i), mean,
                100 * error / mean);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const double photons = argc > 1 ? std::strtod(argv[1], nullptr) : 1e6;
  if (argc > 2 && std::string_view(argv[2]) == "peaked") {
    measure(photons, FournierForand());
  } else {
    measure(photons, HenyeyGreenstein());
  }
}
