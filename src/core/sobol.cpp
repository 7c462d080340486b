#include "core/sobol.hpp"

#include <boost/random/sobol.hpp>

namespace photic {

SobolPoints::SobolPoints(std::size_t points, std::size_t dimensions)
    : dimensions_(dimensions), words_(points * dimensions) {
  boost::random::sobol_engine<std::uint32_t, 32> engine(dimensions);
  for (std::size_t i = dimensions; i < words_.size(); ++i) words_[i] = reversed_bits(engine());
}

}  // namespace photic
