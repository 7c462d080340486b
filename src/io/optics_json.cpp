#include <nlohmann/json.hpp>

#include "io/optics_file.hpp"
#include "io/optics_table.hpp"

namespace photic::io {
namespace {

using Json = nlohmann::ordered_json;
using medium::OpticalTable;

/// The values of a layer, or nothing where there are none.
Json in_layer(const std::vector<double>& values, std::size_t layer, std::size_t count) {
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(layer * count);
  return std::vector<double>(first, first + static_cast<std::ptrdiff_t>(count));
}

Json part(const OpticalTable& table, const OpticalTable::Part& part, std::size_t layer) {
  Json out = Json::object();
  const std::size_t count = table.wavelengths();
  if (!part.a_per_m.empty()) out["a_per_m"] = in_layer(part.a_per_m, layer, count);
  if (!part.b_per_m.empty()) out["b_per_m"] = in_layer(part.b_per_m, layer, count);
  if (!part.bb_per_m.empty()) out["bb_per_m"] = in_layer(part.bb_per_m, layer, count);
  return out;
}

Json emission(const OpticalTable::Emission& emission, std::size_t layer) {
  const std::size_t count = emission.wavelength_nm.size();
  return {{"coefficient_per_m", emission.coefficient_per_m[layer]},
          {"line_nm", emission.wavelength_nm},
          {"line_per_m", in_layer(emission.line_per_m, layer, count)}};
}

Json phase_functions(const OpticalTable& table, std::size_t layer) {
  Json out = Json::array();
  for (std::size_t w = 0; w < table.wavelengths(); ++w)
    out.push_back(
        in_layer(table.phase_function_per_sr, layer * table.wavelengths() + w, table.angles()));
  return out;
}

Json layer(const OpticalTable& table, std::size_t k) {
  const auto of_layer = [&](const std::vector<double>& values) {
    return in_layer(values, k, table.wavelengths());
  };
  const EdgeNames edges = edge_names(table);
  Json out = {{"name", table.layer_name[k]},
              {edges.first_m, table.first_m[k]},
              {edges.last_m, table.last_m[k]},
              {"a_per_m", of_layer(table.a_per_m)},
              {"b_per_m", of_layer(table.b_per_m)},
              {"c_per_m", of_layer(table.c_per_m())},
              {"bb_per_m", of_layer(table.bb_per_m())},
              {"albedo", of_layer(table.albedo())},
              {"backscatter_fraction", of_layer(table.backscatter_fraction)},
              {"mean_cosine", of_layer(table.mean_cosine)}};
  if (!table.a_exciting_per_m.empty())
    out["a_phytoplankton_per_m"] = of_layer(table.a_exciting_per_m);
  if (!table.refractive_index.empty()) out["refractive_index"] = of_layer(table.refractive_index);
  out["parts"] = Json::object();
  for (const auto& each : table.parts) out["parts"][each.name] = part(table, each, k);
  if (!table.emission.empty()) out["emission"] = Json::object();
  for (const auto& each : table.emission) out["emission"][each.process] = emission(each, k);
  out["phase_function_per_sr"] = phase_functions(table, k);
  return out;
}

Json sources(const OpticalTable& table) {
  Json out = Json::array();
  for (const auto& [quantity, first, last, source] : table.sources)
    out.push_back(
        {{"quantity", quantity}, {"first_nm", first}, {"last_nm", last}, {"source", source}});
  for (const auto& emission : table.emission)
    for (const auto& source : emission.sources)
      out.push_back({{"quantity", emission.process + " light"},
                     {"first_nm", table.excitation_nm},
                     {"last_nm", table.excitation_nm},
                     {"source", source}});
  return out;
}

}  // namespace

std::string optics_json(const OpticalTable& table) {
  Json json = {{"wavelength_nm", table.wavelength_nm}, {"angle_deg", table.angle_deg}};
  if (!table.emission.empty()) json["excitation_nm"] = table.excitation_nm;
  json["layers"] = Json::array();
  json["sources"] = sources(table);
  for (std::size_t k = 0; k < table.layers(); ++k) json["layers"].push_back(layer(table, k));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace photic::io
