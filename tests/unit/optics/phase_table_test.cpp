#include "optics/phase_table.hpp"

#include <random>

#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

constexpr int outer_cells = PhaseView::cells - 1;
double edge(int outer_cell) { return PhaseView::edge(outer_cell + 1); }

/// The probability of less than x under the view's value(): the integral of straight lines.
double probability_below(const PhaseView& view, double x) {
  const double core_value = view.value(0.0);
  if (x < PhaseView::x_core) return 2 * pi * core_value * x;
  double sum = 2 * pi * core_value * PhaseView::x_core;
  for (int i = 0; i < outer_cells && edge(i) < x; ++i) {
    const double end = std::min(x, edge(i + 1));
    sum += pi * (view.value(edge(i)) + view.value(std::nextafter(end, 0.0))) * (end - edge(i));
  }
  return sum;
}

template <class T>
class PhaseValues : public testing::Test {};
using Lanes = testing::Types<double, float>;
TYPED_TEST_SUITE(PhaseValues, Lanes);

TEST(PhaseTable, IsAPdf) {
  for (const auto& [name, shape] : all_shapes()) {
    const PhaseTable table(shape);
    EXPECT_NEAR(probability_below(table.view(), 2), 1, 1e-12) << name;
  }
}

// Every cell from both of its ends, the ones at the poles and those on both sides of 90 degrees
// too. Seen red: with the cells behind 90 degrees counted from there on.
TYPED_TEST(PhaseValues, AreThoseOfTheirCells) {
  using T = TypeParam;
  const PhaseShape shape = raman_phase(0.17);
  const PhaseTable table(shape);
  const PhaseView view = table.view();
  const double whole = table_integral(shape);
  EXPECT_EQ(PhaseView::edge(0), 0);
  EXPECT_EQ(PhaseView::edge(PhaseView::forward_cells), 1);
  EXPECT_EQ(PhaseView::edge(PhaseView::cells), 2);
  const double rounding = 1e-13 + std::numeric_limits<T>::epsilon() * 4;
  for (int i = 1; i < PhaseView::cells; ++i) {
    const double from = PhaseView::edge(i), to = PhaseView::edge(i + 1);
    ASSERT_LT(from, to);
    for (const double part : {0.0, 0.3, 0.9999}) {
      const double x = static_cast<double>(static_cast<T>(std::lerp(from, to, part)));
      const double p = std::lerp(shape.p(from), shape.p(to), (x - from) / (to - from)) / whole;
      const double straight = x > 1 ? 1e-7 : 0;  // octaves that are one line
      ASSERT_NEAR(view.value(static_cast<T>(x)) / p, 1, rounding + straight) << i << " " << part;
    }
  }
  // Straight back, and what rounding puts behind it.
  for (const double x : {2 - 1e-6, 2.0, 2 + 1e-6})
    EXPECT_NEAR(view.value(static_cast<T>(x)) / shape.p(2), 1, 1e-4);
}

TEST(PhaseTable, InterpolatesWithin5e5OfTheIntegral) {
  for (const auto& [name, shape] : all_shapes())
    EXPECT_NEAR(table_integral(shape), 1, 5e-5) << name;
}

// Nothing is renormalised away. Seen red: with the core flattened to p(x_core) and the rest scaled
// up; with p taken at the cells' upper edges.
TEST(PhaseTable, KeepsTheFormulaOutsideTheCoreAndItsMassInside) {
  for (const auto& [name, shape] : all_shapes()) {
    const PhaseTable table(shape);
    const PhaseView view = table.view();
    EXPECT_NEAR(view.value(2.0) / shape.p(2), 1, 1e-4) << name;
    // Petzold's rows are as close as the cells straight back, and have corners.
    const double tolerance = name == "petzold" ? 2e-3 : 1e-4;
    for (double x = 2; x >= PhaseView::x_core; x *= 0.97) {
      EXPECT_NEAR(view.value(x) / shape.p(x), 1, tolerance) << name << " " << x;
    }
    EXPECT_NEAR(2 * pi * PhaseView::x_core * view.value(1e-12), shape.core_mass,
                1e-4 * shape.core_mass)
        << name;
    EXPECT_EQ(view.value(0.0), view.value(0.99 * PhaseView::x_core)) << name;
  }
}

