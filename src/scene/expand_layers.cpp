#include "scene/expand_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <utility>

#include "scene/describe_sea.hpp"
#include "scene/profile_reader.hpp"

namespace photic::scene {
namespace {

constexpr const char* bottom_key = "bottom_depth_m";
constexpr const char* name_key = "name";

std::optional<double> number_of(const Node* node) {
  double value = 0;
  if (!node || check(any_number, *node, value)) return std::nullopt;
  return value;
}

void set(Node& table, const std::string& key, Node value) {
  if (Node* old = table.find(key))
    *old = std::move(value);
  else
    table.add(key, std::move(value));
}

void set_number(Node& table, const std::string& key, double value) {
  const Node* old = table.find(key);
  set(table, key, {.value = value, .place = old ? old->place : table.place});
}

/// Takes the layers of a stack one by one, and reports what they become.
class LayerExpander {
 public:
  /// `path`: of the layers.
  LayerExpander(const Node::Array& layers, std::string path, const OtherFiles& files,
                double tolerance, const Cuts* scene_cuts, Findings& findings)
      : layers_(layers),
        path_(std::move(path)),
        keys_(profiled_keys()),
        files_(files),
        tolerance_(tolerance),
        scene_cuts_(scene_cuts && scene_cuts->size() == layers.size() ? scene_cuts : nullptr),
        findings_(findings) {}

  void expand(std::size_t i) {
    Node layer = layers_[i];
    const std::vector<Found> found = take_profiles(i, layer);
    auto ends = ends_of(i, found);
    if (!ends) ends.emplace();  // its problems have been reported
    for (std::size_t k = 0; k < ends->size(); ++k) add_cut(layer, i, k, *ends, found);
    if (ends->empty()) out.push_back(std::move(layer));
    origin_.resize(out.size(), i);
    cuts.push_back(std::move(*ends));
  }

  /// Layers keep the names that they have by default, and their cuts add a number to it.
  void name_layers() {
    if (out.size() == layers_.size()) return;
    std::size_t k = 0;
    for (std::size_t j = 0; j < out.size(); ++j) {
      const std::size_t i = origin_[j];
      k = j > 0 && origin_[j - 1] == i ? k + 1 : 0;
      const Node* given = out[j].find(name_key);
      if (given && !given->as<std::string>()) continue;  // refused where it is read
      std::string name = given ? *given->as<std::string>() : fmt::format("layer{}", i);
      if (cuts[i].size() > 1) name += fmt::format(".{}", k);
      set(out[j], name_key, {.value = name, .place = given ? given->place : out[j].place});
    }
  }

  Node::Array out;
  Cuts cuts;

 private:
  struct Found {
    std::string key;
    std::string path;
    Place place;
    Varying varying;
    Number rule;
  };

  /// From the bottom of the layer above to its own; nothing if they are missing or wrong.
  [[nodiscard]] std::optional<Span> span_of(std::size_t i) const {
    const auto top = i == 0 ? 0.0 : number_of(layers_[i - 1].find(bottom_key));
    const auto bottom = number_of(layers_[i].find(bottom_key));
    if (!top || !bottom || *top < 0 || !(*bottom > *top)) return std::nullopt;
    return Span{*top, *bottom};
  }

  /// Reads the profiles of a layer, in whose place there are numbers from now on.
  std::vector<Found> take_profiles(std::size_t i, Node& layer) {
    std::vector<Found> found;
    const auto span = span_of(i);
    for (const ProfiledKey& key : keys_) {
      const Node* node = layers_[i].find(key.key);
      if (!node || !node->as<Node::Table>()) continue;
      const std::string path = below(below(path_, out.size()), key.key);
      if (span) {
        if (auto profile = read_profile(*node, path, key, *span, files_, findings_))
          found.push_back({key.key, path, node->place, {std::move(*profile), key.scale}, key.rule});
      } else if (!layers_[i].find(bottom_key)) {
        findings_.add(
            path, node->place,
            fmt::format("'{}' changes with depth in a layer without '{}'", key.key, bottom_key),
            "end the layer, and add one with a number below it");
      }
      if (!span) findings_.spoil(path);
      set_number(layer, key.key, 0.0);
    }
    return found;
  }

