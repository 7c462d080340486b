#include "core/turn.hpp"

#include <cmath>

namespace photic {

const Rose rose{.cosine = CellTable([](double x, double) { return std::cos(2 * pi * x); }),
                .sine = CellTable([](double x, double) { return std::sin(2 * pi * x); })};

}  // namespace photic
