#include "core/turn.hpp"

#include <cmath>

namespace photic {

const Rose rose{Table64([](double i) { return std::cos(2 * pi * i / Rose::points); }),
                Table64([](double i) { return std::sin(2 * pi * i / Rose::points); })};

}  // namespace photic
