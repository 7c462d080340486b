#include "scene/compare.hpp"

#include "scene/findings.hpp"
#include "scene/format.hpp"
#include "scene/tree.hpp"

namespace photic::scene {
namespace {

void compare(const Node* left, const Node* right, const std::string& path,
             std::vector<Difference>& out);

void compare_tables(const Node& left, const Node& right, const std::string& path,
                    std::vector<Difference>& out) {
  for (const Entry& entry : *left.as<Node::Table>())
    compare(&entry.value, right.find(entry.key), below(path, entry.key), out);
  for (const Entry& entry : *right.as<Node::Table>())
    if (!left.find(entry.key)) compare(nullptr, &entry.value, below(path, entry.key), out);
}

void compare(const Node* left, const Node* right, const std::string& path,
             std::vector<Difference>& out) {
  if (left && right) {
    if (left->as<Node::Table>() && right->as<Node::Table>())
      return compare_tables(*left, *right, path, out);
    const auto* a = left->as<Node::Array>();
    const auto* b = right->as<Node::Array>();
    if (a && b && a->size() == b->size()) {
      for (std::size_t i = 0; i < a->size(); ++i) compare(&(*a)[i], &(*b)[i], below(path, i), out);
      return;
    }
    if (format_json(*left) == format_json(*right)) return;
  }
  const auto text = [](const Node* node) { return node ? found_text(*node) : "not given"; };
  out.push_back({path, text(left), text(right)});
}

}  // namespace

std::vector<Difference> differences(const Scene& left, const Scene& right) {
  std::vector<Difference> out;
  compare_tables(tree_of(left), tree_of(right), "", out);
  return out;
}

}  // namespace photic::scene
