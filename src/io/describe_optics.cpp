#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

#include "io/describe.hpp"

namespace photic::io {
namespace {

using medium::OpticalTable;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

using Dimensions = std::vector<std::string>;

Dimensions spectral(const OpticalTable& table) { return {edge_names(table).axis, "wavelength"}; }

std::string layer_coordinates(const OpticalTable& table) {
  return "layer_name " + edge_names(table).first_m;
}

std::string spectral_coordinates(const OpticalTable& table) {
  return layer_coordinates(table) + " wavelength_nm";
}

void add_axes(Dataset& dataset, const OpticalTable& table) {
  const EdgeNames edges = edge_names(table);
  const std::string bounds_name = edges.first_m + "_bounds";
  dataset.add_dimension(edges.axis, table.layers());
  dataset.add_dimension("wavelength", table.wavelengths());
  dataset.add_dimension("angle", table.angles());
  dataset.add_dimension("bnds", 2);
  dataset.add_variable(
      "layer_name", {edges.axis}, table.layer_name,
      {{"long_name", table.in_columns ? "name of the column and the layer" : "name of the layer"}});
  std::vector<double> bounds;
  for (std::size_t k = 0; k < table.layers(); ++k)
    bounds.insert(bounds.end(), {table.first_m[k], table.last_m[k]});
  Attributes attributes = {
      {"standard_name", edges.axis},
      {"long_name", fmt::format("{} of the {} edge of the layer", edges.axis, edges.first)},
      {"units", "m"},
      {"positive", edges.onwards},
      {"coordinates", "layer_name"},
      {"bounds", bounds_name}};
  if (table.of == medium::Layered::water)
    attributes.emplace_back("comment", "a bottomless layer ends at an infinite depth");
  dataset.add_variable(edges.first_m, {edges.axis}, table.first_m, attributes);
  dataset.add_variable(
      bounds_name, {edges.axis, "bnds"}, bounds,
      {{"long_name", table.of == medium::Layered::water ? "upper and lower edge of the layer"
                                                        : "lower and upper edge of the layer"}});
  dataset.add_variable("wavelength_nm", {"wavelength"}, table.wavelength_nm,
                       {{"standard_name", "radiation_wavelength"},
                        {"long_name", "wavelength of the light, in air"},
                        {"units", "nm"}});
  dataset.add_variable("angle_deg", {"angle"}, table.angle_deg,
                       {{"long_name", "angle between the directions before and after a scattering"},
                        {"units", "degree"}});
}

/// CF has names of the totals in sea water, not of those in air.
Attributes per_metre(const OpticalTable& table, const std::string& quantity,
                     const std::string& standard_name) {
  const bool water = table.of == medium::Layered::water;
  Attributes out;
  if (water) out.emplace_back("standard_name", standard_name + "_of_radiative_flux_in_sea_water");
  out.emplace_back("long_name", quantity + (water ? " coefficient, water and all its constituents"
                                                  : " coefficient, air and all that is in it"));
  out.emplace_back("units", "m-1");
  out.emplace_back("coordinates", spectral_coordinates(table));
  return out;
}

void add_totals(Dataset& dataset, const OpticalTable& table) {
  const std::string coordinates = spectral_coordinates(table);
  const auto add = [&](const char* name, const std::vector<double>& values,
                       const Attributes& attributes) {
    if (!values.empty()) dataset.add_variable(name, spectral(table), values, attributes);
  };
  add("a_per_m", table.a_per_m, per_metre(table, "absorption", "volume_absorption_coefficient"));
  add("b_per_m", table.b_per_m, per_metre(table, "scattering", "volume_scattering_coefficient"));
  add("c_per_m", table.c_per_m(),
      per_metre(table, "attenuation", "volume_beam_attenuation_coefficient"));
  add("bb_per_m", table.bb_per_m(),
      per_metre(table, "backscattering", "volume_backwards_scattering_coefficient"));
  add("albedo", table.albedo(),
      {{"long_name", "single-scattering albedo b / c"},
       {"units", "1"},
       {"_FillValue", unknown},
       {"coordinates", coordinates}});
  add("mean_cosine", table.mean_cosine,
      {{"long_name", "mean cosine g of the scattering angle"},
       {"units", "1"},
       {"coordinates", coordinates}});
  add("a_phytoplankton_per_m", table.a_exciting_per_m,
      {{"long_name", "part of the absorption that excites chlorophyll fluorescence"},
       {"units", "m-1"},
       {"coordinates", coordinates}});
  add("refractive_index", table.refractive_index,
      {{"long_name", "index of refraction relative to vacuum"},
       {"units", "1"},
       {"coordinates", coordinates}});
  dataset.add_variable("phase_function_per_sr", {edge_names(table).axis, "wavelength", "angle"},
                       table.phase_function_per_sr,
                       {{"long_name", "phase function of all scattering, 1 over the whole sphere"},
                        {"units", "sr-1"},
                        {"coordinates", coordinates + " angle_deg"}});
}

/// The text on the sources of the numbers of a constituent.
std::string sources_of(const std::string& part, const OpticalTable& table) {
  std::vector<std::string> lines;
  for (const auto& source : table.sources)
    if (source.quantity.ends_with(" of " + part)) lines.push_back(source_line(source));
  return fmt::format("{}", fmt::join(lines, "\n"));
}

void add_parts(Dataset& dataset, const OpticalTable& table) {
  for (const auto& part : table.parts) {
    const auto add = [&](const char* letter, const char* verb, const std::vector<double>& values) {
      if (values.empty()) return;
      dataset.add_variable(fmt::format("{}_{}_per_m", letter, name_in_files(part.name)),
                           spectral(table), values,
                           {{"long_name", fmt::format("{} by {}", verb, part.name)},
                            {"units", "m-1"},
                            {"_FillValue", unknown},
                            {"coordinates", spectral_coordinates(table)},
                            {"source", LongText{sources_of(part.name, table)}}});
    };
    add("a", "absorption", part.a_per_m);
    add("b", "scattering", part.b_per_m);
    add("bb", "backscattering", part.bb_per_m);
  }
}

/// All lines of all processes, one behind the other.
void add_emission_lines(Dataset& dataset, const OpticalTable& table) {
  std::vector<std::string> process;
  std::vector<double> nm, per_m;
  for (const auto& emission : table.emission) {
    process.insert(process.end(), emission.wavelength_nm.size(), emission.process);
    nm.insert(nm.end(), emission.wavelength_nm.begin(), emission.wavelength_nm.end());
  }
  if (nm.empty()) return;
  for (std::size_t k = 0; k < table.layers(); ++k) {
    for (const auto& emission : table.emission) {
      const std::size_t count = emission.wavelength_nm.size();
      for (std::size_t i = 0; i < count; ++i) per_m.push_back(emission.line_per_m[k * count + i]);
    }
  }
  dataset.add_dimension("emission_line", nm.size());
  dataset.add_variable("emission_line_process", {"emission_line"}, process,
                       {{"long_name", "process that emits the line"}});
  dataset.add_variable("emission_wavelength_nm", {"emission_line"}, nm,
                       {{"standard_name", "radiation_wavelength"},
                        {"long_name", "wavelength of the emitted line, in air"},
                        {"units", "nm"},
                        {"coordinates", "emission_line_process"}});
  dataset.add_variable(
      "emission_line_per_m", {edge_names(table).axis, "emission_line"}, per_m,
      {{"long_name", "photons emitted in the line per metre and photon of the exciting light"},
       {"units", "m-1"},
       {"coordinates",
        layer_coordinates(table) +
            " emission_line_process emission_wavelength_nm excitation_wavelength_nm"}});
}

void add_emission(Dataset& dataset, const OpticalTable& table) {
  std::vector<std::string> process;
  std::vector<double> per_m;
  for (const auto& emission : table.emission) process.push_back(emission.process);
  for (std::size_t k = 0; k < table.layers(); ++k)
    for (const auto& emission : table.emission) per_m.push_back(emission.coefficient_per_m[k]);
  dataset.add_dimension("process", process.size());
  dataset.add_variable("process_name", {"process"}, process,
                       {{"long_name", "process that emits light of another wavelength"}});
  dataset.add_variable("excitation_wavelength_nm", {}, std::span(&table.excitation_nm, 1),
                       {{"standard_name", "radiation_wavelength"},
                        {"long_name", "wavelength of the light that excites emission, in air"},
                        {"units", "nm"}});
  dataset.add_variable(
      "emission_per_m", {edge_names(table).axis, "process"}, per_m,
      {{"long_name", "photons emitted by the process per metre and photon of the exciting light"},
       {"units", "m-1"},
       {"coordinates", layer_coordinates(table) + " process_name excitation_wavelength_nm"}});
  add_emission_lines(dataset, table);
}

void add_description(Dataset& dataset, const OpticalTable& table, const OpticsOrigin& origin) {
  std::vector<std::string> references;
  for (const auto& source : table.sources) references.push_back(source_line(source));
  for (const auto& emission : table.emission)
    for (const auto& line : source_lines(emission)) references.push_back(line);
  dataset.add_global("Conventions", "CF-1.10");
  dataset.add_global("title", LongText{origin.title});
  dataset.add_global("source",
                     fmt::format("Photic {}: optical properties of {}", origin.version,
                                 table.of == medium::Layered::water ? "the layers of a scene"
                                                                    : "the layers of the air"));
  dataset.add_global("history", LongText{origin.history});
  dataset.add_global("references", LongText{fmt::format("{}", fmt::join(references, "\n"))});
  dataset.add_global("photic_format", photic_format);
  dataset.add_global("photic_content", "optics");
  dataset.add_global("version", origin.version);
  if (!origin.scene_toml.empty()) dataset.add_global("scene", LongText{origin.scene_toml});
}

}  // namespace

void describe(const OpticalTable& table, const OpticsOrigin& origin, Dataset& dataset) {
  add_description(dataset, table, origin);
  add_axes(dataset, table);
  add_totals(dataset, table);
  add_parts(dataset, table);
  if (!table.emission.empty()) add_emission(dataset, table);
}

}  // namespace photic::io
