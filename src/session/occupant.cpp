#include "session/occupant.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "core/error.hpp"
#include "io/csv.hpp"
#include "io/netcdf.hpp"
#include "session/continuation.hpp"
#include "session/result_file.hpp"

namespace photic::session {
namespace {

namespace fs = std::filesystem;

fs::path folder_around(const std::string& file) { return fs::absolute(file).parent_path(); }

/// A scene that went elsewhere with its folder is still the same; one that is there is not.
bool is_same_file(const std::string& recorded, const Origin& origin, const std::string& result) {
  if (recorded.empty() || origin.scene_file.empty() || recorded == origin.scene_file) return true;
  std::error_code none;
  const fs::path folder = folder_around(result);
  if (fs::equivalent(folder / recorded, folder / origin.scene_file, none)) return true;  // by links
  return fs::path(recorded).filename() == fs::path(origin.scene_file).filename() &&
         !fs::exists(folder / recorded, none);
}

Occupant netcdf_occupant(const std::string& file, const Origin& origin) {
  using Kind = Occupant::Kind;
  try {
    const io::RunSoFar run = io::read_run(file);
    if (is_same_scene(run, file, origin.scene, *origin.library))
      return {Kind::same_scene, run.photons, ""};
    if (is_same_file(run.scene_file, origin, file)) return {Kind::edited_scene, run.photons, ""};
    return {Kind::other_scene, run.photons,
            fmt::format("is the result of another scene file, {}", run.scene_file)};
  } catch (const InputError& error) {
    return {Kind::stranger, 0, error.diagnostics().front().reason};
  }
}

Occupant text_occupant(const std::string& file) {
  if (const auto photons = io::photons_in_text(file))
    return {Occupant::Kind::some_scene, *photons, ""};
  return {Occupant::Kind::stranger, 0, "is no result of a run"};
}

}  // namespace

Occupant occupant_of(const std::string& file, const Origin& origin) {
  std::error_code none;
  if (!fs::exists(file, none) || (fs::is_regular_file(file, none) && fs::is_empty(file, none)))
    return {};
  return format_of(file) == Format::netcdf ? netcdf_occupant(file, origin) : text_occupant(file);
}

bool holds_echoes(const std::string& file) {
  std::error_code none;
  if (!fs::is_regular_file(file, none)) return false;
  if (format_of(file) != Format::netcdf) return io::photons_in_text(file).has_value();
  try {
    return !io::read_run(file).scene_toml.empty();
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace photic::session