// Seen red: with the sign of g turned in Henyey-Greenstein; with the mean of x for 1 minus it.
TEST(PhaseTable, HasTheMeanCosineOfHenyeyGreenstein) {
  for (const double g : {-0.3, 0.0, 0.5, 0.924, 0.999}) {
    EXPECT_NEAR(PhaseTable(henyey_greenstein(g)).mean_cosine(), g, 2e-5) << g;
  }
  EXPECT_NEAR(PhaseTable(isotropic()).mean_cosine(), 0, 1e-12);
}

TEST(PhaseTable, HasTheBackscatterFractionOfTheFormulas) {
  EXPECT_NEAR(PhaseTable(isotropic()).backscatter_fraction(), 0.5, 1e-8);
  EXPECT_NEAR(PhaseTable(rayleigh(0.039)).backscatter_fraction(), 0.5, 1e-5);
  EXPECT_NEAR(PhaseTable(petzold(library())).backscatter_fraction(), 0.0183, 5e-5);
  const FournierForand f(1.10, 3.5835);
  EXPECT_NEAR(PhaseTable(f.shape()).backscatter_fraction(), 1 - f.below(1), 1e-6);
  const double g = 0.924;  // the closed form: (1-g)/(2g) [(1+g)/sqrt(1+g^2) - 1]
  const double b = (1 - g) / (2 * g) * ((1 + g) / std::sqrt(1 + g * g) - 1);
  EXPECT_NEAR(PhaseTable(henyey_greenstein(g)).backscatter_fraction(), b, 1e-6);
}

/// u between 0 and 1, half of them in its tails.
std::vector<double> some_u(int count) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<double> out;
  for (int i = 0; i < count; ++i) {
    const double u = uniform(engine), tail = std::pow(2, -25 * u);
    out.push_back(i % 2 == 0 ? u : (i % 4 == 1 ? tail : 1 - tail));
  }
  return out;
}

// Petzold's rows have corners. Seen red: with the slopes of a cell's ends swapped; with cells of
// the upper half taken for those of the lower.
TEST(PhaseTable, SamplesTheInverseOfItsCumulative) {
  for (const auto& [name, shape] : all_shapes()) {
    const PhaseTable table(shape);
    const double tolerance = name == "petzold" ? 1e-7 : 2e-8;
    for (const double u : some_u(400)) {
      const double off = probability_below(table.view(), table.view().sample(u)) - u;
      ASSERT_NEAR(off, 0, tolerance) << name << " " << u;
      ASSERT_NEAR(off / std::min(u, 1 - u), 0, 1e-6) << name << " " << u;
    }
  }
}

// What samples are drawn from is value(), as closely as that is the formula. Differences of
// samples that are close together show it. Seen red: with the slopes of a cell's ends swapped; with
// the kink at the core's edge smoothed.
TEST(PhaseTable, SamplesAreAsDenseAsItsValues) {
  for (const auto& [name, shape] : all_shapes()) {
    const PhaseTable table(shape);
    const PhaseView view = table.view();
    for (const double u : some_u(4000)) {
      const double du = 1e-4 * std::min(u, 1 - u);
      const double from = view.sample(u - du), to = view.sample(u + du);
      if (from < 1e-9) continue;  // no digits left of u, and the core, which has one value
      if (from < PhaseView::x_core && to > PhaseView::x_core) continue;
      const double density = 2 * du / (to - from) / (2 * pi);
      ASSERT_NEAR(density / view.value(view.sample(u)), 1, 1e-3) << name << " " << u;
    }
  }
}

template <class T>
class PhaseSamples : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(PhaseSamples, Reals);

