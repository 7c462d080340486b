#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/vec3.hpp"
#include "estimator/focus.hpp"
#include "estimator/model.hpp"
#include "estimator/nested_views.hpp"
#include "estimator/spherical_air.hpp"
#include "io/netcdf.hpp"
#include "io/netcdf_variable.hpp"
#include "io/table_parts.hpp"
#include "medium/air.hpp"
#include "photic/commands.hpp"
#include "photic/output.hpp"
#include "photic/tables.hpp"
#include "session/result_file.hpp"

namespace photic::app {
namespace {

scene::Reading read(const ShowCommand& command) {
  if (session::format_of(command.file) != session::Format::netcdf)
    return scene::read_scene(command.file, command.overrides, optics_check(), io::netcdf_files());
  return scene::read_scene_text(io::read_scene_attribute(command.file), command.file,
                                std::filesystem::path(command.file).parent_path().string(),
                                command.overrides, optics_check(), io::netcdf_files());
}

constexpr std::size_t comment_width = 96;

/// A list as comments; nothing of an empty one.
std::string comments(const std::string& head, const std::vector<std::string>& items) {
  if (items.empty()) return "";
  std::string out = "\n# " + head + ":\n";
  for (const std::string& item : items) {
    std::string start = "#   ";
    for (const std::string& line : io::wrapped(item, comment_width))
      out += std::exchange(start, "#     ") + line + '\n';
  }
  return out;
}

/// The light of the sun on a level area; of a planet no area is level for all.
std::vector<std::string> reported_light(const scene::Scene& scene) {
  const scene::Source& source = scene.source;
  if (!source.irradiance_w_m2 || scene.is_of_spherical_air()) return {};
  return {fmt::format("{:.6g} W/m2 across the beam, {:.6g} W/m2 on the horizontal",
                      *source.irradiance_w_m2,
                      *source.irradiance_w_m2 * std::abs(normalised(source.direction).z))};
}

/// The irradiance by the sun, the focus of telescopes, what the air takes of the laser's light, how
/// paths are drawn, which telescopes share them, and where every number comes from.
std::string notes_on(const estimator::Model& model) {
  const tally::Result result = estimator::describe(model);
  const auto of_air = model.air ? medium::reported_air(estimator::reported_scene(model), *model.air)
                                : std::vector<std::string>{};
  return comments("The irradiance of the source",
                  reported_light(estimator::reported_scene(model))) +
         comments("The spherical air",
                  estimator::reported_spherical_air(estimator::reported_scene(model))) +
         comments(
             "The share of each open lens whose rays reach the detector, from points on its axis",
             estimator::reported_focus(model)) +
         comments("The air above the sea", of_air) +
         comments("How the bidirectional estimator draws paths", result.strategies) +
         comments("Telescopes that share their light",
                  estimator::reported_nested_views(model.scene)) +
         comments("The optics of this scene and their sources", result.sources);
}

}  // namespace

int run(const ShowCommand& command) {
  const scene::Reading reading = read(command);
  for (const std::string& remark : reading.remarks) print_warning(remark + '\n');
  const estimator::Model model = estimator::make_model(reading.scene, *tables());
  print_out(command.json ? scene::write_scene_json(estimator::reported_scene(model)) + '\n'
                         : scene::write_scene(estimator::reported_scene(model)) + notes_on(model));
  return done;
}

}  // namespace photic::app
