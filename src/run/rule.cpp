#include "run/rule.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include "core/error.hpp"

namespace photic::run {
namespace {

constexpr std::size_t worst_one_in = 5;  // of the gates

}  // namespace

Aim aim_of(const scene::Simulation& simulation) {
  return simulation.target_relative_error ? Aim::worst_gates : Aim::all_gates;
}

double log_work(std::vector<double> work, Aim aim) {
  expect(!work.empty(), "gates to compare by");
  if (aim == Aim::worst_gates) {
    std::ranges::sort(work, std::greater());
    work.resize((work.size() + worst_one_in - 1) / worst_one_in);
  }
  double sum = 0;
  for (const double w : work) sum += std::log(w);
  return sum / static_cast<double>(work.size());
}

}  // namespace photic::run
