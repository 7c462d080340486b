#include "core/turn.hpp"

#include <cmath>

namespace photic {

const Rose rose{Table64Pair([](double i) { return std::cos(2 * pi * i / Rose::points); },
                            [](double i) { return std::sin(2 * pi * i / Rose::points); })};

}  // namespace photic
