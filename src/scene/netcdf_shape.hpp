// The alignment of the values of one variable of a netCDF file with those of another.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace photic::scene {

/// The dimensions of a variable, the last fastest.
struct Shape {
  std::vector<std::string> dimension;
  std::vector<std::size_t> length;

  [[nodiscard]] std::size_t size() const;  ///< the number of values
  /// Returns the dimension of that name.
  [[nodiscard]] std::optional<std::size_t> axis(const std::string& name) const;
  /// The index along a dimension of the value at a position.
  [[nodiscard]] std::size_t index(std::size_t axis, std::size_t position) const;
  /// "[0, 3]".
  [[nodiscard]] std::string index_text(std::size_t position) const;
};

template <class Variable>
[[nodiscard]] Shape shape_of(const Variable& variable) {
  return {variable.dimension, variable.length};
}

/// The values of an inner variable that belong to those of an outer one. Dimensions of length one
/// do not count.
class Alignment {
 public:
  /// None if the inner variable has a dimension that the outer one lacks, unless the lengths of all
  /// are the same; nor if either has one twice.
  static std::optional<Alignment> of(const Shape& inner, const Shape& outer);

  /// The position in the inner variable.
  [[nodiscard]] std::size_t operator()(std::size_t outer_position) const;

 private:
  struct Step {
    std::size_t length;  ///< of a dimension of the outer variable
    std::size_t stride;  ///< in the inner one; 0 where it lacks the dimension
  };
  std::vector<Step> step_;  ///< the fastest first
};

}  // namespace photic::scene
