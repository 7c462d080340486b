#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "core/constants.hpp"
#include "optics/air_plausibility.hpp"
#include "optics/modtran.hpp"
#include "optics/modtran_text.hpp"
#include "optics/table_text.hpp"

namespace photic::optics {
namespace {

// LOWTRAN 7 measures gases against one at 0 C and one atmosphere, p / kT.
constexpr double loschmidt_per_m3 = 101325 / (boltzmann_j_k * 273.15);
constexpr double per_m_of_atm_cm_per_km = 1e-2 / 1e3;  // a thickness in cm on every km

constexpr const char* height = "Z";
constexpr const char* pressure = "P";
constexpr const char* molecules = "MOL SCAT";
constexpr const char* first_aerosols = "AEROSOL 1";

/// A block of a tape6.
struct Block {
  int names_line = 0;
  std::vector<std::string> names;
  std::vector<int> lines;          ///< of the rows
  std::vector<ModtranWord> whole;  ///< a row with a word in each column, if there is one

  [[nodiscard]] bool has(const std::string& name) const {
    return std::find(names.begin(), names.end(), name) != names.end();
  }
};

/// The words of a row as columns: one that is blank where another row has a word is empty. As they
/// stand if that cannot be.
std::vector<ModtranWord> with_blank(std::vector<ModtranWord> words,
                                    const std::vector<ModtranWord>& whole) {
  const auto end = [](const ModtranWord& w) { return w.column + static_cast<int>(w.text.size()); };
  const auto alike = [&](const ModtranWord& a, const ModtranWord& b) { return end(a) == end(b); };
  if (words.size() + 1 != whole.size()) return words;
  const auto blank = std::mismatch(words.begin(), words.end(), whole.begin(), alike);
  if (!std::equal(blank.first, words.end(), blank.second + 1, alike)) return words;
  words.insert(blank.first, {"", blank.second->column});
  return words;
}

/// Blank, or what is printed of a number that is none.
bool is_missing(const std::string& text) {
  return text.find_first_not_of('*') == std::string::npos || text == "NaN";
}

/// Returns whether the second word belongs to the name that the first one begins.
bool one_name(const std::string& first, const std::string& second) {
  static const std::vector<std::pair<std::string, std::string>> pairs{
      {"MOL", "SCAT"}, {"WAT", "DROP"}, {"ICE", "PART"}, {"RAIN", "RATE"}};
  return second.starts_with("(") || (first == "AEROSOL" && second.size() == 1) ||
         std::find(pairs.begin(), pairs.end(), std::pair(first, second)) != pairs.end();
}

std::vector<std::string> joined(const std::vector<ModtranWord>& words) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    out.push_back(words[i].text);
    if (i + 1 < words.size() && one_name(words[i].text, words[i + 1].text))
      out.back() += " " + words[++i].text;
  }
  return out;
}

/// Rows begin with the number of the level.
bool is_row(const std::vector<ModtranWord>& words) {
  return words.size() > 1 && std::all_of(words[0].text.begin(), words[0].text.end(), [](char c) {
           return std::isdigit(static_cast<unsigned char>(c)) != 0;
         });
}

Block block_below(const ModtranText& text, int title_line) {
  Block block;
  int n = title_line + 1;
  while (n <= text.lines() && text.words(n).empty()) ++n;
  if (n > text.lines())
    text.fail(title_line, 1, "the file ends after this title: is it truncated?",
              "expected: the names of columns");
  block.names_line = n;
  block.names = joined(text.words(n));
  while (++n <= text.lines() && !text.is_title(n)) {
    if (const auto words = text.words(n); is_row(words)) {
      block.lines.push_back(n);
      if (words.size() == block.names.size()) block.whole = words;
    } else if (!block.lines.empty()) {
      break;
    }
  }
  return block;
}

