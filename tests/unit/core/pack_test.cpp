// Packs of floats against scalars, in every instruction set that this processor has.
#include "core/pack.hpp"

#include <gtest/gtest.h>

#include "core/isa.hpp"

namespace photic {

// pack_checks.cpp, compiled for each.
namespace baseline {
void check_packs();
}
namespace avx2 {
void check_packs();
}
namespace avx512 {
void check_packs();
}

namespace {

void check_packs(Isa isa) {
#if defined(PHOTIC_ISA_AVX512)
  if (isa == Isa::avx512) return avx512::check_packs();
#endif
#if defined(PHOTIC_ISA_AVX2)
  if (isa == Isa::avx2) return avx2::check_packs();
#endif
  ASSERT_EQ(isa, Isa::baseline);
  baseline::check_packs();
}

// One test for each instruction set of this processor: the others cannot run here, and no test is
// there to say that they did. Seen red: the half of a table of 64 chosen by the wrong bit; a table
// of 17 taken for one of 16; the lower half of the lanes made double twice; rows of a square not
// swapped; lanes of a mask expanded in their own places; the second columns of a pair of tables in
// another order; the second of two places with the event of the first.
class Packs : public testing::TestWithParam<Isa> {};
TEST_P(Packs, AreScalars) { check_packs(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Here, Packs, testing::ValuesIn(isas_here()),
                         [](const auto& set) { return isa_name(set.param); });

}  // namespace
}  // namespace photic
