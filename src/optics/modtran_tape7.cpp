#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "core/interpolation.hpp"
#include "optics/modtran.hpp"
#include "optics/modtran_text.hpp"
#include "optics/table_fields.hpp"
#include "optics/table_text.hpp"

namespace photic::optics {
namespace {

constexpr const char* of_transmittance = " TRANS";
constexpr const char* minus_log = "-LOG ";
constexpr const char* transmittances_expected =
    "expected: a tape7 of transmittances (IEMSCT = 0) of MODTRAN";
constexpr double cm_per_nm = 1e-7;

bool begins_with(const std::vector<ModtranWord>& words, const char* first) {
  return !words.empty() && words[0].text.starts_with(first);
}

/// -9999 ends a run.
bool is_end(const std::vector<ModtranWord>& words) {
  return words.size() == 1 && begins_with(words, "-9999");
}

/// The line of the first names; the second names stand below.
int find_names(const ModtranText& text) {
  for (int n = 1; n <= text.lines(); ++n) {
    if (!begins_with(text.words(n), "FREQ")) continue;
    if (n < text.lines()) {
      const auto below = text.words(n + 1);
      if (begins_with(below, "CM-1") || begins_with(below, "1/CM")) return n;
    }
    text.fail(n, 1, "no second line of names below, from CM-1 on", transmittances_expected);
  }
  text.fail(1, 1, "no line of names that begins with FREQ: is the file truncated?",
            transmittances_expected);
}

/// The widths that all lines of a table share. Names or numbers that touch are cut by a row whose
/// numbers do not touch.
class Fields {
 public:
  Fields(const ModtranText& text, int names_line) : text_(text), first_row_(names_line + 2) {
    for (int n = first_row_; n <= text.lines() && !is_end(text.words(n)); ++n) {
      const auto words = text.words(n);
      if (words.size() > row_.size()) row_ = words;
    }
  }

  /// The words of a line of names, one in each field; as they stand if that cannot be.
  [[nodiscard]] std::vector<ModtranWord> names(int line) const {
    return cut(line).value_or(text_.words(line));
  }

  [[nodiscard]] bool has_rows() const { return !row_.empty(); }

  /// Returns whether there are rows, but none of so many numbers.
  [[nodiscard]] bool lack_numbers(std::size_t count) const {
    if (!has_rows()) return false;
    for (int n = first_row_; n <= text_.lines() && !is_end(text_.words(n)); ++n)
      if (are_numbers(numbers(n), count)) return false;
    return true;
  }

  /// The same of a row. A number that touches must have its point where the others of its column
  /// have theirs.
  [[nodiscard]] std::vector<ModtranWord> numbers(int line) const {
    auto words = text_.words(line);
    if (words.size() >= row_.size()) return words;
    const auto parts = cut(line);
    if (!parts) return words;
    const bool aligned = std::equal(
        row_.begin(), row_.end(), parts->begin(),
        [](const ModtranWord& a, const ModtranWord& b) { return point_of(a) == point_of(b); });
    return aligned ? *parts : words;
  }

 private:
  static std::size_t end_of(const ModtranWord& word) { return word.column - 1 + word.text.size(); }
  static std::size_t point_of(const ModtranWord& word) {
    return word.column + std::min(word.text.find('.'), word.text.size());
  }

  /// None where a field is empty or holds several words, or something stands behind the last one.
  [[nodiscard]] std::optional<std::vector<ModtranWord>> cut(int line) const {
    const auto words = text_.words(line);
    std::vector<ModtranWord> out;
    std::size_t from = 0;
    for (const ModtranWord& field : row_) {
      const std::size_t to = end_of(field);
      std::vector<ModtranWord> inside;
      for (const ModtranWord& word : words) {
        const std::size_t begin = std::max<std::size_t>(word.column - 1, from);
        const std::size_t end = std::min(end_of(word), to);
        if (begin < end)
          inside.push_back(
              {text_.line(line).substr(begin, end - begin), static_cast<int>(begin) + 1});
      }
      if (inside.size() != 1) return {};
      out.push_back(inside.front());
      from = to;
    }
    if (!words.empty() && end_of(words.back()) > from) return {};
    return out;
  }

  const ModtranText& text_;
  int first_row_;
  std::vector<ModtranWord> row_;
};

/// Each name with the one below it.
std::vector<std::string> joined_names(const ModtranText& text, const Fields& fields, int line) {
  const auto first = fields.names(line), second = fields.names(line + 1);
  if (first.size() != second.size())
    text.fail(line, 1,
              fmt::format("{} names where the line below has {}", first.size(), second.size()),
              transmittances_expected);
  if (fields.lack_numbers(first.size())) text.fail_without_numbers(line);
  std::vector<std::string> out;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const std::string name = first[i].text + " " + second[i].text;
    const bool twice = std::find(out.begin(), out.end(), name) != out.end();
    if (twice && !fields.has_rows()) text.fail_without_numbers(line);
    if (twice)
      text.fail(line, first[i].column, fmt::format("column \"{}\" appears twice", shown(name)), "");
    out.push_back(name);
  }
  return out;
}

}  // namespace

bool is_tape7(const std::string& text) {
  if (is_tape6(text)) return false;
  const ModtranText file(text, "");
  for (int n = 1; n <= file.lines(); ++n)
    if (begins_with(file.words(n), "FREQ")) return true;
  return false;
}

