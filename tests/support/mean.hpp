// The mean of a sample and its standard error.
#pragma once

#include <cmath>

namespace photic::test {

struct Mean {
  double sum = 0, squares = 0;
  int count = 0;

  void add(double x) {
    sum += x;
    squares += x * x;
    ++count;
  }
  [[nodiscard]] double value() const { return sum / count; }
  [[nodiscard]] double error() const {
    return std::sqrt((squares / count - value() * value()) / (count - 1));
  }
};

}  // namespace photic::test
