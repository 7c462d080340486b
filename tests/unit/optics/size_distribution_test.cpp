#include "optics/size_distribution.hpp"

#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

/// Particles per radius, over those at r0.
double ratio_per_radius(const SizeDistribution& sizes, double r, double r0) {
  return number_per_log_radius(sizes, r) / r / (number_per_log_radius(sizes, r0) / r0);
}

// Seen red: with numbers per radius in place of those per ln(radius).
TEST(SizeDistribution, OfJungeIsAPowerLaw) {
  EXPECT_NEAR(ratio_per_radius(Junge{5, 1e-7, 1e-5}, 2e-6, 1e-6), 1.0 / 32, 1e-12);
}

// At one spread from the mode exp(-1/2), at two exp(-2) of what there is at the mode. Seen red:
// without the half.
TEST(SizeDistribution, OfLogNormalFallsBySpreads) {
  const LogNormal sizes{1e-6, 2, 1e-7, 1e-5};
  EXPECT_NEAR(number_per_log_radius(sizes, 2e-6) / number_per_log_radius(sizes, 1e-6),
              std::exp(-0.5), 1e-12);
  EXPECT_NEAR(number_per_log_radius(sizes, 0.25e-6) / number_per_log_radius(sizes, 1e-6),
              std::exp(-2.0), 1e-12);
}

// Seen red: with straight lines throughout; with radii left in um; per ln(radius).
TEST(SizeDistribution, OfATableIsAPowerLawBetweenItsRows) {
  const SizeTable sizes = size_table(
      DataTable::parse("radius_um,number_per_um\n0.1,0\n0.2,8\n0.8,0.5\n1.6,0\n", "sizes.csv"));
  EXPECT_EQ(smooth_between_m(sizes).size(), 4U);
  EXPECT_NEAR(smooth_between_m(sizes)[1], 2e-7, 1e-20);
  const auto per_um = [&](double r_um) {
    return number_per_log_radius(sizes, r_um * 1e-6) / (r_um * 1e-6);
  };
  EXPECT_NEAR(per_um(0.15), 4, 1e-9);
  EXPECT_NEAR(per_um(0.2), 8, 1e-9);
  EXPECT_NEAR(per_um(0.4), 2, 1e-9);
  EXPECT_NEAR(per_um(1.2), 0.25, 1e-9);
  EXPECT_NEAR(per_um(1.6), 0, 1e-9);
}

TEST(SizeDistribution, TablesOfNoUseAreRefusedWithLineAndColumn) {
  const auto problem = [](const std::string& rows) {
    return message<InputError>(
        [&] { size_table(DataTable::parse("radius_um,number_per_um\n" + rows, "s.csv")); });
  };
  expect_contains(problem("0.1,1\n"), "s.csv:2:1: a size distribution needs at least two rows");
  expect_contains(problem("0,1\n1,1\n"), "s.csv:2:1: ");
  expect_contains(problem("0.1,1\n1,-1\n"), "s.csv:3:3: ");
  expect_contains(problem("0.1,0\n1,0\n"), "there are no particles");
}

}  // namespace
}  // namespace photic::optics
