#include "scene/netcdf_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "scene/suggest.hpp"
#include "scene/unit_text.hpp"

namespace photic::scene {
namespace {

/// A profile needs them.
constexpr std::size_t fewest_levels = 2;

/// Whether a flag says that a value is probably bad, bad, or missing: by its meaning, where the
/// file tells it; by Argo's table otherwise (Argo user's manual, reference table 2; from memory).
bool is_bad(double flag, const NetcdfVariable& flags) {
  if (flags.meaning.empty()) return flag == 3 || flag == 4 || flag == 9;
  const auto meaning = flags.meaning.find(flag);
  if (meaning == flags.meaning.end()) return false;
  const std::string text = lower_case(meaning->second);
  if (text.starts_with("not_") || text.starts_with("not ")) return false;
  constexpr std::array words{"bad",   "missing", "fail",  "suspect", "questionable", "reject",
                             "error", "erron",   "wrong", "invalid", "spike",        "doubtful"};
  return std::ranges::any_of(
      words, [&](const char* word) { return text.find(word) != std::string::npos; });
}

std::size_t known(const Levels& levels) {
  return static_cast<std::size_t>(std::count_if(levels.value.begin(), levels.value.end(),
                                                [](double x) { return std::isfinite(x); }));
}

std::size_t known_together(const Levels& a, const Levels& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < std::min(a.value.size(), b.value.size()); ++i)
    if (std::isfinite(a.value[i]) && std::isfinite(b.value[i])) ++count;
  return count;
}

/// The adjusted values of a variable, if there are enough of them.
bool has_adjusted(const NetcdfColumns& file, const std::string& name, std::size_t profile) {
  if (!file.has(name)) return false;
  try {
    return known(ProfileVariable(file, name).levels_for(profile)) >= fewest_levels;
  } catch (const InputError&) {
    return false;
  }
}

/// The adjusted variables that have what these lack; none if any of them has it not.
std::vector<std::string> adjusted(const NetcdfColumns& file,
                                  const std::vector<const ProfileVariable*>& variables,
                                  std::size_t profile) {
  std::vector<std::string> found;
  for (const ProfileVariable* variable : variables) {
    if (known(variable->levels_for(profile)) >= fewest_levels) continue;
    const std::string other = variable->name() + "_ADJUSTED";
    if (!has_adjusted(file, other, profile)) return {};
    found.push_back(other);
  }
  return found;
}

}  // namespace

std::string Levels::at(std::size_t level) const { return fmt::format("{}{}]", prefix, level); }

ProfileVariable::ProfileVariable(const NetcdfColumns& file, std::string name)
    : file_(file), name_(std::move(name)), flags_name_(name_ + "_QC"), variable_(file.read(name_)) {
  const auto& length = variable_.length;
  if (length.empty() || length.size() > 2)
    file_.fail(shape(),
               fmt::format("has {} dimensions, not (levels) or (profiles, levels)", length.size()));
  if (length.size() == 2 && variable_.dimension.back() == "N_PROF")
    file_.fail(shape(), "has its levels first", "dimensions are (profiles, levels)");
  if (length.back() > most_levels)
    file_.fail(shape(),
               fmt::format("has {} levels; at most {} are read", length.back(), most_levels));
  if (file_.has(flags_name_)) read_flags();
}

void ProfileVariable::read_flags() {
  flags_ = file_.read_flags(flags_name_, variable_.length.size());
  if (flags_->length != variable_.length)
    file_.fail(shape_text(flags_name_, *flags_),
               fmt::format("should have a flag for each value of {}", shape()));
}

std::size_t ProfileVariable::profiles() const {
  return variable_.length.size() == 2 ? variable_.length.front() : 1;
}

Levels ProfileVariable::levels(std::size_t profile) const {
  if (profile >= profiles())
    file_.fail(shape(), fmt::format("there is no profile {}: it has {}, counted from 0", profile,
                                    profiles()));
  Levels levels;
  levels.prefix =
      variable_.length.size() == 2 ? fmt::format("{}[{}, ", name_, profile) : name_ + "[";
  levels.value = row(variable_, profile);
  if (flags_) drop_flagged(profile, levels);
  return levels;
}

Levels ProfileVariable::levels_for(std::size_t profile) const {
  return levels(variable_.length.size() == 2 ? profile : 0);
}

std::vector<double> ProfileVariable::row(const NetcdfVariable& of, std::size_t profile) const {
  const std::size_t levels = variable_.length.back();
  const auto first = of.value.begin() + static_cast<std::ptrdiff_t>(profile * levels);
  return {first, first + static_cast<std::ptrdiff_t>(levels)};
}

void ProfileVariable::drop_flagged(std::size_t profile, Levels& levels) const {
  const std::vector<double> flag = row(*flags_, profile);
  std::size_t dropped = 0;
  for (std::size_t i = 0; i < levels.value.size(); ++i) {
    if (!is_bad(flag[i], *flags_) || !std::isfinite(levels.value[i])) continue;
    levels.value[i] = std::numeric_limits<double>::quiet_NaN();
    ++dropped;
  }
  const char* what = flags_->meaning.empty() ? "bad (3, 4) or missing (9)" : "bad or missing";
  if (dropped > 0)
    levels.flagged = fmt::format("{} flags {} of {} levels of {} as {}, which then have no value",
                                 flags_name_, dropped, levels.value.size(), name_, what);
}

std::string instead_of(const NetcdfColumns& file, const ProfileVariable& depth,
                       const ProfileVariable& value, std::size_t profile) {
  const auto others = adjusted(file, {&value, &depth}, profile);
  if (!others.empty()) return fmt::format("there is {}", joined(others, "and"));
  // Floats write each of their instruments into another profile.
  const bool one_depth = depth.variable().length.size() == 1;
  const std::size_t profiles =
      one_depth ? value.profiles() : std::min(value.profiles(), depth.profiles());
  for (std::size_t i = 0; i < profiles; ++i)
    if (known_together(value.levels_for(i), depth.levels_for(i)) >= fewest_levels)
      return fmt::format("the first profile with values is {}", i);
  return "no profile has values";
}

}  // namespace photic::scene
