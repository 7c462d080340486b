// The rule by which estimators are compared, on made-up numbers.
#include "run/rule.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace photic::run {
namespace {

std::vector<double> gates(std::size_t count, double work) {
  return std::vector<double>(count, work);
}

TEST(Rule, TakesTheGeometricMeanOverAllGates) {
  EXPECT_NEAR(log_work({1.0, 100.0}, Aim::all_gates), std::log(10.0), 1e-12);
}

// Seen red: with the fifth of least work; with the number of gates rounded down.
TEST(Rule, TakesTheWorstFifthForATarget) {
  std::vector<double> work = gates(11, 1.0);
  work[3] = 1e4;
  work[8] = 100.0;
  EXPECT_NEAR(log_work(work, Aim::worst_gates), std::log(100.0), 1e-12);  // 1e4, 100 and 1
  EXPECT_NEAR(log_work({5.0, 3.0}, Aim::worst_gates), std::log(5.0), 1e-12);
}

// One gate that is off by luck does not decide among many. Seen red: with the worst gate alone.
TEST(Rule, IsNotDecidedByOneGateOfMany) {
  std::vector<double> unlucky = gates(80, 1.0);
  unlucky[40] = 50.0;
  EXPECT_LT(log_work(unlucky, Aim::worst_gates), log_work(gates(80, 2.0), Aim::worst_gates));
}

TEST(Rule, IsThatOfATargetIfTheSceneHasOne) {
  scene::Simulation simulation;
  EXPECT_EQ(aim_of(simulation), Aim::all_gates);
  simulation.target_relative_error = 0.02;
  EXPECT_EQ(aim_of(simulation), Aim::worst_gates);
}

}  // namespace
}  // namespace photic::run
