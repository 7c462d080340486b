#include "medium/sources.hpp"

#include <gtest/gtest.h>

#include "medium/layer_optics.hpp"

namespace photic::medium {
namespace {

// Seen red: with a new source for each wavelength.
TEST(Sources, OfManyWavelengthsAreListedOnce) {
  std::vector<Source> sources;
  for (const double nm : {532.0, 650.0, 488.0}) add_source("a of water", "a paper", nm, sources);
  add_source("a of water", "another paper", 700, sources);
  add_source(Contribution{.name = "CDOM", .a_per_m = 0.1, .b_per_m = {}, .source = "given"}, 532,
             sources);
  ASSERT_EQ(sources.size(), 3U);
  EXPECT_EQ(source_line(sources[0]), "a of water, 488-650 nm: a paper");
  EXPECT_EQ(source_line(sources[1]), "a of water, 700 nm: another paper");
  EXPECT_EQ(source_line(sources[2]), "a of CDOM, 532 nm: given");
}

TEST(Sources, OfWhatIsTheSameAtAllWavelengthsNameNone) {
  std::vector<Source> sources;
  add_source("slopes of the sea surface", "a paper", 0, sources);
  EXPECT_EQ(source_line(sources.at(0)), "slopes of the sea surface: a paper");
}

TEST(Sources, OfWhatAddsNothingAreNotListed) {
  std::vector<Source> sources;
  add_source(Contribution{.name = "CDOM", .a_per_m = {}, .b_per_m = {}, .source = "given"}, 532,
             sources);
  EXPECT_TRUE(sources.empty());
}

}  // namespace
}  // namespace photic::medium
