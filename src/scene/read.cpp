#include "scene/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "scene/air_levels.hpp"
#include "scene/channel_steps.hpp"
#include "scene/checks.hpp"
#include "scene/describe.hpp"
#include "scene/environment_grid.hpp"
#include "scene/environments.hpp"
#include "scene/expand_layers.hpp"
#include "scene/override.hpp"
#include "scene/parse.hpp"
#include "scene/reader.hpp"
#include "scene/sensitivities.hpp"
#include "scene/tree.hpp"

namespace photic::scene {
namespace {

/// The first column of the last line.
Place end_of(const std::string& text, const std::string& name) {
  const auto breaks = std::count(text.begin(), text.end(), '\n');
  const bool closed = text.empty() || text.back() == '\n';
  return {name, std::max(1, static_cast<int>(breaks) + (closed ? 0 : 1)), 1};
}

template <class Named>
void fill_names(std::vector<Named>& all, const std::string& stem) {
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].name.empty()) all[i].name = stem + std::to_string(i);
}

[[noreturn]] void refuse_file(const std::string& path, const std::string& reason,
                              const std::string& suggestion) {
  throw InputError({{path, 0, 0, reason, suggestion}});
}

/// Returns whether the first bytes are those of netCDF: HDF5, or CDF in version 1, 2 or 5.
bool begins_as_netcdf(const std::string& bytes) {
  return bytes.starts_with("\x89HDF\r\n\x1a\n") || bytes.starts_with("CDF\x01") ||
         bytes.starts_with("CDF\x02") || bytes.starts_with("CDF\x05");
}

/// Throws InputError for what is no text.
void expect_text(const std::string& path, const std::string& bytes) {
  if (begins_as_netcdf(bytes))
    refuse_file(path, "this is a result, or another netCDF file, not a scene",
                fmt::format("for a result, photic show {0} prints the scene and photic run "
                            "--continue {0} continues it",
                            path));
  if (bytes.find('\0') != std::string::npos)
    refuse_file(path, "this is not a text in UTF-8, and so not a scene",
                "scenes are TOML files: photic new ship prints one");
}

/// Texts of the scene that are names of files, whatever keys they stand under.
void add_files(const Node& node, const std::filesystem::path& folder,
               std::vector<std::string>& files) {
  std::error_code none;
  const auto* text = node.as<std::string>();
  if (text && std::filesystem::is_regular_file(folder / *text, none))
    files.push_back((folder / *text).string());
  if (const auto* array = node.as<Node::Array>())
    for (const Node& element : *array) add_files(element, folder, files);
  if (const auto* table = node.as<Node::Table>())
    for (const Entry& entry : *table) add_files(entry.value, folder, files);
}

/// The scene with its environments, alone all of them being good.
void check_together(const Node& document, const Check& check, const Scene& scene,
                    Findings& findings) {
  Findings again(document, findings.end());
  check(scene, again, Asked::of_environments);
  for (const auto& [what, path] : again.problems())
    findings.add_at({what.file, what.line, what.column}, what.reason, what.suggestion);
}

/// Reads the parts that need files. Where files fail, the known problems of the scene are reported
/// first.
void read_on(const Node& document, const Layered& layered, const Check& check, Scene& scene,
             Findings& findings) {
  try {
    if (check) check(scene, findings, Asked::of_scene);
    read_sensitivities(document, check, scene, findings);
    read_environments(layered, check, scene, findings);
    check_estimator(scene, findings);
    if (check && scene.has_environments() && findings.problems().empty())
      check_together(document, check, scene, findings);
  } catch (const EnvironmentError&) {
    findings.raise();
    throw;
  }
}

/// A table may give its oil's yield and lifetime beside its columns. Light that is not emitted
/// takes no time.
void fill_in_light(Oil& oil, const std::string& oil_path, Findings& findings) {
  if (oil.table.columns().empty()) return;
  const auto& table = oil.table.data();
  const std::string label = oil_path == "oil" ? "[oil]" : "'oil'";
  const auto read = [&](std::optional<double>& value, const char* key) {
    const std::string path = below(oil_path, key);
    if (value) return;
    if (!table.has_header(key) && table.column_line() == 0)
      return findings.add(path, fmt::format("'{}' is missing in {}", key, label),
                          "add it, there or in 'file'");
    if (!table.has_header(key))
      return findings.add(path, {table.name(), 1, 1}, fmt::format("no line \"# {}: …\"", key),
                          fmt::format("add it, or give {} in {}", key, label));
    try {
      value = table.number_in_header(key);
    } catch (const InputError& error) {
      findings.add_from_file(path, findings.place_of(below(oil_path, "file")), error);
    }
  };
  read(oil.yield, "yield");
  if (oil.yield == 0 && !oil.lifetime_ns && !table.has_header("lifetime_ns")) oil.lifetime_ns = 0;
  read(oil.lifetime_ns, "lifetime_ns");
}

/// Oil damps the waves like a slick, on which there are no whitecaps.
void fill_in_oil(const Node& document, Scene& scene, Findings& findings) {
  Surface& surface = scene.sea.surface;
  const Node* sea = document.find("sea");
  const Node* given = sea ? sea->find("surface") : nullptr;
  if (surface.model == SurfaceModel::cox_munk && !(given && given->find("slick")))
    surface.slick = true;
  if (!surface.whitecaps && !surface.whitecap_fraction) surface.whitecaps = false;
  fill_in_light(*scene.oil, "oil", findings);
}

