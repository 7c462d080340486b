#include "io/oil_text.hpp"

#include <fmt/format.h>

#include <functional>

#include "io/text_columns.hpp"

namespace photic::io {
namespace {

std::string property_line(const optics::OilProperty& p) {
  const std::string range =
      p.low < p.high ? fmt::format(" ({:g} to {:g})", p.low, p.high) : std::string();
  return fmt::format("{} = {:g}{} {}: {}\n", p.item, p.value, range, p.unit, p.source);
}

}  // namespace

std::string oil_text(const optics::Oil& oil, const std::vector<double>& wavelength_nm) {
  const auto column = [&](const char* heading, const auto& of, const char* format) {
    std::vector<double> values;
    for (const double nm : wavelength_nm) values.push_back(of(nm));
    return text_column(heading, values, 0, values.size(), format);
  };
  std::string out = fmt::format("Oil: {}\n\n", oil.name);
  out += side_by_side({column("nm", std::identity(), "{:g}"),
                       column("n", oil.refractive_index, "{:.4f}"),
                       column("a [1/m]", oil.absorption_per_m, "{:.4g}"),
                       column("emission [1/nm]", oil.emission_per_nm, "{:.4g}")});
  out += fmt::format("\n{:g} photons are emitted per photon absorbed, after {:g} ns on average.\n",
                     oil.yield, oil.lifetime_ns);
  if (!oil.properties.empty()) out += "\n";
  for (const auto& property : oil.properties) out += property_line(property);
  return out;
}

SpectralTable oil_table(const optics::Oil& oil, const std::vector<double>& wavelength_nm) {
  SpectralTable table{.what = "optical properties of an oil", .wavelength_nm = wavelength_nm};
  const auto add = [&](const char* name, const char* long_name, const char* units,
                       const optics::OilSpectrum& spectrum) {
    table.columns.push_back({name, name, long_name, units, {}});
    for (const double nm : wavelength_nm) table.columns.back().values.push_back(spectrum(nm));
  };
  add("n", "index of refraction relative to air", "1", oil.refractive_index);
  add("a_per_m", "absorption coefficient", "m-1", oil.absorption_per_m);
  add("emission_per_nm", "spectrum of emitted photons, 1 in all", "nm-1", oil.emission_per_nm);
  table.numbers = {{"yield", "photons emitted per photon absorbed", "1", oil.yield},
                   {"lifetime_ns", "mean time from absorption to emission", "ns", oil.lifetime_ns}};
  for (const auto& property : oil.properties) {
    table.sources.push_back(property_line(property));
    table.sources.back().pop_back();  // the end of the line
  }
  return table;
}

}  // namespace photic::io
