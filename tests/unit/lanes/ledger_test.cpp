// Accounts whose lanes are added up at the end.
#include <gtest/gtest.h>

#include "core/pack.hpp"
// Packs first: what follows is made of them.
#include "lanes/lane_ledger.hpp"

namespace photic::lanes {
namespace {

using Lanes = Pack<float, 4>;

// Seen red: with weights of lanes that are not of the mask booked, too.
TEST(LaneLedger, AddsUpWhatIsBooked) {
  LaneLedger<Lanes> ledger;
  Lanes weight;
  for (std::size_t i = 0; i < 4; ++i) weight.set(i, static_cast<float>(1 + i));
  const auto odd = weight < Lanes(3);
  book(ledger.absorbed, odd, weight);
  book(ledger.absorbed, odd, weight);
  book(ledger.lost, !odd, weight);
  const tally::Ledger all = total(ledger);
  EXPECT_EQ(all.absorbed, 6);
  EXPECT_EQ(all.lost, 7);
  EXPECT_EQ(all.sum(), 13);
}

}  // namespace
}  // namespace photic::lanes
