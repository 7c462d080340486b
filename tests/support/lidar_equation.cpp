#include "support/lidar_equation.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>

#include "core/constants.hpp"

namespace photic::test {
namespace {

using Vec = Vec3<double>;
using boost::math::quadrature::gauss;
using boost::math::quadrature::gauss_kronrod;

/// Unpolarised reflectance from angles (Born & Wolf, section 1.5.2).
double reflectance(double n1, double n2, double angle1) {
  const double s = n1 / n2 * std::sin(angle1);
  if (s >= 1) return 1;
  if (angle1 < 1e-7) return std::pow((n1 - n2) / (n1 + n2), 2);
  const double angle2 = std::asin(s);
  const double rs = std::sin(angle1 - angle2) / std::sin(angle1 + angle2);
  const double rp = std::tan(angle1 - angle2) / std::tan(angle1 + angle2);
  return (rs * rs + rp * rp) / 2;
}

/// Refracts a unit vector at the horizontal surface.
Vec refracted(const Vec& k, double n1, double n2) {
  const Vec out{k.x * n1 / n2, k.y * n1 / n2, 0};
  const double z = std::sqrt(1 - out.x * out.x - out.y * out.y);
  return {out.x, out.y, k.z > 0 ? z : -z};
}

double optical_depth(const EquationWater& water, bool back, double depth1, double depth2) {
  const auto [low, high] = std::minmax(depth1, depth2);
  double tau = 0;
  for (std::size_t k = 0; k < water.layers.size(); ++k) {
    const double bottom = k + 1 < water.layers.size() ? water.layers[k + 1].top_m : 1e9;
    const double inside = std::min(high, bottom) - std::max(low, water.layers[k].top_m);
    tau +=
        std::max(0.0, inside) * (back ? water.layers[k].c_back_per_m : water.layers[k].c_out_per_m);
  }
  return tau;
}

const EquationLayer& layer_at(const EquationWater& water, double depth) {
  std::size_t k = water.layers.size() - 1;
  while (k > 0 && water.layers[k].top_m > depth) --k;
  return water.layers[k];
}

/// How light from a point gets to the lens' centre.
struct WayBack {
  Vec leaving, arriving;
  double in_water = 0, in_air = 0, apparent = 0, solid_angle = 0, transmittance = 1;
};

/// Where a ray from the point crosses the plane through the lens' centre across the arriving ray.
Vec landing(const Vec& point, const Vec& leaving, double n, const Vec& centre, const Vec& normal) {
  const Vec crossing = point + (-point.z / leaving.z) * leaving;
  const Vec k = refracted(leaving, n, 1.0);
  return crossing + (dot(centre - crossing, normal) / dot(k, normal)) * k;
}

WayBack through_surface(const Vec& point, const scene::Telescope& telescope, double n) {
  const double depth = -point.z;
  const double height = telescope.position_m.z;
  const double dx = telescope.position_m.x - point.x;
  const double dy = telescope.position_m.y - point.y;
  const double aside = std::hypot(dx, dy);
  double r = 0;  // horizontal distance of the crossing from the point
  if (aside > 0) {
    const auto snell = [&](double x) {
      return n * x / std::hypot(x, depth) - (aside - x) / std::hypot(aside - x, height);
    };
    std::uintmax_t steps = 200;
    const auto root =
        boost::math::tools::toms748_solve(snell, 0.0, aside, snell(0.0), snell(aside),
                                          boost::math::tools::eps_tolerance<double>(50), steps);
    r = (root.first + root.second) / 2;
  }
  const double ex = aside > 0 ? dx / aside : 1;
  const double ey = aside > 0 ? dy / aside : 0;
  WayBack way;
  way.in_water = std::hypot(r, depth);
  way.in_air = std::hypot(aside - r, height);
  way.leaving = {ex * r / way.in_water, ey * r / way.in_water, depth / way.in_water};
  way.arriving = {ex * (aside - r) / way.in_air, ey * (aside - r) / way.in_air,
                  height / way.in_air};
  way.transmittance = 1 - reflectance(n, 1.0, std::atan2(r, depth));
  way.apparent = way.in_air + way.in_water / n;

  const double step = 1e-5;  // rad; central differences
  const Vec u =
      normalised(cross(way.leaving, std::abs(way.leaving.z) > 0.9 ? Vec{1, 0, 0} : Vec{0, 0, 1}));
  const Vec v = cross(way.leaving, u);
  const auto moved = [&](const Vec& across) {
    const Vec plus = landing(point, normalised(way.leaving + step * across), n,
                             telescope.position_m, way.arriving);
    const Vec minus = landing(point, normalised(way.leaving - step * across), n,
                              telescope.position_m, way.arriving);
    return (0.5 / step) * (plus - minus);
  };
  const double area_per_solid_angle = length(cross(moved(u), moved(v)));
  const double area = pi / 4 *
                      (telescope.diameter_m * telescope.diameter_m -
                       telescope.obstruction_diameter_m * telescope.obstruction_diameter_m);
  way.solid_angle =
      area * std::abs(dot(way.arriving, normalised(telescope.direction))) / area_per_solid_angle;
  return way;
}

/// Solid angle of the open lens by an integral over its area.
double lens_from(const Vec& point, const scene::Telescope& telescope) {
  const Vec axis = normalised(telescope.direction);
  const Vec u = normalised(cross(axis, std::abs(axis.z) > 0.9 ? Vec{1, 0, 0} : Vec{0, 0, 1}));
  const Vec v = cross(axis, u);
  const auto ring = [&](double r) {
    const auto at = [&](double azimuth) {
      const Vec d =
          telescope.position_m + (r * std::cos(azimuth)) * u + (r * std::sin(azimuth)) * v - point;
      const double s = length(d);
      return std::abs(dot(d, axis)) / (s * s * s);
    };
    return r * gauss<double, 30>::integrate(at, 0.0, 2 * pi);
  };
  return gauss<double, 30>::integrate(ring, telescope.obstruction_diameter_m / 2,
                                      telescope.diameter_m / 2);
}

WayBack in_water(const Vec& point, const scene::Telescope& telescope) {
  WayBack way;
  const Vec d = telescope.position_m - point;
  way.in_water = way.apparent = length(d);
  way.leaving = way.arriving = normalised(d);
  way.solid_angle = lens_from(point, telescope);
  return way;
}

/// One ray of the laser's cone in the water: where it starts, where it goes, what came through, its
/// path so far.
struct Ray {
  Vec start, direction;
  double weight, path;
};

Ray ray_in_water(const scene::Source& source, const EquationWater& water, double angle,
                 double azimuth) {
  const Vec axis = normalised(source.direction);
  const Vec u = normalised(cross(axis, std::abs(axis.z) > 0.9 ? Vec{1, 0, 0} : Vec{0, 0, 1}));
  const Vec v = cross(axis, u);
  const Vec k = std::cos(angle) * axis + (std::sin(angle) * std::cos(azimuth)) * u +
                (std::sin(angle) * std::sin(azimuth)) * v;
  const double behind = source.diameter_m / 2 / std::tan(source.half_divergence_mrad * 1e-3);
  const Vec on_disc = source.position_m + (behind / std::cos(angle)) * k - behind * axis;
  if (source.position_m.z < 0) return {on_disc, k, 1.0, 0.0};
  const double to_surface = on_disc.z / -k.z;
  return {on_disc + to_surface * k, refracted(k, 1.0, water.n_out),
          1 - reflectance(1.0, water.n_out, std::acos(-k.z)), to_surface};
}

/// Whether turning everything about one vertical changes nothing: all azimuths are then the same.
bool about_one_vertical(const scene::Source& source, const scene::Telescope& telescope) {
  const auto vertical = [](const Vec& v) { return v.x == 0 && v.y == 0; };
  return vertical(source.direction) && vertical(telescope.direction) &&
         vertical(telescope.position_m - source.position_m);
}

}  // namespace

double overlap_by_integration(const scene::Telescope& telescope, double z, double tan_psi) {
  const double f = telescope.focal_length_m;
  const double x = telescope.detector_distance_m();
  const double defocus = std::abs(1 - x * (1 / f - 1 / z));
  const double blur = telescope.diameter_m / 2 * defocus;
  const double shadow = telescope.obstruction_diameter_m / 2 * defocus;
  const double r = telescope.effective_detector_diameter_m() / 2;
  const double q = x * tan_psi;
  // The share of a circle of radius s about the image's centre that lies on the detector.
  const auto share = [&](double s) {
    if (s + q <= r) return 1.0;
    if (s >= r + q || q >= r + s) return 0.0;
    return std::acos(std::clamp((s * s + q * q - r * r) / (2 * s * q), -1.0, 1.0)) / pi;
  };
  if (blur < 1e-9) return q < r ? 1.0 : 0.0;
  // The integrand has kinks where the circle touches the detector's rim.
  std::vector<double> edges{shadow, std::clamp(std::abs(r - q), shadow, blur),
                            std::clamp(r + q, shadow, blur), blur};
  std::sort(edges.begin(), edges.end());
  double sum = 0;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (edges[i] <= edges[i - 1]) continue;
    sum += gauss_kronrod<double, 31>::integrate([&](double s) { return s * share(s); },
                                                edges[i - 1], edges[i], 8, 1e-9);
  }
  return sum * 2 / (blur * blur - shadow * shadow);
}

