#include "session/document.hpp"

#include <algorithm>
#include <utility>

#include "estimator/model.hpp"
#include "io/netcdf_variable.hpp"
#include "scene/environment_grid.hpp"
#include "scene/findings.hpp"
#include "scene/format.hpp"
#include "scene/override.hpp"
#include "scene/tree.hpp"

namespace photic::session {
namespace {

using scene::Node;

/// The name of a scene without a file.
constexpr const char* scene_of_values = "scene";

/// Gives a value and all in it their paths for places.
void place_by_path(const std::string& path, Node& node) {
  node.place = {path, 0, 0};
  if (auto* array = node.as<Node::Array>())
    for (std::size_t i = 0; i < array->size(); ++i)
      place_by_path(scene::below(path, i), (*array)[i]);
  if (auto* table = node.as<Node::Table>())
    for (scene::Entry& entry : *table) {
      place_by_path(scene::below(path, entry.key), entry.value);
      entry.place = entry.value.place;
    }
}

/// The tree as it is checked: its profiles and grids are put in full, which `given` is not.
scene::Reading checked(const Context& context, Node given, const std::string& folder,
                       const std::vector<Change>& changes, Node& changed) {
  scene::Findings findings(given, given.place);
  for (const auto& [path, value] : changes) {
    const scene::Place place{path, 0, 0};
    if (!value) {
      scene::take_away(path, place, given, findings);
      continue;
    }
    Node placed = *value;
    place_by_path(path, placed);
    scene::assign(path, std::move(placed), place, given, findings);
  }
  changed = given;
  return scene::read_document(given, folder, findings, estimator::optics_check(context.library),
                              io::netcdf_files());
}

/// The document with the environments of a grid in full.
Node with_all_environments(Node document) {
  scene::Findings none(document, document.place);
  scene::expand_grid(document, none);
  return document;
}

bool holds_tables(const Node& node) {
  const auto* array = node.as<Node::Array>();
  return array && !array->empty() && std::ranges::all_of(*array, [](const Node& element) {
           return element.as<Node::Table>() != nullptr;
         });
}

/// Has tables stand under headers as in the starter scenes: [sea] and [[sea.layer]], but all else
/// in one line.
void put_in_sections(Node& document) {
  for (scene::Entry& entry : *document.as<Node::Table>()) {
    entry.value.section = entry.value.as<Node::Table>() || holds_tables(entry.value);
    auto* table = entry.value.as<Node::Table>();
    for (std::size_t i = 0; table && i < table->size(); ++i)
      (*table)[i].value.section = holds_tables((*table)[i].value);
  }
}

}  // namespace

Document::Document(const Context& context, const SceneText& scene,
                   const std::vector<Change>& changes)
    : context_(context),
      name_(scene.name),
      folder_(scene.folder),
      text_(changes.empty() ? std::optional(scene.text) : std::nullopt),
      reading_(checked(context_, scene::document_of(scene.text, scene.name), folder_, changes,
                       given_)) {}

Document::Document(const Context& context, Node values, std::string folder,
                   const std::vector<Change>& changes)
    : context_(context), name_(scene_of_values), folder_(std::move(folder)) {
  place_by_path("", values);
  values.place = {name_, 0, 0};
  reading_ = checked(context_, std::move(values), folder_, changes, given_);
}

void Document::change(const std::vector<Change>& changes) {
  Node changed;
  reading_ = checked(context_, given_, folder_, changes, changed);
  given_ = std::move(changed);
  text_.reset();
}

std::optional<Node> Document::find(const std::string& path) const {
  if (const Node* given = scene::find(path, given_)) return *given;
  if (path.starts_with("environment.") && given_.find("environment_grid")) {
    const Node full = with_all_environments(given_);
    if (const Node* given = scene::find(path, full)) return *given;
    return scene::find_default(path, full, scene::tree_of(reading_.scene), reading_.multiples);
  }
  return scene::find_default(path, given_, scene::tree_of(reading_.scene), reading_.multiples);
}

std::string Document::toml() const {
  if (text_) return *text_;
  Node document = given_;
  put_in_sections(document);
  return scene::format_toml(document);
}

}  // namespace photic::session
