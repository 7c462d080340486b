#include "optics/table_fields.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "optics/table_text.hpp"

namespace photic::optics {
namespace {

constexpr const char* any_blank = " \t";

/// The first letter of a field from `at` on.
std::size_t begin_of_field(const std::string& line, std::size_t at, char separator) {
  const char* skipped = separator == tab ? " " : any_blank;
  return std::min(line.find_first_not_of(skipped, at), line.size());
}

/// Behind its last letter.
std::size_t end_of_field(const std::string& line, std::size_t at, char separator) {
  const std::size_t end =
      separator == blank ? line.find_first_of(any_blank, at) : line.find(separator, at);
  return std::min(end, line.size());
}

}  // namespace

const char* name_of(char separator) {
  return separator == comma       ? "comma"
         : separator == semicolon ? "semicolon"
         : separator == tab       ? "tab"
                                  : "blank";
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(any_blank);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(any_blank) - first + 1);
}

bool is_comment(const std::string& content) {
  return content.starts_with("#") || content.starts_with("\"#") || content.starts_with("!");
}

std::string quoted_text(const std::string& line, std::size_t& at, const std::string& name,
                        int number) {
  const int column = static_cast<int>(at) + 1;
  std::string text;
  for (++at; at < line.size(); ++at) {
    if (line[at] == '"' && line.compare(at, 2, "\"\"") != 0) {
      ++at;
      return text;
    }
    if (line[at] == '"') ++at;  // the first of two
    text += line[at];
  }
  throw InputError({{name, number, column, "a double quote is not closed", ""}});
}

TableCells fields_of(const std::string& line, char separator, const std::string& name, int number) {
  TableCells fields;
  std::string content = line;
  if (separator == blank) content.erase(content.find_last_not_of(any_blank) + 1);
  for (std::size_t at = 0;; ++at) {
    const std::size_t begin = begin_of_field(content, at, separator);
    const int column = static_cast<int>(separator == blank ? begin : at) + 1;
    at = begin;
    const bool quoted = at < content.size() && content[at] == '"';
    std::string text;
    if (quoted) text = quoted_text(content, at, name, number);
    const std::size_t end = end_of_field(content, at, separator);
    const std::string rest = trimmed(content.substr(at, end - at));
    if (rest.find('"') != std::string::npos || (quoted && !rest.empty()))
      throw InputError({{name, number, column, "a double quote inside a text",
                         "put the text in double quotes, and write those inside twice"}});
    fields.push_back({trimmed(quoted ? text : rest), column});
    at = end;
    if (at == content.size()) return fields;
  }
}

std::optional<TableCells> fields_if_any(const std::string& line, char separator) {
  try {
    return fields_of(line, separator, "", 0);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::size_t count_outside_quotes(const std::string& line, char letter) {
  bool quoted = false;
  std::size_t count = 0;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == letter && !quoted) ++count;
  }
  return count;
}

bool is_number(const std::string& text, char separator) {
  return finite_number(text) || (separator != comma && number_with_comma(text));
}

bool are_numbers(const TableCells& fields, char separator) {
  return std::ranges::all_of(
      fields, [&](const TableCell& field) { return is_number(field.text, separator); });
}

bool are_numbers_or_gaps(const TableCells& fields, char separator) {
  bool any = false;
  for (const TableCell& field : fields) {
    const bool number = is_number(field.text, separator);
    if (!number && !is_gap(field.text)) return false;
    any = any || number;
  }
  return any;
}

std::string shown(const std::string& text) {
  constexpr std::size_t longest = 60;
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (out.size() >= longest && (byte & 0xC0U) != 0x80U) return out + "…";
    const bool long_control =
        byte == 0xC2U && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0U;
    if (long_control) ++i;  // U+0080 to U+009F
    out += long_control || byte < 0x20U || byte == 0x7FU ? '?' : text[i];
  }
  return out;
}

}  // namespace photic::optics
