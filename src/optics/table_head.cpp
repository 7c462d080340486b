#include "optics/table_head.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "optics/table_text.hpp"

namespace photic::optics {
namespace {

constexpr char marks[] = {comma, semicolon, tab};

bool has_mark(const std::string& line) {
  return std::ranges::any_of(marks, [&](char m) { return count_outside_quotes(line, m) > 0; });
}

/// The separators that the line of names has, the one of the first row among several.
std::vector<char> possible_separators(const std::string& names, const std::string& row) {
  std::vector<char> in_names, alike;
  for (const char mark : marks) {
    const std::size_t count = count_outside_quotes(names, mark);
    if (count == 0) continue;
    in_names.push_back(mark);
    if (count == count_outside_quotes(row, mark)) alike.push_back(mark);
  }
  return in_names.size() > 1 && !alike.empty() ? alike : in_names;
}

/// The separator of a line of numbers, and its number of fields.
struct Row {
  char separator = comma;
  std::size_t fields = 0;
};

class HeadReader {
 public:
  HeadReader(const std::vector<std::string>& lines, const std::string& name)
      : lines_(lines), name_(name) {}

  TableHead read() {
    pass_header();
    const std::vector<Row> ways = first_numbers();
    head_.has_numbers = !ways.empty();
    try {
      take(ways);
    } catch (const InputError& error) {
      if (head_.has_numbers) throw;
      raise_without_numbers(error.diagnostics().front());
    }
    return std::move(head_);
  }

 private:
  void take(const std::vector<Row>& ways) {
    if (first_ == lines_.size())
      head_.first_row = first_;
    else if (ways.empty() || (fields_.empty() && separated_as_its_rows(first_)))
      take_names_at(first_);
    else if (std::ranges::none_of(ways, [&](const Row& way) { return take_names(way); }))
      take_no_names(ways.front());
  }

  // --- Lines -------------------------------------------------------------------------------------

  [[nodiscard]] std::string content(std::size_t i) const { return trimmed(lines_[i]); }

  /// The next line from `i` on that is no comment.
  [[nodiscard]] std::size_t next(std::size_t i) const {
    while (i < lines_.size() && (content(i).empty() || is_comment(content(i)))) ++i;
    return i;
  }

  [[nodiscard]] std::string line_after(std::size_t i) const {
    const std::size_t row = next(i + 1);
    return row < lines_.size() ? lines_[row] : "";
  }

  /// "sep=;", as Excel writes it, and the header of SeaBASS: "/fields=depth,chl", "/missing=-999".
  void pass_header() {
    for (first_ = next(0); first_ < lines_.size(); first_ = next(first_ + 1)) {
      const std::string& line = lines_[first_];
      if (line.size() == 5 && line.starts_with("sep="))
        given_ = line[4];
      else if (!read_seabass(content(first_)))
        return;
    }
  }

  bool read_seabass(const std::string& line) {
    if (!line.starts_with("/")) return false;
    const auto sign = std::min(line.find('='), line.size());
    std::string key = trimmed(line.substr(0, sign));
    std::ranges::transform(key, key.begin(), [](unsigned char c) { return std::tolower(c); });
    const std::string value = trimmed(line.substr(std::min(sign + 1, line.size())));
    if (sign == line.size() && !key.starts_with("/begin_header") && !key.starts_with("/end_header"))
      return false;
    if (key == "/fields") {
      fields_ = texts_in(value);
      fields_line_ = first_;
    }
    if (key == "/units") units_ = texts_in(value);
    if (key == "/delimiter")
      given_ = value == "comma" ? comma : value == "tab" ? tab : value == "space" ? blank : given_;
    if (key == "/missing" || key == "/below_detection_limit" || key == "/above_detection_limit")
      if (const auto number = finite_number(value)) head_.missing.push_back(*number);
    return true;
  }

  [[nodiscard]] std::vector<std::string> texts_in(const std::string& list) const {
    std::vector<std::string> texts;
    for (const TableCell& field : fields_of(list, comma, name_, static_cast<int>(first_) + 1))
      texts.push_back(field.text);
    return texts;
  }

  // --- Lines of numbers --------------------------------------------------------------------------

  [[nodiscard]] static bool has(const std::string& line, char separator) {
    if (separator != blank) return count_outside_quotes(line, separator) > 0;
    return trimmed(line).find_first_of(" \t") != std::string::npos;
  }

