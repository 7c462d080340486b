// The tables of a medium and the view of them.
#include "medium/medium.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.hpp"
#include "optics/phase_functions.hpp"
#include "unit/medium/two_layers.hpp"

namespace photic::medium {
namespace {

TEST(Medium, KeepsEqualPhaseFunctionsOnce) {
  Medium m;
  const auto of = [](double g) {
    return std::make_shared<const optics::PhaseTable>(optics::henyey_greenstein(g));
  };
  const auto table = of(0.9);
  EXPECT_EQ(m.add_phase(table), 0);
  EXPECT_EQ(m.add_phase(of(0.5)), 1);
  EXPECT_EQ(m.add_phase(table), 0);
  EXPECT_EQ(m.add_phase(of(0.9)), 0);
  EXPECT_EQ(m.add_phase(of(0.5)), 1);
  EXPECT_EQ(m.phases()[0].lock(), table);
  EXPECT_TRUE(m.phases()[1].expired());
  const optics::PhaseTable a(optics::henyey_greenstein(0.9)), b(optics::henyey_greenstein(0.5));
  m.top = {0, 1};
  for (const double x : {0.0, 1e-9, 0.01, 1.0, 2.0}) {
    EXPECT_EQ(m.view().phases.value<double>(x, 0), a.view().value<double>(x));
    EXPECT_EQ(m.view().phases.value<double>(x, 1), b.view().value<double>(x));
  }
  for (const double u : {1e-9, 0.1, 0.5, 0.99}) {
    EXPECT_EQ(m.view().phases.sample<double>(u, 0), a.view().sample<double>(u));
    EXPECT_EQ(m.view().phases.sample<double>(u, 1), b.view().sample<double>(u));
  }
}

// Seen red: with the rows of the lines one value short; without the part above the layer.
TEST(Medium, AddsUpOpticalDepths) {
  auto m = two_layers();
  m.finish();
  const auto v = m.view();
  EXPECT_NEAR(v.optical_depth(0, v.level(0, 4.0)), 0.8, 1e-15);
  EXPECT_NEAR(v.optical_depth(0, v.level(1, 10.0)), 2.0, 1e-15);
  EXPECT_NEAR(v.optical_depth(0, v.level(1, 12.0)), 3.0, 1e-15);
  EXPECT_NEAR(v.optical_depth(1, v.level(1, 12.0)), 8.8, 1e-14);
  EXPECT_EQ(v.layers, 2);
  EXPECT_EQ(v.lines, 2);
  EXPECT_EQ(v.index[1], 1.33);
  EXPECT_EQ(v.group_index[1], 1.35);
}

// Seen red: with the length along the way left out between layers.
TEST(Medium, AddsUpOpticalDepthsOfSlantedWays) {
  auto m = two_layers();
  m.finish();
  const auto v = m.view();
  EXPECT_NEAR(v.slant_optical_depth(0, v.level(0, 4.0), v.level(0, 7.0), 5.0), 1.0, 1e-15);
  EXPECT_NEAR(v.slant_optical_depth(0, v.level(0, 4.0), v.level(0, 4.0), 5.0), 1.0,
              1e-15);  // level
  EXPECT_NEAR(v.slant_optical_depth(0, v.level(0, 4.0), v.level(1, 12.0), 16.0),
              2 * (6 * 0.2 + 2 * 0.5), 1e-14);
  EXPECT_NEAR(v.slant_optical_depth(0, v.level(1, 12.0), v.level(0, 4.0), 16.0),
              2 * (6 * 0.2 + 2 * 0.5), 1e-14);
}

TEST(Medium, ListsWhatCanBeEmittedByLayer) {
  auto m = two_layers();
  m.finish();
  const auto v = m.view();
  EXPECT_EQ(v.convertible_count[0], 0);
  EXPECT_EQ(v.convertible_count[1], 1);
  EXPECT_EQ(v.convertible[1], 0);
}

TEST(Medium, FindsTheLayerOfADepth) {
  auto m = two_layers();
  EXPECT_EQ(m.layer_at(0), 0);
  EXPECT_EQ(m.layer_at(9.999), 0);
  EXPECT_EQ(m.layer_at(10), 1);  // an edge belongs to the layer below
  EXPECT_EQ(m.layer_at(29), 1);
  EXPECT_EQ(m.layer_at(30), 1);  // on the bed
  m.top.back() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(m.layer_at(1e6), 1);
}

TEST(Medium, RefusesIncompleteTables) {
  auto m = two_layers();
  m.albedo.pop_back();
  EXPECT_THROW(m.finish(), ContractViolation);
}

TEST(Process, HasTheNamesOfTheResultFile) {
  EXPECT_STREQ(scene::word_of(Process::elastic), "elastic");
  EXPECT_STREQ(scene::word_of(Process::raman), "raman");
  EXPECT_STREQ(scene::word_of(Process::chlorophyll), "chlorophyll");
}

}  // namespace
}  // namespace photic::medium
