#include <fmt/format.h>

#include <filesystem>

#include "core/error.hpp"
#include "engine/problem.hpp"
#include "io/air_text.hpp"
#include "io/netcdf.hpp"
#include "io/netcdf_variable.hpp"
#include "io/oil_text.hpp"
#include "io/optics_file.hpp"
#include "io/optics_table.hpp"
#include "medium/optical_table.hpp"
#include "optics/data_folder.hpp"
#include "optics/modtran.hpp"
#include "photic/commands.hpp"
#include "photic/output.hpp"

namespace photic::app {
namespace {

/// The starter scene with one bottomless layer of the water that is asked for.
scene::Reading read_water(const OpticsCommand& command) {
  std::string title = "Sea water";
  std::vector<scene::Override> overrides{R"(channel=[{ name = "elastic", process = "elastic" }])",
                                         R"(sea.layer=[{ name = "water" }])"};
  for (const std::string& key : command.water) {
    title += (&key == command.water.data() ? ": " : ", ") + key;
    overrides.push_back("sea.layer.0." + key);
  }
  overrides.push_back("title=" + title);
  overrides.insert(overrides.end(), command.overrides.begin(), command.overrides.end());
  return scene::read_scene_text(scene::starter_scene("ship"), "--water", "", overrides,
                                engine::optics_check(), io::netcdf_files());
}

scene::Scene read(const OpticsCommand& command) {
  if (!command.output.empty()) check_output(command.output, command.scene);
  const scene::Reading reading =
      command.scene.empty() ? read_water(command)
                            : scene::read_scene(command.scene, command.overrides,
                                                engine::optics_check(), io::netcdf_files());
  for (const std::string& remark : reading.remarks) print_error(remark + '\n');
  spare(reading.files, command.output);
  return reading.scene;
}

medium::OpticalTable table_of(const scene::Scene& scene, const OpticsCommand& command) {
  const optics::Library library(optics::find_data_folder());
  if (command.wavelength_nm.empty())
    return medium::optical_table(scene, library, medium::wavelengths_of_light(scene, library));
  try {
    return medium::optical_table(scene, library, command.wavelength_nm);
  } catch (const InputError& error) {  // nothing is wrong with the scene, which has been checked
    throw UsageError(fmt::format("--wavelengths: {}", error.what()));
  }
}

void write(const medium::OpticalTable& table, const scene::Scene& scene,
           const OpticsCommand& command) {
  const io::OpticsOrigin origin{.title = scene.title,
                                .scene_toml = scene::write_scene(scene),
                                .version = PHOTIC_VERSION,
                                .history = io::history_line(command.command_line)};
  if (std::filesystem::path(command.output).extension() == ".csv")
    io::write_optics_csv(table, origin, command.output);
  else
    io::write_optics_netcdf(table, origin, command.output);
}

/// What is told of a file that was written.
std::string where_it_is(const medium::OpticalTable& table, const std::string& output) {
  std::string out = fmt::format("{}: the optics of {} layer{} at {} wavelength{}\n", output,
                                table.layers(), table.layers() == 1 ? "" : "s", table.wavelengths(),
                                table.wavelengths() == 1 ? "" : "s");
  const std::filesystem::path file(output);
  if (file.extension() == ".nc")
    out += fmt::format("Plot it: python3 -m photic plot {} -o {}\n", output,
                       std::filesystem::path(file).replace_extension(".png").string());
  return out;
}

/// Those asked for, or from the ultraviolet of fluorosensors to the red.
std::vector<double> wavelengths_of(const OpticsCommand& command) {
  std::vector<double> nm = command.wavelength_nm;
  for (double each = 300; command.wavelength_nm.empty() && each <= 700; each += 50)
    nm.push_back(each);
  return nm;
}

std::string oil_table(const OpticsCommand& command) {
  const optics::Library library(optics::find_data_folder());
  return io::oil_text(optics::oil(library, command.oil), wavelengths_of(command));
}

/// A CSV file by its name, another file as a tape6, else one of Photic's atmospheres.
optics::AirProfile air_profile(const optics::AirLibrary& library, const std::string& name) {
  if (std::filesystem::path(name).extension() == ".csv")
    return optics::air_profile(optics::DataTable::read(name));
  std::error_code none;
  if (std::filesystem::is_regular_file(name, none))
    return optics::modtran_profile(optics::read_text(name), name);
  return library.atmosphere(name);
}

std::string air_table(const OpticsCommand& command) {
  const optics::AirLibrary library(optics::find_data_folder());
  optics::AirProfile profile = air_profile(library, command.air);
  if (command.visibility_km)
    profile = optics::with_aerosols(library, std::move(profile), *command.visibility_km,
                                    optics::AerosolProfiles::seasons.front());
  optics::AerosolChoice aerosols;
  aerosols.model[optics::boundary_layer] = command.aerosol;
  return io::air_text(library, profile, aerosols, wavelengths_of(command));
}

}  // namespace

int run(const OpticsCommand& command) {
  if (!command.oil.empty() || !command.air.empty()) {
    print_out(command.air.empty() ? oil_table(command) : air_table(command));
    return done;
  }
  const scene::Scene scene = read(command);
  const medium::OpticalTable table = table_of(scene, command);
  if (!command.output.empty()) {
    write(table, scene, command);
    if (!command.json) print_out(where_it_is(table, command.output));
  } else if (!command.json) {
    print_out(io::optics_text(table));
  }
  if (command.json) print_out(io::optics_json(table));
  return done;
}

}  // namespace photic::app
