#include "optics/fluorescence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/constants.hpp"
#include "core/interpolation.hpp"

namespace photic::optics {
namespace {

constexpr double last_cdom_nm = 750;
constexpr double nodes_apart_nm = 1;

/// A function at wavelengths about 1 nm apart.
template <class Function>
EmissionSpectrum sampled(double from_nm, double to_nm, const Function& per_nm) {
  if (!(from_nm < to_nm)) return {};
  const auto steps = static_cast<int>(std::ceil((to_nm - from_nm) / nodes_apart_nm));
  std::vector<double> nm, density;
  for (int i = 0; i <= steps; ++i) {
    nm.push_back(std::lerp(from_nm, to_nm, static_cast<double>(i) / steps));
    density.push_back(per_nm(nm.back()));
  }
  return {nm, density};
}

struct Gaussian {
  double share, centre_nm, sigma_nm;
  static constexpr double reach = 4.5;  ///< in sigma; 7e-6 lie beyond

  [[nodiscard]] double per_nm(double nm) const {
    const double t = (nm - centre_nm) / sigma_nm;
    return share * std::exp(-t * t / 2) / (sigma_nm * std::sqrt(2 * pi));
  }
  [[nodiscard]] double above(double nm) const {
    return share * 0.5 * std::erfc((nm - centre_nm) / (std::sqrt(2.0) * sigma_nm));
  }
};

/// Rows of a table that have one excitation.
struct Excitation {
  double nm;
  std::vector<double> emission_nm, yield_per_nm;
};

std::vector<Excitation> excitations_of(const DataTable& table) {
  const auto excitation = table.numbers("excitation_nm");
  const auto emission = table.numbers("emission_nm");
  const auto yield = table.numbers("yield_per_nm");
  std::vector<Excitation> out;
  for (std::size_t i = 0; i < excitation.size(); ++i) {
    if (yield[i] < 0) table.fail(i, "yield_per_nm", "a yield is not negative");
    if (out.empty() || excitation[i] > out.back().nm) out.push_back({excitation[i], {}, {}});
    if (excitation[i] < out.back().nm)
      table.fail(i, "excitation_nm", "excitations ascend, all emissions of one together");
    auto& row = out.back();
    if (!row.emission_nm.empty() && emission[i] <= row.emission_nm.back())
      table.fail(i, "emission_nm", "the emissions of an excitation ascend");
    const std::size_t at = row.emission_nm.size();
    if (out.size() > 1 &&
        (at >= out[0].emission_nm.size() || emission[i] != out[0].emission_nm[at]))
      table.fail(i, "emission_nm", "every excitation has the same emissions");
    row.emission_nm.push_back(emission[i]);
    row.yield_per_nm.push_back(yield[i]);
  }
  for (const auto& row : out) {
    if (row.emission_nm.size() < 2 || row.emission_nm.size() != out[0].emission_nm.size())
      table.fail(excitation.size() - 1, "emission_nm",
                 fmt::format("excitation {:g} nm has {} emissions; two or more, and all as many",
                             row.nm, row.emission_nm.size()));
  }
  return out;
}

}  // namespace

Emission chlorophyll_fluorescence(const Library& library, double laser_nm, double share_730) {
  const auto at = [&](const char* item) { return library.fluorescence.at(item); };
  const Sourced centre = at("chlorophyll_emission_centre");
  const Gaussian first{1 - share_730, centre.value, at("chlorophyll_emission_sigma").value};
  const Gaussian second{share_730, at("chlorophyll_second_centre").value,
                        at("chlorophyll_second_sigma").value};
  const Sourced shortest = at("chlorophyll_excitation_min");
  const Sourced longest = at("chlorophyll_excitation_max");
  Emission out;
  out.source = centre.source + "; excitation from " + shortest.source + " to " + longest.source;
  if (share_730 > 0) out.source += "; at 730 nm " + at("chlorophyll_second_centre").source;
  if (laser_nm < shortest.value || laser_nm > longest.value) return out;
  out.line = EmissionLine{first.centre_nm, first.above(laser_nm) + second.above(laser_nm)};
  const double from = first.centre_nm - Gaussian::reach * first.sigma_nm;
  const Gaussian& last = share_730 > 0 ? second : first;
  out.spectrum = sampled(std::max(laser_nm, from), last.centre_nm + Gaussian::reach * last.sigma_nm,
                         [&](double nm) { return first.per_nm(nm) + second.per_nm(nm); });
  return out;
}

Emission cdom_fluorescence(const Library& library, double laser_nm) {
  const auto at = [&](const char* item) { return library.fluorescence.at(item).value; };
  const auto& a0 = library.hawes_a0;
  Emission out{{}, {}, a0.source};
  if (laser_nm > a0.values.max()) return out;
  const double height = a0.values(std::max(laser_nm, a0.values.min()));
  if (height <= 0) return out;
  const double middle = at("cdom_a1") / laser_nm + at("cdom_b1_per_nm");
  const double width = 0.6 * (at("cdom_a2") / laser_nm + at("cdom_b2_per_nm"));
  out.spectrum = sampled(laser_nm, last_cdom_nm, [&](double nm) {
    const double t = (1 / nm - middle) / width;
    return height * std::exp(-t * t);
  });
  return out;
}

Emission cdom_fluorescence(const DataTable& table, double laser_nm) {
  const auto rows = excitations_of(table);
  if (laser_nm < rows.front().nm || laser_nm > rows.back().nm)
    no_data("CDOM fluorescence", laser_nm, table.name(), rows.front().nm, rows.back().nm,
            "add excitations around the laser's wavelength");
  std::vector<double> excitation_nm;
  for (const auto& row : rows) excitation_nm.push_back(row.nm);
  const auto [upper, t] = rows.size() > 1 ? interval_of(excitation_nm, laser_nm) : Interval{0, 0};
  const auto& high = rows[upper];
  const auto& low = rows[upper == 0 ? 0 : upper - 1];
  Emission out{{}, {}, table.name()};
  std::vector<double> nm, per_nm;
  for (std::size_t i = 0; i < low.emission_nm.size(); ++i) {
    const double here = low.emission_nm[i];
    const double value = std::lerp(low.yield_per_nm[i], high.yield_per_nm[i], t);
    if (here <= laser_nm) continue;
    if (nm.empty() && i > 0) {  // from the laser's wavelength on
      const double before = std::lerp(low.yield_per_nm[i - 1], high.yield_per_nm[i - 1], t);
      const double from = std::max(laser_nm, low.emission_nm[i - 1]);
      const double way = (from - low.emission_nm[i - 1]) / (here - low.emission_nm[i - 1]);
      nm.push_back(from);
      per_nm.push_back(std::lerp(before, value, way));
    }
    nm.push_back(here);
    per_nm.push_back(value);
  }
  out.spectrum = {nm, per_nm};
  return out;
}

}  // namespace photic::optics
