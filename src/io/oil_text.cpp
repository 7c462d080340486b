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

}  // namespace photic::io
