#include "optics/legendre.hpp"

#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

TEST(Legendre, IntegratesPolynomialsAndSmoothFunctions) {
  for (const int count : {2, 4, 10, 64, 400, 2000}) {
    const GaussRule rule(count);
    double even = 0, exponential = 0;
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      even += rule.weight[i] * std::pow(rule.node[i], 2 * count - 2);
      exponential += rule.weight[i] * std::exp(3 * rule.node[i]);
    }
    EXPECT_NEAR(even * (2 * count - 1) / 2, 1, 1e-10) << count;
    if (count >= 10) {
      EXPECT_NEAR(exponential / ((std::exp(3.0) - std::exp(-3.0)) / 3), 1, 1e-12) << count;
    }
  }
}

// Henyey & Greenstein's function, whose coefficients are (2 l + 1) g^l / (4 pi). Seen red: with 2 l
// for 2 l + 1; with 2 l + 2 in the recurrence.
TEST(Legendre, HoldsAFunctionByItsValuesAtTheNodes) {
  const double g = 0.9;
  const PhaseShape function = henyey_greenstein(g);
  const GaussRule rule(400);
  std::vector<double> values;
  for (const double cosine : rule.node) values.push_back(function.p(1 - cosine));
  const LegendreSeries series(rule, values);
  EXPECT_NEAR(4 * pi * series.mean(), 1, 1e-12);
  EXPECT_NEAR(4 * pi * series.mean_with_cosine(), g, 1e-12);
  for (const double x : {0.0, 1e-12, 1e-8, 1e-3, 0.02, 0.5, 1.0, 1.7, 2.0})
    EXPECT_NEAR(series.at(x) / function.p(x), 1, 1e-9) << x;
}

// Near the forward direction P_l(1 - x) = 1 - l (l + 1) x / 2: the digits of x are not lost.
TEST(Legendre, KeepsTheDigitsOfSmallAngles) {
  const GaussRule rule(100);
  std::vector<double> values;
  for (const double cosine : rule.node) values.push_back(std::legendre(90, cosine));
  const LegendreSeries series(rule, values);
  const double slope = (series.at(1e-10) - series.at(0)) / 1e-10;
  EXPECT_NEAR(slope, -90 * 91 / 2.0, 0.05);
}

// Seen red: with odd numbers of nodes let through.
TEST(Legendre, RefusesWhatMakesNoSense) {
  EXPECT_THROW(GaussRule(0), ContractViolation);
  EXPECT_THROW(GaussRule(7), ContractViolation);
  EXPECT_THROW(LegendreSeries(GaussRule(4), {1, 2, 3}), ContractViolation);
}

}  // namespace
}  // namespace photic::optics
