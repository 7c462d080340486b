#include "optics/spheres.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <utility>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "core/stop.hpp"
#include "optics/mie.hpp"

namespace photic::optics {
namespace {

using Values = std::vector<double>;

/// The integrands over ln(radius): numbers of particles times the first few of these, then times
/// the differential cross-section [m^2/sr] at each node of the angle. Places of the integrals over
/// size.
struct Of {
  enum : std::size_t { number, volume, extinction, scattering, absorption, forward, angles };
};

class Integrand {
 public:
  Integrand(const Spheres& spheres, int angles, const std::stop_token& stop)
      : spheres_(spheres),
        stop_(stop),
        wave_number_(2 * pi / spheres.wavelength_m),
        contrast_({spheres.index, -spheres.absorption_index}),
        rule_(angles),
        amplitude_(rule_.node.size()) {}

  [[nodiscard]] const GaussRule& rule() const { return rule_; }
  /// The sections by the integrals over all sizes.
  [[nodiscard]] SphereSections sections(const Values& total) const {
    const double n = total[Of::number];
    return {contrast_.scattering * total[Of::scattering] / n,
            contrast_.absorption * total[Of::absorption] / n, total[Of::volume] / n};
  }
  [[nodiscard]] std::size_t size() const { return Of::angles + rule_.node.size(); }
  [[nodiscard]] double work() const { return work_; }
  [[nodiscard]] int radii() const { return radii_; }

  /// Between two ln(radius).
  [[nodiscard]] double size_parameters(double from, double to) const {
    return wave_number_ * (std::exp(to) - std::exp(from));
  }

  /// Per ln(radius).
  void evaluate(double log_radius, Values& out) {
    break_off_if(stop_);
    const double radius = std::exp(log_radius);
    const double n = number_per_log_radius(spheres_.sizes, radius);
    const MieSphere sphere(wave_number_ * radius, contrast_.index);
    const MieEfficiencies q = sphere.efficiencies();
    const double area = n * pi * radius * radius;
    out[Of::number] = n;
    out[Of::volume] = area * 4 / 3 * radius;
    out[Of::extinction] = area * q.extinction;
    out[Of::scattering] = area * q.scattering;
    out[Of::absorption] = area * q.absorption;
    out[Of::forward] = area * q.scattering * q.mean_cosine;
    sphere.amplitudes(rule_.node, amplitude_);
    work_ += static_cast<double>(rule_.node.size()) * mie_orders(wave_number_ * radius);
    ++radii_;
    for (std::size_t i = 0; i < amplitude_.size(); ++i)
      out[Of::angles + i] = n * mueller(amplitude_[i]).s11 / (wave_number_ * wave_number_);
  }

 private:
  const Spheres& spheres_;
  const std::stop_token& stop_;
  double wave_number_;
  MieContrast contrast_;
  GaussRule rule_;
  std::vector<MieAmplitudes> amplitude_;
  double work_ = 0;
  int radii_ = 0;
};

/// A piece of the integral over sizes, and how far two rules disagree about it.
struct Panel {
  double from, to;
  Values integral, error;
};

constexpr int kronrod_points = 31, gauss_points = 15;

Panel integrate(Integrand& f, double from, double to) {
  const auto& node = boost::math::quadrature::gauss_kronrod<double, kronrod_points>::abscissa();
  const auto& kronrod = boost::math::quadrature::gauss_kronrod<double, kronrod_points>::weights();
  const auto& gauss = boost::math::quadrature::gauss<double, gauss_points>::weights();
  const double centre = (from + to) / 2, half = (to - from) / 2;
  Panel panel{from, to, Values(f.size(), 0.0), Values(f.size(), 0.0)};
  Values value(f.size());
  for (std::size_t i = 0; i < node.size(); ++i) {
    const double by_kronrod = half * kronrod[i];
    const double by_gauss = i % 2 == 0 ? half * gauss[i / 2] : 0;  // every other node is Gauss's
    for (const double side : {-1.0, 1.0}) {
      if (i == 0 && side > 0) continue;  // the centre, once
      f.evaluate(centre + side * half * node[i], value);
      for (std::size_t k = 0; k < value.size(); ++k) {
        panel.integral[k] += by_kronrod * value[k];
        panel.error[k] += (by_kronrod - by_gauss) * value[k];
      }
    }
  }
  for (double& e : panel.error) e = std::abs(e);
  return panel;
}

/// The worst of the relative errors, of extinction, scattering and angles; absorption may be no
/// more than a rounding of the two.
double worst(const Values& error, const Values& integral) {
  double out = 0;
  for (std::size_t k = 0; k < integral.size(); ++k)
    if (integral[k] > 0 && k != Of::absorption && k != Of::forward)
      out = std::max(out, error[k] / integral[k]);
  return out;
}

/// Panels that are halved where they need it.
class AdaptiveIntegral {
 public:
  AdaptiveIntegral(Integrand& f, const Values& radii_m);

  [[nodiscard]] const Values& total() const { return total_; }
  [[nodiscard]] double error() const { return worst(error_, total_); }

 private:
  void add_up();
  /// Returns whether there were any to halve.
  bool halve_the_worst(Integrand& f);

