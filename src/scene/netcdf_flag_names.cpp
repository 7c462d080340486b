#include "scene/netcdf_flag_names.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "scene/flag_meaning.hpp"
#include "scene/netcdf_shape.hpp"
#include "scene/suggest.hpp"

namespace photic::scene {
namespace {

using Words = std::vector<std::string>;

/// Returns whether this is a word of the names of flags, besides the variable's own name.
bool is_flag_word(const std::string& word) {
  return word == "quality" || word.ends_with("qc") || word.ends_with("flag") ||
         word.ends_with("flags");
}

bool goes_with_flags(const std::string& word) {
  constexpr std::array others{"control", "status",    "data", "primary", "rollup",
                              "summary", "aggregate", "agg",  "qartod",  "seadatanet"};
  return is_flag_word(word) || std::ranges::find(others, word) != others.end();
}

bool has_flag_word(const Words& words) { return std::ranges::any_of(words, is_flag_word); }

/// The words of a name; "chlaqc" and "chlaQC" have two.
Words words_of_name(const std::string& name) {
  Words words = parts_of(name);
  const std::string last = words.back();
  if (last.size() > 2 && last.ends_with("qc")) {
    words.back() = last.substr(0, last.size() - 2);
    words.emplace_back("qc");
  }
  return words;
}

/// The words of a name besides those of another name that it holds; nothing if it does not.
std::optional<Words> words_besides(Words words, const Words& held) {
  const auto found = std::search(words.begin(), words.end(), held.begin(), held.end());
  if (found == words.end()) return std::nullopt;
  words.erase(found, found + static_cast<std::ptrdiff_t>(held.size()));
  return words;
}

std::vector<std::string> listed_by(const NetcdfHeader& header) {
  std::string list = header.text("ancillary_variables");
  std::ranges::replace(list, ',', ' ');  // CF asks for blanks
  std::istringstream words(list);
  std::vector<std::string> names;
  for (std::string name; words >> name;)
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  return names;
}

/// Finds the flags of one variable.
class Search {
 public:
  Search(const NetcdfColumns& file, const std::string& variable)
      : file_(file), variable_(variable), header_(file.header(variable)) {
    for (const auto& [name, header] : file.contents().variable) {
      words_[name] = words_of_name(name);
      for (const std::string& flags : listed_by(header)) listed_.insert(flags);
    }
  }

  FlagNames found() {
    for (const std::string& name : listed_by(header_)) take_listed(name);
    for (const auto& [name, header] : file_.contents().variable)
      if (name != variable_ && !is_listed(name)) take_named(name, header);
    return std::move(found_);
  }

 private:
  void take_listed(const std::string& name) {
    const bool is_there = file_.has(name) && name != variable_;
    if (!is_there)
      return remark(
          fmt::format("the attribute ancillary_variables of {} names {}, which the file does "
                      "not have: no flags of it are looked at",
                      variable_, name));
    const NetcdfHeader& header = file_.header(name);
    if (!looks_like_flags(name, header)) return;
    if (!Alignment::of(shape_of(header), shape_of(header_)))
      remark(not_understood(name, fmt::format("does not have the dimensions of {}", variable_)));
    else if (is_explained(name, header))
      found_.listed.push_back(name);
    else
      remark(not_understood(name, "does not explain its flags"));
  }

  void take_named(const std::string& name, const NetcdfHeader& header) {
    const Words& words = words_.at(name);
    if (!has_flag_word(words) && !has_standard_name_of_flags(header) && !means_bad(header)) return;
    const std::string owner = owner_of(name, words);
    if (owner.empty() && !listed_.contains(name)) return take_nobodys(name, words, header);
    if (owner != variable_) return;
    const Words besides = *words_besides(words, words_.at(variable_));
    const bool is_plain = std::ranges::all_of(besides, goes_with_flags);
    if (!is_plain && !is_of_each_value(header)) return;  // such as flags of whole profiles
    if (!is_plain)
      remark(not_understood(name, "looks like one of the flags of " + variable_));
    else if (is_explained(name, header))
      found_.named.push_back(name);
    else
      remark(not_understood(name, "does not explain its flags"));
  }