  [[nodiscard]] std::vector<Row> ways_to_read(const std::string& line) const {
    std::vector<Row> ways;
    for (const char separator : separators) {
      if (given_ ? separator != *given_ : !has(line, separator)) continue;
      const auto fields = fields_if_any(line, separator);
      if (fields && are_numbers_or_gaps(*fields, separator))
        ways.push_back({separator, fields->size()});
    }
    if (ways.empty() && !given_ && is_number(trimmed(line), comma)) ways.push_back({comma, 1});
    return ways;
  }

  /// The ways to read the first line of several numbers, or else of one.
  [[nodiscard]] std::vector<Row> first_numbers() const {
    std::vector<Row> alone;
    for (std::size_t i = next(first_); i < lines_.size(); i = next(i + 1)) {
      std::vector<Row> ways = ways_to_read(lines_[i]);
      if (ways.empty()) continue;
      if (ways.front().fields == 1) {
        alone = std::move(ways);
        continue;
      }
      if (ways.size() > 1 && ways[0].separator == tab && mixes_tabs_with_blanks(i, ways[0]))
        ways.erase(ways.begin());
      return ways;
    }
    return alone;
  }

  /// Returns whether rows are alike from a line on where tabs are blanks, and are not where they
  /// separate.
  [[nodiscard]] bool mixes_tabs_with_blanks(std::size_t from, const Row& by_tabs) const {
    const auto all_have = [&](char separator, std::size_t count) {
      for (std::size_t i = from; i < lines_.size(); i = next(i + 1)) {
        const auto fields = fields_if_any(lines_[i], separator);
        if (!fields || fields->size() != count) return false;
      }
      return true;
    };
    if (all_have(tab, by_tabs.fields)) return false;
    const auto fields = fields_if_any(lines_[from], blank);
    return fields && all_have(blank, fields->size());
  }

  /// A row, although one of its fields may be no number. No row may pass for a text above others.
  [[nodiscard]] bool is_row(std::size_t i, const Row& way) const {
    const auto fields = fields_if_any(lines_[i], way.separator);
    if (!fields) return std::string("+-.0123456789").find(content(i)[0]) != std::string::npos;
    const auto number = [&](const TableCell& f) { return is_number(f.text, way.separator); };
    const auto numbers = static_cast<std::size_t>(std::ranges::count_if(*fields, number));
    return number(fields->front()) ||
           (fields->size() == way.fields && numbers > 0 && numbers + 1 >= fields->size());
  }

  [[nodiscard]] std::size_t first_row(const Row& way) const {
    std::size_t i = next(first_);
    while (i < lines_.size() && !is_row(i, way)) i = next(i + 1);
    return i;
  }

  // --- Lines of names ----------------------------------------------------------------------------

  /// Returns whether a line has a comma, semicolon or tab as often as the line below it, which is a
  /// row.
  [[nodiscard]] bool separated_as_its_rows(std::size_t i) const {
    const std::string row = line_after(i);
    for (const char mark : marks) {
      if (given_ ? mark != *given_ : count_outside_quotes(lines_[i], mark) == 0) continue;
      const auto names = fields_if_any(lines_[i], mark), fields = fields_if_any(row, mark);
      if (!names || !fields || names->size() != fields->size()) continue;
      if (is_number(names->front().text, mark)) continue;
      if (mark == tab && mixes_tabs_with_blanks(next(i + 1), {tab, fields->size()})) continue;
      if (std::ranges::any_of(*fields, [&](const auto& f) { return is_number(f.text, mark); }))
        return true;
    }
    return false;
  }

  void take_names_at(std::size_t i) {
    const int number = static_cast<int>(i) + 1;
    const auto may_be =
        given_ ? std::vector{*given_} : possible_separators(lines_[i], line_after(i));
    if (may_be.size() > 1)
      throw InputError({{name_, number, 1,
                         fmt::format("are columns separated by a {} or by a {}?",
                                     name_of(may_be[0]), name_of(may_be[1])),
                         "put names that hold the other one in double quotes"}});
    head_.separator = may_be.empty() ? comma : may_be.front();
    set_names(fields_of(lines_[i], head_.separator, name_, number), i);
    head_.first_row = i + 1;
  }

  void set_names(const TableCells& names, std::size_t line) {
    head_.names.clear();
    for (const TableCell& name : names) head_.names.push_back(name.text);
    head_.columns = names.size();
    head_.line = static_cast<int>(line) + 1;
  }

