#include "scene/netcdf_shape.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace photic::scene {
namespace {

std::size_t stride(const Shape& shape, std::size_t axis) {
  std::size_t product = 1;
  for (std::size_t i = axis + 1; i < shape.length.size(); ++i) product *= shape.length[i];
  return product;
}

/// Without the dimensions of length one.
Shape squeezed(const Shape& shape) {
  Shape out;
  for (std::size_t i = 0; i < shape.length.size(); ++i) {
    if (shape.length[i] == 1) continue;
    out.dimension.push_back(shape.dimension[i]);
    out.length.push_back(shape.length[i]);
  }
  return out;
}

bool has_repeats(std::vector<std::string> names) {
  std::ranges::sort(names);
  return std::ranges::adjacent_find(names) != names.end();
}

}  // namespace

std::size_t Shape::size() const { return length.empty() ? 1 : stride(*this, 0) * length.front(); }

std::optional<std::size_t> Shape::axis(const std::string& name) const {
  const auto at = std::find(dimension.begin(), dimension.end(), name);
  return at == dimension.end() ? std::nullopt
                               : std::optional(static_cast<std::size_t>(at - dimension.begin()));
}

std::size_t Shape::index(std::size_t axis, std::size_t position) const {
  return position / stride(*this, axis) % length[axis];
}

std::string Shape::index_text(std::size_t position) const {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < length.size(); ++i) all.push_back(index(i, position));
  return fmt::format("[{}]", fmt::join(all, ", "));
}

std::optional<Alignment> Alignment::of(const Shape& inner, const Shape& outer) {
  const Shape small = squeezed(inner), large = squeezed(outer);
  if (has_repeats(small.dimension) || has_repeats(large.dimension)) return std::nullopt;
  const bool named = std::ranges::all_of(
      small.dimension, [&](const std::string& name) { return large.axis(name).has_value(); });
  if (!named && small.length != large.length) return std::nullopt;
  Alignment alignment;
  for (std::size_t i = large.length.size(); i-- > 0;) {
    const auto axis = named ? small.axis(large.dimension[i]) : std::optional(i);
    if (axis && small.length[*axis] != large.length[i]) return std::nullopt;
    alignment.step_.push_back({large.length[i], axis ? stride(small, *axis) : 0});
  }
  return alignment;
}

std::size_t Alignment::operator()(std::size_t outer_position) const {
  std::size_t position = 0;
  for (const Step& step : step_) {
    position += outer_position % step.length * step.stride;
    outer_position /= step.length;
  }
  return position;
}

}  // namespace photic::scene