/// The direction of light that comes from a zenith angle and an azimuth.
void fill_in_direction(Source& source, Findings& findings) {
  if (!findings.good({"source.zenith_deg", "source.azimuth_deg"}))
    findings.spoil("source.direction");
  if (!source.zenith_deg) return;
  const double zenith = *source.zenith_deg * radian_per_degree;
  const double azimuth = source.azimuth_deg * radian_per_degree;
  source.direction = {-std::sin(zenith) * std::cos(azimuth), -std::sin(zenith) * std::sin(azimuth),
                      -std::cos(zenith)};
}

/// LOWTRAN 7's visibility of clear air, unless levels have their own aerosols.
void fill_in_air(Atmosphere& air) {
  fill_names(air.layer, "air");
  if (!air.layer.empty() || !air.has_aerosols() || air.visibility_km ||
      air.aerosol_optical_depth_550)
    return;
  if (!has_own_aerosols(air)) air.visibility_km = optics::clear_visibility_km;
}

}  // namespace

Scene scene_of(const Node& document, const std::optional<std::string>& folder, Findings& findings) {
  Scene scene;
  ReadContext context{findings, folder};
  Reader reader(document, {"", "", "the scene"}, context);
  describe(reader, scene);
  reader.finish();
  fill_in_direction(scene.source, findings);
  fill_names(scene.telescope, "telescope");
  fill_names(scene.sea.layer, "layer");
  fill_names(scene.sea.column, "column");
  for (Column& column : scene.sea.column) fill_names(column.layer, "layer");
  fill_names(scene.environment, "environment");
  const auto is_measured = [](const PlacedLayer& l) {
    return !l->iop.empty() || !l->jerlov.empty();
  };
  if (!scene.optics.emission)
    scene.optics.emission = std::ranges::any_of(layers_of(scene.sea), is_measured)
                                ? Emission::lines
                                : Emission::spectra;
  Surface& surface = scene.sea.surface;
  if (scene.oil) fill_in_oil(document, scene, findings);
  for (std::size_t i = 0; i < scene.sea.column.size(); ++i)
    if (auto& oil = scene.sea.column[i].oil)
      fill_in_light(*oil, below(below("sea.column", i), "oil"), findings);
  if (surface.is_rough()) surface.whitecaps = surface.has_whitecaps();
  if (scene.atmosphere) fill_in_air(*scene.atmosphere);
  return scene;
}

std::string text_of_scene(const std::string& path) {
  std::error_code unknown;
  const auto status = std::filesystem::status(path, unknown);
  if (status.type() == std::filesystem::file_type::not_found)
    refuse_file(path, "there is no such file", "photic new ship -o FILE writes a scene");
  if (std::filesystem::is_directory(status))
    refuse_file(path, "this is a folder and not a scene", "name a scene file in it");
  const auto fail = [&](const std::string& why) {
    throw EnvironmentError("cannot read the scene " + path + ": " + why);
  };
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(std::generic_category().message(errno));
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) fail("reading failed");
  expect_text(path, text);
  return text;
}

Node document_of(const std::string& text, const std::string& name) {
  Node document = parse_toml(text, name);
  document.place = end_of(text, name);
  return document;
}

Reading read_scene_text(const std::string& text, const std::string& name, const std::string& folder,
                        const std::vector<Override>& overrides, const Check& check,
                        const NetcdfFiles& netcdf) {
  Node document = document_of(text, name);
  Findings findings(document, document.place);
  for (const Override& override_text : overrides) apply_override(override_text, document, findings);
  return read_document(document, folder, findings, check, netcdf);
}

Reading read_document(Node& document, const std::string& folder, Findings& findings,
                      const Check& check, const NetcdfFiles& netcdf) {
  std::vector<std::string> files;
  add_files(document, folder, files);
  expand_grid(document, findings);
  const std::vector<std::size_t> channels = expand_channels(document);
  const NetcdfFiles kept_netcdf = read_once(netcdf);
  Layered layered{document, {folder, kept_netcdf}, {}};
  layered.cuts = expand_layers(document, layered.files, nullptr, findings);
  Reading reading{scene_of(document, folder, findings), {}, std::move(files)};
  reading.multiples = multiples_of(document, layered.cuts);
  if (!channels.empty()) reading.multiples["channel"] = channels;
  check_sea(reading.scene, findings);
  check_bottom(reading.scene, findings);
  check_oil(reading.scene, findings);
  check_columns(reading.scene, findings);
  check_atmosphere(reading.scene, findings);
  check_instrument(reading.scene, findings);
  check_gates(reading.scene, findings);
  check_surface(reading.scene, findings);
  check_tallies(reading.scene, findings);
  check_spherical(reading.scene, findings);
  check_memory(reading.scene, findings);
  read_on(document, layered, check, reading.scene, findings);
  findings.raise();
  reading.remarks = findings.remarks();
  return reading;
}

Reading read_scene(const std::string& path, const std::vector<Override>& overrides,
                   const Check& check, const NetcdfFiles& netcdf) {
  return read_scene_text(text_of_scene(path), path,
                         std::filesystem::path(path).parent_path().string(), overrides, check,
                         netcdf);
}

}  // namespace photic::scene
