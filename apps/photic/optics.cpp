#include <fmt/format.h>

#include "core/error.hpp"
#include "estimator/model.hpp"
#include "io/netcdf_variable.hpp"
#include "io/optics_table.hpp"
#include "medium/air_table.hpp"
#include "medium/optical_table.hpp"
#include "photic/commands.hpp"
#include "photic/optics_report.hpp"
#include "photic/output.hpp"
#include "photic/tables.hpp"
#include "session/result_file.hpp"

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
                                optics_check(), io::netcdf_files());
}

/// The scene at a path; none: the water that is asked for.
scene::Scene read(const OpticsCommand& command, const std::string& path) {
  if (!command.output.empty()) check_optics_output(command.output, path);
  const scene::Reading reading =
      path.empty() ? read_water(command)
                   : scene::read_scene(path, command.overrides, optics_check(), io::netcdf_files());
  for (const std::string& remark : reading.remarks) print_error(remark + '\n');
  session::spare(reading.files, command.output);
  return reading.scene;
}

/// At the wavelengths that are asked for, or that light of the scene has.
template <class TableAt>
medium::OpticalTable table_of(const scene::Scene& scene, const OpticsCommand& command,
                              TableAt table_at) {
  if (command.wavelength_nm.empty())
    return table_at(medium::wavelengths_of_light(scene, *tables()));
  try {
    return table_at(command.wavelength_nm);
  } catch (const InputError& error) {  // nothing is wrong with the scene, which has been checked
    throw UsageError(fmt::format("--wavelengths: {}", error.what()));
  }
}

/// The water of the scene, and on the terminal the air above it.
int report_water(const OpticsCommand& command) {
  const scene::Scene scene = read(command, command.scene);
  const auto water = table_of(scene, command, [&](const std::vector<double>& nm) {
    return medium::optical_table(scene, *tables(), nm);
  });
  report(water, {scene.title, scene::write_scene(scene)}, command);
  if (!scene.atmosphere || command.json || !command.output.empty()) return done;
  const auto air = table_of(scene, command, [&](const std::vector<double>& nm) {
    return medium::air_table(scene, *tables(), nm);
  });
  print_out(fmt::format("\nThe air above it (by itself: photic optics --air {})\n\n{}",
                        command.scene, io::optics_text(air)));
  return done;
}

/// The air of the scene that --air names.
int report_air_of_scene(const OpticsCommand& command) {
  if (command.visibility_km || command.aerosol != OpticsCommand().aerosol)
    throw UsageError(command.air +
                     ": --visibility and --aerosol are for profiles: change the air of a scene by "
                     "--set (--set atmosphere.visibility_km=10)");
  const scene::Scene scene = read(command, command.air);
  if (!scene.atmosphere)
    throw UsageError(command.air +
                     ": there is no air above the sea (give it an [atmosphere], or name a profile: "
                     "--air us-standard)");
  const auto air = table_of(scene, command, [&](const std::vector<double>& nm) {
    return medium::air_table(scene, *tables(), nm);
  });
  report(air, {scene.title, scene::write_scene(scene)}, command);
  return done;
}

}  // namespace

int run(const OpticsCommand& command) {
  if (!command.oil.empty()) return report_oil(command);
  if (command.is_air_of_scene()) return report_air_of_scene(command);
  return command.air.empty() ? report_water(command) : report_air(command);
}

}  // namespace photic::app
