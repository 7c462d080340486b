// The names of instruction sets, and which are here.
#include "core/isa.hpp"

#include <gtest/gtest.h>

namespace photic {
namespace {

TEST(Isa, HasAName) {
  for (const Isa isa : isas) EXPECT_EQ(isa_of(isa_name(isa)), isa);
  EXPECT_FALSE(isa_of("sse9"));
}

// Each set needs the ones before it.
TEST(Isa, OfThisProcessorAreTheFirstOfAll) {
  const auto here = isas_here();
  ASSERT_FALSE(here.empty());
  for (std::size_t i = 0; i < here.size(); ++i) EXPECT_EQ(here[i], isas.at(i));
}

}  // namespace
}  // namespace photic
