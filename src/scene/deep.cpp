#include "scene/deep.hpp"

#include <algorithm>
#include <vector>

namespace photic::scene {
namespace {

/// Follows the keys of a text character by character, strings and comments left out.
class Depth {
 public:
  void see(char c) {
    switch (c) {
      case '.':
        ++dots_;
        break;
      case '=':
        in_value_ = true;
        key_ = dots_ + 1;
        dots_ = 0;
        break;
      case '[':
      case '{':
        open();
        break;
      case ']':
      case '}':
        close();
        break;
      case ',':
        dots_ = key_ = 0;
        break;
      case '\n':
        end_line();
        break;
      default:
        break;
    }
  }
  [[nodiscard]] bool is_too_deep() const { return header_ + around_ + dots_ >= max_depth; }

 private:
  void open() {
    if (!in_value_) header_ = 0;
    outer_.push_back(key_);
    around_ += key_;
    dots_ = key_ = 0;
  }
  void close() {
    if (!in_value_) header_ = std::max(header_, dots_ + 1);
    dots_ = key_ = 0;
    if (outer_.empty()) return;
    around_ -= outer_.back();
    outer_.pop_back();
  }
  void end_line() {
    dots_ = 0;
    if (!outer_.empty()) return;
    key_ = 0;
    in_value_ = false;
  }

  std::vector<std::size_t> outer_;  ///< the parts of the keys whose values are open
  std::size_t around_ = 0;          ///< their sum
  std::size_t header_ = 0;          ///< the parts of the last header
  std::size_t key_ = 0;             ///< those of the key whose value is being read
  std::size_t dots_ = 0;            ///< since the last key, value or bracket began
  bool in_value_ = false;
};

}  // namespace

std::optional<LineColumn> find_deep_key(const std::string& toml) {
  Depth depth;
  for (std::size_t at = 0; at < toml.size();) {
    if (begins_free_text(toml[at])) {
      at = end_of_free_text(toml, at);
      continue;
    }
    depth.see(toml[at]);
    if (depth.is_too_deep()) return place_of(toml, at);
    ++at;
  }
  return std::nullopt;
}

}  // namespace photic::scene
