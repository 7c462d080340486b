#include "medium/optical_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "optics/phase_table.hpp"

namespace photic::medium {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The values of one constituent, as OpticalTable::Part has them.
std::vector<double> values_of(const std::string& name, std::optional<double> Contribution::*value,
                              const WatersOptics& waters) {
  std::vector<double> out;
  bool known = false;
  for (const WaterOptics& water : waters) {
    double sum = 0;
    for (const Contribution& each : water.contributions) {
      if (each.name.empty()) sum = nan;
      if (each.name != name || !(each.*value)) continue;
      sum += *(each.*value);
      known = true;
    }
    out.push_back(sum);
  }
  return known ? out : std::vector<double>{};
}

const char* name_of(Scatterer scatterer) {
  switch (scatterer) {
    case Scatterer::water:
      return "water";
    case Scatterer::phytoplankton:
      return "phytoplankton";
    case Scatterer::minerals:
      return "minerals";
    case Scatterer::all:
      break;
  }
  return "";
}

/// As OpticalTable::Part has them, of a constituent that scatters so much.
std::vector<double> backscattering_of(const std::string& name, const std::vector<double>& b_per_m,
                                      const std::vector<BackscatteringByName>& backscattering) {
  std::vector<double> out;
  for (std::size_t i = 0; i < b_per_m.size(); ++i) {
    const auto found = backscattering[i].find(name);
    out.push_back(std::isnan(b_per_m[i])             ? nan
                  : found == backscattering[i].end() ? 0.0
                                                     : found->second);
  }
  return out;
}

}  // namespace

BackscatteringByName Backscattering::operator()(const scene::Layer& layer, double nm,
                                                const WaterOptics& water) {
  BackscatteringByName out;
  for (const ScatteringPart& part : optics_of_.scattering(layer, nm, water))
    if (part.of != Scatterer::all) out[name_of(part.of)] = part.b_per_m * fraction(part, nm);
  return out;
}

double Backscattering::fraction(const ScatteringPart& part, double nm) {
  const auto known = fraction_.find({part.of, nm});
  if (known != fraction_.end()) return known->second;
  return fraction_[{part.of, nm}] = phases_(part.phase)->backscatter_fraction();
}

std::vector<OpticalTable::Part> parts_of(const WatersOptics& waters,
                                         const std::vector<BackscatteringByName>& backscattering) {
  std::vector<OpticalTable::Part> parts;
  for (const WaterOptics& water : waters) {
    for (const Contribution& each : water.contributions) {
      const bool known =
          std::ranges::find(parts, each.name, &OpticalTable::Part::name) != parts.end();
      if (each.name.empty() || known) continue;
      parts.push_back({each.name,
                       values_of(each.name, &Contribution::a_per_m, waters),
                       values_of(each.name, &Contribution::b_per_m, waters),
                       {}});
      OpticalTable::Part& part = parts.back();
      part.bb_per_m = backscattering_of(part.name, part.b_per_m, backscattering);
    }
  }
  return parts;
}

}  // namespace photic::medium
