#include "scene/netcdf_instead.hpp"

#include <cmath>
#include <optional>
#include <vector>

#include "core/error.hpp"
#include "scene/suggest.hpp"
#include "scene/unit_text.hpp"

namespace photic::scene {
namespace {

/// A profile needs them.
constexpr std::size_t fewest_levels = 2;

/// The number of levels of a cast with a value and a depth; 0 if flags contradict each other.
std::size_t known_levels(const Cast& cast, const ProfileVariable& value,
                         const ProfileVariable& depth) {
  std::size_t count = 0;
  try {
    const Levels x = value.levels(cast.value), z = depth.levels(cast.depth);
    for (std::size_t i = 0; i < x.value.size(); ++i)
      if (std::isfinite(x.value[i]) && std::isfinite(z.value[i])) ++count;
  } catch (const InputError&) {
    return 0;
  }
  return count;
}

/// The name of a variable's adjusted values, if there are enough of them in a cast.
std::optional<std::string> adjusted(const NetcdfColumns& file, const ProfileVariable& variable,
                                    const std::vector<std::size_t>& positions) {
  const Cast cast{0, {}, positions, positions};
  for (const auto& [name, header] : file.contents().variable) {
    if (lower_case(name) != lower_case(variable.name() + "_adjusted") || !header.has_numbers ||
        header.length != variable.variable().length)
      continue;
    try {
      const ProfileVariable other(file, name);
      if (known_levels(cast, other, other) >= fewest_levels) return name;
    } catch (const InputError&) {
      continue;  // it is of no use itself
    }
  }
  return std::nullopt;
}

/// The adjusted variables that have what these lack; none if any of them has it not.
std::vector<std::string> all_adjusted(const NetcdfColumns& file, const Cast& cast,
                                      const ProfileVariable& value, const ProfileVariable& depth) {
  std::vector<std::string> found;
  const Cast of_value{0, {}, cast.value, cast.value}, of_depth{0, {}, cast.depth, cast.depth};
  for (const ProfileVariable* variable : {&value, &depth}) {
    const Cast& own = variable == &value ? of_value : of_depth;
    if (known_levels(own, *variable, *variable) >= fewest_levels) continue;
    const auto other = adjusted(file, *variable, own.value);
    if (!other) return {};
    found.push_back(*other);
  }
  return found;
}

}  // namespace

std::string instead_of(const NetcdfColumns& file, const Casts& casts, const Cast& cast,
                       const ProfileVariable& value, const ProfileVariable& depth) {
  const auto others = all_adjusted(file, cast, value, depth);
  if (!others.empty()) return fmt::format("there is {}", joined(others, "and"));
  // Floats write each of their instruments into another profile.
  for (const std::size_t number : casts.numbers())
    if (known_levels(casts.cast(number), value, depth) >= fewest_levels)
      return fmt::format("the first profile with values is {}", number);
  return "no profile has values";
}

}  // namespace photic::scene
