// Scenes of light sources and tallies, and numbers of their results.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/scenes.hpp"
#include "tally/result.hpp"

namespace photic::test {

/// Light at 532 nm; `keys`: of its kind.
inline std::string light(const std::string& kind, const std::string& keys) {
  return fmt::format("[source]\nkind = \"{}\"\nwavelength_nm = 532.0\n{}\n", kind, keys);
}
/// From +x.
inline std::string sun_at(double zenith_deg) {
  return light("beam", fmt::format("zenith_deg = {}", zenith_deg));
}

/// Levels, or edges of cells, below the surface and above it.
struct Heights {
  std::vector<double> depth_m{}, height_m{};
};
/// A tally of a kind; `keys`: the others.
inline std::string tally_of(const std::string& kind, const Heights& at = {},
                            const std::string& keys = "") {
  std::string out = fmt::format("[[tally]]\nkind = \"{}\"\n", kind);
  if (!at.depth_m.empty()) out += fmt::format("depth_m = [{}]\n", fmt::join(at.depth_m, ", "));
  if (!at.height_m.empty()) out += fmt::format("height_m = [{}]\n", fmt::join(at.height_m, ", "));
  return out + keys + "\n";
}

/// Down to a bottom; `phase`: as in a scene.
inline std::string layer_to(double bottom_m, double a_per_m, double b_per_m,
                            const std::string& phase = "\"isotropic\"") {
  return water(a_per_m, b_per_m, phase) + fmt::format("bottom_depth_m = {}\n", bottom_m);
}

/// A tally of a result. Throws std::invalid_argument for one that there is not.
inline const tally::TallyEstimates& tally_named(const tally::Result& result,
                                                const std::string& name) {
  const auto found = std::ranges::find(result.tallies, name,
                                       [](const tally::TallyEstimates& t) { return t.grid.name; });
  if (found == result.tallies.end()) throw std::invalid_argument("no tally " + name);
  return *found;
}

/// A cell of a tally.
struct Known {
  double value = 0, error = 0;
};
inline Known known(const tally::Result& result, const std::string& name, std::size_t cell = 0) {
  const auto& tally = tally_named(result, name);
  return {tally.mean.at(cell), tally.standard_error.at(cell)};
}

/// Fails if a number is not within three of its errors of what it should be, but for what floats
/// round off, or not within 0.1 %.
inline void expect_known(const Known& number, double expected, const std::string& what) {
  constexpr double rounding = 3e-6;
  EXPECT_NEAR(number.value, expected, 3 * number.error + rounding * expected) << what;
  EXPECT_NEAR(number.value, expected, 1e-3 * expected) << what;
}

/// The sum over the cells of a tally.
inline double sum_of(const tally::Result& result, const std::string& name) {
  double sum = 0;
  for (const double cell : tally_named(result, name).mean) sum += cell;
  return sum;
}

}  // namespace photic::test