void check_version(const ModtranText& text, int first_title) {
  for (int n = 1; n < first_title; ++n) {
    if (text.line(n).find("MODTRAN") != std::string::npos) return;
    const auto at = text.line(n).find("LOWTRAN");
    if (at == std::string::npos) continue;
    const auto version = text.line(n).find_first_of("0123456789", at);
    if (version != std::string::npos && text.line(n)[version] == '7') return;
    text.fail(n, static_cast<int>(at) + 1, "another version of LOWTRAN",
              "expected: LOWTRAN 7 or MODTRAN");
  }
  text.fail(1, 1, "no LOWTRAN 7 or MODTRAN is named above the first profile",
            "expected: a tape6 from its beginning");
}

/// The columns of a profile as they are read.
class Tape6 {
 public:
  explicit Tape6(const ModtranText& text) : text_(text) {
    int first_title = 0;
    for (int n = 1; n <= text.lines(); ++n) {
      if (!text.is_title(n)) continue;
      if (first_title == 0) first_title = n;
      const Block block = block_below(text, n);
      if (block.has(molecules)) keep(molecules_, block);
      if (block.has(first_aerosols)) keep(aerosols_, block);
    }
    if (first_title == 0)
      text.fail(1, 1, fmt::format("no block \"{}\"", modtran_profiles),
                "expected: a tape6 that has one, as of NOPRNT = 0");
    check_version(text, first_title);
    if (!molecules_) missing(molecules);
    if (!aerosols_) missing(first_aerosols);
  }

  [[nodiscard]] AirProfile profile(const std::string& name) const {
    AirProfile out;
    out.source = name;
    out.z_km = heights(*molecules_);
    check_same(out.z_km);
    out.edges_km = out.aerosol_z_km = out.z_km;
    out.pressure_hpa = column(*molecules_, pressure, 0, max_hpa);
    out.temperature_k = column(*molecules_, "T", lowest_k, highest_k);
    out.air_per_m3 = scaled(column(*molecules_, molecules, 1e-20, 10), loschmidt_per_m3);
    out.ozone_per_m3 =
        scaled(column(*molecules_, "O3 (UV)", 0, 1e3), loschmidt_per_m3 * per_m_of_atm_cm_per_km);
    // MODTRAN prints a second column of that name if it scales the water vapour; aerosols go by
    // the first.
    const std::string humidity = aerosols_->has("RH (%)") ? "RH (%)" : "RH";
    out.relative_humidity_percent = column(*aerosols_, humidity, 0, 100, May::lack);
    if (const auto remark = fill_humidities(out.z_km, out.relative_humidity_percent))
      out.remarks.push_back(fmt::format("{} {}", humidity, *remark));
    for (std::size_t k = 0; k < aerosol_regions; ++k)
      out.aerosols_per_km[k] =
          column(*aerosols_, fmt::format("AEROSOL {}", k + 1), 0, max_aerosols_per_km);
    if (const auto fault = fault_of(out, rounding_hpa())) fail(*fault);
    return out;
  }

 private:
  /// A column may lack numbers, which are NaN then.
  enum class May { not_lack, lack };

  void keep(std::optional<Block>& place, const Block& block) const {
    if (place)
      text_.fail(block.names_line, 1,
                 fmt::format("these columns are also at line {}", place->names_line),
                 "expected: one run in a file");
    if (block.lines.empty())
      text_.fail(block.names_line, 1, "there are no levels below: is the file truncated?",
                 "expected: rows of numbers");
    const auto of_numbers = [&](int line) {
      return are_numbers(text_.words(line), block.names.size());
    };
    if (std::ranges::none_of(block.lines, of_numbers)) text_.fail_without_numbers(block.names_line);
    place = block;
    const std::vector<double> z = column(block, height, 0, 1e6);
    if (z.front() > z.back()) std::ranges::reverse(place->lines);  // printed from the top down
  }

  [[noreturn]] void missing(const std::string& column) const {
    text_.fail(
        text_.lines(), 1,
        fmt::format("the file ends without a block \"{}\" with a column {}: is it truncated?",
                    modtran_profiles, column),
        "");
  }

  [[nodiscard]] std::size_t index_of(const Block& block, const std::string& name) const {
    const auto found = std::find(block.names.begin(), block.names.end(), name);
    if (found == block.names.end())
      text_.fail(block.names_line, 1, fmt::format("no column {}", name),
                 fmt::format("there are: {}", fmt::join(block.names, ", ")));
    return static_cast<std::size_t>(found - block.names.begin());
  }

