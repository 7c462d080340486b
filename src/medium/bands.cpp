#include "medium/bands.hpp"

#include <algorithm>
#include <cmath>

namespace photic::medium {
namespace {

constexpr double max_apart_nm = 5;

/// The places where the spectrum is cut: at the ends, at filters, and between so that no piece is
/// too long.
std::vector<double> cuts_of(const optics::EmissionSpectrum& spectrum,
                            const std::vector<std::optional<Filter>>& filters) {
  std::vector<double> given{spectrum.min_nm(), spectrum.max_nm()};
  for (const auto& filter : filters) {
    if (!filter) continue;
    for (const double nm : filter->cuts_nm)
      if (nm > spectrum.min_nm() && nm < spectrum.max_nm()) given.push_back(nm);
  }
  std::ranges::sort(given);
  std::vector<double> cuts{given.front()};
  for (std::size_t i = 1; i < given.size(); ++i) {
    const double from = given[i - 1];
    const double way = given[i] - from;
    const auto pieces = static_cast<int>(std::ceil(way / max_apart_nm));
    for (int k = 1; k <= pieces; ++k) cuts.push_back(from + way * k / pieces);
  }
  return cuts;
}

}  // namespace

std::vector<BandLine> cut_into_lines(const optics::EmissionSpectrum& spectrum,
                                     const std::vector<bool>& counts_all,
                                     const std::vector<std::optional<Filter>>& filters) {
  std::vector<BandLine> out;
  if (spectrum.empty()) return out;
  const auto cuts = cuts_of(spectrum, filters);
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const double low = cuts[i - 1];
    const double high = cuts[i];
    BandLine line;
    line.photons = spectrum.photons(low, high);
    if (!(line.photons > 0)) continue;
    const auto mean = [&](const auto& of_wavelength) {
      return spectrum.photons(low, high, of_wavelength) / line.photons;
    };
    line.wavelength_nm = mean([](double nm) { return nm; });
    bool counted = false;
    for (std::size_t c = 0; c < filters.size(); ++c) {
      line.counted_by.push_back(filters[c]      ? mean(filters[c]->transmission)
                                : counts_all[c] ? 1
                                                : 0);
      counted = counted || line.counted_by.back() > 0;
    }
    if (counted) out.push_back(std::move(line));
  }
  return out;
}

}  // namespace photic::medium
