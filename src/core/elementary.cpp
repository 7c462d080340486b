#include "core/elementary.hpp"

#include <cmath>

namespace photic {
namespace {

constexpr double cells = OctaveTables::cells;

}  // namespace

const OctaveTables octave_tables{Table64([](double i) { return std::exp2(-i / cells); }),
                                 Table64Pair([](double i) { return 1 / (cells * (1 + i / cells)); },
                                             [](double i) { return std::log1p(i / cells); })};

}  // namespace photic
