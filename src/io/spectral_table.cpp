#include "io/spectral_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <span>

#include "io/describe.hpp"
#include "io/table_parts.hpp"
#include "io/text_columns.hpp"

namespace photic::io {
void describe(const SpectralTable& table, const OpticsOrigin& origin, Dataset& dataset) {
  dataset.add_global("Conventions", "CF-1.10");
  dataset.add_global("title", LongText{origin.title});
  dataset.add_global("source", fmt::format("Photic {}: {}", origin.version, table.what));
  dataset.add_global("history", LongText{origin.history});
  dataset.add_global("references", LongText{fmt::format("{}", fmt::join(table.sources, "\n"))});
  dataset.add_global("photic_format", photic_format);
  dataset.add_global("photic_content", "spectra");
  dataset.add_global("version", origin.version);
  dataset.add_dimension("wavelength", table.wavelength_nm.size());
  dataset.add_variable("wavelength_nm", {"wavelength"}, table.wavelength_nm,
                       {{"standard_name", "radiation_wavelength"},
                        {"long_name", "wavelength of the light"},
                        {"units", "nm"}});
  for (const auto& column : table.columns)
    dataset.add_variable(column.name, {"wavelength"}, column.values,
                         {{"long_name", column.long_name},
                          {"units", column.units},
                          {"coordinates", "wavelength_nm"}});
  for (const auto& number : table.numbers)
    dataset.add_variable(number.name, {}, std::span(&number.value, 1),
                         {{"long_name", number.long_name}, {"units", number.units}});
}

std::string spectral_csv(const SpectralTable& table, const OpticsOrigin& origin) {
  std::string out = fmt::format("# {}\n# Photic {}, {}\n", one_line(origin.title), origin.version,
                                one_line(origin.history));
  for (const auto& number : table.numbers)
    out += fmt::format("# {}: {}\n", number.name, number.value);
  for (const auto& column : table.columns)
    out += fmt::format("# {} [{}] {}\n", column.name, column.units, one_line(column.long_name));
  for (const auto& source : table.sources) out += "# " + one_line(source) + '\n';
  out += "wavelength_nm";
  for (const auto& column : table.columns) out += ',' + column.name;
  out += '\n';
  for (std::size_t i = 0; i < table.wavelength_nm.size(); ++i) {
    out += fmt::format("{}", table.wavelength_nm[i]);
    for (const auto& column : table.columns) out += fmt::format(",{}", column.values[i]);
    out += '\n';
  }
  return out;
}

std::string spectral_json(const SpectralTable& table) {
  using Json = nlohmann::ordered_json;
  Json json = {{"wavelength_nm", table.wavelength_nm}};
  for (const auto& column : table.columns) json[column.name] = column.values;
  for (const auto& number : table.numbers) json[number.name] = number.value;
  json["sources"] = table.sources;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string spectral_text(const SpectralTable& table) {
  const std::size_t count = table.wavelength_nm.size();
  std::vector<TextColumn> columns = {text_column("nm", table.wavelength_nm, 0, count, "{:.2f}")};
  for (const auto& column : table.columns)
    columns.push_back(text_column(column.heading, column.values, 0, count, "{:.5g}"));
  return side_by_side(columns);
}

}  // namespace photic::io
