#include "core/utf8.hpp"

#include <gtest/gtest.h>

namespace photic {
namespace {

// Seen red: with bytes for letters.
TEST(Utf8, LettersNotBytes) {
  EXPECT_EQ(letters("déjà ±1 µm"), 10U);
  EXPECT_EQ(letters(""), 0U);
  EXPECT_EQ(first_letters("déjà", 2), "dé");
  EXPECT_EQ(first_letters("déjà", 9), "déjà");
  EXPECT_EQ(first_letters("é", 0), "");
}

}  // namespace
}  // namespace photic
