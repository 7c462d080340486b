#include "scene/place_of_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "scene/describe.hpp"
#include "scene/suggest.hpp"
#include "scene/unit_text.hpp"

namespace photic::scene {
namespace {

struct Placed {
  std::string key;
  std::string label;  ///< of its section, or its own if it is one: "[gates]"
  bool is_section;
};

/// The visitor that learns the keys of all sections.
class KeyPlaces {
 public:
  template <class... Rest>
  void required(const Key& key, const Rest&...) {
    if (!label_.empty()) all_.push_back({key.name, label_, false});
  }
  template <class... Rest>
  void optional(const Key& key, const Rest&...) {
    required(key);
  }
  template <class... Rest>
  void profiled(const Key& key, const Rest&...) {
    required(key);
  }
  template <class... Rest>
  void tables(const Key& key, const Rest&...) {
    required(key);
  }
  template <class... Rest>
  void table(const Key& key, const Rest&...) {
    required(key);
  }
  template <class... Rest>
  void table_or_word(const Key& key, const Rest&...) {
    required(key);
  }
  template <class... Rest>
  void expanded(const Key& key, const Rest&...) {
    required(key);
  }

  template <class T>
  void section(const Key& key, T& value, Need, const char*) {
    below_key(key, "[", "]", value);
  }
  template <class T>
  void section(const Key& key, std::optional<T>&, Need need, const char* meaning) {
    T value{};
    section(key, value, need, meaning);
  }
  template <class T>
  void sections(const Key& key, std::vector<T>&, Need, const char*) {
    T value{};
    below_key(key, "[[", "]]", value);
  }

  template <class T, class Value, class Keys>
  void when(const char*, const T&, const Value&, const Keys& keys) {
    keys(*this);
  }
  template <class E, class... Keys>
  void by_choice(const char*, const E&, const ForChoice<E, Keys>&... groups) {
    (groups.keys(*this), ...);
  }
  template <class... Keys>
  void one_of(const Option<Keys>&... options) {
    (options.keys(*this), ...);
  }
  template <class Keys>
  void any_of(const Keys& keys, const char* = "") {
    keys(*this);
  }
  template <class Keys>
  void with(const char*, bool, const Keys& keys) {
    keys(*this);
  }
  template <class Keys>
  void unless(const char*, const char*, bool, const char*, const Keys& keys) {
    keys(*this);
  }
  template <class Action>
  void once_read(const Action&) {}

  [[nodiscard]] const std::vector<Placed>& all() const { return all_; }

 private:
  template <class T>
  void below_key(const Key& key, const char* open, const char* close, T& value) {
    if (key.level == Level::expert) return;
    const std::string path = below(path_, key.name), label = open + path + close;
    all_.push_back({key.name, label, true});
    const std::string outer_path = std::exchange(path_, path);
    const std::string outer_label = std::exchange(label_, label);
    describe(*this, value);
    path_ = outer_path;
    label_ = outer_label;
  }

  std::string path_, label_;
  std::vector<Placed> all_;
};

}  // namespace

std::optional<std::string> place_of_key(const std::string& key, const std::string& section) {
  // [source] of every scene has it: elsewhere it is meant for a band of a channel. [gates] have
  // depths of their own.
  if (key == "wavelength_nm" || key == "depth_m") return std::nullopt;
  KeyPlaces places;
  Scene scene;
  describe(places, scene);
  std::vector<std::string> labels;
  for (const Placed& place : places.all()) {
    if (lower_case(place.key) != lower_case(key)) continue;
    if (place.is_section && (!section.empty() || place.label.find('.') != std::string::npos))
      return fmt::format("write {}", place.label);
    if (std::ranges::find(labels, place.label) == labels.end()) labels.push_back(place.label);
  }
  if (const auto parent = section.rfind('.'); parent != std::string::npos) {
    const std::string around = fmt::format("[{}]", section.substr(0, parent));
    if (std::ranges::find(labels, around) != labels.end()) labels = {around};
  }
  if (labels.empty() || labels.size() > 2) return std::nullopt;
  return fmt::format("it belongs in {}", joined(labels, "or"));
}

}  // namespace photic::scene
