#include "optics/table_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/locale/encoding_utf.hpp>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <utility>

namespace photic::optics {
namespace {

/// Two bytes a unit behind a mark of two bytes.
std::u16string utf16_units(const std::string& bytes, bool low_byte_first) {
  std::u16string units;
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    const auto first = static_cast<unsigned char>(bytes[i]),
               second = static_cast<unsigned char>(bytes[i + 1]);
    units += static_cast<char16_t>(low_byte_first ? first | second << 8 : first << 8 | second);
  }
  return units;
}

bool is_utf8(const std::string& bytes) {
  try {
    boost::locale::conv::utf_to_utf<char32_t>(bytes, boost::locale::conv::stop);
    return true;
  } catch (const boost::locale::conv::conversion_error&) {
    return false;
  }
}

std::string as_utf8(const std::string& bytes) {
  using boost::locale::conv::utf_to_utf;
  if (bytes.starts_with("\xEF\xBB\xBF")) return as_utf8(bytes.substr(3));
  if (bytes.starts_with("\xFF\xFE")) return utf_to_utf<char>(utf16_units(bytes, true));
  if (bytes.starts_with("\xFE\xFF")) return utf_to_utf<char>(utf16_units(bytes, false));
  if (is_utf8(bytes)) return bytes;
  std::u16string latin1;
  for (const unsigned char byte : bytes) latin1 += byte;
  return utf_to_utf<char>(latin1);
}

/// As a spreadsheet shows numbers: groups of three digits behind one to three.
bool has_groups(const std::string& text) {
  constexpr std::size_t longest = 60;  // of a number; the expression needs a stack for each letter
  static const std::regex groups(
      "[+-]?\\d{1,3}(?:(?:[ ',.]|\xC2\xA0|\xE2\x80\xAF|\xE2\x80\x99)\\d{3})+(?:[.,]\\d*)?");
  return text.size() <= longest && std::regex_match(text, groups);
}

}  // namespace

std::vector<std::string> lines_of_table(const std::string& bytes, const std::string& name) {
  const std::string text = as_utf8(bytes);
  if (text.find('\0') != std::string::npos)
    throw InputError(
        {{name, 1, 1, "is not text: it holds bytes of 0",
          "save it as CSV in UTF-8, not as a workbook or in UTF-16 without its mark"}});
  std::vector<std::string> lines;
  std::size_t from = 0;
  while (from < text.size()) {
    const std::size_t end = std::min(text.find_first_of("\r\n", from), text.size());
    lines.push_back(text.substr(from, end - from));
    from = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
  }
  return lines;
}

void raise_together(std::vector<Diagnostic> found, std::size_t lines) {
  constexpr std::size_t few = 3, most = 20;
  if (found.empty()) return;
  const bool all = found.size() == lines && lines > 1;
  if (all || (found.size() > few && 2 * found.size() > lines)) {
    const std::size_t more = found.size() - 1;
    found.front().reason +=
        fmt::format("; {} more line{} like it", more, more == 1 ? " is" : "s are");
    found.resize(1);
  }
  if (found.size() > most) found.resize(most);
  throw InputError(std::move(found));
}

void raise_without_numbers(const Diagnostic& found) {
  throw InputError({{found.file, found.line, found.column, no_numbers, what_a_table_is}});
}

std::optional<double> finite_number(const std::string& text) {
  const auto digits = [](unsigned char c) { return std::isdigit(c) != 0 || c == '.'; };
  const bool plus = text.size() > 1 && text[0] == '+' && digits(text[1]);
  double value = 0;
  const auto end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + (plus ? 1 : 0), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<double> number_with_comma(const std::string& text) {
  const auto comma = text.find(',');
  if (comma == std::string::npos || text.find('.') != std::string::npos) return std::nullopt;
  std::string with_point = text;
  with_point[comma] = '.';
  return finite_number(with_point);
}

bool has_decimal_point(const std::string& text) {
  return text.find('.') != std::string::npos && finite_number(text);
}

bool may_be_thousands(const std::string& text) {
  const auto digit = text.find_first_not_of("+-");
  return has_groups(text) && text[digit] != '0';
}

double half_last_digit(const std::string& text) {
  const auto exponent = text.find_first_of("Ee");
  const std::string mantissa = text.substr(0, exponent);
  const auto point = mantissa.find_first_of(".,");
  const double decimals =
      point == std::string::npos ? 0 : static_cast<double>(mantissa.size() - point - 1);
  const int power = exponent == std::string::npos ? 0 : std::atoi(text.c_str() + exponent + 1);
  return 0.5 * std::pow(10.0, power - decimals);
}

bool is_gap(const std::string& text) {
  std::string word = text;
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return std::tolower(c); });
  return word.empty() || word == "nan" || word == "-nan" || word == "na";
}

std::string how_to_write_number(const std::string& text) {
  if (is_gap(text)) return "fill the gap, or leave the row out";
  if (has_groups(text)) return "leave out what separates thousands, and write a decimal point";
  if (number_with_comma(text)) return "write a decimal point";
  return "";
}

}  // namespace photic::optics
