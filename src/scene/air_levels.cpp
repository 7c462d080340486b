#include "scene/air_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/error.hpp"
#include "optics/atmosphere.hpp"
#include "optics/modtran.hpp"
#include "optics/table_text.hpp"
#include "scene/format.hpp"

namespace photic::scene {
namespace {

constexpr double m3_per_cm3 = 1e-6;
/// The least density that a CSV may give. A tape6 prints less as 0 where the air is thin.
constexpr double min_per_cm3 = 1;

optics::DataTable::Column column(const std::string& name, const std::vector<double>& values,
                                 double factor = 1, double least = 0) {
  optics::DataTable::Column out{name, {}};
  for (const double value : values)
    out.second.push_back({number_text(std::max(least, factor * value))});
  return out;
}

optics::DataTable table_of(const optics::AirProfile& air, const std::string& name) {
  const auto& aerosols = air.aerosols_per_km;
  auto table = optics::DataTable::of_columns(
      {column("z_km", air.z_km), column("p_hpa", air.pressure_hpa, 1, optics::min_hpa),
       column("t_k", air.temperature_k),
       column("air_per_cm3", air.air_per_m3, m3_per_cm3, min_per_cm3),
       column("ozone_per_cm3", air.ozone_per_m3, m3_per_cm3),
       column("relative_humidity_percent", air.relative_humidity_percent),
       column("boundary_layer_per_km", aerosols[optics::boundary_layer]),
       column("troposphere_per_km", aerosols[optics::troposphere]),
       column("stratosphere_per_km", aerosols[optics::stratosphere]),
       column("upper_atmosphere_per_km", aerosols[optics::upper_atmosphere])},
      name);
  for (const std::string& remark : air.remarks) table.remark(remark);
  return table;
}

constexpr double min_nm = 200, max_nm = 1100;

/// MODTRAN's names of the transmittance by all there is, and by the parts that Photic has itself.
constexpr const char* of_all = "COMBIN TRANS";
constexpr const char* of_profile[] = {"MOLEC SCAT", "O3 TRANS", "AER+CLD TRANS"};

/// By all but that.
double of_gases(const optics::ModtranTransmittances& air, const std::vector<std::string>& columns,
                double nm) {
  const auto opaque = [&](const char* column) { return air.transmittance(column, nm) == 0; };
  if (opaque(of_all)) return opaque_depth;
  double depth = air.optical_depth(of_all, nm).value;
  for (const char* column : of_profile) {
    if (std::ranges::find(columns, column) == columns.end()) continue;
    if (opaque(column)) return opaque_depth;
    depth -= air.optical_depth(column, nm).value;
  }
  return std::max(0.0, depth);  // the digits that are printed allow less
}

bool is_csv(const std::string& path) { return path.ends_with(".csv"); }

/// The table in a file that is not the one of MODTRAN's that would do as well.
optics::DataTable table_of_text(const std::string& path, const std::string& text,
                                const char* no_tape) {
  if (!is_csv(path) && (optics::is_tape6(text) || optics::is_tape7(text)))
    throw InputError({{path, 0, 0, no_tape, "MODTRAN's other file does not hold it"}});
  auto table = optics::DataTable::parse(text, path);
  if (!is_csv(path) && !table.may_be_quoted())
    throw InputError({{path, 0, 0, fmt::format("{}, and {}", optics::no_numbers, no_tape),
                       table.what_there_is()}});
  return table;
}

}  // namespace

optics::DataTable read_air_levels(const std::string& path) {
  const std::string text = optics::read_text(path);
  if (is_csv(path) || !optics::is_tape6(text))
    return optics::with_all_humidities(table_of_text(
        path, text, "not a tape6 of LOWTRAN 7 or MODTRAN (no block \"ATMOSPHERIC PROFILES\")"));
  return table_of(optics::modtran_profile(text, path), path);
}

optics::DataTable read_gas_depths(const std::string& path) {
  const std::string text = optics::read_text(path);
  if (is_csv(path) || !optics::is_tape7(text))
    return table_of_text(path, text,
                         "not a tape7 of LOWTRAN 7 or MODTRAN (no line begins with FREQ)");
  const optics::ModtranTransmittances air(text, path);
  const std::vector<std::string> columns = air.columns();
  std::vector<double> wavelength_nm, optical_depth;
  for (const double nm : air.wavelengths_nm()) {
    if (nm < min_nm || nm > max_nm) continue;
    wavelength_nm.push_back(nm);
    optical_depth.push_back(of_gases(air, columns, nm));
  }
  return optics::DataTable::of_columns(
      {column("wavelength_nm", wavelength_nm), column("optical_depth", optical_depth)}, path);
}

bool has_own_aerosols(const Atmosphere& air) {
  const auto* levels = std::get_if<UserTable>(&air.profile);
  if (!levels) return false;
  constexpr const char* columns[] = {"boundary_layer_per_km", "troposphere_per_km",
                                     "stratosphere_per_km", "upper_atmosphere_per_km"};
  return std::ranges::any_of(levels->columns(), [&](const UserTable::Column& column) {
    return std::ranges::find(columns, column.name) != std::end(columns);
  });
}

}  // namespace photic::scene
