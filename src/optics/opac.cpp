#include "optics/opac.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/interpolation.hpp"
#include "optics/library.hpp"

namespace photic::optics {
namespace {

constexpr double m_per_nm = 1e-9, m_per_um = 1e-6;

/// The names of the rows: component and relative humidity.
std::vector<std::string> component_names(const DataTable& table) {
  std::vector<std::string> out = table.texts("component");
  const auto humidity = table.numbers("relative_humidity_percent");
  for (std::size_t i = 0; i < out.size(); ++i) out[i] += fmt::format("-{:g}", humidity[i]);
  return out;
}

/// Without the largest spheres: cross-sectional area is distributed as numbers are, about a median
/// e^(2 s^2) times theirs (s the logarithm of the spread), and 1e-9 of it is more than six s
/// above. Straight ahead, where light goes as the fourth power of the radius, it is below 1e-3.
LogNormal without_the_largest(LogNormal sizes) {
  const double s = std::log(sizes.spread);
  sizes.max_radius_m =
      std::min(sizes.max_radius_m, sizes.mode_radius_m * std::exp(2 * s * s + 6 * s));
  return sizes;
}

}  // namespace

Opac::Opac(const DataTable& indices, const DataTable& sizes) : source_(source_of(sizes)) {
  const auto size_name = component_names(sizes);
  const auto mode = sizes.numbers("mode_radius_um"), spread = sizes.numbers("spread");
  const auto min = sizes.numbers("min_radius_um"), max = sizes.numbers("max_radius_um");
  for (std::size_t i = 0; i < size_name.size(); ++i) {
    components_[size_name[i]].sizes =
        without_the_largest({mode[i] * m_per_um, spread[i], min[i] * m_per_um, max[i] * m_per_um});
  }
  const auto index_name = component_names(indices);
  const auto nm = indices.numbers("wavelength_nm"), n = indices.numbers("n"),
             k = indices.numbers("k");
  for (std::size_t i = 0; i < index_name.size(); ++i) {
    const auto found = components_.find(index_name[i]);
    if (found == components_.end()) indices.fail(i, "component", "there are no sizes for it");
    Component& c = found->second;
    if (!c.wavelength_nm.empty() && nm[i] <= c.wavelength_nm.back())
      indices.fail(i, "wavelength_nm", "wavelengths of a component ascend");
    c.wavelength_nm.push_back(nm[i]);
    c.n.push_back(n[i]);
    c.k.push_back(k[i]);
  }
  for (std::size_t i = 0; i < size_name.size(); ++i) {
    if (components_.at(size_name[i]).wavelength_nm.size() < 2)
      sizes.fail(i, "component", "there is no spectrum of its refractive index");
  }
}

Spheres Opac::spheres(const std::string& component, double nm) const {
  const auto found = components_.find(component);
  if (found == components_.end()) {
    std::vector<std::string> known;
    for (const auto& [name, unused] : components_) known.push_back(name);
    no_model("OPAC", component, fmt::format("{}", fmt::join(known, ", ")));
  }
  const Component& c = found->second;
  const auto& w = c.wavelength_nm;
  if (!(nm >= w.front() && nm <= w.back()))
    no_data("OPAC", nm, source_, w.front(), w.back(), "choose another wavelength");
  const auto [i, t] = interval_of(w, nm);
  return {nm * m_per_nm, std::lerp(c.n[i - 1], c.n[i], t), geometric_lerp(c.k[i - 1], c.k[i], t),
          c.sizes};
}

AerosolOptics Opac::at(const SampledSpheresCache& cache, const std::string& component, double nm,
                       Phases phases, const std::stop_token& stop) const {
  const Spheres here = spheres(component, nm);
  const auto there = phases == Phases::wanted ? cache(here, stop) : cache.sections(here, stop);
  const auto at_550 = cache.sections(spheres(component, 550), stop);
  AerosolOptics out;
  out.extinction = there->extinction_m2 / at_550->extinction_m2;
  out.absorption = there->absorption_m2 / at_550->extinction_m2;
  out.g = there->mean_cosine;
  out.phase = there->phase;
  out.source = source_;
  return out;
}

}  // namespace photic::optics
