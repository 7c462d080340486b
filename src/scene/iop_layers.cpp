#include "scene/iop_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "scene/describe_iop_table.hpp"
#include "scene/iop_grid.hpp"
#include "scene/reader.hpp"
#include "scene/schema_builder.hpp"

namespace photic::scene {
namespace {

constexpr const char* table_key = "iop_table";
constexpr const char* table_path = "sea.iop_table";

Node at(const Place& place, double value) { return {.value = value, .place = place}; }

Node empty_table_at(const Place& place) {
  Node table = empty_table();
  table.place = place;
  return table;
}

/// The optical properties of depth d and wavelength w as an element of an iop list.
Node entry_of(const IopGrid& grid, std::size_t d, std::size_t w, Findings& findings) {
  const std::size_t i = d * grid.wavelength_nm.size() + w;
  const auto place = [&](const char* name) { return grid.place(name, i); };
  const auto value = [&](const char* name) { return grid.value.at(name)[i]; };
  Node entry = empty_table_at(place("a_per_m"));
  entry.add("wavelength_nm", at(place("wavelength_nm"), grid.wavelength_nm[w]));
  entry.add("a_per_m", at(entry.place, value("a_per_m")));
  if (grid.has("b_per_m")) {
    entry.add("b_per_m", at(place("b_per_m"), value("b_per_m")));
  } else {
    const double a = value("a_per_m"), c = value("c_per_m");
    if (c < a)
      findings.add_at(
          place("c_per_m"),
          fmt::format("c_per_m, {}, is below a_per_m, {}", plain_number(c), plain_number(a)),
          "c is a + b");
    entry.add("b_per_m", at(place("c_per_m"), c < a ? 0.0 : c - a));
  }
  for (const char* name : {"a_phytoplankton_per_m", "a_cdom_per_m", "bb_per_m"})
    if (grid.has(name)) entry.add(name, at(place(name), value(name)));
  return entry;
}

Node layers_of(const IopGrid& grid, const Node* phase_function, const Place& place,
               Findings& findings) {
  Node::Array layers;
  for (std::size_t d = 0; d < grid.depth_m.size(); ++d) {
    Node& layer = layers.emplace_back(empty_table_at(place));
    if (d + 1 < grid.depth_m.size())
      layer.add("bottom_depth_m", at(grid.place("depth_m", (d + 1) * grid.wavelength_nm.size()),
                                     grid.depth_m[d + 1]));
    Node::Array iop;
    for (std::size_t w = 0; w < grid.wavelength_nm.size(); ++w)
      iop.push_back(entry_of(grid, d, w, findings));
    layer.add("iop", {.value = std::move(iop), .place = place});
    if (phase_function) layer.add("phase_function", *phase_function);
  }
  return {.value = std::move(layers), .place = place};
}

/// A file's name stands for a table with nothing else.
Node as_table(const Node& given) {
  if (!given.as<std::string>()) return given;
  Node table = empty_table_at(given.place);
  table.add(file_key, given);
  return table;
}

/// The table's own keys; nothing if anything is wrong with them.
std::optional<IopTable> keys_of(const Node& given, const OtherFiles& files, Findings& findings) {
  if (!given.as<Node::Table>()) {
    findings.add(
        table_path, given.place,
        fmt::format("'{}' must be a file or a table, not {}", table_key, found_text(given)),
        "write { file = …, phase_function = … }");
    return std::nullopt;
  }
  const std::size_t before = findings.problems().size();
  ReadContext context{findings, files.folder};
  IopTable keys;
  Reader reader(given, {table_path, table_path, fmt::format("'{}'", table_key)}, context);
  describe(reader, keys);
  reader.finish();
  return findings.problems().size() == before ? std::optional(keys) : std::nullopt;
}

IopNames names_in_file(const IopTable& keys) {
  IopNames names;
  for (std::size_t i = 0; i < iop_columns.size(); ++i)
    names.emplace_back(iop_columns[i].name, keys.column[i].value_or(optics::ColumnInFile{}));
  return names;
}

/// Places in a netCDF file, which has no lines, behind that of the scene that names it.
void place_behind(const Place& scene, IopGrid& grid) {
  grid.place = [scene, in_file = grid.place](const std::string& name, std::size_t i) {
    Place place = in_file(name, i);
    if (place.line == 0 && scene.line > 0)
      place.file = fmt::format("{}:{}:{}: {}", scene.file, scene.line, scene.column, place.file);
    return place;
  };
}

/// Either the file gives the phase function, or the scene.
bool check_phase_function(const IopGrid& grid, const Node& table, Findings& findings) {
  const Node* given = table.find("phase_function");
  if (grid.has("bb_per_m") == (given == nullptr)) return true;
  if (given)
    findings.add(table_path, given->place,
                 "'phase_function' and the file's bb_per_m exclude each other", "keep one of them");
  else
    findings.add(
        table_path, table.place,
        fmt::format("'phase_function' is missing in '{}', whose file has no bb_per_m", table_key),
        "write { file = …, phase_function = … }");
  return false;
}

std::optional<Node> read_layers(const Node& given, const OtherFiles& files, Findings& findings) {
  const Node table = as_table(given);
  const auto keys = keys_of(table, files, findings);
  if (!keys) return std::nullopt;
  try {
    IopGrid grid = read_iop_grid(keys->file, names_in_file(*keys), files.netcdf);
    place_behind(table.find(file_key)->place, grid);
    if (!check_phase_function(grid, table, findings)) return std::nullopt;
    return layers_of(grid, table.find("phase_function"), given.place, findings);
  } catch (const InputError& error) {
    findings.add_from_file(table_path, table.find(file_key)->place, error);
    return std::nullopt;
  }
}

}  // namespace

Node schema_of(const IopTableKey&) {
  SchemaBuilder builder;
  IopTable keys;
  describe(builder, keys);
  Node schema = empty_table();
  schema.add("anyOf", {.value = Node::Array{schema_of(Text{}), builder.take()}});
  return schema;
}

void expand_iop_table(Node& document, const OtherFiles& files, Findings& findings) {
  Node* sea = document.find("sea");
  auto* keys = sea ? sea->as<Node::Table>() : nullptr;
  if (!keys) return;
  const auto entry =
      std::find_if(keys->begin(), keys->end(), [](const Entry& e) { return e.key == table_key; });
  if (entry == keys->end()) return;
  const Entry given = std::move(*entry);
  keys->erase(entry);
  for (const char* other : {layer_key, column_key})
    if (sea->find(other))
      return findings.add(
          table_path, given.place,
          fmt::format("'{}' and '{}' exclude each other in [sea]", other, table_key),
          "keep one of them");
  auto layers = read_layers(given.value, files, findings);
  if (!layers) {
    findings.spoil(below("sea", layer_key));
    layers = Node{.value = Node::Array{empty_table_at(given.place)}, .place = given.place};
  }
  sea->add(layer_key, std::move(*layers));
}

}  // namespace photic::scene
