// What diagnostics look like to the user.
#include "core/error.hpp"

#include <gtest/gtest.h>

namespace photic {
namespace {

TEST(Diagnostic, SaysPlaceReasonAndSuggestion) {
  EXPECT_EQ((Diagnostic{"a.toml", 3, 7, "no such key", "did you mean g?"}.text()),
            "a.toml:3:7: no such key (did you mean g?)");
  EXPECT_EQ((Diagnostic{"a.toml", 3, 7, "no such key", ""}.text()), "a.toml:3:7: no such key");
  EXPECT_EQ((Diagnostic{"--set sea.depth=1", 0, 0, "no such key", ""}.text()),
            "--set sea.depth=1: no such key");
  EXPECT_EQ((Diagnostic{"", 0, 0, "no data at 200 nm", "choose another set"}.text()),
            "no data at 200 nm (choose another set)");
}

TEST(InputError, ListsAllDiagnosticsLineByLine) {
  const InputError error({{"a", 1, 2, "first", ""}, {"b", 3, 4, "second", "third"}});
  EXPECT_STREQ(error.what(), "a:1:2: first\nb:3:4: second (third)");
  EXPECT_EQ(error.diagnostics().size(), 2U);
}

TEST(Contract, ThrowsWhenBroken) {
  EXPECT_NO_THROW(expect(true, "kept"));
  try {
    expect(false, "kept");
    FAIL() << "nothing was thrown";
  } catch (const ContractViolation& e) {
    EXPECT_STREQ(e.what(), "broken promise: kept");
  }
}

}  // namespace
}  // namespace photic
