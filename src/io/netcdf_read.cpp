#include "io/netcdf.hpp"
#include "io/netcdf_reader.hpp"

namespace photic::io {

std::string read_scene_attribute(const std::string& path) {
  const NetcdfReader reader(path);
  reader.expect_result();
  const std::string other = reader.other_content();
  if (!other.empty() && !reader.has("scene"))
    reader.refuse("holds " + other + " of what is no scene");
  return reader.text("scene");
}

RunSoFar read_run(const std::string& path) {
  const NetcdfReader reader(path);
  reader.expect_result();
  const std::string other = reader.other_content();
  if (!other.empty()) reader.refuse("holds " + other + ", and no echoes");
  return {.scene_toml = reader.text("scene"),
          .version = reader.text("version"),
          .engine = reader.text("engine"),
          .history = reader.text("history"),
          .scene_file = reader.has("scene_file") ? reader.text("scene_file") : "",
          .photons = reader.count("photons"),
          .wall_time_s = reader.number("wall_time_s")};
}

}  // namespace photic::io