  /// The ends of a layer's cuts: none if it stays as it is; nothing if it cannot be.
  std::optional<std::vector<double>> ends_of(std::size_t i, const std::vector<Found>& found) {
    const auto span = span_of(i);
    if (scene_cuts_ && span) {
      const auto& given = (*scene_cuts_)[i];
      if (given.empty() && found.empty()) return given;
      if (given.empty() || given.back() == span->bottom_m) {
        const auto ends = given.empty() ? std::vector{span->bottom_m} : given;
        check_departures(found, *span, ends);
        return ends;
      }
    }
    if (found.empty()) return std::vector<double>{};
    std::vector<Varying> profiles;
    for (const Found& f : found) profiles.push_back(f.varying);
    auto ends = cut(profiles, *span, tolerance_);
    if (ends) return ends;
    const auto enough = tolerance_to_keep(profiles, *span, tolerance_);
    findings_.add(
        found.front().path, found.front().place,
        fmt::format("the layer would be cut into more than {} with profile_tolerance = {}",
                    max_cuts, plain_number(tolerance_)),
        enough ? fmt::format("profile_tolerance = {:g} would do", *enough)
               : "are the units right?");
    return std::nullopt;
  }

  /// Checks that an environment's profiles are well cut where the scene's are.
  void check_departures(const std::vector<Found>& found, const Span& span,
                        const std::vector<double>& ends) {
    constexpr double rounding = 1 + 1e-9;
    for (const Found& f : found) {
      const double allowed = allowed_departure(f.varying, span, tolerance_);
      double top = span.top_m;
      for (const double end : ends) {
        const double most = departure(f.varying.profile, top, end);
        if (!(most <= allowed * rounding)) {
          findings_.add(f.path, f.place,
                        fmt::format("'{}' departs from its mean by {:.3g} between {:.6g} and "
                                    "{:.6g} m, a layer of the scene; profile_tolerance allows "
                                    "{:.3g}",
                                    f.key, most, top, end, allowed),
                        "allow more by \"sea.profile_tolerance\" in the environment, or simulate "
                        "that in a scene of its own");
          break;
        }
        top = end;
      }
    }
  }

  void add_cut(const Node& layer, std::size_t i, std::size_t k, const std::vector<double>& ends,
               const std::vector<Found>& found) {
    const double top = k == 0 ? span_of(i)->top_m : ends[k - 1];
    Node& part = out.emplace_back(layer);
    if (k + 1 < ends.size()) set_number(part, bottom_key, ends[k]);
    for (const Found& f : found) {  // rounding must not take a mean out of what values may be
      const double value = mean(f.varying.profile, top, ends[k]);
      set_number(part, f.key, std::clamp(value, f.rule.low, f.rule.high));
    }
  }

  const Node::Array& layers_;
  const std::string path_;
  const std::vector<ProfiledKey> keys_;
  const OtherFiles& files_;
  double tolerance_;
  const Cuts* scene_cuts_;
  Findings& findings_;
  std::vector<std::size_t> origin_;  ///< the layer that each of `out` comes from
};

double tolerance_of(const Node& sea, Findings& findings) {
  const Node* given = sea.find("profile_tolerance");
  double tolerance = default_profile_tolerance;
  if (!given) return tolerance;
  if (const auto refusal = check(profile_tolerance_rule, *given, tolerance))
    findings.add("sea.profile_tolerance", given->place, "'profile_tolerance' " + refusal->reason,
                 refusal->suggestion);
  return tolerance;
}

/// The element that a part of a path names, which by default is called `stem` and its number.
std::optional<std::size_t> element_called(const Node::Array& elements, const std::string& part,
                                          const std::string& stem) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
  if (error == std::errc() && end == part.data() + part.size())
    return index < elements.size() ? std::optional(index) : std::nullopt;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const Node* name = elements[i].find(name_key);
    if (!name && part == fmt::format("{}{}", stem, i)) return i;
    if (name && name->as<std::string>() && *name->as<std::string>() == part) return i;
  }
  return std::nullopt;
}

/// The elements of an array of tables; null if it is none.
Node::Array* tables_in(Node* node) {
  auto* elements = node ? node->as<Node::Array>() : nullptr;
  const auto is_table = [](const Node& element) { return element.as<Node::Table>() != nullptr; };
  return elements && std::ranges::all_of(*elements, is_table) ? elements : nullptr;
}

/// The layers of a sea or a column in the document, and what they become.
struct ExpandedStack {
  Node::Array* layers = nullptr;  ///< null: what is there is refused where it is read
  std::string path;               ///< "sea.layer", "sea.column.0.layer"
  Node::Array before = {};        ///< the layers as the file has them
  Cuts cuts = {};
};

/// Those of the sea, if it has any, and those of each of its columns.
std::vector<ExpandedStack> stacks_in(Node& sea) {
  std::vector<ExpandedStack> out;
  if (Node* layers = sea.find(layer_key)) out.push_back({tables_in(layers), "sea.layer"});
  auto* columns = tables_in(sea.find(column_key));
  for (std::size_t i = 0; columns && i < columns->size(); ++i)
    out.push_back({tables_in((*columns)[i].find(layer_key)),
                   below(below(below("sea", column_key), i), layer_key)});
  return out;
}