  /// A row as its columns.
  [[nodiscard]] std::vector<ModtranWord> row(const Block& block, int line) const {
    const std::size_t columns = block.names.size();
    auto words = text_.words(line);
    if (!text_.is_open(line)) words = with_blank(std::move(words), block.whole);
    if (words.size() != columns)
      text_.fail(line, 1,
                 fmt::format("{} numbers where {} columns are named at line {}", words.size(),
                             columns, block.names_line),
                 "");
    return words;
  }

  /// A column of a block by its name.
  [[nodiscard]] std::vector<double> column(const Block& block, const std::string& name, double min,
                                           double max, May may = May::not_lack) const {
    const std::size_t at = index_of(block, name);
    std::vector<double> out;
    for (const int line : block.lines) {
      const ModtranWord word = row(block, line)[at];
      const bool missing = may == May::lack && is_missing(word.text);
      out.push_back(missing ? std::nan("") : text_.number(line, word, name, min, max));
    }
    return out;
  }

  /// The largest error of pressures by the digits that are printed.
  [[nodiscard]] double rounding_hpa() const {
    const std::size_t at = index_of(*molecules_, pressure);
    double out = max_hpa;
    for (const int line : molecules_->lines)
      out = std::min(out, half_last_digit(row(*molecules_, line)[at].text));
    return out;
  }

  [[noreturn]] void fail(const AirFault& fault) const {
    const char* name = fault.of == AirFault::Of::altitude   ? height
                       : fault.of == AirFault::Of::pressure ? pressure
                                                            : molecules;
    const int line = molecules_->lines[fault.level];
    text_.fail(line, row(*molecules_, line)[index_of(*molecules_, name)].column, fault.reason,
               fault.suggestion);
  }

  [[nodiscard]] std::vector<double> heights(const Block& block) const {
    std::vector<double> z = column(block, height, 0, 1e6);
    const bool down = block.lines.front() > block.lines.back();
    for (std::size_t i = 1; i < z.size(); ++i) {
      if (z[i] > z[i - 1]) continue;
      const std::size_t later = down ? i - 1 : i, before = down ? i : i - 1;
      text_.fail(block.lines[later], row(block, block.lines[later])[1].column,
                 fmt::format("Z {:g} is not {} the {:g} before it", z[later],
                             down ? "below" : "above", z[before]),
                 down ? "expected: descending altitudes" : "expected: ascending altitudes");
    }
    if (z.size() < 2)
      text_.fail(block.lines[0], 1, "a profile of one level", "expected: two or more");
    return z;
  }

  /// Both blocks must be about the same levels.
  void check_same(const std::vector<double>& z) const {
    const std::vector<double> other = heights(*aerosols_);
    if (other.size() != z.size())
      text_.fail(aerosols_->lines.back(), 1,
                 fmt::format("{} levels where the block at line {} has {}: is the file truncated?",
                             other.size(), molecules_->names_line, z.size()),
                 "");
    for (std::size_t i = 0; i < z.size(); ++i) {
      if (z[i] != other[i])
        text_.fail(aerosols_->lines[i], 1,
                   fmt::format("Z {:g} where the block at line {} has {:g}", other[i],
                               molecules_->names_line, z[i]),
                   "expected: one run in a file");
    }
  }

  static std::vector<double> scaled(std::vector<double> values, double factor) {
    for (double& value : values) value *= factor;
    return values;
  }

  const ModtranText& text_;
  std::optional<Block> molecules_, aerosols_;
};

}  // namespace

bool is_tape6(const std::string& text) {
  const ModtranText file(text, "");
  for (int n = 1; n <= file.lines(); ++n)
    if (file.is_title(n) || file.is_head(n)) return true;
  return false;
}

AirProfile modtran_profile(const std::string& text, const std::string& name) {
  return Tape6(ModtranText(text, name)).profile(name);
}

}  // namespace photic::optics