  /// Flags of everything, or of what the file does not name.
  void take_nobodys(const std::string& name, const Words& words, const NetcdfHeader& header) {
    const std::string standard_name = header.text("standard_name");
    const std::string own = header_.text("standard_name");
    const bool may_be_own = std::ranges::all_of(words, goes_with_flags) || means_bad(header) ||
                            standard_name.ends_with("quality_flag") ||
                            (!own.empty() && standard_name == own + " status_flag");
    if (may_be_own && is_of_each_value(header))
      remark(not_understood(name, "looks like flags, but not of which variable"));
  }

  /// The variable of the longest name that the name of flags holds; of those that differ by case
  /// alone the one that is spelled alike, then this one. Empty if there is none.
  [[nodiscard]] std::string owner_of(const std::string& flags, const Words& words) const {
    std::string owner;
    std::array<std::size_t, 3> best{};
    for (const auto& [name, header] : file_.contents().variable) {
      const Words& held = words_.at(name);
      if (looks_like_flags(name, header) || !header.has_numbers || !words_besides(words, held))
        continue;
      const std::array<std::size_t, 3> rank{held.size(),
                                            flags.find(name) != std::string::npos ? 1U : 0U,
                                            name == variable_ ? 1U : 0U};
      if (rank > best) owner = name;
      best = std::max(best, rank);
    }
    return owner;
  }

  /// Returns whether a variable has a value for each level of this one, at least.
  [[nodiscard]] bool is_of_each_value(const NetcdfHeader& header) const {
    const Shape own = shape_of(header_), other = shape_of(header);
    const auto alignment = Alignment::of(other, own);
    return alignment && other.size() == own.size();
  }

  [[nodiscard]] bool is_listed(const std::string& name) const {
    const auto names = listed_by(header_);
    return std::ranges::find(names, name) != names.end();
  }

  /// Returns whether some of its flags are those of bad values.
  static bool means_bad(const NetcdfHeader& header) {
    std::istringstream meanings(header.text("flag_meanings"));
    for (std::string meaning; meanings >> meaning;)
      if (quality_of(meaning) == Quality::bad) return true;
    return false;
  }

  static bool has_standard_name_of_flags(const NetcdfHeader& header) {
    const std::string name = header.text("standard_name");
    return name.ends_with("quality_flag") || name.ends_with("status_flag");
  }

  [[nodiscard]] bool looks_like_flags(const std::string& name, const NetcdfHeader& header) const {
    return name != variable_ && (header.has_flags || has_standard_name_of_flags(header) ||
                                 has_flag_word(words_.at(name)));
  }

  /// Returns whether the meaning of the flags is known, by the file or by Argo's table.
  static bool is_explained(const std::string& name, const NetcdfHeader& header) {
    const Words words = words_of_name(name);
    return !header.text("flag_meanings").empty() || std::ranges::find(words, "qc") != words.end() ||
           std::ranges::find(words, "qartod") != words.end();
  }

  static std::string not_understood(const std::string& name, const std::string& why) {
    return fmt::format(
        "{} {}: no level is left out by these flags (those are read that ancillary_variables of "
        "the variable lists and that flag_values and flag_meanings explain)",
        name, why);
  }

  void remark(std::string text) { found_.remarks.push_back(std::move(text)); }

  const NetcdfColumns& file_;
  const std::string& variable_;
  const NetcdfHeader& header_;
  std::map<std::string, Words> words_;  ///< of all names
  std::set<std::string> listed_;        ///< by any variable
  FlagNames found_;
};

}  // namespace

FlagNames flag_names_of(const NetcdfColumns& file, const std::string& variable) {
  return Search(file, variable).found();
}

}  // namespace photic::scene