/// Makes the layers of a stack homogeneous.
void expand(ExpandedStack& stack, const OtherFiles& files, double tolerance, const Cuts* scene_cuts,
            Findings& findings) {
  if (!stack.layers) return;
  stack.before = *stack.layers;
  LayerExpander expander(stack.before, stack.path, files, tolerance, scene_cuts, findings);
  for (std::size_t i = 0; i < stack.before.size(); ++i) expander.expand(i);
  expander.name_layers();
  stack.cuts = std::move(expander.cuts);
  *stack.layers = std::move(expander.out);
}

/// The layers that a path goes through: "sea.layer", or, by the name or the number of a column,
/// "sea.column.0.layer".
std::optional<std::string> stack_of(const std::vector<std::string>& parts, Node& sea) {
  if (parts.size() > 3 && parts[0] == "sea" && parts[1] == layer_key) return "sea.layer";
  if (parts.size() < 6 || parts[0] != "sea" || parts[1] != column_key || parts[3] != layer_key)
    return std::nullopt;
  const auto* columns = tables_in(sea.find(column_key));
  const auto i = columns ? element_called(*columns, parts[2], column_key) : std::nullopt;
  if (!i) return std::nullopt;
  return below(below(below("sea", column_key), *i), layer_key);
}

/// The path of a parameter where its layers are now; nothing if it is in none of the stack's, or in
/// a layer that has been cut, which is refused at a place.
std::optional<std::string> moved(const std::string& path, const ExpandedStack& stack,
                                 const std::string& refused, const Place& place,
                                 Findings& findings) {
  const auto parts = components(path);
  const std::size_t at = components(stack.path).size();
  const auto i = element_called(stack.before, parts[at], layer_key);
  if (!i) return std::nullopt;
  if (stack.cuts[*i].size() > 1) {
    findings.add(refused, place,
                 fmt::format("'{}' is in a layer that its profiles cut into {}: it has no single "
                             "value for a derivative",
                             path, stack.cuts[*i].size()),
                 "compare environments, or take the derivative in the scene that `photic show` "
                 "writes");
    return std::nullopt;
  }
  std::size_t now = 0;
  for (std::size_t k = 0; k < *i; ++k) now += std::max<std::size_t>(stack.cuts[k].size(), 1);
  std::string out = below(stack.path, now);
  for (std::size_t p = at + 1; p < parts.size(); ++p) out = below(out, parts[p]);
  return out;
}

/// Derivatives are with respect to values of the layers that there are now.
void move_sensitivities(Node& document, const std::vector<ExpandedStack>& stacks,
                        Findings& findings) {
  Node* sensitivity = document.find("sensitivity");
  auto* elements = sensitivity ? sensitivity->as<Node::Array>() : nullptr;
  if (!elements) return;
  for (std::size_t s = 0; s < elements->size(); ++s) {
    auto* path = (*elements)[s].as<std::string>();
    if (!path) continue;
    const auto through = stack_of(components(*path), *document.find("sea"));
    const auto stack = std::ranges::find(stacks, through.value_or(""), &ExpandedStack::path);
    if (stack == stacks.end() || !stack->layers || stack->layers->size() == stack->before.size())
      continue;
    if (auto now = moved(*path, *stack, below("sensitivity", s), (*elements)[s].place, findings))
      *path = std::move(*now);
  }
}

}  // namespace

std::vector<Cuts> expand_layers(Node& document, const OtherFiles& files,
                                const std::vector<Cuts>* scene_cuts, Findings& findings) {
  expand_iop_table(document, files, findings);
  Node* sea = document.find("sea");
  if (!sea || !sea->as<Node::Table>()) return {};
  const double tolerance = tolerance_of(*sea, findings);
  std::vector<ExpandedStack> stacks = stacks_in(*sea);
  for (std::size_t i = 0; i < stacks.size(); ++i) {
    const bool known = scene_cuts && scene_cuts->size() == stacks.size();
    expand(stacks[i], files, tolerance, known ? &(*scene_cuts)[i] : nullptr, findings);
  }
  move_sensitivities(document, stacks, findings);
  std::vector<Cuts> cuts;
  for (ExpandedStack& stack : stacks) cuts.push_back(std::move(stack.cuts));
  return cuts;
}

Multiples multiples_of(Node& document, const std::vector<Cuts>& cuts) {
  Multiples out;
  Node* sea = document.find("sea");
  if (cuts.empty() || !sea) return out;
  const auto stacks = stacks_in(*sea);
  for (std::size_t i = 0; i < stacks.size(); ++i)
    for (const auto& ends : cuts[i])
      out[stacks[i].path].push_back(std::max<std::size_t>(ends.size(), 1));
  return out;
}

}  // namespace photic::scene
