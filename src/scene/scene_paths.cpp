#include "scene/scene_paths.hpp"

#include <nlohmann/json.hpp>

#include "scene/read.hpp"

namespace photic::scene {
namespace {

using Json = nlohmann::ordered_json;

std::vector<SceneChoice> choices_of(const Json& schema) {
  if (schema.value("type", "") == "boolean") return {{"true", ""}, {"false", ""}};
  std::vector<SceneChoice> choices;
  for (const Json& choice : schema.value("oneOf", Json::array()))
    if (choice.contains("const"))
      choices.push_back({choice["const"].get<std::string>(), choice.value("description", "")});
  return choices;
}

void collect(const Json& table, const std::string& prefix, std::vector<ScenePath>& paths) {
  for (const auto& [key, schema] : table.at("properties").items()) {
    const std::string path = prefix + key;
    if (schema.contains("properties"))
      collect(schema, path + '.', paths);
    else if (schema.contains("items") && schema["items"].contains("properties"))
      collect(schema["items"], path + ".*.", paths);
    else
      paths.push_back({path, schema.value("description", ""), choices_of(schema)});
  }
}

}  // namespace

std::vector<ScenePath> scene_paths() {
  std::vector<ScenePath> paths;
  collect(Json::parse(scene_schema("")), "", paths);
  return paths;
}

}  // namespace photic::scene
