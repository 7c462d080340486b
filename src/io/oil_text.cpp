#include "io/oil_text.hpp"

#include <fmt/format.h>

namespace photic::io {
namespace {

std::string property_line(const optics::OilProperty& p) {
  const std::string range =
      p.low < p.high ? fmt::format(" ({:g} to {:g})", p.low, p.high) : std::string();
  return fmt::format("{} = {:g}{} {}: {}\n", p.item, p.value, range, p.unit, p.source);
}

}  // namespace

std::string oil_text(const optics::Oil& oil, const std::vector<double>& wavelength_nm) {
  std::string out = fmt::format("Oil: {}\n\n{:>10} {:>10} {:>12} {:>16}\n", oil.name, "nm", "n",
                                "a [1/m]", "emission [1/nm]");
  for (const double nm : wavelength_nm)
    out += fmt::format("{:>10g} {:>10.4f} {:>12.4g} {:>16.4g}\n", nm, oil.refractive_index(nm),
                       oil.absorption_per_m(nm), oil.emission_per_nm(nm));
  out += fmt::format("\n{:g} photons are emitted per photon absorbed, after {:g} ns in the mean.\n",
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
  add("n", "index of refraction against air", "1", oil.refractive_index);
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
