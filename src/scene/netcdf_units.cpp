#include "scene/netcdf_units.hpp"

#include <fmt/format.h>

#include "scene/unit_text.hpp"

namespace photic::scene {

Conversion conversion_of(const NetcdfColumns& file, const std::string& name,
                         const NetcdfVariable& variable, const std::string& key) {
  const auto found = conversion_to(key, variable.units, variable.standard_name);
  if (!found)
    file.fail(name, fmt::format("{}, not {}", units_text(variable), unit_of(key)),
              understood_for(key));
  return *found;
}

std::string units_text(const NetcdfVariable& variable) {
  return variable.units.empty() ? "has no attribute units"
                                : fmt::format("is in units of \"{}\"", variable.units);
}

bool points_up(const NetcdfColumns& file, const std::string& name, const NetcdfVariable& variable) {
  const std::string positive = lower_case(variable.positive);
  if (positive.empty())
    return variable.standard_name == "altitude" || variable.standard_name.starts_with("height");
  if (positive != "up" && positive != "down")
    file.fail(name, fmt::format("its attribute positive is \"{}\"", variable.positive),
              "it is \"up\" or \"down\"");
  return positive == "up";
}

}  // namespace photic::scene
