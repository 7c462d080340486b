#include "core/turn.hpp"

#include <cmath>

namespace photic {

const Rose rose{FixedTable<Rose::points>([](double i) { return std::cos(2 * pi * i / Rose::points); }),
                FixedTable<Rose::points>([](double i) { return std::sin(2 * pi * i / Rose::points); })};

}  // namespace photic
