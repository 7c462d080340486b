#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "scene/format.hpp"

namespace photic::scene {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Node& node) {
  if (const auto* table = node.as<Node::Table>()) {
    Json out = Json::object();
    for (const Entry& entry : *table) out[entry.key] = to_json(entry.value);
    return out;
  }
  if (const auto* array = node.as<Node::Array>()) {
    Json out = Json::array();
    for (const Node& element : *array) out.push_back(to_json(element));
    return out;
  }
  if (const auto* b = node.as<bool>()) return *b;
  if (const auto* i = node.as<std::int64_t>()) return *i;
  if (const auto* x = node.as<double>()) return *x;
  const auto* text = node.as<std::string>();
  expect(text != nullptr, "nobody writes dates");
  return *text;
}

}  // namespace

std::string format_json(const Node& node) {
  return to_json(node).dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace photic::scene
