// The names of instruction sets, and which are here.
#include "core/isa.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace photic {
namespace {

TEST(Isa, HasAName) {
  for (const Isa isa : isas) EXPECT_EQ(isa_of(isa_name(isa)), isa);
  EXPECT_FALSE(isa_of("sse9"));
}

// Each set needs the ones before it; some may not have been built. Seen red: with those of the
// processor taken for those that run here.
TEST(Isa, RunsHereIfBuiltAndOfThisProcessor) {
  const auto here = isas_here();
  ASSERT_FALSE(here.empty());
  EXPECT_EQ(here.front(), Isa::baseline);
  EXPECT_TRUE(std::ranges::is_sorted(here));
  for (std::size_t i = 0; i < isas.size(); ++i) {
    const bool runs = is_built(isas.at(i)) && is_of_processor(isas.at(i));
    EXPECT_EQ(std::ranges::count(here, isas.at(i)), runs ? 1 : 0);
    if (i > 0 && is_of_processor(isas.at(i))) {
      EXPECT_TRUE(is_of_processor(isas.at(i - 1)));
    }
  }
}

}  // namespace
}  // namespace photic
