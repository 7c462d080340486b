#include "core/elementary.hpp"

#include <cmath>

namespace photic {

const OctaveTables octave_tables{
    .power = CellTable([](double x, double) { return std::exp2(-x); }),
    .inverse = CellTable([](double x, double width) { return width / (1 + x); }),
    .log = CellTable([](double x, double) { return std::log1p(x); })};

}  // namespace photic
