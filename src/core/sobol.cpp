#include "core/sobol.hpp"

#include <boost/random/sobol.hpp>

#include "core/lanes.hpp"

namespace photic {

SobolPoints::SobolPoints(std::size_t points, std::size_t dimensions)
    : points_(points), dimensions_(dimensions), words_(points * dimensions + table_padding) {
  boost::random::sobol_engine<std::uint32_t, 32> engine(dimensions);
  for (std::size_t p = 1; p < points; ++p)
    for (std::size_t d = 0; d < dimensions; ++d) words_[d * points + p] = reversed_bits(engine());
}

}  // namespace photic
