#include "scene/flag_meaning.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace photic::scene {
namespace {

// Beginnings of words in lower case.
constexpr std::array good_words{"good", "pass", "ok", "valid", "accept", "reliable", "usable"};
constexpr std::array bad_words{"bad",     "miss",    "fail",    "suspect", "suspic",    "question",
                               "reject",  "erro",    "wrong",   "invalid", "spik",      "doubt",
                               "dubi",    "outlier", "outside", "corrupt", "incorrect", "unaccept",
                               "unreli",  "unusab",  "unreal",  "unavail", "fault",     "absent",
                               "discard", "nodata",  "nan",     "problem", "contaminat"};
constexpr std::array unchecked_words{"unknown",  "uncheck", "uneval", "unassess", "untest",
                                     "uncontr",  "unused",  "unqual", "raw",      "spare",
                                     "reserved", "change",  "adjust", "correct",  "interpol",
                                     "estimat",  "despik",  "smooth", "modif",    "nominal"};
/// Words that turn "valid" and "detection" into something else.
constexpr std::array limit_words{"below", "above", "exceed", "beyond", "limit"};
// After "no" or "not": that no check was made, or that there is no value.
constexpr std::array check_words{"qc",   "quality", "control", "check", "eval", "assess", "test",
                                 "used", "perform", "inspect", "appli", "flag", "calibr"};
constexpr std::array value_words{"data",  "value",  "observ",  "measur",
                                 "sampl", "report", "present", "avail"};

template <class Words>
bool begins(const std::string& word, const Words& beginnings) {
  return std::ranges::any_of(beginnings,
                             [&](const char* beginning) { return word.starts_with(beginning); });
}

/// "Not_evaluated", "not evaluated" and "notEvaluated" are not, evaluated.
std::vector<std::string> words_of_meaning(const std::string& text) {
  std::vector<std::string> words{""};
  bool was_lower = false;
  for (const char c : text) {
    const auto letter = static_cast<unsigned char>(c);
    const bool is_upper = std::isupper(letter) != 0;
    if (std::isalpha(letter) == 0 || (is_upper && was_lower)) words.emplace_back();
    if (std::isalpha(letter) != 0) words.back() += static_cast<char>(std::tolower(letter));
    was_lower = std::islower(letter) != 0;
  }
  std::erase(words, "");
  return words;
}

std::optional<Quality> of_word(const std::string& word) {
  if (word == "out" || begins(word, bad_words)) return Quality::bad;
  if (begins(word, good_words)) return Quality::good;
  if (begins(word, unchecked_words)) return Quality::unchecked;
  if (begins(word, limit_words)) return Quality::unclear;
  return std::nullopt;
}

/// The quality for a word after "no" or "not".
Quality of_negated(const std::string& word) {
  if (begins(word, check_words)) return Quality::unchecked;
  if (begins(word, value_words)) return Quality::bad;
  const auto plain = of_word(word);
  if (plain == Quality::bad) return Quality::good;
  if (plain == Quality::good) return Quality::bad;
  return Quality::unclear;
}

bool negates(const std::string& word) { return word == "no" || word == "not" || word == "non"; }

}  // namespace

Quality quality_of(const std::string& meaning) {
  const std::vector<std::string> words = words_of_meaning(meaning);
  std::vector<Quality> said;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (negates(words[i])) {
      said.push_back(i + 1 < words.size() ? of_negated(words[++i]) : Quality::unclear);
      if (said.back() == Quality::unclear) return Quality::unclear;
    } else if (const auto quality = of_word(words[i])) {
      said.push_back(*quality);
    }
  }
  const auto says = [&](Quality q) { return std::ranges::find(said, q) != said.end(); };
  if (says(Quality::bad)) return says(Quality::good) ? Quality::unclear : Quality::bad;
  if (said.empty() || says(Quality::unclear)) return Quality::unclear;
  return says(Quality::good) ? Quality::good : Quality::unchecked;
}

Quality quality_in_table(const std::string& flag) {
  if (flag.size() != 1 || flag[0] < '0' || flag[0] > '9') return Quality::unclear;
  switch (flag[0]) {
    case '1':
    case '2':
      return Quality::good;
    case '3':
    case '4':
    case '9':
      return Quality::bad;
    default:
      return Quality::unchecked;
  }
}

}  // namespace photic::scene
