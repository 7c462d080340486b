#include "scene/compare.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scene/findings.hpp"
#include "scene/format.hpp"
#include "scene/tree.hpp"

namespace photic::scene {
namespace {

void compare(const Node* left, const Node* right, const std::string& path,
             std::vector<Difference>& out);

/// Above it, a column of numbers is reported as a whole.
constexpr std::size_t max_elements = 4;

/// Elements of two arrays that are equally long.
void compare_elements(const Node::Array& left, const Node::Array& right, const std::string& path,
                      std::vector<Difference>& out) {
  std::vector<Difference> found;
  for (std::size_t i = 0; i < left.size(); ++i) compare(&left[i], &right[i], below(path, i), found);
  const bool plain = std::ranges::none_of(left, [](const Node& element) {
    return element.as<Node::Array>() || element.as<Node::Table>();
  });
  if (plain && found.size() > max_elements)
    found = {{path, fmt::format("an array of {}", left.size()),
              fmt::format("one with {} other values", found.size())}};
  out.insert(out.end(), found.begin(), found.end());
}

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
    if (a && b && a->size() == b->size()) return compare_elements(*a, *b, path, out);
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
