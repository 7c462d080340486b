#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

#include "io/atomic_file.hpp"
#include "io/netcdf.hpp"
#include "io/netcdf_image.hpp"
#include "io/optics_file.hpp"

namespace photic::io {
namespace {

using medium::OpticalTable;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

const std::vector<std::string> spectral = {"depth", "wavelength"};
const std::string spectral_coordinates = "layer_name depth_m wavelength_nm";

void add_axes(NetcdfImage& file, const OpticalTable& table) {
  file.add_dimension("depth", table.layers());
  file.add_dimension("wavelength", table.wavelengths());
  file.add_dimension("angle", table.angles());
  file.add_dimension("bnds", 2);
  file.add_variable("layer_name", {"depth"}, table.layer_name,
                    {{"long_name", "name of the layer"}});
  std::vector<double> top, bounds;
  for (std::size_t k = 0; k < table.layers(); ++k) {
    top.push_back(table.edge_m[k]);
    bounds.insert(bounds.end(), {table.edge_m[k], table.edge_m[k + 1]});
  }
  file.add_variable("depth_m", {"depth"}, top,
                    {{"standard_name", "depth"},
                     {"long_name", "depth of the upper edge of the layer"},
                     {"units", "m"},
                     {"positive", "down"},
                     {"coordinates", "layer_name"},
                     {"bounds", "depth_m_bounds"},
                     {"comment", "a bottomless layer ends at an infinite depth"}});
  file.add_variable("depth_m_bounds", {"depth", "bnds"}, bounds,
                    {{"long_name", "upper and lower edge of the layer"}});
  file.add_variable("wavelength_nm", {"wavelength"}, table.wavelength_nm,
                    {{"standard_name", "radiation_wavelength"},
                     {"long_name", "wavelength of the light, in air"},
                     {"units", "nm"}});
  file.add_variable("angle_deg", {"angle"}, table.angle_deg,
                    {{"long_name", "angle between the directions before and after a scattering"},
                     {"units", "degree"}});
}

Attributes per_metre(const std::string& quantity, const std::string& standard_name) {
  return {{"standard_name", standard_name + "_of_radiative_flux_in_sea_water"},
          {"long_name", quantity + " coefficient, water and all its constituents"},
          {"units", "m-1"},
          {"coordinates", spectral_coordinates}};
}

void add_totals(NetcdfImage& file, const OpticalTable& table) {
  file.add_variable("a_per_m", spectral, table.a_per_m,
                    per_metre("absorption", "volume_absorption_coefficient"));
  file.add_variable("b_per_m", spectral, table.b_per_m,
                    per_metre("scattering", "volume_scattering_coefficient"));
  file.add_variable("c_per_m", spectral, table.c_per_m(),
                    per_metre("attenuation", "volume_beam_attenuation_coefficient"));
  file.add_variable("bb_per_m", spectral, table.bb_per_m(),
                    per_metre("backscattering", "volume_backwards_scattering_coefficient"));
  file.add_variable("albedo", spectral, table.albedo(),
                    {{"long_name", "single-scattering albedo b / c"},
                     {"units", "1"},
                     {"_FillValue", unknown},
                     {"coordinates", spectral_coordinates}});
  file.add_variable("mean_cosine", spectral, table.mean_cosine,
                    {{"long_name", "mean cosine g of the scattering angle"},
                     {"units", "1"},
                     {"coordinates", spectral_coordinates}});
  file.add_variable("a_phytoplankton_per_m", spectral, table.a_exciting_per_m,
                    {{"long_name", "share of the absorption that excites chlorophyll fluorescence"},
                     {"units", "m-1"},
                     {"coordinates", spectral_coordinates}});
  file.add_variable("phase_function_per_sr", {"depth", "wavelength", "angle"},
                    table.phase_function_per_sr,
                    {{"long_name", "phase function of all scattering, 1 over the whole sphere"},
                     {"units", "sr-1"},
                     {"coordinates", spectral_coordinates + " angle_deg"}});
}

/// What is said of where the numbers of a constituent come from.
std::string sources_of(const std::string& part, const OpticalTable& table) {
  std::vector<std::string> lines;
  for (const auto& source : table.sources)
    if (source.quantity.ends_with(" of " + part)) lines.push_back(source_line(source));
  return fmt::format("{}", fmt::join(lines, "\n"));
}

void add_parts(NetcdfImage& file, const OpticalTable& table) {
  for (const auto& part : table.parts) {
    const auto add = [&](const char* letter, const char* verb, const std::vector<double>& values) {
      if (values.empty()) return;
      file.add_variable(fmt::format("{}_{}_per_m", letter, name_in_files(part.name)), spectral,
                        values,
                        {{"long_name", fmt::format("{} by {}", verb, part.name)},
                         {"units", "m-1"},
                         {"_FillValue", unknown},
                         {"coordinates", spectral_coordinates},
                         {"source", LongText{sources_of(part.name, table)}}});
    };
    add("a", "absorption", part.a_per_m);
    add("b", "scattering", part.b_per_m);
    add("bb", "backscattering", part.bb_per_m);
  }
}

/// All lines of all processes, one behind the other.
void add_emission_lines(NetcdfImage& file, const OpticalTable& table) {
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
  file.add_dimension("emission_line", nm.size());
  file.add_variable("emission_line_process", {"emission_line"}, process,
                    {{"long_name", "process that emits the line"}});
  file.add_variable("emission_wavelength_nm", {"emission_line"}, nm,
                    {{"standard_name", "radiation_wavelength"},
                     {"long_name", "wavelength of the emitted line, in air"},
                     {"units", "nm"},
                     {"coordinates", "emission_line_process"}});
  file.add_variable(
      "emission_line_per_m", {"depth", "emission_line"}, per_m,
      {{"long_name", "photons emitted in the line per metre and photon of the exciting light"},
       {"units", "m-1"},
       {"coordinates",
        "layer_name depth_m emission_line_process emission_wavelength_nm "
        "excitation_wavelength_nm"}});
}

void add_emission(NetcdfImage& file, const OpticalTable& table) {
  std::vector<std::string> process;
  std::vector<double> per_m;
  for (const auto& emission : table.emission) process.push_back(emission.process);
  for (std::size_t k = 0; k < table.layers(); ++k)
    for (const auto& emission : table.emission) per_m.push_back(emission.coefficient_per_m[k]);
  file.add_dimension("process", process.size());
  file.add_variable("process_name", {"process"}, process,
                    {{"long_name", "process that emits light of another wavelength"}});
  file.add_variable("excitation_wavelength_nm", {}, std::span(&table.excitation_nm, 1),
                    {{"standard_name", "radiation_wavelength"},
                     {"long_name", "wavelength of the light that excites emission, in air"},
                     {"units", "nm"}});
  file.add_variable(
      "emission_per_m", {"depth", "process"}, per_m,
      {{"long_name", "photons emitted by the process per metre and photon of the exciting light"},
       {"units", "m-1"},
       {"coordinates", "layer_name depth_m process_name excitation_wavelength_nm"}});
  add_emission_lines(file, table);
}

void add_description(NetcdfImage& file, const OpticalTable& table, const OpticsOrigin& origin) {
  std::vector<std::string> references;
  for (const auto& source : table.sources) references.push_back(source_line(source));
  for (const auto& emission : table.emission)
    for (const auto& line : source_lines(emission)) references.push_back(line);
  file.add_global("Conventions", "CF-1.10");
  file.add_global("title", LongText{origin.title});
  file.add_global("source", fmt::format("Photic {}: optical properties of the layers of a scene",
                                        origin.version));
  file.add_global("history", LongText{origin.history});
  file.add_global("references", LongText{fmt::format("{}", fmt::join(references, "\n"))});
  file.add_global("photic_format", photic_format);
  file.add_global("photic_content", "optics");
  file.add_global("version", origin.version);
  file.add_global("scene", LongText{origin.scene_toml});
}

}  // namespace

void write_optics_netcdf(const OpticalTable& table, const OpticsOrigin& origin,
                         const std::string& path) {
  NetcdfImage file;
  add_description(file, table, origin);
  add_axes(file, table);
  add_totals(file, table);
  add_parts(file, table);
  add_emission(file, table);
  write_atomically(path, file.finish());
}

}  // namespace photic::io
