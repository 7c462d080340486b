// Lines and words of the files that LOWTRAN and MODTRAN print.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace photic::optics {

inline constexpr const char* modtran_profiles = "ATMOSPHERIC PROFILES";

struct ModtranWord {
  std::string text;
  int column = 0;  ///< its start, from 1
};

/// Returns whether they are so many, all of them numbers. Without such a line nothing that a
/// table's lines hold may stand in a message: the file may be no table.
[[nodiscard]] bool are_numbers(const std::vector<ModtranWord>& words, std::size_t count);

/// A file with its name, for diagnostics.
class ModtranText {
 public:
  ModtranText(const std::string& text, std::string name);

  [[nodiscard]] int lines() const { return static_cast<int>(lines_.size()); }
  /// Lines are numbered from 1.
  [[nodiscard]] const std::string& line(int number) const { return lines_.at(number - 1); }
  [[nodiscard]] std::vector<ModtranWord> words(int number) const;
  /// Returns whether nothing ends the line: the file may have been truncated in it.
  [[nodiscard]] bool is_open(int number) const { return number == lines() && !ends_; }
  /// The title of a block of profiles, which only a tape6 has.
  [[nodiscard]] bool is_title(int number) const;
  /// The name of the program between stars, which is the head of a tape6.
  [[nodiscard]] bool is_head(int number) const;

  /// Says that a table, whose names stand in a line, holds no line of numbers.
  [[noreturn]] void fail_without_numbers(int names_line) const;

  /// A finite number from min to max.
  [[nodiscard]] double number(int line, const ModtranWord& word, const std::string& what,
                              double min, double max) const;

  [[noreturn]] void fail(int line, int column, const std::string& reason,
                         const std::string& suggestion) const;

 private:
  std::string name_;
  std::vector<std::string> lines_;
  bool ends_ = false;  ///< the last line is whole
};

}  // namespace photic::optics
