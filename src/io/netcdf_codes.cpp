// Flags and names of casts in netCDF files.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "io/netcdf_packing.hpp"
#include "io/netcdf_values.hpp"
#include "io/netcdf_variable.hpp"
#include "scene/node.hpp"

namespace photic::io {
namespace {

using namespace std::string_literals;
using scene::NetcdfCodes;

constexpr double no_code = std::numeric_limits<double>::quiet_NaN();

/// The whole text as a number; nothing if it is none.
std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && stop == end ? std::optional(value) : std::nullopt;
}

/// Without blanks at its ends; "4" for "4.0", as programs write what were numbers.
std::string word_of(const std::string& text) {
  const std::string blanks = " \t\r\n\0"s;
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return "";
  std::string word = text.substr(first, text.find_last_not_of(blanks) + 1 - first);
  const auto number = number_in(word);
  if (!number) return word;
  return std::isnan(*number) ? "" : scene::plain_number(*number + 0.0);
}

/// All but those that are none, each once, ascending.
template <class T, class IsNone>
std::vector<T> different(std::vector<T> all, const IsNone& is_none) {
  all.erase(std::remove_if(all.begin(), all.end(), is_none), all.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

template <class T, class IsNone>
std::vector<std::size_t> index_in(const std::vector<T>& codes, const std::vector<T>& all,
                                  const IsNone& is_none) {
  std::vector<std::size_t> index;
  index.reserve(all.size());
  for (const T& x : all) {
    const auto at = std::lower_bound(codes.begin(), codes.end(), x);
    index.push_back(is_none(x) ? NetcdfCodes::none : static_cast<std::size_t>(at - codes.begin()));
  }
  return index;
}

bool is_nan(double x) { return std::isnan(x); }
bool is_empty(const std::string& text) { return text.empty(); }

/// Reads a variable of an open file.
class CodesReader {
 public:
  CodesReader(const NetcdfReader& file, const std::string& name)
      : variable_(file, name, dimensions_of_values(file)), attributes_(variable_.attributes()) {}

  [[nodiscard]] NetcdfCodes read() const {
    NetcdfCodes out{variable_.dimension(), variable_.length()};
    out.flag_meanings = attributes_.texts("flag_meanings");
    if (holds_numbers(variable_.type()))
      read_numbers(out);
    else
      read_texts(out);
    return out;
  }

 private:
  void read_numbers(NetcdfCodes& out) const {
    const Packing packing(attributes_, variable_.type());
    std::vector<double> flags;
    if (!is_text(attributes_.type("flag_values")))
      for (const double x : attributes_.numbers("flag_values"))
        flags.push_back(packing.as_stored(x));
    const bool bits = attributes_.type("flag_masks") != NC_NAT;
    for (const double x : attributes_.numbers("flag_masks")) out.flag_masks.push_back(bits_of(x));
    const auto code = [&](double x) { return bits ? bits_of(x) : packing.value_of(x) + 0.0; };
    out.flag_values = flag_values_in_text();
    for (const double x : flags) out.flag_values.push_back(scene::plain_number(code(x)));
    std::sort(flags.begin(), flags.end());
    std::vector<double> all = variable_.numbers();
    for (double& x : all) {
      const bool is_flag =
          flags.empty() ? x >= 1 && x <= 9
                        : std::binary_search(flags.begin(), flags.end(), packing.as_stored(x));
      x = !is_flag && packing.is_missing(x) ? no_code : code(x);
    }
    out.number = different(all, is_nan);
    out.value = index_in(out.number, all, is_nan);
  }

  void read_texts(NetcdfCodes& out) const {
    if (attributes_.type("flag_masks") != NC_NAT)
      attributes_.refuse("has flag_masks, but holds no numbers");
    out.flag_values = flag_values_in_text();
    if (!is_text(attributes_.type("flag_values")))
      for (const double x : attributes_.numbers("flag_values"))
        out.flag_values.push_back(scene::plain_number(x));
    std::vector<std::string> all = variable_.texts();
    for (std::string& text : all) text = word_of(text);
    out.text = different(all, is_empty);
    out.value = index_in(out.text, all, is_empty);
    as_numbers(out);
  }

  /// Texts that are all numbers ascend as these.
  static void as_numbers(NetcdfCodes& out) {
    std::vector<double> number;
    for (const std::string& text : out.text) {
      const auto x = number_in(text);
      if (!x || !std::isfinite(*x)) return;
      number.push_back(*x);
    }
    out.number = different(number, is_nan);
    for (std::size_t& i : out.value)
      if (i != NetcdfCodes::none)
        i = static_cast<std::size_t>(
            std::lower_bound(out.number.begin(), out.number.end(), number[i]) - out.number.begin());
    out.text.clear();
  }

  /// "0149A", each a flag, or with blanks or commas between; "0b" is how CDL writes a byte.
  [[nodiscard]] std::vector<std::string> flag_values_in_text() const {
    if (!is_text(attributes_.type("flag_values"))) return {};
    std::vector<std::string> words;
    for (std::string text : attributes_.texts("flag_values")) {
      std::replace(text.begin(), text.end(), ',', ' ');
      std::istringstream in(text);
      for (std::string word; in >> word;) words.push_back(word);
    }
    std::vector<std::string> out;
    if (words.size() == 1 && variable_.type() == NC_CHAR)
      for (const char c : words.front()) out.emplace_back(1, c);
    else
      for (const std::string& word : words) out.push_back(word_of(without_suffix(word)));
    return out;
  }

  static std::string without_suffix(const std::string& word) {
    const std::string rest = word.substr(0, word.size() - 1);
    return (word.back() == 'b' || word.back() == 's') && number_in(rest) ? rest : word;
  }

  [[nodiscard]] double bits_of(double x) const { return x < 0 ? x + span_of(variable_.type()) : x; }

  static bool is_text(nc_type type) { return type == NC_CHAR || type == NC_STRING; }

  const NetcdfValues variable_;
  const NetcdfAttributes& attributes_;
};

}  // namespace

NetcdfCodes netcdf_codes(const std::string& path, const std::string& name) {
  const NetcdfReader file(path, what_is_wanted);
  return CodesReader(file, name).read();
}

}  // namespace photic::io
