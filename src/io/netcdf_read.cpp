#include "io/netcdf.hpp"
#include "io/netcdf_reader.hpp"

namespace photic::io {

std::string read_scene_attribute(const std::string& path) {
  const NetcdfReader reader(path);
  reader.expect_result();
  return reader.text("scene");
}

RunSoFar read_run(const std::string& path) {
  const NetcdfReader reader(path);
  reader.expect_result();
  if (reader.holds_optics()) reader.refuse("holds the optics of layers, and no echoes");
  return {.scene_toml = reader.text("scene"),
          .version = reader.text("version"),
          .engine = reader.text("engine"),
          .history = reader.text("history"),
          .photons = reader.count("photons"),
          .wall_time_s = reader.number("wall_time_s")};
}

}  // namespace photic::io