std::vector<double> first_order_echo(const scene::Source& source, const scene::Telescope& telescope,
                                     const EquationWater& water,
                                     const std::vector<double>& gate_edges_m) {
  const bool submerged = telescope.position_m.z < 0;
  const Vec axis = normalised(telescope.direction);
  std::vector<double> echo(gate_edges_m.size() - 1, 0.0);

  const auto add_ray = [&](const Ray& ray, double ray_weight) {
    const auto point_at = [&](double s) { return ray.start + s * ray.direction; };
    const auto way_back = [&](const Vec& point) {
      return submerged ? in_water(point, telescope)
                       : through_surface(point, telescope, water.n_back);
    };
    const auto path_at = [&](double s) {
      const WayBack way = way_back(point_at(s));
      return ray.path + s * water.group_out + way.in_air + way.in_water * water.group_back;
    };
    const auto density = [&](double s) {
      const Vec point = point_at(s);
      const WayBack way = way_back(point);
      const double cos_off_axis = -dot(way.arriving, axis);
      if (cos_off_axis <= 0) return 0.0;
      const double tan_psi =
          std::sqrt(std::max(0.0, 1 - cos_off_axis * cos_off_axis)) / cos_off_axis;
      const double eta = overlap_by_integration(telescope, way.apparent * cos_off_axis, tan_psi);
      const double depth = -point.z;
      const double steep_out = std::abs(ray.direction.z);
      const double steep_back = std::abs(way.leaving.z);
      const double tau =
          optical_depth(water, false, -ray.start.z, depth) / steep_out +
          optical_depth(water, true, depth, submerged ? -telescope.position_m.z : 0.0) / steep_back;
      return layer_at(water, depth).turning_per_m * water.phase(dot(ray.direction, way.leaving)) *
             way.solid_angle * way.transmittance * eta * std::exp(-tau);
    };
    // Distances along the ray of the gate edges and of the layers' edges.
    const auto distance_of = [&](double path) {
      if (path_at(1e-6) >= path) return 0.0;
      double high = 1.0;
      while (path_at(high) < path) high *= 2;
      std::uintmax_t steps = 200;
      const auto root =
          boost::math::tools::toms748_solve([&](double s) { return path_at(s) - path; }, 1e-6, high,
                                            boost::math::tools::eps_tolerance<double>(40), steps);
      return (root.first + root.second) / 2;
    };
    double low = distance_of(gate_edges_m.front());
    for (std::size_t g = 0; g < echo.size(); ++g) {
      const double high = distance_of(gate_edges_m[g + 1]);
      std::vector<double> cuts{low, high};
      for (const auto& layer : water.layers) {
        const double s = (ray.start.z + layer.top_m) / -ray.direction.z;
        if (s > low && s < high) cuts.push_back(s);
      }
      std::sort(cuts.begin(), cuts.end());
      for (std::size_t i = 1; i < cuts.size(); ++i) {
        if (cuts[i] > cuts[i - 1])
          echo[g] += ray_weight * gauss<double, 20>::integrate(density, cuts[i - 1], cuts[i]);
      }
      low = high;
    }
  };

  // The cone: uniform in solid angle, so uniform in 1 - cos and in azimuth.
  const double widest = 1 - std::cos(source.half_divergence_mrad * 1e-3);
  constexpr int rings = 64;
  const int azimuths = about_one_vertical(source, telescope) ? 1 : 12;
  for (int i = 0; i < rings; ++i) {
    const double angle = std::acos(1 - widest * (i + 0.5) / rings);
    for (int j = 0; j < azimuths; ++j) {
      const Ray ray = ray_in_water(source, water, angle, 2 * pi * (j + 0.5) / azimuths);
      add_ray(ray, ray.weight / (rings * azimuths));
    }
  }
  return echo;
}

}  // namespace photic::test
