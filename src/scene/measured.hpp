// The levels of a profile as an instrument wrote them: in any order, some at the same depth, some
// with less than nothing.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "scene/rules.hpp"

namespace photic::scene {

/// Levels that have both a depth and a value.
struct Measured {
  std::string levels;              ///< name of the file's own: "levels", "rows"
  std::string depth_name, name;    ///< names of depths and values in the file
  std::vector<std::size_t> level;  ///< which of the file's
  std::vector<double> depth_m, value;
};

/// Counts values below 0 as 0, with a remark.
void zero_negatives(Measured& measured, std::vector<std::string>& remarks);

/// Throws the error about a level of the file.
using RefuseLevel = std::function<void(std::size_t level, const Refusal& refusal)>;

/// Refuses the first value that does not obey the rule.
void check_values(const Measured& measured, const Number& rule, const RefuseLevel& refuse);

/// Makes depths ascend, values at the same one becoming their mean, with remarks. The levels of the
/// file are not known any more.
void put_in_order(Measured& measured, std::vector<std::string>& remarks);

}  // namespace photic::scene