  std::vector<Panel> panels_;
  Values total_, error_;
};

// The limits to the halving of panels whose error stays up. Resonances of large spheres that hardly
// absorb are sharper than any panel; one of half a size parameter resolves all else. And ten
// seconds' worth of angles times orders are enough for very large spheres.
constexpr double narrowest_panel = 0.5;
constexpr double enough_work = 3e9;

AdaptiveIntegral::AdaptiveIntegral(Integrand& f, const Values& radii_m)
    : total_(f.size()), error_(f.size()) {
  for (std::size_t i = 1; i < radii_m.size(); ++i) {
    const double from = std::log(radii_m[i - 1]), to = std::log(radii_m[i]);
    const int pieces = static_cast<int>(std::ceil((to - from) / std::log(2.0)));  // octaves at most
    for (int k = 0; k < pieces; ++k)
      panels_.push_back(integrate(f, std::lerp(from, to, k / double(pieces)),
                                  std::lerp(from, to, (k + 1) / double(pieces))));
  }
  add_up();
  while (error() > spheres_tolerance && f.work() < enough_work && halve_the_worst(f)) add_up();
}

void AdaptiveIntegral::add_up() {
  std::fill(total_.begin(), total_.end(), 0.0);
  std::fill(error_.begin(), error_.end(), 0.0);
  for (const Panel& p : panels_) {
    for (std::size_t k = 0; k < total_.size(); ++k) {
      total_[k] += p.integral[k];
      error_[k] += p.error[k];
    }
  }
}

bool AdaptiveIntegral::halve_the_worst(Integrand& f) {
  const double share = spheres_tolerance / static_cast<double>(panels_.size());
  std::vector<Panel> next;
  for (Panel& p : panels_) {
    if (worst(p.error, total_) <= share || f.size_parameters(p.from, p.to) < narrowest_panel) {
      next.push_back(std::move(p));
    } else {
      const double middle = (p.from + p.to) / 2;
      next.push_back(integrate(f, p.from, middle));
      next.push_back(integrate(f, middle, p.to));
    }
  }
  const bool any = next.size() > panels_.size();
  panels_ = std::move(next);
  return any;
}

PhaseKey key_of(const Spheres& spheres) {
  PhaseKey key("spheres");
  key.add(spheres.wavelength_m).add(spheres.index).add(spheres.absorption_index);
  if (const auto* junge = std::get_if<Junge>(&spheres.sizes))
    return key.add(
        PhaseKey("junge").add(junge->slope).add(junge->min_radius_m).add(junge->max_radius_m));
  if (const auto* log_normal = std::get_if<LogNormal>(&spheres.sizes))
    return key.add(PhaseKey("log-normal")
                       .add(log_normal->mode_radius_m)
                       .add(log_normal->spread)
                       .add(log_normal->min_radius_m)
                       .add(log_normal->max_radius_m));
  const auto& table = std::get<SizeTable>(spheres.sizes);
  return key.add(PhaseKey("sizes").add(table.radius_m).add(table.number));
}

}  // namespace

SpheresOptics optics_of_spheres(const Spheres& spheres, const std::stop_token& stop) {
  const double largest_m = smooth_between_m(spheres.sizes).back();
  Integrand integrand(spheres, 2 * mie_orders(2 * pi / spheres.wavelength_m * largest_m) + 2, stop);
  const AdaptiveIntegral integral(integrand, smooth_between_m(spheres.sizes));
  const Values& total = integral.total();
  Values p(total.begin() + Of::angles, total.end());
  for (double& value : p) value /= total[Of::scattering];
  const SphereSections sections = integrand.sections(total);
  return {.of = spheres,
          .extinction_m2 = sections.scattering_m2 + sections.absorption_m2,
          .scattering_m2 = sections.scattering_m2,
          .absorption_m2 = sections.absorption_m2,
          .mean_cosine = total[Of::forward] / total[Of::scattering],
          .volume_m3 = sections.volume_m3,
          .phase = LegendreSeries(integrand.rule(), p),
          .error = integral.error(),
          .radii = integrand.radii()};
}

SphereSections sections_of_spheres(const Spheres& spheres, const std::stop_token& stop) {
  Integrand integrand(spheres, 2, stop);  // as few angles as there can be
  const AdaptiveIntegral integral(integrand, smooth_between_m(spheres.sizes));
  return integrand.sections(integral.total());
}

PhaseShape phase_of_spheres(std::shared_ptr<const SpheresOptics> optics) {
  PhaseShape shape;
  shape.key = key_of(optics->of);
  shape.p = [optics = std::move(optics)](double x) {
    return std::max(0.0, optics->phase.at(x));  // not a rounding below
  };
  shape.core_mass =
      2 * pi *
      boost::math::quadrature::gauss<double, 7>::integrate(shape.p, 0.0, PhaseView::x_core);
  shape = tabulated(shape);
  const double resolved = table_integral(shape);
  if (std::abs(resolved - 1) > 1e-4) {
    throw InputError(
        {{"", 0, 0,
          fmt::format("the phase function of these spheres has detail that is too "
                      "fine: as tabulated by the program it integrates to {:.5f}, not 1",
                      resolved),
          "take smaller spheres, or a wider range of sizes"}});
  }
  return shape;
}

std::shared_ptr<const SpheresOptics> SpheresCache::operator()(const Spheres& spheres,
                                                              const std::stop_token& stop) const {
  return known_(spheres, [&] {
    return std::make_shared<const SpheresOptics>(optics_of_spheres(spheres, stop));
  });
}

SphereSections SpheresCache::sections(const Spheres& spheres, const std::stop_token& stop) const {
  return sections_(spheres, [&] { return sections_of_spheres(spheres, stop); });
}

std::shared_ptr<const PhaseShape> SpheresCache::phase(const Spheres& spheres,
                                                      const std::stop_token& stop) const {
  return phase_(spheres, [&] {
    return std::make_shared<const PhaseShape>(phase_of_spheres((*this)(spheres, stop)));
  });
}

}  // namespace photic::optics
