#include "scene/unit_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

namespace photic::scene {
namespace {

struct NamedUnit {
  const char* name;
  Unit unit;
};

struct NamedDecade {
  const char* name;
  int decade;
};

// Symbols, whose case matters: m is no M. Some write decibars as "db".
constexpr std::array symbols{NamedUnit{"g", {0, 1, 0, 0}},  NamedUnit{"m", {0, 0, 1, 0}},
                             NamedUnit{"l", {-3, 0, 3, 0}}, NamedUnit{"L", {-3, 0, 3, 0}},
                             NamedUnit{"Pa", {0, 0, 0, 1}}, NamedUnit{"db", {4, 0, 0, 1}}};
// Words, in any case, in the singular or the plural.
constexpr std::array unit_words{
    NamedUnit{"gram", {0, 1, 0, 0}},   NamedUnit{"metre", {0, 0, 1, 0}},
    NamedUnit{"meter", {0, 0, 1, 0}},  NamedUnit{"litre", {-3, 0, 3, 0}},
    NamedUnit{"liter", {-3, 0, 3, 0}}, NamedUnit{"pascal", {0, 0, 0, 1}},
    NamedUnit{"bar", {5, 0, 0, 1}}};
constexpr std::array short_prefixes{
    NamedDecade{"", 0},   NamedDecade{"k", 3},  NamedDecade{"h", 2},  NamedDecade{"d", -1},
    NamedDecade{"c", -2}, NamedDecade{"m", -3}, NamedDecade{"u", -6}, NamedDecade{"n", -9}};
constexpr std::array long_prefixes{NamedDecade{"kilo", 3},   NamedDecade{"hecto", 2},
                                   NamedDecade{"deci", -1},  NamedDecade{"centi", -2},
                                   NamedDecade{"milli", -3}, NamedDecade{"micro", -6},
                                   NamedDecade{"nano", -9}};

template <class Prefixes, class Units>
std::optional<Unit> prefixed(const std::string& word, const Prefixes& prefixes,
                             const Units& units) {
  for (const auto& unit : units) {
    if (!word.ends_with(unit.name)) continue;
    const std::string rest = word.substr(0, word.size() - std::string(unit.name).size());
    for (const auto& prefix : prefixes) {
      if (rest != prefix.name) continue;
      Unit found = unit.unit;
      found.decade += prefix.decade;
      return found;
    }
  }
  return std::nullopt;
}

std::optional<Unit> named(const std::string& word) {
  if (const auto unit = prefixed(word, short_prefixes, symbols)) return unit;
  std::string lower = lower_case(word);
  if (lower.ends_with('s')) lower.pop_back();
  if (const auto unit = prefixed(lower, short_prefixes, unit_words)) return unit;
  return prefixed(lower, long_prefixes, unit_words);
}

/// A text taken apart from its beginning.
class UnitReader {
 public:
  explicit UnitReader(std::string text) : text_(std::move(text)) {}

  std::optional<Unit> read() {
    Unit product;
    bool below = false, any = false;
    while (skip_blanks()) {
      if (!below && take_division()) {
        below = true;
        continue;
      }
      const auto unit = factor();
      if (!unit) return std::nullopt;
      multiply(product, *unit, below ? -1 : 1);
      below = false;
      any = true;
    }
    return any && !below ? std::optional(product) : std::nullopt;
  }

 private:
  /// Skips all that only stands between factors. Returns whether anything is left.
  bool skip_blanks() {
    while (at_ < text_.size() && std::string(" .*").find(text_[at_]) != std::string::npos) ++at_;
    return at_ < text_.size();
  }

  bool take(const std::string& token) {
    if (text_.compare(at_, token.size(), token) != 0) return false;
    at_ += token.size();
    return true;
  }

  bool take_division() { return take("/") || take("per "); }

  std::optional<Unit> factor() {
    const bool numeric = is_digit(at_);
    const auto unit = numeric ? number() : name();
    const auto exponent = unit ? power(!numeric) : std::nullopt;
    if (!exponent) return std::nullopt;
    Unit raised;
    multiply(raised, *unit, *exponent);
    return raised;
  }

  /// Powers of ten only.
  std::optional<Unit> number() {
    double value = 0;
    const char* end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(text_.data() + at_, end, value);
    if (error != std::errc{} || !(value > 0)) return std::nullopt;
    at_ = static_cast<std::size_t>(stop - text_.data());
    const int decade = static_cast<int>(std::lround(std::log10(value)));
    if (std::abs(decade) > max_decades || std::fabs(value / std::pow(10, decade) - 1) > 1e-12)
      return std::nullopt;
    return Unit{decade, 0, 0, 0};
  }

  std::optional<Unit> name() {
    const std::size_t first = at_;
    while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    return named(text_.substr(first, at_ - first));
  }

  /// "3", "-3", "^3", "**-3", of one digit; 1 if there is none. Numbers need a sign of it.
  std::optional<int> power(bool bare) {
    const bool marked = take("**") || take("^");
    if (!marked && !bare) return 1;
    const int sign = take("-") ? -1 : 1;
    if (!is_digit(at_)) return marked || sign < 0 ? std::nullopt : std::optional(1);
    if (is_digit(at_ + 1)) return std::nullopt;
    return sign * (text_[at_++] - '0');
  }

  [[nodiscard]] bool is_digit(std::size_t i) const {
    return i < text_.size() && text_[i] >= '0' && text_[i] <= '9';
  }

  static void multiply(Unit& product, const Unit& unit, int exponent) {
    product.decade += exponent * unit.decade;
    product.gram += exponent * unit.gram;
    product.metre += exponent * unit.metre;
    product.pascal += exponent * unit.pascal;
  }

  static constexpr int max_decades = 30;
  const std::string text_;
  std::size_t at_ = 0;
};

}  // namespace

std::optional<Unit> unit_called(const std::string& text) {
  constexpr std::size_t longest = 60;  // so that exponents stay small
  return text.size() > longest ? std::nullopt : UnitReader(plain_text(text)).read();
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string plain_text(std::string text) {
  // UTF-8, then what is left of ISO 8859-1.
  constexpr std::array<std::pair<const char*, const char*>, 17> signs{{{"\xC2\xB5", "u"},
                                                                       {"\xCE\xBC", "u"},
                                                                       {"\xC2\xB9", "1"},
                                                                       {"\xC2\xB2", "2"},
                                                                       {"\xC2\xB3", "3"},
                                                                       {"\xE2\x81\xBB", "-"},
                                                                       {"\xE2\x88\x92", "-"},
                                                                       {"\xC2\xB7", " "},
                                                                       {"\xE2\x8B\x85", " "},
                                                                       {"\xC2\xB0", "deg"},
                                                                       {"\xC2\xBA", "deg"},
                                                                       {"\xE2\x80\xB0", "1e-3"},
                                                                       {"\xB5", "u"},
                                                                       {"\xB9", "1"},
                                                                       {"\xB2", "2"},
                                                                       {"\xB3", "3"},
                                                                       {"\xB0", "deg"}}};
  for (const auto& [sign, plain] : signs) {
    const std::string from = sign, to = plain;
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  }
  return text;
}

}  // namespace photic::scene
