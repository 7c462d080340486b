#include "scene/findings.hpp"

#include <algorithm>
#include <charconv>
#include <tuple>

namespace photic::scene {
namespace {

/// Returns whether `path` is `root` or lies below it.
bool lies_in(const std::string& path, const std::string& root) {
  return root.empty() || path == root || path.rfind(root + ".", 0) == 0;
}

const Node* child(const Node& node, const std::string& key) {
  const auto* array = node.as<Node::Array>();
  if (!array) return node.find(key);
  std::size_t index = 0;
  std::from_chars(key.data(), key.data() + key.size(), index);
  return index < array->size() ? &(*array)[index] : nullptr;
}

bool same(const Diagnostic& a, const Diagnostic& b) {
  return a.file == b.file && a.line == b.line && a.column == b.column && a.reason == b.reason;
}

/// The order of the file, and --set, which has no lines, last.
auto rank(int line, int column) { return std::tuple(line == 0, line, column); }

/// The same for what was found, other files that the scene names between the scene and --set.
auto rank(const Diagnostic& d, const std::string& scene_file) {
  const std::string other = d.file == scene_file || d.line == 0 ? "" : d.file;
  return std::tuple(d.line == 0, other, rank(d.line, d.column));
}

Finding found(const std::string& path, const Place& place, std::string reason,
              std::string suggestion) {
  return {{place.file, place.line, place.column, std::move(reason), std::move(suggestion), path},
          path};
}

}  // namespace

void Findings::add_at(const Place& place, std::string reason, std::string suggestion) {
  problems_.push_back(found("", place, std::move(reason), std::move(suggestion)));
}

void Findings::add(const std::string& path, const Place& place, std::string reason,
                   std::string suggestion) {
  spoil(path);
  problems_.push_back(found(path, place, std::move(reason), std::move(suggestion)));
}

void Findings::add(const std::string& path, std::string reason, std::string suggestion) {
  add(path, place_of(path), std::move(reason), std::move(suggestion));
}

void Findings::add_from_file(const std::string& path, const Place& place, const InputError& error) {
  for (const Diagnostic& d : error.diagnostics()) {
    if (d.line > 0)
      add(path, {d.file, d.line, d.column}, d.reason, d.suggestion);
    else
      add(path, place, d.file + ": " + d.reason, d.suggestion);
  }
}

void Findings::remark(const std::string& path, const std::string& text) {
  remarked_.push_back(found(path, place_of(path), text, ""));
}

void Findings::remark_at(const Place& place, const std::string& text) {
  remarked_.push_back(found("", place, text, ""));
}

std::vector<std::string> Findings::remarks() const {
  std::vector<std::string> texts;
  for (const Finding& finding : remarked_) texts.push_back(finding.what.text());
  return texts;
}

bool Findings::good(std::initializer_list<std::string> paths) const {
  return std::none_of(spoilt_.begin(), spoilt_.end(), [&](const std::string& bad) {
    return std::any_of(paths.begin(), paths.end(), [&](const std::string& path) {
      return lies_in(path, bad) || lies_in(bad, path);
    });
  });
}

bool Findings::given(const std::string& path) const { return node_at(document_, path) != nullptr; }

Place Findings::place_of(const std::string& path) const {
  const Node* node = &document_;
  for (const std::string& key : components(path)) {
    const Node* next = child(*node, key);
    if (!next) break;
    node = next;
  }
  return node == &document_ ? end_ : node->place;
}

Place Findings::place_in(const std::string& path, const std::string& key) const {
  const Node* table = node_at(document_, path);
  if (const auto* entries = table ? table->as<Node::Table>() : nullptr)
    for (const Entry& entry : *entries)
      if (entry.key == key) return entry.value.place.line > 0 ? entry.place : entry.value.place;
  return place_of(path);
}

void Findings::raise() const {
  if (problems_.empty()) return;
  std::vector<Diagnostic> sorted;
  for (const Finding& finding : problems_) sorted.push_back(finding.what);
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Diagnostic& a, const Diagnostic& b) {
    return rank(a, end_.file) < rank(b, end_.file);
  });
  // A value that stands for several layers may be wrong for all of them.
  const auto end = std::unique(sorted.begin(), sorted.end(), same);
  sorted.erase(end, sorted.end());
  throw InputError(std::move(sorted));
}

bool before(const Place& a, const Place& b) {
  return rank(a.line, a.column) < rank(b.line, b.column);
}

std::vector<std::string> components(const std::string& path) {
  std::vector<std::string> parts;
  std::size_t start = 0;
  while (start < path.size()) {
    const std::size_t dot = std::min(path.find('.', start), path.size());
    parts.push_back(path.substr(start, dot - start));
    start = dot + 1;
  }
  return parts;
}

const Node* node_at(const Node& root, const std::string& path) {
  const Node* node = &root;
  for (const std::string& key : components(path)) {
    node = child(*node, key);
    if (!node) return nullptr;
  }
  return node;
}

std::string below(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

std::string below(const std::string& path, std::size_t index) {
  return below(path, std::to_string(index));
}

}  // namespace photic::scene
