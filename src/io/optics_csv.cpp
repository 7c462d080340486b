#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "io/atomic_file.hpp"
#include "io/csv_field.hpp"
#include "io/optics_file.hpp"
#include "io/table_parts.hpp"

namespace photic::io {
namespace {

using medium::OpticalTable;

struct Column {
  std::string name;
  std::vector<double> values;
};

std::vector<Column> columns_of(const OpticalTable& table) {
  std::vector<Column> columns = {{"a_per_m", table.a_per_m},   {"b_per_m", table.b_per_m},
                                 {"c_per_m", table.c_per_m()}, {"bb_per_m", table.bb_per_m()},
                                 {"albedo", table.albedo()},   {"mean_cosine", table.mean_cosine}};
  if (!table.a_exciting_per_m.empty())
    columns.push_back({"a_phytoplankton_per_m", table.a_exciting_per_m});
  if (!table.refractive_index.empty())
    columns.push_back({"refractive_index", table.refractive_index});
  for (const auto& [name, a, b, bb] : table.parts) {
    if (!a.empty()) columns.push_back({"a_" + name_in_files(name) + "_per_m", a});
    if (!b.empty()) columns.push_back({"b_" + name_in_files(name) + "_per_m", b});
    if (!bb.empty()) columns.push_back({"bb_" + name_in_files(name) + "_per_m", bb});
  }
  return columns;
}

/// All lines of a process's light in a layer.
std::string spectrum_line(const OpticalTable::Emission& emission, std::size_t layer) {
  const std::size_t count = emission.wavelength_nm.size();
  std::string out = "#   of which, by line";
  for (std::size_t i = 0; i < count; ++i)
    out += fmt::format("{} {:.2f} nm: {:.6g}", i == 0 ? ":" : ",", emission.wavelength_nm[i],
                       emission.line_per_m[layer * count + i]);
  return out + '\n';
}

std::string line_on_edges(const OpticalTable& table) {
  const EdgeNames edges = edge_names(table);
  if (table.in_columns)
    return fmt::format("# layer: the column and the layer, from {} to {}\n", edges.first_m,
                       edges.last_m);
  const double end = table.last_m.back();
  return fmt::format(
      "# {}: the {} edge of a layer, which reaches {} to the next; the last one {}\n",
      edges.first_m, edges.first, edges.onwards,
      std::isinf(end) ? "is bottomless" : fmt::format("ends at {} m", end));
}

/// The names of the columns that a row begins with.
std::string names_of_place(const OpticalTable& table) {
  const EdgeNames edges = edge_names(table);
  return table.in_columns ? fmt::format("layer,{},{}", edges.first_m, edges.last_m) : edges.first_m;
}

/// The first fields of the rows of a layer.
std::string fields_of_place(const OpticalTable& table, std::size_t layer) {
  if (!table.in_columns) return fmt::format("{}", table.first_m[layer]);
  return fmt::format("{},{},{}", csv_field(table.layer_name[layer]), table.first_m[layer],
                     table.last_m[layer]);
}

std::string head(const OpticalTable& table, const OpticsOrigin& origin) {
  std::string out = fmt::format("# {}\n# Photic {}, {}\n", one_line(origin.title), origin.version,
                                one_line(origin.history));
  out += line_on_edges(table);
  out +=
      "# a absorption, b scattering, c = a + b, bb backscattering, albedo = b / c, mean_cosine of "
      "the scattering angle\n";
  if (!table.a_exciting_per_m.empty())
    out += "# a_phytoplankton_per_m: the part of a that excites chlorophyll fluorescence\n";
  for (const auto& emission : table.emission) {
    for (std::size_t k = 0; k < table.layers(); ++k) {
      const std::string where = table.in_columns ? "in " + one_line(table.layer_name[k])
                                                 : fmt::format("from depth_m {}", table.first_m[k]);
      out += fmt::format("# {} light, excited at {} nm, {}: {} per m\n", emission.process,
                         table.excitation_nm, where, emission.coefficient_per_m[k]);
      if (emission.coefficient_per_m[k] > 0) out += spectrum_line(emission, k);
    }
  }
  for (const auto& source : table.sources) out += "# " + one_line(source_line(source)) + '\n';
  for (const auto& emission : table.emission)
    for (const auto& line : source_lines(emission)) out += "# " + one_line(line) + '\n';
  return out;
}

}  // namespace

EdgeNames edge_names(const OpticalTable& table) {
  if (table.of == medium::Layered::air)
    return {"altitude", "altitude_m", "top_altitude_m", "lower", "up"};
  return {"depth", "depth_m", "bottom_depth_m", "upper", "down"};
}

std::string name_in_files(const std::string& constituent) {
  if (constituent == "phytoplankton") return "phytoplankton_and_detritus";
  std::string out;
  for (const unsigned char c : constituent)
    out += std::isalnum(c) != 0 ? static_cast<char>(std::tolower(c)) : '_';
  return out;
}

std::vector<std::string> source_lines(const OpticalTable::Emission& emission) {
  std::vector<std::string> out;
  for (const auto& source : emission.sources)
    out.push_back(fmt::format("{} light: {}", emission.process, source));
  return out;
}

std::string optics_csv(const OpticalTable& table, const OpticsOrigin& origin) {
  const auto columns = columns_of(table);
  std::string out = head(table, origin) + names_of_place(table) + ",wavelength_nm";
  for (const Column& column : columns) out += ',' + column.name;
  out += '\n';
  for (std::size_t i = 0; i < table.a_per_m.size(); ++i) {
    const std::size_t layer = i / table.wavelengths();
    out += fmt::format("{},{}", fields_of_place(table, layer),
                       table.wavelength_nm[i % table.wavelengths()]);
    for (const Column& column : columns) out += fmt::format(",{}", column.values[i]);
    out += '\n';
  }
  return out;
}

void write_optics_csv(const OpticalTable& table, const OpticsOrigin& origin,
                      const std::string& path) {
  write_atomically(path, optics_csv(table, origin));
}

}  // namespace photic::io