  /// The names in a line, if there are as many as fields in a row.
  [[nodiscard]] static std::optional<TableCells> names_in(const std::string& line,
                                                          std::initializer_list<char> by,
                                                          const Row& way) {
    for (const char separator : by) {
      auto names = fields_if_any(line, separator);
      if (names && names->size() == way.fields && !are_numbers_or_gaps(*names, separator))
        return names;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<TableCells> names_in_text(std::size_t i, const Row& way) const {
    if (way.separator == blank) return names_in(lines_[i], {blank, tab}, way);
    return names_in(lines_[i], {way.separator}, way);
  }

  /// Not in one of the form "key: text".
  [[nodiscard]] std::optional<TableCells> names_in_comment(std::size_t i, const Row& way) const {
    std::string text = content(i);
    if (text.front() == '"') text = text.substr(1, text.find('"', 1) - 1);
    text = trimmed(text.erase(0, text.find_first_not_of("#! \t")));
    const char first = way.separator == blank ? comma : way.separator;
    const auto names = names_in(text, {first, tab, comma, semicolon, blank}, way);
    const bool is_key = names && names->front().text.ends_with(":");
    return is_key ? std::nullopt : names;
  }

  /// The last comment with letters before a row.
  [[nodiscard]] std::optional<std::size_t> last_comment(std::size_t row) const {
    while (row-- > 0)
      if (is_comment(content(row)) &&
          std::ranges::any_of(lines_[row], [](unsigned char c) { return std::isalnum(c) != 0; }))
        return row;
    return std::nullopt;
  }

  [[nodiscard]] std::vector<std::size_t> texts_above(std::size_t row) const {
    std::vector<std::size_t> texts;
    for (std::size_t i = next(first_); i < row; i = next(i + 1)) texts.push_back(i);
    return texts;
  }

  bool take_names(const Row& way) {
    if (!fields_.empty()) return fields_.size() == way.fields && take_fields(way);
    const std::size_t row = first_row(way);
    const auto texts = texts_above(row);
    const auto take = [&](const std::optional<TableCells>& names, std::size_t i, std::size_t from) {
      if (!names) return false;
      set_names(*names, i);
      head_.separator = way.separator;
      head_.first_row = from;
      return true;
    };
    if (!texts.empty() && take(names_in_text(texts.front(), way), texts.front(),
                               way.separator == blank ? row : texts.front() + 1))
      return true;
    const auto comment = last_comment(row);
    const auto take_comment = [&] {
      return comment && take(names_in_comment(*comment, way), *comment, row);
    };
    const auto take_text = [&] {
      return !texts.empty() && take(names_in_text(texts.back(), way), texts.back(), row);
    };
    const bool comment_first = comment && (texts.empty() || *comment > texts.back());
    return comment_first ? take_comment() || take_text() : take_text() || take_comment();
  }

  bool take_fields(const Row& way) {
    head_.names = fields_;
    if (units_.size() == fields_.size()) head_.units = units_;
    head_.columns = fields_.size();
    head_.line = static_cast<int>(fields_line_) + 1;
    head_.separator = way.separator;
    head_.first_row = first_;
    return true;
  }

  /// Names that are not as many as the fields are reported; texts that are no names are skipped.
  void take_no_names(const Row& way) {
    if (!fields_.empty()) {
      take_fields(way);
      return;
    }
    const std::size_t row = first_row(way);
    const auto texts = texts_above(row);
    if (!texts.empty() &&
        (way.separator == blank ? texts.size() == 1 && has_mark(lines_[texts.back()])
                                : texts.size() == 1 || has(lines_[texts.back()], way.separator)))
      return take_names_at(texts.back());
    head_.columns = way.fields;
    head_.line = static_cast<int>(row) + 1;
    head_.separator = way.separator;
    head_.first_row = row;
  }

  const std::vector<std::string>& lines_;
  const std::string& name_;
  std::size_t first_ = 0;      ///< the first line that is no comment and no header
  std::optional<char> given_;  ///< the separator
  std::vector<std::string> fields_, units_;
  std::size_t fields_line_ = 0;
  TableHead head_;
};

}  // namespace

TableHead head_of(const std::vector<std::string>& lines, const std::string& name) {
  return HeadReader(lines, name).read();
}

}  // namespace photic::optics
