#include "scene/netcdf_layout.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "scene/unit_text.hpp"

namespace photic::scene {
namespace {

bool is_time(const NetcdfColumns& file, const std::string& dimension) {
  const std::string word = lower_case(dimension);
  return word == "time" || word == "t" ||
         (file.has(dimension) && file.header(dimension).text("standard_name") == "time");
}

/// Returns whether a dimension is known as one of places or times.
bool is_horizontal(const NetcdfColumns& file, const std::string& dimension) {
  static const std::set<std::string> names{"lat", "latitude", "lon", "longitude", "x", "y"};
  static const std::set<std::string> axes{"X", "Y", "T"};
  if (names.contains(lower_case(dimension)) || is_time(file, dimension)) return true;
  if (!file.has(dimension)) return false;
  const NetcdfHeader& coordinate = file.header(dimension);
  const std::string standard_name = coordinate.text("standard_name");
  return standard_name == "latitude" || standard_name == "longitude" ||
         axes.contains(coordinate.text("axis"));
}

bool is_called_levels(const std::string& dimension) {
  const std::string word = lower_case(dimension);
  return word.find("lev") != std::string::npos || word == "z" || word.starts_with("depth") ||
         word.starts_with("pres");
}

/// Returns whether the last of two dimensions cannot be that of levels. Gliders write them against
/// time.
bool are_turned(const NetcdfColumns& file, const std::string& first, const std::string& last) {
  static const std::set<std::string> profiles{"n_prof", "profile", "profiles",  "cast",
                                              "casts",  "station", "trajectory"};
  if (is_horizontal(file, last)) return is_called_levels(first) || !is_time(file, last);
  return profiles.contains(lower_case(last));
}

/// The last dimension, but for those of length one that are none of levels.
std::size_t last_axis(const NetcdfColumns& file, const Shape& shape) {
  std::size_t axis = shape.length.size() - 1;
  const auto has_no_levels = [&](std::size_t i) {
    const auto others = shape.dimension.begin() + static_cast<std::ptrdiff_t>(i);
    return is_horizontal(file, shape.dimension[i]) ||
           (!is_called_levels(shape.dimension[i]) &&
            std::any_of(shape.dimension.begin(), others, is_called_levels));
  };
  while (axis > 0 && shape.length[axis] == 1 && has_no_levels(axis)) --axis;
  return axis;
}

constexpr const char* wanted_dimensions = "dimensions are (profiles, levels)";

/// The dimension of the profiles, if there are several.
std::optional<std::size_t> profile_axis(const NetcdfColumns& file, const std::string& name,
                                        const Shape& shape, std::size_t level_axis) {
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < shape.length.size(); ++i)
    if (i != level_axis && shape.length[i] != 1) others.push_back(i);
  if (others.size() > 1)
    file.fail(shape_text(name, shape),
              fmt::format("has {} dimensions longer than one, not (levels) or (profiles, levels)",
                          others.size() + 1),
              "one place or one time has to be cut out of it");
  return others.empty() ? std::nullopt : std::optional(others.front());
}

Shape known_shape(const NetcdfColumns& file, const std::string& name) {
  Shape shape = shape_of(file.header(name));
  if (shape.length.empty())
    file.fail(shape_text(name, shape), "has 0 dimensions, not (levels) or (profiles, levels)");
  return shape;
}

}  // namespace

Layout layout_of(const NetcdfColumns& file, const std::string& value, const std::string& depth) {
  const Shape x = known_shape(file, value);
  Shape z = known_shape(file, depth);
  const std::string x_text = shape_text(value, x), z_text = shape_text(depth, z);
  const std::size_t z_axis = last_axis(file, z);
  const auto shared = x.axis(z.dimension[z_axis]);
  const std::size_t x_axis = shared.value_or(last_axis(file, x));
  const auto profiles = profile_axis(file, value, x, x_axis);
  if (profiles && *profiles > x_axis)
    file.fail(x_text, fmt::format("has its levels first, and {} has them last", z_text),
              wanted_dimensions);
  if (profiles && are_turned(file, x.dimension[*profiles], x.dimension[x_axis]))
    file.fail(x_text, "has its levels first", wanted_dimensions);
  if (z.length[z_axis] != x.length[x_axis])
    file.fail(z_text, fmt::format("has {} levels where {} has {}", z.length[z_axis], value,
                                  x.length[x_axis]));
  z.dimension[z_axis] = x.dimension[x_axis];
  const auto aligned = Alignment::of(z, x);
  if (!aligned) file.fail(z_text, fmt::format("has a dimension that {} lacks", x_text));
  return {x, x_axis, profiles, *aligned, !shared};
}

}  // namespace photic::scene
