#include "optics/modtran_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "core/error.hpp"
#include "optics/table_fields.hpp"
#include "optics/table_text.hpp"

namespace photic::optics {

bool are_numbers(const std::vector<ModtranWord>& words, std::size_t count) {
  return words.size() == count && std::ranges::all_of(words, [](const ModtranWord& word) {
           return finite_number(word.text).has_value();
         });
}

ModtranText::ModtranText(const std::string& text, std::string name) : name_(std::move(name)) {
  ends_ = text.ends_with('\n');
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines_.push_back(line);
}

std::vector<ModtranWord> ModtranText::words(int number) const {
  std::vector<ModtranWord> out;
  const std::string& text = line(number);
  constexpr const char* blanks = " \t\r\f";
  auto from = text.find_first_not_of(blanks);
  while (from != std::string::npos) {
    const auto to = std::min(text.find_first_of(blanks, from), text.size());
    out.push_back({text.substr(from, to - from), static_cast<int>(from) + 1});
    from = text.find_first_not_of(blanks, to);
  }
  return out;
}

bool ModtranText::is_title(int number) const {
  const auto at = line(number).find(modtran_profiles);  // after blanks or the 1 of a new page
  return at != std::string::npos && line(number).find_first_not_of(" 1") == at;
}

bool ModtranText::is_head(int number) const {
  const auto has = [&](const char* part) { return line(number).find(part) != std::string::npos; };
  return has("***") && (has("MODTRAN") || has("LOWTRAN"));
}

void ModtranText::fail_without_numbers(int names_line) const {
  fail(names_line, 1, no_numbers, "expected: rows of numbers below, as many as names");
}

double ModtranText::number(int line, const ModtranWord& word, const std::string& what, double min,
                           double max) const {
  const auto value = finite_number(word.text);
  if (!value)
    fail(line, word.column, fmt::format("\"{}\" where {} is expected", shown(word.text), what),
         "a number");
  if (*value < min || *value > max) {
    fail(line, word.column,
         fmt::format("{} {} where {:g} to {:g} is expected", what, word.text, min, max), "");
  }
  return *value;
}

void ModtranText::fail(int line, int column, const std::string& reason,
                       const std::string& suggestion) const {
  throw InputError({{name_, line, column, reason, suggestion}});
}

}  // namespace photic::optics