ModtranTransmittances::ModtranTransmittances(const std::string& text, const std::string& name)
    : name_(name) {
  const ModtranText file(text, name);
  names_line_ = find_names(file);
  const Fields fields(file, names_line_);
  const std::vector<std::string> names = joined_names(file, fields, names_line_);
  int n = names_line_ + 2;
  for (; n <= file.lines() && !is_end(file.words(n)); ++n) {
    const auto words = fields.numbers(n);
    if (words.empty()) continue;
    if (words.size() != names.size())
      file.fail(n, 1,
                fmt::format("{} numbers where {} columns are named at line {}", words.size(),
                            names.size(), names_line_),
                "");
    const double wavenumber = file.number(n, words[0], "a wavenumber", 1, 1e6);
    if (!wavenumber_per_cm_.empty() && wavenumber <= wavenumber_per_cm_.back())
      file.fail(n, words[0].column,
                fmt::format("wavenumber {:g} is not above the {:g} before it", wavenumber,
                            wavenumber_per_cm_.back()),
                "expected: ascending wavenumbers");
    wavenumber_per_cm_.push_back(wavenumber);
    line_.push_back(n);
    for (std::size_t i = 1; i < words.size(); ++i) {
      const double max = names[i].starts_with(minus_log) ? 1e6 : 1;
      cells_[names[i]].push_back(
          {file.number(n, words[i], names[i], 0, max), half_last_digit(words[i].text)});
    }
  }
  if (n > file.lines())
    file.fail(file.lines(), 1, "the file ends without -9999: is it truncated?", "");
  while (++n <= file.lines()) {
    if (!file.words(n).empty())
      file.fail(n, 1, "something follows the -9999 that ends a run", "expected: one run in a file");
  }
  if (wavenumber_per_cm_.size() < 2)
    file.fail(names_line_, 1, "there are no two rows of numbers below", "");
}

std::vector<std::string> ModtranTransmittances::columns() const {
  std::vector<std::string> out;
  for (const auto& [column, cells] : cells_) out.push_back(column);
  return out;
}

RoundedDepth ModtranTransmittances::at_row(const std::string& column, std::size_t row) const {
  const Cell t = cells_.at(column)[row];
  const auto species = column.substr(0, column.find(' '));
  const auto log = cells_.find(minus_log + species);
  if (log != cells_.end() && column == species + of_transmittance) {
    const Cell depth = log->second[row];
    if (t.value == 0 || depth.rounding < t.rounding / t.value) return {depth.value, depth.rounding};
  }
  return {0 - std::log(t.value), t.rounding / t.value};
}

void ModtranTransmittances::fail_opaque(const std::string& column, std::size_t row) const {
  throw InputError({{name_, line_[row], 1,
                     fmt::format("{} is printed as 0: its optical depth is above {:.1f}", column,
                                 -std::log(cells_.at(column)[row].rounding)),
                     "take a shorter path"}});
}

ModtranTransmittances::Between ModtranTransmittances::between_rows(const std::string& column,
                                                                   double wavelength_nm) const {
  if (!cells_.contains(column) || column.starts_with(minus_log))
    throw InputError({{name_, names_line_, 1, fmt::format("no column \"{}\"", column),
                       fmt::format("there are: {}", fmt::join(columns(), ", "))}});
  const auto& w = wavenumber_per_cm_;
  const double wavenumber = 1 / (cm_per_nm * wavelength_nm);
  constexpr double rounding = 1e-12;  // of a wavelength that wavelengths_nm() gave
  if (!(wavenumber >= w.front() * (1 - rounding) && wavenumber <= w.back() * (1 + rounding)))
    throw InputError(
        {{name_, 0, 0,
          fmt::format("no transmittances at {:g} nm: the file covers {:g}-{:g} nm", wavelength_nm,
                      1 / (cm_per_nm * w.back()), 1 / (cm_per_nm * w.front())),
          "choose another wavelength"}});
  const auto [i, t] = interval_of(w, wavenumber);
  return {i, std::clamp(t, 0.0, 1.0)};
}

RoundedDepth ModtranTransmittances::optical_depth(const std::string& column,
                                                  double wavelength_nm) const {
  const auto [i, t] = between_rows(column, wavelength_nm);
  const RoundedDepth from = at_row(column, i - 1), to = at_row(column, i);
  if (std::isinf(from.value)) fail_opaque(column, i - 1);
  if (std::isinf(to.value)) fail_opaque(column, i);
  return {std::lerp(from.value, to.value, t), std::lerp(from.rounding, to.rounding, t)};
}

double ModtranTransmittances::transmittance(const std::string& column, double wavelength_nm) const {
  constexpr double at_a_row = 1e-9;  // of the way to the next
  const auto [i, t] = between_rows(column, wavelength_nm);
  const double from = at_row(column, i - 1).value, to = at_row(column, i).value;
  if (t < at_a_row) return std::exp(-from);
  if (t > 1 - at_a_row) return std::exp(-to);
  return std::exp(-(1 - t) * from - t * to);
}

std::vector<double> ModtranTransmittances::wavelengths_nm() const {
  std::vector<double> out;
  for (auto w = wavenumber_per_cm_.rbegin(); w != wavenumber_per_cm_.rend(); ++w)
    out.push_back(1 / (cm_per_nm * *w));
  return out;
}

}  // namespace photic::optics
