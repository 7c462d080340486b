// Sums of the environments' numbers, for the lanes of a pack.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/lanes.hpp"
#include "medium/medium.hpp"

namespace photic::estimator {

/// Rows of the environments' numbers, each with a factor, lane by lane.
template <class T>
class Terms {
 public:
  void clear() { count_ = 0; }
  void add(const Index<T>& row, const T& factor) {
    if (count_ == term_.size()) term_.emplace_back();
    term_[count_++] = {each_lane(row), each_lane(factor)};
  }
  /// Their sum in a lane, for environments from `first` on.
  [[nodiscard]] T sum(const medium::EnvironmentsView& environments, std::size_t lane,
                      std::int32_t first) const {
    T sum(0);
    for (std::size_t k = 0; k < count_; ++k) {
      const auto& [rows, factors] = term_[k];
      if (factors[lane] == 0) continue;
      const T number = load<T>(environments.number, rows[lane] * environments.stride + first);
      sum = sum + T(factors[lane]) * number;
    }
    return sum;
  }

 private:
  struct Term {
    std::array<std::int32_t, lanes_of<T>> row{};
    std::array<Element<T>, lanes_of<T>> factor{};
  };
  std::vector<Term> term_;  ///< the first `count_` count
  std::size_t count_ = 0;
};

}  // namespace photic::estimator
