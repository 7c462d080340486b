#include "io/air_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace photic::io {
namespace {

/// Of molecules, ozone, scattering and absorption by aerosols.
std::array<double, 4> optical_depths(const optics::AirOptics& air) {
  std::array<double, 4> depth{};
  for (const optics::AirLayer& layer : air.layers) {
    const double metres = (layer.top_km - layer.bottom_km) * 1e3;
    depth[0] += layer.molecules_b_per_m * metres;
    depth[1] += layer.ozone_a_per_m * metres;
    depth[2] += layer.aerosols_b_per_m * metres;
    depth[3] += layer.aerosols_a_per_m * metres;
  }
  return depth;
}

/// Each once: ozone's tables change with the wavelength.
void add_sources(const optics::AirOptics& air, std::vector<std::string>& sources) {
  for (const auto& [what, source] :
       {std::pair{"profile", air.profile_source}, std::pair{"molecules", air.molecules_source},
        std::pair{"ozone", air.ozone_source}, std::pair{"aerosols", air.aerosols_source}}) {
    const std::string line = fmt::format("  {}: {}\n", what, source);
    if (!source.empty() && std::ranges::find(sources, line) == sources.end())
      sources.push_back(line);
  }
}

}  // namespace

std::string air_text(const optics::AirLibrary& library, const optics::AirProfile& profile,
                     const optics::AerosolChoice& aerosols,
                     const std::vector<double>& wavelength_nm) {
  std::string out = fmt::format(
      "Air from {:g} to {:g} km, straight up: optical depths\n\n{:>8} {:>10} {:>10} {:>12} {:>12} "
      "{:>13}\n{:>8} {:>10} {:>10} {:>12} {:>12} {:>13}\n",
      profile.z_km.front(), profile.z_km.back(), "", "", "", "aerosols", "aerosols", "", "nm",
      "molecules", "ozone", "scattering", "absorption", "transmission");
  std::vector<std::string> sources;
  for (const double nm : wavelength_nm) {
    const optics::AirOptics air = optics::air_at(library, profile, aerosols, nm);
    add_sources(air, sources);
    const auto [molecules, ozone, scattering, absorption] = optical_depths(air);
    out += fmt::format("{:>8g} {:>10.5f} {:>10.5f} {:>12.5f} {:>12.5f} {:>13.5f}\n", nm, molecules,
                       ozone, scattering, absorption,
                       std::exp(-(molecules + ozone + scattering + absorption)));
  }
  out += "\nWhere the numbers come from\n";
  for (const std::string& source : sources) out += source;
  return out;
}

}  // namespace photic::io
