#include <filesystem>
#include <utility>

#include "estimator/model.hpp"
#include "io/netcdf.hpp"
#include "io/netcdf_variable.hpp"
#include "io/table_parts.hpp"
#include "photic/commands.hpp"
#include "photic/output.hpp"

namespace photic::app {
namespace {

scene::Reading read(const ShowCommand& command) {
  if (format_of(command.file) != Format::netcdf)
    return scene::read_scene(command.file, command.overrides, estimator::optics_check(),
                             io::netcdf_files());
  return scene::read_scene_text(io::read_scene_attribute(command.file), command.file,
                                std::filesystem::path(command.file).parent_path().string(),
                                command.overrides, estimator::optics_check(), io::netcdf_files());
}

constexpr std::size_t comment_width = 96;

/// Where every number of the water comes from, as comments under the scene.
std::string sources_of(const estimator::Model& model) {
  std::string out = "\n# The optics of this scene and their sources:\n";
  for (const std::string& source : estimator::describe(model).sources) {
    std::string start = "#   ";
    for (const std::string& line : io::wrapped(source, comment_width)) {
      out += std::exchange(start, "#     ") + line + '\n';
    }
  }
  return out;
}

}  // namespace

int run(const ShowCommand& command) {
  const estimator::Model model = estimator::make_model(read(command).scene);
  print_out(command.json ? scene::write_scene_json(model.scene) + '\n'
                         : scene::write_scene(model.scene) + sources_of(model));
  return done;
}

}  // namespace photic::app