TYPED_TEST(PhaseSamples, AreMonotoneAndInsideForEveryU) {
  using T = TypeParam;
  for (const auto& [name, shape] : all_shapes()) {
    const PhaseTable table(shape);
    T last = 0;
    for (int i = 1; i < 200000; ++i) {
      const T x = table.view().sample(T(i) / T(200000));
      ASSERT_GE(x, last) << name << " " << i;
      last = x;
    }
    const T almost_one = std::nextafter(T(1), T(0));
    EXPECT_LE(table.view().sample(almost_one), T(2)) << name;
    EXPECT_GE(table.view().sample(almost_one), last) << name;
    EXPECT_GE(table.view().sample(std::numeric_limits<T>::min()), T(0)) << name;
  }
}

TYPED_TEST(PhaseSamples, DoNotFallOnZeros) {
  using T = TypeParam;
  // Forward hemisphere only: half of the cells are empty.
  const auto p = [](double x) { return x < 1 ? (1 - x) / pi : 0.0; };
  const PhaseTable table({p, 2 * PhaseView::x_core});
  for (int i = 0; i < 100000; ++i) {
    const T x = table.view().sample((T(i) + T(0.5)) / T(100000));
    ASSERT_TRUE(x >= T(0) && x <= T(1)) << i << " " << x;
  }
  EXPECT_LT(table.view().value(1.5), 1e-29);
}

// Zero from 60 to 90 degrees, where the inverse jumps by what no density shows: it is smeared over
// one cell of u. Seen red: without the least value of a node; without limits to slopes.
TEST(PhaseTable, SamplesOnBothSidesOfAGap) {
  const auto p = [](double x) {
    if (x < 1) return 1 / pi * std::max(0.5 - x, 0.0);
    return 3 * (x - 1) / (4 * pi);
  };
  const PhaseTable table({p, PhaseView::x_core});
  const PhaseView view = table.view();
  int inside = 0;
  constexpr int count = 100000;
  for (int i = 0; i < count; ++i) {
    const double u = (i + 0.5) / count, x = view.sample(u);
    ASSERT_TRUE(x >= 0 && x <= 2) << u;
    if (x > 0.501 && x < 0.999) {
      ++inside;
      ASSERT_NEAR(u, 0.25, 1.0 / 256) << x;
    }
  }
  EXPECT_LT(inside, count / 256);
}

// To the last bit, at the nodes of a table and between them; a table asks the formula no more. Seen
// red: with the node above taken for all.
TEST(PhaseTable, OfATabulatedShapeIsThatOfTheShape) {
  for (const auto& [name, shape] : all_shapes()) {
    int asked = 0;
    PhaseShape counting = shape;
    counting.p = [&](double x) {
      ++asked;
      return shape.p(x);
    };
    const PhaseShape known = tabulated(counting);
    const int once = asked;
    const PhaseTable table(shape), same(known);
    EXPECT_EQ(asked, once) << name;
    for (const double x : {PhaseView::x_core, 3e-8, 1e-3, 0.5, 1.0, 1.7, 2.0}) {
      EXPECT_EQ(known.p(x), shape.p(x)) << name;
      EXPECT_EQ(same.view().value<double>(x), table.view().value<double>(x)) << name;
    }
    EXPECT_EQ(known.core_mass, shape.core_mass);
  }
}

TEST(PhaseTable, RefusesWhatIsNoPhaseFunction) {
  const PhaseShape too_much{[](double) { return 1.001 / (4 * pi); }, PhaseView::x_core / 2};
  EXPECT_THROW(PhaseTable{too_much}, ContractViolation);
  const PhaseShape negative{[](double x) { return (1 - x) / (4 * pi); }, 0};
  EXPECT_THROW(PhaseTable{negative}, ContractViolation);
  const PhaseShape infinite{[](double x) { return 1 / (2 - x); }, 0};
  EXPECT_THROW(PhaseTable{infinite}, ContractViolation);
}

}  // namespace
}  // namespace photic::optics
