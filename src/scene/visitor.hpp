// The common interface of the visitors of describe_*.hpp. A visitor has
//   required, optional(name, value, rule, meaning)   a single value
//   profiled(name, value, rule, meaning, scale)      a number that may be a profile in the file
//                                                    (scene/expand_layers.hpp); the scale, which
//                                                    may be left out, is that of cut.hpp
//   section, sections(name, value, …)                [name] and [[name]]
//   table, tables, table_or_word(name, value, …)     inline tables
//   when(key, chosen, choice, keys)                  keys that belong to one choice of another key,
//                                                    or to several (Among)
//   by_choice(key, chosen, for_choice(value, keys)…) all keys of each choice of another key, which
//                                                    may be those of several choices
//   one_of(option…), any_of(keys, suggestion)        exactly one of some groups of keys; at least
//                                                    one key
//   with(key, active, keys)                          keys that make sense only beside another one
//   unless(table, key, active, reason, keys)         keys whose place another one takes, which is
//                                                    in a table
//   once_read(action)                                done when the keys before have been read
//   expanded(name, rule, meaning[, default])         a key that stands for others, and has become
//                                                    them before anything is read
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/constants.hpp"

namespace photic::scene {

enum class Need { required, optional };

/// The users that a key is for: those who write a first scene, or those who know its effect.
enum class Level { basic, expert };

/// The name of a key, and what else editors should know of it. A plain name is one for everybody
/// whose unit is at its end (units.hpp).
struct Key {
  Key(const char* plain) : name(plain) {}        // NOLINT(google-explicit-constructor)
  operator const char*() const { return name; }  // NOLINT(google-explicit-constructor)

  const char* name;
  Level level = Level::basic;
  bool has_unit = true;
};

inline Key expert(Key key) {
  key.level = Level::expert;
  return key;
}

/// Returns the key of a number that is no quantity, as a seed, or that has the unit of another key.
inline Key without_unit(Key key) {
  key.has_unit = false;
  return key;
}

/// A group of keys of which a scene uses one: `active` says whether the scene at hand uses it.
template <class Keys>
struct Option {
  bool active;
  Keys keys;
};

template <class Keys>
Option<Keys> option(bool active, Keys keys) {
  return {active, std::move(keys)};
}

/// The keys of one choice of another key.
template <class E, class Keys>
struct ForChoice {
  E value;
  Keys keys;
};

template <class E, class Keys>
ForChoice<E, Keys> for_choice(E value, Keys keys) {
  return {value, std::move(keys)};
}

/// The visitor that learns the names in a group of keys.
class Names {
 public:
  template <class Keys>
  explicit Names(const Keys& keys) {
    keys(*this);
  }

  template <class... Rest>
  void required(const char* name, Rest&&...) {
    required_.push_back(name);
    all_.push_back(name);
  }
  template <class... Rest>
  void optional(const char* name, Rest&&...) {
    all_.push_back(name);
  }
  template <class... Rest>
  void profiled(const char* name, Rest&&...) {
    all_.push_back(name);
  }
  template <class... Rest>
  void tables(const char* name, Rest&&...) {
    required(name);
  }
  template <class... Rest>
  void expanded(const char* name, Rest&&...) {
    required(name);
  }
  template <class T, class... Rest>
  void sections(const char* name, std::vector<T>&, Need need, Rest&&...) {
    if (need == Need::required)
      required(name);
    else
      optional(name);
  }
  template <class T, class... Rest>
  void section(const char* name, T&, Need need, Rest&&...) {
    if (need == Need::required)
      required(name);
    else
      optional(name);
  }
  template <class... Rest>
  void table_or_word(const char* name, Rest&&...) {
    all_.push_back(name);
  }
  template <class... Keys>
  void one_of(const Option<Keys>&... options) {
    (add_some(options.keys), ...);
  }
  template <class Keys>
  void any_of(const Keys& keys, const char* = "") {
    add_some(keys);
  }
  template <class Action>
  void once_read(const Action&) {}

  [[nodiscard]] const std::vector<std::string>& all() const { return all_; }
  [[nodiscard]] const std::vector<std::string>& needed() const { return required_; }

 private:
  /// Keys none of which alone must be given.
  template <class Keys>
  void add_some(const Keys& keys) {
    const Names names(keys);
    all_.insert(all_.end(), names.all_.begin(), names.all_.end());
  }

  std::vector<std::string> all_, required_;
};

}  // namespace photic::scene
