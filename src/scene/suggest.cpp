#include "scene/suggest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <set>

#include "scene/unit_text.hpp"
#include "scene/units.hpp"

namespace photic::scene {
namespace {

/// Insertions, deletions, substitutions and swaps of neighbours that turn a into b ("optimal string
/// alignment": Damerau, Commun. ACM 7(3), 171 (1964)).
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

/// A word in lower case, with one joint between its parts: "half_divergence_mrad".
std::string folded(const std::string& word) {
  std::string out = lower_case(word);
  std::ranges::replace_if(
      out, [](char c) { return c == '-' || c == ' '; }, '_');
  return out;
}

/// Returns whether this is a part of units in the names of keys, those of scenes and those that
/// people would write.
bool is_unit_part(const std::string& part) {
  static const std::set<std::string> all{
      "per", "nm",  "um",  "mm",      "cm",      "m",    "km",   "m2",   "m3", "l",    "ml", "ng",
      "ug",  "mg",  "g",   "kg",      "rad",     "mrad", "urad", "deg",  "sr", "s",    "ms", "us",
      "ns",  "psu", "ppt", "degrees", "percent", "c",    "k",    "degc", "kn", "knots"};
  return all.count(part) > 0;
}

/// A word without its unit, and that unit's parts.
struct StemAndUnit {
  explicit StemAndUnit(const std::string& word) : stem(parts_of(word)) {
    while (stem.size() > 1 && is_unit_part(stem.back())) {
      unit.insert(unit.begin(), stem.back());
      stem.pop_back();
    }
  }

  std::vector<std::string> stem, unit;
};

using OfCandidate = std::function<bool(const std::string& candidate)>;

std::vector<std::string> those(const std::vector<std::string>& known, const OfCandidate& test) {
  std::vector<std::string> out;
  std::copy_if(known.begin(), known.end(), std::back_inserter(out), test);
  return out;
}

bool holds(const std::vector<std::string>& parts, const std::vector<std::string>& some) {
  return std::search(parts.begin(), parts.end(), some.begin(), some.end()) != parts.end();
}

/// The words that are spelt much like the word.
std::vector<std::string> misspelt(const std::string& word, const std::vector<std::string>& known) {
  constexpr std::size_t shortest = 3;  // letters: of fewer, one that is wrong leaves too little
  if (word.size() < shortest) return {};
  const std::string plain = folded(word);
  std::vector<std::string> best;
  std::size_t best_distance =
      std::max<std::size_t>(1, std::min<std::size_t>(4, word.size() / 3)) + 1;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(plain, folded(candidate));
    if (distance < best_distance) {
      best = {candidate};
      best_distance = distance;
    }
  }
  return best;
}

/// The words whose name holds the word's, as few parts longer as there are. A word with a unit does
/// not stand for one without.
std::vector<std::string> longer(const StemAndUnit& word, const std::vector<std::string>& known) {
  const auto parts = [](const std::string& candidate) {
    return StemAndUnit(candidate).stem.size();
  };
  if (word.stem.size() == 1 && word.stem.front().size() < 4) return {};
  const auto all = those(known, [&](const std::string& c) {
    const StemAndUnit candidate(c);
    return holds(candidate.stem, word.stem) && (word.unit.empty() || !candidate.unit.empty());
  });
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (const std::string& candidate : all) fewest = std::min(fewest, parts(candidate));
  return those(all, [&](const std::string& c) { return parts(c) == fewest; });
}

/// The words that differ from the word in case alone, or else in their unit alone.
std::vector<std::string> alike(const std::string& word, const std::vector<std::string>& known) {
  const StemAndUnit named(word);
  auto found = those(known, [&](const std::string& c) { return folded(c) == folded(word); });
  if (found.empty())
    found = those(known, [&](const std::string& c) { return StemAndUnit(c).stem == named.stem; });
  return found;
}

std::vector<std::string> closest(const std::string& word, const std::vector<std::string>& known) {
  constexpr std::size_t longest_key = 100;  // longer than any mistyped key; keeps the table small
  if (word.empty() || word.size() > longest_key) return {};
  auto found = alike(word, known);
  if (found.empty()) found = misspelt(word, known);
  if (found.empty()) found = longer(StemAndUnit(word), known);
  constexpr std::size_t most = 4;
  return found.size() <= most ? found : std::vector<std::string>{};
}

/// The part of the meant word that the written one lacks.
std::string difference(const StemAndUnit& written, const std::string& meant) {
  const StemAndUnit named(meant);
  const auto has = [](const StemAndUnit& n, const char* part) {
    return std::find(n.stem.begin(), n.stem.end(), part) != n.stem.end();
  };
  std::string out;
  if (has(named, "half") && !has(written, "half")) out = " it is half of the full angle";
  // "min" is no part of a unit: it is in depth_min_m, too.
  const bool other_time = has(written, "min") && named.unit == std::vector<std::string>{"s"};
  if (other_time || (!written.unit.empty() && !named.unit.empty() && written.unit != named.unit))
    out += fmt::format("{} in {}", out.empty() ? " it is" : ",", unit_of(meant));
  return out;
}

std::string question(const std::string& word, const std::vector<std::string>& meant) {
  std::vector<std::string> names;
  for (const std::string& name : meant) names.push_back(fmt::format("'{}'", name));
  return fmt::format("did you mean {}?{}", joined(names, "or"),
                     meant.size() == 1 ? difference(StemAndUnit(word), meant.front()) : "");
}

}  // namespace

std::vector<std::string> parts_of(const std::string& word) {
  std::vector<std::string> parts{""};
  for (const char c : folded(word)) {
    if (c == '_')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

std::optional<std::string> same_word(const std::string& word,
                                     const std::vector<std::string>& known) {
  const auto same = alike(word, known);
  return same.size() == 1 ? std::optional(question(word, same)) : std::nullopt;
}

std::string suggestion_for(const std::string& word, const std::vector<std::string>& known,
                           const std::string& lead) {
  const auto near = closest(word, known);
  return near.empty() ? fmt::format("{}: {}", lead, fmt::join(known, ", ")) : question(word, near);
}

std::string joined(const std::vector<std::string>& words, const std::string& last_joint) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) out += i + 1 == words.size() ? fmt::format(" {} ", last_joint) : ", ";
    out += words[i];
  }
  return out;
}

std::string first_of(const std::vector<std::string>& words) {
  constexpr std::size_t most = 5;
  const auto end = words.begin() + static_cast<std::ptrdiff_t>(std::min(words.size(), most));
  return fmt::format("{}{}", fmt::join(words.begin(), end, ", "), words.size() > most ? ", …" : "");
}

}  // namespace photic::scene
