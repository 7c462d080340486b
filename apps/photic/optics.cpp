#include <fmt/format.h>

#include "core/error.hpp"
#include "estimator/model.hpp"
#include "io/netcdf_variable.hpp"
#include "medium/optical_table.hpp"
#include "optics/data_folder.hpp"
#include "photic/commands.hpp"
#include "photic/output.hpp"
#include "photic/tell_optics.hpp"

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
                                estimator::optics_check(), io::netcdf_files());
}

scene::Scene read(const OpticsCommand& command) {
  if (!command.output.empty()) check_optics_output(command.output, command.scene);
  const scene::Reading reading =
      command.scene.empty() ? read_water(command)
                            : scene::read_scene(command.scene, command.overrides,
                                                estimator::optics_check(), io::netcdf_files());
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

}  // namespace

int run(const OpticsCommand& command) {
  if (!command.oil.empty()) return tell_oil(command);
  if (!command.air.empty()) return tell_air(command);
  const scene::Scene scene = read(command);
  const medium::OpticalTable table = table_of(scene, command);
  tell(table, {scene.title, scene::write_scene(scene)}, command);
  return done;
}

}  // namespace photic::app
