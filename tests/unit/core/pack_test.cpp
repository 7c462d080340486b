// Packs of floats against scalars, in every instruction set that this processor has.
#include "core/pack.hpp"

#include <gtest/gtest.h>

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

// Seen red: the half of a table of 64 chosen by the wrong bit; a table of 17 taken for one of 16;
// the lower half of the lanes made double twice.
TEST(Packs, OfTheBaseline) { baseline::check_packs(); }

#if defined(__x86_64__)
TEST(Packs, OfAvx2) {
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "this processor has no AVX2";
  avx2::check_packs();
}
TEST(Packs, OfAvx512) {
  if (!__builtin_cpu_supports("avx512dq")) GTEST_SKIP() << "this processor has no AVX-512";
  avx512::check_packs();
}
#endif

}  // namespace
}  // namespace photic
