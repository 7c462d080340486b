#include "session/read.hpp"

#include <filesystem>

#include "estimator/model.hpp"
#include "io/netcdf_variable.hpp"

namespace photic::session {

scene::Reading read(const Context& context, const SceneText& scene,
                    const std::vector<scene::Override>& overrides) {
  return scene::read_scene_text(scene.text, scene.name, scene.folder, overrides,
                                estimator::optics_check(context.library), io::netcdf_files());
}

scene::Reading read_file(const Context& context, const std::string& path,
                         const std::vector<scene::Override>& overrides) {
  return scene::read_scene(path, overrides, estimator::optics_check(context.library),
                           io::netcdf_files());
}

std::string folder_of(const std::string& file) {
  return std::filesystem::path(file).parent_path().string();
}

}  // namespace photic::session
