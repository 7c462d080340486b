#include "scene/air_levels.hpp"

#include <algorithm>
#include <vector>

#include "core/error.hpp"
#include "optics/modtran.hpp"
#include "scene/format.hpp"

namespace photic::scene {
namespace {

constexpr double m3_per_cm3 = 1e-6;
/// The least that a CSV may tell. A tape6 prints less as 0 where the air is thin.
constexpr double least_hpa = 1e-12, least_per_cm3 = 1;

optics::DataTable::Column column(const std::string& name, const std::vector<double>& values,
                                 double factor = 1, double least = 0) {
  optics::DataTable::Column out{name, {}};
  for (const double value : values)
    out.second.push_back({number_text(std::max(least, factor * value))});
  return out;
}

optics::DataTable table_of(const optics::AirProfile& air, const std::string& name) {
  const auto& aerosols = air.aerosols_per_km;
  return optics::DataTable::of_columns(
      {column("z_km", air.z_km), column("p_hpa", air.pressure_hpa, 1, least_hpa),
       column("t_k", air.temperature_k),
       column("air_per_cm3", air.air_per_m3, m3_per_cm3, least_per_cm3),
       column("ozone_per_cm3", air.ozone_per_m3, m3_per_cm3),
       column("relative_humidity_percent", air.relative_humidity_percent),
       column("boundary_layer_per_km", aerosols[optics::boundary_layer]),
       column("troposphere_per_km", aerosols[optics::troposphere]),
       column("stratosphere_per_km", aerosols[optics::stratosphere]),
       column("upper_atmosphere_per_km", aerosols[optics::upper_atmosphere])},
      name);
}

}  // namespace

optics::DataTable read_air_levels(const std::string& path) {
  if (path.ends_with(".csv")) return optics::DataTable::read(path);
  const std::string text = optics::read_text(path);
  if (!optics::is_tape6(text))
    throw InputError(
        {{path, 0, 0, "no tape6 of LOWTRAN 7 or MODTRAN (no block \"ATMOSPHERIC PROFILES\")",
          "a table of levels is known by its name: it ends in .csv"}});
  return table_of(optics::modtran_profile(text, path), path);
}

bool tells_of_aerosols(const UserTable& levels) {
  constexpr const char* columns[] = {"boundary_layer_per_km", "troposphere_per_km",
                                     "stratosphere_per_km", "upper_atmosphere_per_km"};
  return std::ranges::any_of(levels.columns(), [&](const UserTable::Column& column) {
    return std::ranges::find(columns, column.name) != std::end(columns);
  });
}

}  // namespace photic::scene
