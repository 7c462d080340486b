// What the format knows and this version cannot do, refused by its name: the texts of all
// diagnostics, with line and column.
#include <gtest/gtest.h>

#include "unit/scene/base_scene.hpp"

namespace photic::scene {
namespace {

const std::vector<Case>& not_available_cases() {
  static const std::vector<Case> all{
      {"Sources",
       {{2, 2, R"([source]
kind = "beam")"}},
       {R"(scene.toml:3:8: 'kind' = "beam" is not available yet (available: laser))"}},
  };
  return all;
}

// Seen red: keys of later versions taken for unknown ones.
TEST(NotAvailableYet, EveryTextWithLineAndColumn) {
  for (const Case& c : not_available_cases()) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(diagnostics_of(edited(c.edits)), c.expected);
  }
}

}  // namespace
}  // namespace photic::scene
