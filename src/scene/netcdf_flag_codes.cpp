#include "scene/netcdf_flag_codes.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <sstream>

#include "scene/node.hpp"
#include "scene/suggest.hpp"

namespace photic::scene {
namespace {

std::vector<std::string> divided(std::string text, const std::string& dividers) {
  for (char& c : text)
    if (dividers.find(c) != std::string::npos) c = '\n';
  std::istringstream lines(text);
  std::vector<std::string> parts;
  for (std::string part; std::getline(lines, part);)
    if (part.find_first_not_of(' ') != std::string::npos) parts.push_back(part);
  return parts;
}

/// The attribute's words; what commas divide, where that makes as many as there are flags.
std::vector<std::string> meanings_of(const NetcdfCodes& codes, std::size_t flags) {
  if (codes.flag_meanings.size() != 1) return codes.flag_meanings;
  auto words = divided(codes.flag_meanings.front(), " \t");
  auto phrases = divided(codes.flag_meanings.front(), ",;");
  return words.size() != flags && phrases.size() == flags ? phrases : words;
}

std::string in_brackets(const std::string& meaning) {
  return fmt::format(" ({})", quoted(shortened(meaning)));
}

/// Explains the flags of one variable.
class Explainer {
 public:
  Explainer(const NetcdfColumns& file, const std::string& name, const NetcdfCodes& codes)
      : file_(file), name_(name), codes_(codes) {
    const std::size_t flags = codes.flag_masks.empty() ? values().size() : masks().size();
    meanings_ = meanings_of(codes, flags);
    const bool has_meanings = !meanings_.empty() || !masks().empty();
    if (has_meanings && meanings_.size() != flags)
      fail(fmt::format("has {} {} and {} flag_meanings", flags,
                       masks().empty() ? "flag_values" : "flag_masks", meanings_.size()));
    if (!masks().empty() && !values().empty() && values().size() != flags)
      fail(fmt::format("has {} flag_values and {} flag_masks", values().size(), flags));
  }

  FlagCodes explained() {
    FlagCodes out;
    if (!masks().empty()) read_bits();
    if (masks().empty() && !meanings_.empty()) read_values();
    for (std::size_t i = 0; i < codes_.size(); ++i) {
      const std::string flag = codes_.code(i);
      if (!masks().empty())
        out.code.push_back(by_bits(codes_.number[i]));
      else if (!meanings_.empty())
        out.code.push_back(by_values(flag));
      else
        out.code.push_back(by_table(flag));
      FlagCode& code = out.code.back();
      code.text = fmt::format("{}{}", codes_.code_text(i), code.text);
    }
    out.by_table = meanings_.empty() && !codes_.number.empty();
    return out;
  }

 private:
  /// Values of some bits that say something; of single bits that they are not all 0.
  struct Bits {
    std::uint64_t mask;
    std::optional<std::uint64_t> value;
    std::string meaning;

    [[nodiscard]] bool hold(std::uint64_t flag) const {
      return value ? (flag & mask) == *value : (flag & mask) != 0;
    }
  };

  [[nodiscard]] const std::vector<std::string>& values() const { return codes_.flag_values; }
  [[nodiscard]] const std::vector<double>& masks() const { return codes_.flag_masks; }

  [[noreturn]] void fail(const std::string& reason) const {
    file_.fail(name_, reason, "every flag has one meaning");
  }

  void expect_one_meaning(const std::string& flag, const std::string& a,
                          const std::string& b) const {
    if (quality_of(a) != quality_of(b))
      fail(fmt::format("its attributes explain the flag {} as {} and as {}", flag,
                       quoted(shortened(a)), quoted(shortened(b))));
  }

  void read_values() {
    for (std::size_t i = 0; i < values().size(); ++i) {
      const auto [at, is_new] = meaning_.emplace(values()[i], meanings_[i]);
      if (!is_new) expect_one_meaning(values()[i], at->second, meanings_[i]);
    }
  }

  static std::optional<std::uint64_t> as_bits(double x) {
    constexpr double most = 0x1p53;  // above it not every whole number is a double
    if (!(x >= 0 && x <= most) || x != std::floor(x)) return std::nullopt;
    return static_cast<std::uint64_t>(x);
  }

  [[nodiscard]] std::uint64_t bits_of_mask(double x) const {
    const auto bits = as_bits(x);
    if (!bits) fail(fmt::format("its flag_masks has {}, which is no set of bits", x));
    if (*bits == 0) fail("its flag_masks has 0, which is no bit");
    return *bits;
  }

  [[nodiscard]] std::uint64_t bits_of_value(const std::string& text) const {
    std::uint64_t bits = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, bits);
    if (error != std::errc{} || stop != end)
      fail(fmt::format("its flag_values has {}, which is no set of bits", shortened(text)));
    return bits;
  }

  void read_bits() {
    for (std::size_t i = 0; i < masks().size(); ++i) {
      Bits bits{bits_of_mask(masks()[i]), std::nullopt, meanings_[i]};
      if (!values().empty()) bits.value = bits_of_value(values()[i]);
      for (const Bits& other : bits_)
        if (other.mask == bits.mask && other.value == bits.value)
          expect_one_meaning(plain_number(masks()[i]), other.meaning, bits.meaning);
      bits_.push_back(std::move(bits));
    }
  }

  [[nodiscard]] FlagCode by_bits(double number) const {
    FlagCode out{Quality::unchecked, "", ""};
    const auto set = as_bits(number);
    std::uint64_t unexplained = set.value_or(0);
    std::vector<std::string> meanings;
    for (const Bits& bits : bits_) {
      if (!set || !bits.hold(*set)) continue;
      meanings.push_back(bits.meaning);
      out.quality = worst(out.quality, quality_of(bits.meaning));
      unexplained &= ~bits.mask;
    }
    if (!meanings.empty()) out.text = in_brackets(fmt::format("{}", fmt::join(meanings, " ")));
    if (!set || unexplained != 0) out.misfit = "has bits that its attributes do not explain";
    return out;
  }

  static Quality worst(Quality a, Quality b) {
    for (const Quality q : {Quality::bad, Quality::unclear, Quality::good})
      if (a == q || b == q) return q;
    return Quality::unchecked;
  }

  [[nodiscard]] FlagCode by_values(const std::string& flag) const {
    const auto at = meaning_.find(flag);
    if (at == meaning_.end()) return {Quality::unclear, "", misfit()};
    return {quality_of(at->second), in_brackets(at->second), ""};
  }

  /// Without meanings. A word is its own one.
  [[nodiscard]] FlagCode by_table(const std::string& flag) const {
    const bool is_word = codes_.number.empty() && flag.size() > 1;
    const bool fits = values().empty() || std::ranges::find(values(), flag) != values().end();
    return {is_word ? quality_of(flag) : quality_in_table(flag), "", fits ? "" : misfit()};
  }

  [[nodiscard]] std::string misfit() const {
    return fmt::format("is none of its flag_values ({})", first_of(values()));
  }

  const NetcdfColumns& file_;
  const std::string& name_;
  const NetcdfCodes& codes_;
  std::vector<std::string> meanings_;
  std::map<std::string, std::string> meaning_;  ///< of each flag
  std::vector<Bits> bits_;
};

}  // namespace

FlagCodes flag_codes(const NetcdfColumns& file, const std::string& name, const NetcdfCodes& codes) {
  return Explainer(file, name, codes).explained();
}

}  // namespace photic::scene
